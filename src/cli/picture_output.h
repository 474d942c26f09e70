// Where pictures go: into files, whose names tell what they are, or to the standard output.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "cli/console.h"

namespace selvage::cli {

// The name by which a command that writes one picture is told to write it to the standard output.
inline constexpr std::string_view kStandardOutput = "-";

[[nodiscard]] bool is_animation_name(const std::string& name);  // .apng

// What a command can write: files alone, whose names end in .png, the standard output in their
// place, or a file whose name ends in .apng, too.
enum class PictureKinds { kFiles, kFilesOrOutput, kAnimationsToo };

// These let a command refuse before it does the work. A UserError says what would be right.
void check_picture_name(const std::string& name, PictureKinds kinds);
// The name, and where it leads: as check_output has it, and to no standard output that is a
// terminal, or that `is_taken` by other lines.
void check_picture(const std::string& name, PictureKinds kinds, const Console& console,
                   bool is_taken = false);

void write_picture(const std::string& name, std::span<const uint8_t> bytes, const Console& console);

}  // namespace selvage::cli
