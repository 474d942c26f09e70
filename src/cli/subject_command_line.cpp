#include "cli/subject_command_line.h"

#include <optional>
#include <vector>

namespace selvage::cli {
namespace {

constexpr const char* kClaimsGroup = "What it claims (the library's own selvage_subject() else)";

}  // namespace

void add_library(CLI::App& command, SubjectOptions& subject, const std::string& what) {
  command.add_option("--subject", subject.library, what)->type_name("FILE")->group(kSubjectGroup);
  command
      .add_option(
          "--call-limit", subject.call_limit,
          "Time that a call may take, 2 if left out; up to 8 times as much on a busy machine")
      ->type_name("SECONDS")
      ->group(kSubjectGroup);
}

void add_claims(CLI::App& command, SubjectOptions& subject) {
  const auto add = [&](const char* name, std::string& value, const char* type, const char* what) {
    command.add_option(name, value, what)->type_name(type)->group(kClaimsGroup);
  };
  const auto add_list = [&](const char* name, std::vector<std::string>& values, const char* what) {
    command.add_option(name, values, what)
        ->type_name("NAME,...")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->group(kClaimsGroup);
  };
  const auto add_flag = [&](const char* name, std::optional<bool>& value, const char* what) {
    const std::string yes = "--" + std::string(name), no = "--no-" + std::string(name);
    command
        .add_flag_callback(
            yes, [&value] { value = true; }, what + (" (or " + no + ")"))
        ->group(kClaimsGroup);
    command.add_flag_callback(no, [&value] { value = false; })->group("");  // told with the other
  };
  add("--name", subject.name, "TEXT", "Its name in the verdict");
  add("--winding", subject.winding, "NAME", "both, clockwise or counter-clockwise");
  add_list("--formats", subject.formats, "Of index8, rgb565, rgba8888");
  add_list("--filters", subject.filters,
           "Of nearest (always), four, bilinear, area; others must be refused");
  add_list("--addresses", subject.addresses, "Of clamp, wrap");
  add_flag("perspective", subject.perspective, "Whether q may differ");
  add_flag("clip", subject.clip, "Whether it takes a clip rectangle");
  add_flag("negative-pitch", subject.negative_pitch, "Whether pictures may be bottom row first");
  add_flag("concave", subject.concave, "Whether outlines need not be convex");
  add_flag("named-errors", subject.named_errors, "Whether bad arguments get their status");
  add_flag("any-texture-side", subject.any_texture_side,
           "Whether texture sides need not be powers of two");
  add_flag("outside-texels", subject.outside_texels, "Whether u, v may lie beyond the texture");
  add_flag("outside-vertices", subject.outside_vertices, "Whether x, y may lie beyond the target");
  add("--longest-side", subject.longest_side, "PX", "Of the target; 0: any");
  add("--longest-texture-side", subject.longest_texture_side, "TEXELS", "Of the texture; 0: any");
  add("--guard-band", subject.guard_band, "PX",
      "How far beyond the target x, y may lie; 0: anywhere");
  add("--most-vertices", subject.most_vertices, "N", "3: it draws triangles alone");
  add("--position-step", subject.position_step, "PX",
      "Its x, y are multiples of it: 1 takes whole pixels alone, 1/16 sixteenths");
  add("--coordinate-step", subject.coordinate_step, "TEXELS",
      "Its u, v are multiples of it: 1 takes whole texels alone");
  add("--accuracy", subject.accuracy, "TEXELS",
      "How far its texels may be off in u and v, as 0.25 or 1/256; 0: exact");
  add("--coverage-accuracy", subject.coverage_accuracy, "PX",
      "How far from the outline a pixel may be drawn or missing, up to 1; 0: exact");
}

}  // namespace selvage::cli
