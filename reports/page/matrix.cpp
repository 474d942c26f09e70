// The table, and what each subject and each of its violations is about.
#include "reports/page/matrix.h"

#include "reports/page/html.h"

namespace selvage::reports {

namespace {

using json = nlohmann::ordered_json;

std::string text_if_any(const json& values, const char* key) {
  return escaped(values.value(key, std::string()));
}

// As it calls itself, or where it could not be asked by its file.
std::string subject_name(const json& subject) {
  const std::string name = text_if_any(subject, subject.contains("subject") ? "subject" : "id");
  const std::string profile = text_if_any(subject, "profile");
  return profile.empty() || profile == "exact" ? name : name + ", " + profile;
}

// "defect", "convention", ...; what nobody has looked at is no defect yet.
std::string kind_of(const json& cell) {
  return cell.contains("finding") ? cell["finding"].at("kind").get<std::string>() : "unexamined";
}

std::string holding(const json& cell) {
  const std::string px = grouped(cell.at("judged_px").get<uint64_t>());
  std::string title = grouped(cell.at("cases").get<uint64_t>()) + " cases, " + px + " px";
  std::string text = cell.contains("not_claimed") ? "holds*" : "holds";
  text += element("small", px);
  if (cell.contains("nearest")) {
    const json& nearest = cell["nearest"];
    const double share = nearest.at("measured").get<double>() / nearest.at("bound").get<double>();
    text += element("small", rounded(share) + " of bound");
  }
  if (cell.contains("not_claimed")) {
    for (const auto& [what, cases] : cell["not_claimed"].items())
      title += "; not claimed: " + cases.dump() + " cases: " + escaped(what);
  }
  return element("td", text, "class=good title=\"" + title + "\"");
}

std::string cell_html(const json& cell) {
  const auto verdict = cell.at("verdict").get<std::string>();
  if (verdict == "holds") return holding(cell);
  if (verdict == "not promised")
    return element("td", "&ndash;", "class=quiet title=\"" + text_if_any(cell, "why") + "\"");
  if (verdict != "violated") return element("td", escaped(verdict), "class=quiet");
  const std::string kind = kind_of(cell);
  const std::string link = element("a", kind == "defect" ? "defect" : "fails",
                                   "href=\"" + text_if_any(cell, "page") + "\"");
  return element("td", link + element("small", escaped(kind == "defect" ? "" : kind)),
                 kind == "defect" ? "class=bad" : "class=differs");
}

// Of a law that has no verdict: it says nothing of the subject's profile, and why.
std::string silent(const json& subject, const json& law) {
  const json notes = law.value("silent", json::object());
  const std::string note = text_if_any(notes, subject.value("profile", "").c_str());
  return element("td", "", note.empty() ? "class=quiet" : "class=quiet title=\"" + note + "\"");
}

std::string row_html(const json& subject, const json& laws) {
  std::string row = element("th", subject_name(subject), "scope=row");
  if (subject.contains("error")) {
    row += element("td", "not judged: " + text_if_any(subject, "error"),
                   "class=quiet colspan=" + std::to_string(laws.size()));
    return element("tr", row);
  }
  for (const json& law : laws) {
    std::string html = silent(subject, law);
    for (const json& cell : subject.at("cells")) {
      if (cell.at("law") == law.at("law")) html = cell_html(cell);
    }
    row += html;
  }
  return element("tr", row);
}

std::string matrix_table(const json& matrix) {
  std::string head = "<tr><th>subject";
  for (const json& law : matrix.at("laws"))
    head += "<th title=\"" + text_if_any(law, "statement") + "\">" + text_if_any(law, "law");
  std::string rows = head + "</tr>\n";
  for (const json& subject : matrix.at("subjects")) rows += row_html(subject, matrix.at("laws"));
  return element("div", element("table", rows, "class=matrix"), "class=\"wide reaching\"");
}

std::string finding_item(const json& cell) {
  const json& finding = cell.at("finding");
  std::string item = element("a", element("strong", text_if_any(cell, "law")),
                             "href=\"" + text_if_any(cell, "page") + "\"") +
                     " (" + text_if_any(finding, "kind") + "): " + text_if_any(finding, "text");
  if (finding.contains("source"))
    item += "<br>" + element("small", "Source: " + text_if_any(finding, "source"));
  return element("li", item);
}

// What a subject follows, and what its violations are.
std::string about(const json& subject) {
  if (!subject.contains("convention")) return {};
  std::string items;
  for (const json& cell : subject.value("cells", json::array())) {
    if (cell.contains("finding")) items += finding_item(cell);
  }
  for (const json& law : subject.value("stale", json::array())) {
    items += element("li", element("strong", escaped(law.get<std::string>())) +
                               ": the case that the finding is about holds now");
  }
  std::string title = subject_name(subject);
  const std::string examined = subject.value("examined", "");
  if (subject.value("subject", std::string()).find(examined) == std::string::npos)
    title += " (examined: " + escaped(examined) + ")";
  return element("details", element("summary", element("strong", title)) +
                                element("p", text_if_any(subject, "convention")) +
                                element("ul", items));
}

}  // namespace

std::string matrix_section(const json& matrix) {
  if (matrix.is_null()) return {};
  std::string abouts;
  for (const json& subject : matrix.at("subjects")) abouts += about(subject);
  const auto& count = [&](const char* key) { return matrix.value(key, uint64_t{0}); };
  return element("h2", "Subjects against laws", "id=matrix") +
         element("p",
                 "Other mappers, and each of our own, held against the laws that they promise: " +
                     grouped(count("cases")) + " cases each from seed " + grouped(count("seed")) +
                     ", with no tolerance; below it the number of pixels judged. "
                     "&ldquo;fails&rdquo; leads to the smallest "
                     "counterexample; it says that a picture differs from the exact one, not "
                     "that the mapper is wrong: most mappers never promised it. Where a "
                     "violation was examined, its kind is below it: a convention or a precision "
                     "that the mapper documents or leaves open, a limit of the range in which it "
                     "works, or a defect, where its own documentation promises otherwise. &ndash; "
                     "is not promised, * is promised in part; where a cell is empty, the law says "
                     "nothing of the profile.") +
         matrix_table(matrix) + abouts;
}

}  // namespace selvage::reports
