#include "cli/picture_output.h"

#include <filesystem>

#include "cli/error.h"
#include "cli/file.h"

namespace selvage::cli {
namespace {

[[nodiscard]] bool is_png_name(const std::string& name) {
  return std::filesystem::path(name).extension() == ".png";
}

void check_standard_output(const Console& console, bool is_taken) {
  if (is_taken) {
    throw UserError(
        "the picture and what is told of it cannot both go to the standard output; name a file in "
        "the place of -");
  }
  if (console.out_is_terminal) {
    throw UserError(
        "the standard output is a terminal, which shows no PNG; redirect it, or name a file in the "
        "place of -");
  }
}

[[nodiscard]] std::string right_names(PictureKinds kinds) {
  switch (kinds) {
    case PictureKinds::kFiles:
      return "a PNG; name it .png";
    case PictureKinds::kFilesOrOutput:
      return "a PNG; name it .png, or - for the standard output";
    default:
      return "a PNG or an animated PNG; name it .png or .apng, or - for a PNG on the standard "
             "output";
  }
}

}  // namespace

bool is_animation_name(const std::string& name) {
  return std::filesystem::path(name).extension() == ".apng";
}

void check_picture_name(const std::string& name, PictureKinds kinds) {
  const bool is_right = is_png_name(name) ||
                        (name == kStandardOutput && kinds != PictureKinds::kFiles) ||
                        (is_animation_name(name) && kinds == PictureKinds::kAnimationsToo);
  if (!is_right) {
    throw UserError("cannot write '" + name + "': the output is " + right_names(kinds));
  }
}

void check_picture(const std::string& name, PictureKinds kinds, const Console& console,
                   bool is_taken) {
  check_picture_name(name, kinds);
  if (name == kStandardOutput) return check_standard_output(console, is_taken);
  check_output(name);
}

void write_picture(const std::string& name, std::span<const uint8_t> bytes,
                   const Console& console) {
  if (name != kStandardOutput) return write_file(name, bytes);
  console.out.write(reinterpret_cast<const char*>(bytes.data()),
                    static_cast<std::streamsize>(bytes.size()));
}

}  // namespace selvage::cli
