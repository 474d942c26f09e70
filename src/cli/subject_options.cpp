#include "cli/subject_options.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdio>
#include <string_view>
#include <utility>

#include "cli/bitmap.h"
#include "cli/error.h"
#include "cli/job.h"
#include "cli/number.h"
#include "testbed/printable.h"

namespace selvage::cli {
namespace {

constexpr double kUsualCallLimit_s = 2, kMostCallLimit_s = 3600;
constexpr double kMostAccuracy_fx16 = 1 << 30, kMostCoverageAccuracy_fx16 = 1 << 16;

[[nodiscard]] std::chrono::nanoseconds call_limit(const std::string& text) {
  const std::optional<double> seconds =
      text.empty() ? std::optional(kUsualCallLimit_s) : parse_double(text);
  if (!seconds || *seconds < 0.001 || *seconds > kMostCallLimit_s) {
    throw UserError("--call-limit: '" + text + "' is no time; 0.001 to 3600 seconds are");
  }
  return std::chrono::nanoseconds(static_cast<int64_t>(*seconds * 1e9));
}

[[nodiscard]] spec::Winding parse_winding(const std::string& name) {
  if (name == "both") return spec::Winding::kBoth;
  if (name == "clockwise") return spec::Winding::kClockwise;
  if (name == "counter-clockwise") return spec::Winding::kCounterClockwise;
  throw UserError("--winding: '" + name + "' is none; both, clockwise and counter-clockwise are");
}

template <typename Parse>
void read_set(const char* option, const std::vector<std::string>& names, Parse parse,
              spec::ValueSet* set) {
  if (names.empty()) return;
  *set = 0;
  for (const std::string& name : names) {
    *set |= spec::only(about(option, [&] { return parse(std::string_view(name)); }));
  }
}

[[nodiscard]] selvage_kernel parse_kernel(const std::string& name) {
  std::string known;
  for (selvage_kernel i = 0; i < SELVAGE_KERNEL_NEON + 1; ++i) {
    if (selvage_has_kernel(i) == 0) continue;
    if (kernel_name(i) == name) return i;
    known += " " + std::string(kernel_name(i));
  }
  throw UserError("--kernel: '" + name + "' is none of this machine; there are" + known);
}

void draw_by(selvage_kernel kernel, spec::Subject* subject) {
  spec::take_kernel(kernel, subject);
  subject->name += ", kernel " + std::string(kernel_name(kernel));
}

void read_number(const char* option, const std::string& text, int32_t least, int32_t* number) {
  if (text.empty()) return;
  const std::optional<int32_t> value = parse_integer<int32_t>(text);
  if (!value || *value < least) {
    throw UserError(std::string(option) + ": '" + text + "' is no number from " +
                    std::to_string(least) + " on");
  }
  *number = *value;
}

void read_side(const char* option, const std::string& text, int32_t* side) {
  if (text.empty()) return;
  read_number(option, text, 0, side);
  if (*side == 0) *side = spec::kAnyNumber;  // as in selvage_subject.h
}

void read_guard_band(const SubjectOptions& options, int32_t* band_px) {
  read_side("--guard-band", options.guard_band, band_px);
  if (!options.outside_vertices) return;
  if (*options.outside_vertices && *band_px == 0) *band_px = spec::kAnyNumber;
  if (*options.outside_vertices) return;
  if (!options.guard_band.empty()) {
    throw UserError("--guard-band and --no-outside-vertices: one or the other is right");
  }
  *band_px = 0;
}

// A number or a quotient of two, in units of which so many are 1; empty where it is neither.
[[nodiscard]] std::optional<double> parse_units(const std::string& text, int32_t units_in_one) {
  const std::vector<std::string_view> parts = split(text, '/');
  if (parts.size() > 2) return std::nullopt;
  const std::optional<double> number = parse_double(parts.front());
  const std::optional<double> divisor = parts.size() == 2 ? parse_double(parts[1]) : 1;
  if (!number || !divisor || *divisor <= 0) return std::nullopt;
  return *number / *divisor * units_in_one;
}

// Rounded down: no more is claimed than was said.
void read_accuracy(const char* option, const std::string& text, double most_fx16, const char* right,
                   int32_t* accuracy_fx16) {
  if (text.empty()) return;
  const double fx16 = parse_units(text, SELVAGE_SUBTEXELS).value_or(-1);
  if (fx16 != 0 && (fx16 < 1 || fx16 > most_fx16)) {
    throw UserError(std::string(option) + ": '" + text + "' is none; " + right +
                    ", as 0.25 or 1/256, are, or 0: exact");
  }
  *accuracy_fx16 = static_cast<int32_t>(fx16);
}

void read_step(const char* option, const std::string& text, int32_t units_in_one, int32_t* step) {
  if (text.empty()) return;
  const double units = parse_units(text, units_in_one).value_or(0);
  const auto whole = static_cast<uint32_t>(std::clamp<double>(units, 0, units_in_one));
  if (static_cast<double>(whole) != units || !std::has_single_bit(whole)) {
    throw UserError(std::string(option) + ": '" + text +
                    "' is no step; 1, 1/2, 1/4 and so on to 1/" + std::to_string(units_in_one) +
                    " are");
  }
  *step = static_cast<int32_t>(whole);
}

void read_claims(const SubjectOptions& options, spec::Capabilities* claims) {
  if (!options.winding.empty()) claims->winding = parse_winding(options.winding);
  read_set("--formats", options.formats, parse_format, &claims->formats);
  read_set("--filters", options.filters, parse_filter, &claims->filters);
  read_set("--addresses", options.addresses, parse_address, &claims->addresses);
  if (!spec::holds(claims->filters, SELVAGE_FILTER_NEAREST)) {
    throw UserError("--filters: nearest must be among them: without it no texel can be told");
  }
  claims->perspective = options.perspective.value_or(claims->perspective);
  claims->clip = options.clip.value_or(claims->clip);
  claims->negative_pitch = options.negative_pitch.value_or(claims->negative_pitch);
  claims->concave = options.concave.value_or(claims->concave);
  claims->named_errors = options.named_errors.value_or(claims->named_errors);
  claims->any_texture_side = options.any_texture_side.value_or(claims->any_texture_side);
  claims->outside_texels = options.outside_texels.value_or(claims->outside_texels);
  read_side("--longest-side", options.longest_side, &claims->longest_side_px);
  read_side("--longest-texture-side", options.longest_texture_side, &claims->longest_side_texel);
  read_number("--most-vertices", options.most_vertices, 3, &claims->most_vertices);
  read_step("--position-step", options.position_step, SELVAGE_SUBPIXELS,
            &claims->position_step_fx8);
  read_step("--coordinate-step", options.coordinate_step, SELVAGE_SUBTEXELS,
            &claims->coordinate_step_fx16);
  read_guard_band(options, &claims->guard_band_px);
  read_accuracy("--accuracy", options.accuracy, kMostAccuracy_fx16, "texels from 1/65536 to 16384",
                &claims->accuracy_fx16);
  read_accuracy("--coverage-accuracy", options.coverage_accuracy, kMostCoverageAccuracy_fx16,
                "pixels from 1/65536 to 1", &claims->coverage_accuracy_fx16);
}

[[nodiscard]] std::string arguments_of(const SubjectOptions& options) {
  std::string text;
  const auto tell = [&](const char* option, const std::string& value) {
    if (!value.empty()) text += " " + std::string(option) + " " + shell_word(value);
  };
  const auto tell_all = [&](const char* option, const std::vector<std::string>& values) {
    std::string joined;
    for (const std::string& value : values) joined += (joined.empty() ? "" : ",") + value;
    tell(option, joined);
  };
  const auto tell_flag = [&](const char* name, const std::optional<bool>& value) {
    if (value) text += (*value ? " --" : " --no-") + std::string(name);
  };
  tell("--subject", options.library);
  tell("--call-limit", options.call_limit);
  tell("--kernel", options.kernel);
  tell("--name", options.name);
  tell("--winding", options.winding);
  tell_all("--formats", options.formats);
  tell_all("--filters", options.filters);
  tell_all("--addresses", options.addresses);
  tell_flag("perspective", options.perspective);
  tell_flag("clip", options.clip);
  tell_flag("negative-pitch", options.negative_pitch);
  tell_flag("concave", options.concave);
  tell_flag("named-errors", options.named_errors);
  tell_flag("any-texture-side", options.any_texture_side);
  tell_flag("outside-texels", options.outside_texels);
  tell_flag("outside-vertices", options.outside_vertices);
  tell("--longest-side", options.longest_side);
  tell("--longest-texture-side", options.longest_texture_side);
  tell("--guard-band", options.guard_band);
  tell("--most-vertices", options.most_vertices);
  tell("--position-step", options.position_step);
  tell("--coordinate-step", options.coordinate_step);
  tell("--accuracy", options.accuracy);
  tell("--coverage-accuracy", options.coverage_accuracy);
  return text.empty() ? text : text.substr(1);
}

// In the dollar quotes of POSIX.1-2024: a replay must find a file whose name cannot be shown.
[[nodiscard]] std::string octal_word(std::string_view text) {
  std::string quoted = "$'";
  for (const char letter : text) {
    char octal[8];
    std::snprintf(octal, sizeof octal, "\\%03o", unsigned{static_cast<unsigned char>(letter)});
    const bool is_plain = letter >= ' ' && letter <= '~' && letter != '\'' && letter != '\\';
    quoted += is_plain ? std::string(1, letter) : octal;
  }
  return quoted + "'";
}

}  // namespace

std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=.,:/@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  if (text != testbed::printable(text)) return octal_word(text);
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

void demand_exact_profile(const spec::Subject& subject) {
  if (spec::draws_exactly(subject.claims) || subject.profile == SELVAGE_PROFILE_EXACT) return;
  throw UserError(
      "an accuracy is claimed in profile exact alone, for the other profiles' bounds are derived; "
      "--accuracy 0 and --coverage-accuracy 0 take the claims back");
}

ChosenSubject choose_subject(const SubjectOptions& options, const std::string& profile,
                             const spec::Subject& built_in) {
  ChosenSubject chosen{.subject = built_in, .host = {}, .arguments = arguments_of(options)};
  const std::chrono::nanoseconds limit = call_limit(options.call_limit);
  if (options.library.empty() && !(options.call_limit.empty() && options.output.empty())) {
    throw UserError("--call-limit and --subject-output are about a --subject, and none is given");
  }
  if (!options.kernel.empty() && !options.library.empty()) {
    throw UserError("--kernel is about the built-in mapper, and not about a --subject");
  }
  if (!options.kernel.empty()) draw_by(parse_kernel(options.kernel), &chosen.subject);
  try {
    if (!options.library.empty()) {
      chosen.host = std::make_shared<testbed::Host>(options.library, limit);
      chosen.subject = testbed::Host::subject(chosen.host);
    }
  } catch (const testbed::LibraryError& error) {
    throw UserError(error.what());
  }
  if (!profile.empty()) {
    chosen.subject.profile = about("--profile", [&] { return parse_profile(profile); });
  }
  if (!options.name.empty()) chosen.subject.name = testbed::printable(options.name);
  read_claims(options, &chosen.subject.claims);
  demand_exact_profile(chosen.subject);
  return chosen;
}

}  // namespace selvage::cli
