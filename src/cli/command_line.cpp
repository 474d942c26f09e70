#include "cli/command_line.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <exception>
#include <new>

#include "cli/bench_command.h"
#include "cli/demo_command_line.h"
#include "cli/draw_command.h"
#include "cli/error.h"
#include "cli/laws_command.h"
#include "cli/render_command_line.h"
#include "cli/stability_command.h"
#include "cli/subject_command_line.h"
#include "cli/usage_error.h"
#include "cli/verify_command.h"
#include "cli/verify_command_line.h"
#include "selvage.h"

namespace selvage::cli {
namespace {

constexpr const char* kUsualExitCodes =
    "Exit codes: 0 fine; 2 wrong use, or a file that cannot be read or written.";

constexpr const char* kProgramExitCodes =
    "Exit codes: 0 fine; 1 a law failed, or a promise is broken (verify, merge, stability, "
    "bench);\n"
    "2 wrong use, or a file that cannot be read or written; 3 there was no time for each law\n"
    "(verify, merge).";

constexpr const char* kStabilityExitCodes =
    "Exit codes: 0 fine; 1 a promise is broken: 'exact' differs from the model, or a texel lies\n"
    "beyond its derived bound, or a subject crashes or writes where it may not; 2 wrong use, or a "
    "file that cannot be read or written.";

constexpr const char* kProgramExamples = R"(Examples:
  selvage draw --texture earth.jpg --polygon '10,10,0,0 200,20,640,0 190,180,640,480' \
               --size 256x192 -o out.png
  selvage render station.json -o station.png
  selvage demo
  selvage verify --cases 1000
  selvage verify --subject ./theirs.so
  selvage stability --list
  selvage bench --filter '^W1/'
  selvage laws
'selvage COMMAND --help' tells more.
)";

constexpr const char* kDrawExamples = R"(Examples:
  selvage draw --texture earth.jpg --size 256x192 --background '#203040' -o out.png \
               --polygon '10,10,0,0 200,20,640,0 190,180,640,480 20,170,0,480'
  selvage draw --texture floor.png --background room.png --address wrap -o out.png \
               --polygon '80,40,0,0,4 160,40,64,0,4 240,180,64,64,1 0,180,0,64,1'
  selvage draw --texture earth.jpg --size 64x32 --filter area -o small.png \
               --polygon '0,0,0,0 64,0,2048,0 64,32,2048,1024 0,32,0,1024'
  selvage draw --texture floor.png --size 640x200 --tolerance 0.25 -o out.png --json \
               --polygon '0,0,0,0,1 640,0,64,0,1.015 640,200,64,64,1.015 0,200,0,64,1'
  selvage draw --texture earth.jpg --polygon-file globe.json --size 640x480 -o out.png --json
  selvage draw --texture earth.jpg --polygon-file globe.json --size 640x480 -o - | display

A polygon's vertices go around it, either way; every row of pixels may cross two of its edges or
none. The texture replaces what is under it: alpha is copied, not blended. The historic profiles
want vertices on whole pixels, no w and no filter but nearest, which is also all that 8-bit and
16-bit formats can do. area takes the mean of all that a pixel shows: for pictures made smaller.

A polygon file:
  {"vertices": [[10, 10, 0, 0], [200, 20, 640, 0], {"x": 190, "y": 180, "u": 640, "v": 480, "w": 2}],
   "clip": [0, 0, 128, 128], "address": "wrap", "filter": "bilinear",
   "profile": "exact"}
or several, drawn in order: {"polygons": [{"vertices": ...}, ...]}. Only "vertices" is needed.
)";

constexpr const char* kStabilityExamples = R"(Examples:
  selvage stability --list                     what there is to measure, and why it is hard
  selvage stability --family NAME --seed 1     one family, every arithmetic
  selvage stability --family NAME --arithmetic float32-dda --seed 17 --cases 1 --picture worst.png
  selvage stability --subject ./theirs.so      another mapper beside them: how wrong, and where

A subject promises nothing here but the accuracy that it claims, of its texels or its coverage: it
is measured, on scenes that it claims to draw; where it takes no perspective, on those in perspective without it,
so that what it lacks is measured, too. 'selvage verify' holds it to what it promises. Scene k of a
run is the family's scene of seed S + k, so the seed of a worst case names it alone.
)";

constexpr const char* kLawsExamples = R"(Examples:
  selvage laws
  selvage laws --json
)";

[[nodiscard]] std::string footer(const char* examples, const char* exit_codes = kUsualExitCodes) {
  return std::string(examples) + "\n" + exit_codes;
}

// The polygons and the picture on them.
void add_polygons(CLI::App& draw, DrawOptions& options) {
  draw.add_option("--texture", options.texture, "PNG or JPEG to draw with")
      ->required()
      ->type_name("FILE");
  CLI::Option* polygon =
      draw.add_option("--polygon", options.polygons,
                      "Vertices 'x,y,u,v[,w] ...' in pixels and texels; w is the distance along "
                      "the view axis, 1 if left out. May be repeated")
          ->type_name("TEXT")
          ->allow_extra_args(false);
  draw.add_option("--polygon-file", options.polygon_file, "The same from a small JSON file")
      ->type_name("FILE")
      ->excludes(polygon);
}

// Where they are drawn.
void add_target(CLI::App& draw, DrawOptions& options) {
  draw.add_option("--size", options.size,
                  "Size of the output; that of the background picture if left out")
      ->type_name("WxH");
  draw.add_option("--background", options.background, "#rgb, #rrggbb, #rrggbbaa, or a PNG or JPEG")
      ->type_name("COLOUR|FILE")
      ->capture_default_str();
  draw.add_option("--clip", options.clip,
                  "Draw only columns [l, r) and rows [t, b); wins over the polygon file")
      ->type_name("l,t,r,b");
}

// How they are drawn.
void add_manner(CLI::App& draw, DrawOptions& options) {
  draw.add_option("--address", options.address,
                  "Beyond the texture: clamp (the default) or wrap; wins over the polygon file")
      ->type_name("MODE");
  draw.add_option("--filter", options.filter,
                  "How texels make a pixel: nearest (the default), four, bilinear or area; wins "
                  "over the polygon file")
      ->type_name("NAME");
  draw.add_option("--tolerance", options.tolerance,
                  "How far u and v may be off, in texels, for speed; 0, the default, is exact. "
                  "Of use in perspective, by filter nearest and profile exact")
      ->type_name("TEXELS");
  draw.add_option("--profile", options.profile,
                  "Conventions to draw by: exact (the default), abrash56 and abrash57, which draw "
                  "clockwise outlines alone, or dkit; wins over the polygon file")
      ->type_name("NAME");
}

void add_output(CLI::App& draw, DrawOptions& options) {
  draw.add_option("--format", options.format,
                  "Format to draw in: rgba8888, rgb565 or index8 (levels of grey)")
      ->type_name("FORMAT")
      ->capture_default_str();
  draw.add_option("-o,--output", options.output, "PNG to write; - is the standard output")
      ->required()
      ->type_name("FILE");
  draw.add_option("--threads", options.threads,
                  "Draw with at most N threads; 0 takes all. The picture is the same")
      ->type_name("N")
      ->capture_default_str();
}

CLI::App* add_draw(CLI::App& program, DrawOptions& options) {
  CLI::App* draw = program.add_subcommand("draw", "Draw a picture onto polygons, to PNG");
  add_polygons(*draw, options);
  add_target(*draw, options);
  add_manner(*draw, options);
  add_output(*draw, options);
  draw->add_flag("--json", options.json, "Print size, covered pixels, time and methods as JSON");
  draw->footer(footer(kDrawExamples));
  return draw;
}

CLI::App* add_stability(CLI::App& program, StabilityOptions& options) {
  CLI::App* stability = program.add_subcommand(
      "stability", "Measure arithmetics against the exact model on numerically hard families");
  stability
      ->add_option("--family", options.families, "A hard family; all if left out. May be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  stability
      ->add_option("--arithmetic", options.arithmetics,
                   "An arithmetic; all if left out. May be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  stability->add_option("--seed", options.seed, "Seed of the first scene; a fresh one if left out")
      ->type_name("S");
  stability->add_option("--cases", options.cases, "Scenes of each family")
      ->type_name("N")
      ->capture_default_str();
  stability
      ->add_option("--picture", options.picture,
                   "PNG for the worst case of all (drawn | exact | difference)")
      ->type_name("FILE");
  add_library(*stability, options.subject,
              "A shared library that exports selvage_draw, to be measured beside them");
  add_claims(*stability, options.subject);
  stability->add_flag("--list", options.list, "List the families and the arithmetics instead");
  stability->add_flag("--json", options.json, "Print it as JSON");
  stability->footer(footer(kStabilityExamples, kStabilityExitCodes));
  return stability;
}

CLI::App* add_laws(CLI::App& program, bool& json) {
  CLI::App* laws = program.add_subcommand("laws", "List the laws, and which profile promises them");
  laws->add_flag("--json", json, "Print them as JSON");
  laws->footer(footer(kLawsExamples));
  return laws;
}

// An option that was given as an empty text would otherwise count as not given.
void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      if (value.empty()) throw UserError(option->get_name() + " is given without a value");
    }
  }
}

int parse_and_run(std::vector<std::string> arguments, const spec::Subject& subject,
                  const Console& console) {
  CLI::App program("Selvage: exact polygon texture mapping, and the laws it is held against",
                   "selvage");
  program.set_version_flag("--version", std::string("selvage ") + selvage_version());
  program.require_subcommand(1);
  program.footer(footer(kProgramExamples, kProgramExitCodes));
  DrawOptions draw_options;
  VerifyOptions verify_options;
  StabilityOptions stability_options;
  BenchOptions bench_options;
  MergeOptions merge_options;
  RenderOptions render_options;
  DemoOptions demo_options;
  bool laws_json = false;
  const CLI::App* draw = add_draw(program, draw_options);
  const CLI::App* render = add_render(program, render_options);
  const CLI::App* demo = add_demo(program, demo_options);
  const CLI::App* verify = add_verify(program, verify_options);
  const CLI::App* merge = add_merge(program, merge_options);
  const CLI::App* stability = add_stability(program, stability_options);
  const CLI::App* bench = add_bench(program, bench_options);
  add_laws(program, laws_json);
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  try {
    program.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error, console.out, console.err);
    throw usage_error(program, error);
  }
  refuse_empty_values(*program.get_subcommands().front());
  if (draw->parsed()) return run_draw(draw_options, console);
  if (render->parsed()) return run_render(render_options, console);
  if (demo->parsed()) return run_demo(demo_options, console);
  if (verify->parsed()) return run_verify(verify_options, subject, console);
  if (merge->parsed()) return run_merge(merge_options, console);
  if (stability->parsed()) return run_stability(stability_options, subject, console);
  if (bench->parsed()) return run_bench(bench_options, console);
  return run_laws(laws_json, console);
}

}  // namespace

int run_program(std::vector<std::string> arguments, const spec::Subject& subject,
                const Console& console) {
  try {
    const int code = parse_and_run(std::move(arguments), subject, console);
    if (!console.out.flush()) throw UserError("cannot write to the standard output");
    return code;
  } catch (const std::bad_alloc&) {
    console.err << "selvage: out of memory\n";
  } catch (const std::exception& error) {
    console.err << "selvage: " << error.what() << '\n';
  }
  return kExitUsage;
}

}  // namespace selvage::cli
