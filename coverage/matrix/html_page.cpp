#include <algorithm>
#include <bit>
#include <string_view>

#include "coverage/matrix/render.h"
#include "spec/profiles.h"

namespace selvage::coverage {
namespace {

// The shades of a kill go from k0, by the first case, to k4, by the 256th or a later one.
constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --text: #1d2228; --page: #fdfdfb; --line: #d5d8dc;
        --soft: #f0f1f3; --faint: #868d96; --bad: #b3152a; --kill: 20 113 58; --ink: #fff; }
@media (prefers-color-scheme: dark) {
  :root { --text: #dfe3e8; --page: #14171c; --line: #363c45; --soft: #1f242b; --faint: #7c8590;
          --bad: #ff7a85; --kill: 88 201 131; --ink: #0d1013; } }
body { margin: 0; padding: 1rem 1.25rem 4rem; background: var(--page); color: var(--text);
       font: 15px/1.45 system-ui, sans-serif; }
p { max-width: 52rem; }
table { border-collapse: separate; border-spacing: 0; font-size: .82rem;
        font-variant-numeric: tabular-nums; }
th, td { padding: .1rem .35rem; border-bottom: 1px solid var(--line); text-align: left;
         white-space: nowrap; font-weight: normal; }
thead th { position: sticky; top: 0; background: var(--page); vertical-align: bottom; }
thead th.law { writing-mode: vertical-rl; transform: rotate(180deg);
               border-bottom: 0; border-top: 1px solid var(--line); padding: .35rem .1rem; }
td.c { text-align: right; min-width: 1.9rem; border-left: 1px solid var(--line); }
td.k { background: rgb(var(--kill) / var(--shade)); }
.k0 { --shade: 1; color: var(--ink); } .k1 { --shade: .75; color: var(--ink); }
.k2 { --shade: .5; } .k3 { --shade: .32; } .k4 { --shade: .18; }
td.p { color: var(--faint); } td.z { color: var(--bad); } td.n { background: var(--soft); }
td.own { box-shadow: inset 0 0 0 2px var(--text); }
tr.profile th { padding-top: 1rem; font-weight: 600; font-size: .95rem; }
td.bug { color: var(--faint); padding-left: .8rem; } tr.bad th { color: var(--bad); }
tfoot th, tfoot td { border-top: 1px solid var(--line); font-weight: 600; }
)";

[[nodiscard]] std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    html += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return html;
}

[[nodiscard]] std::string counted(size_t count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

[[nodiscard]] std::string cell_html(const Cell& cell, bool is_own) {
  const std::string own = is_own ? " own" : "";
  switch (cell.fate) {
    case Fate::kKilled: {
      const int shade = std::min(static_cast<int>(std::bit_width(cell.cases) - 1) / 2, 4);
      return "<td class=\"c k k" + std::to_string(shade) + own + "\">" +
             std::to_string(cell.cases) + "</td>";
    }
    case Fate::kPassed:
      return "<td class=\"c p" + own + "\">&ndash;</td>";
    case Fate::kNotJudged:
      return "<td class=\"c z" + own + "\">0</td>";
    default:
      return "<td class=\"c n\"></td>";
  }
}

[[nodiscard]] std::string row_html(const Row& row) {
  std::string html = kills_of(row) == 0 ? "<tr class=bad>" : "<tr>";
  html += "<th>" + escaped(row.mapper->name) + "</th>";
  for (size_t i = 0; i < row.cells.size(); ++i) {
    html += cell_html(row.cells[i], spec::laws()[i].name == row.mapper->killer);
  }
  return html + "<td class=bug>" + escaped(row.mapper->bug) + "</td></tr>\n";
}

[[nodiscard]] std::string head_html() {
  std::string html = "<thead><tr><th></th>";
  for (const spec::Law& law : spec::laws()) {
    html += "<th class=law title=\"" + escaped(law.statement) + "\">" + escaped(law.name) + "</th>";
  }
  return html + "<th></th></tr></thead>\n";
}

// The rows of a profile under its name.
[[nodiscard]] std::string body_html(const Matrix& matrix, const spec::Profile& profile) {
  std::string rows;
  size_t count = 0;
  for (const Row& row : matrix.rows) {
    if (row.mapper->subject.profile != profile.id) continue;
    rows += row_html(row);
    ++count;
  }
  if (count == 0) return {};
  return "<tbody><tr class=profile><th colspan=" + std::to_string(spec::laws().size() + 2) + ">" +
         std::string(profile.name) + ": " + counted(count, "wrong mapper") + "</th></tr>\n" + rows +
         "</tbody>\n";
}

[[nodiscard]] std::string foot_html(const Matrix& matrix) {
  std::string kills = "<tr><th>kills</th>", sole = "<tr><th>of which no other law does</th>";
  for (size_t i = 0; i < spec::laws().size(); ++i) {
    const Tally of_law = tally(matrix, i);
    kills += "<td class=\"c" + std::string(of_law.kills == 0 ? " z" : "") + "\">" +
             std::to_string(of_law.kills) + "</td>";
    sole += "<td class=c>" + std::to_string(of_law.sole) + "</td>";
  }
  return "<tfoot>" + kills + "<td></td></tr>\n" + sole + "<td></td></tr></tfoot>\n";
}

[[nodiscard]] std::string intro_html(const Matrix& matrix) {
  const auto& [first_seed, cases, killer_cases] = matrix.budget;
  const auto survivors = std::ranges::count(matrix.rows, size_t{0}, kills_of);
  return "<h1>Wrong mappers and the laws that kill them</h1>\n<p>" +
         counted(matrix.rows.size(), "wrong mapper") + ", of which " + std::to_string(survivors) +
         " survive, against " + counted(spec::laws().size(), "law") + ". Each law looked at " +
         counted(cases, "case") + ", from seed " + std::to_string(first_seed) +
         " on, until it saw something wrong; the one that the catalogue names, which is framed, "
         "at " +
         std::to_string(std::max(cases, killer_cases)) + ".</p>\n<p>" +
         "A number is the case that killed, the stronger its colour the earlier; &ndash; is a law "
         "that saw nothing wrong, 0 one that found nothing to judge; grey is a law that the "
         "profile does not promise.</p>\n";
}

}  // namespace

std::string html_page(const Matrix& matrix) {
  std::string table = "<table>\n" + head_html();
  for (const spec::Profile& profile : spec::profiles()) table += body_html(matrix, profile);
  table += foot_html(matrix) + "</table>\n";
  return "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n<meta name=viewport "
         "content=\"width=device-width, initial-scale=1\">\n<title>Selvage: wrong mappers and "
         "laws</title>\n<style>" +
         std::string(kStyle) + "</style></head>\n<body>\n" + intro_html(matrix) + table +
         "</body></html>\n";
}

}  // namespace selvage::coverage
