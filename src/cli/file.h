// The only file input and output of the program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace selvage::cli {

inline constexpr size_t kMaxFileBytes = size_t{256} << 20;

// The whole file, or a UserError that names it: missing, a directory, unreadable, too long.
[[nodiscard]] std::vector<uint8_t> read_file(const std::filesystem::path& path,
                                             size_t max_bytes = kMaxFileBytes);
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path,
                                         size_t max_bytes = kMaxFileBytes);

// Throws a UserError where write_file would: no such directory, the name of a directory or of a
// device, a file that may not be written, or that this program's own standard output or error goes
// to. Lets a command refuse before it does the work.
void check_output(const std::filesystem::path& path);

// Writes all bytes under a temporary name in the same directory, then renames: at every moment
// `path` is what it was before or complete. On a failure the temporary is removed.
void write_file(const std::filesystem::path& path, std::span<const uint8_t> bytes);
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace selvage::cli
