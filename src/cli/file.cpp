#include "cli/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <random>
#include <system_error>
#include <utility>

#include "cli/error.h"

namespace selvage::cli {
namespace {

namespace fs = std::filesystem;

[[nodiscard]] UserError failure(const std::string& doing, const fs::path& path, int error) {
  return UserError("cannot " + doing + " '" + path.string() +
                   "': " + std::generic_category().message(error));
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }
  // Closes early, for the error that a late write may report only here.
  [[nodiscard]] bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

template <typename Bytes>
Bytes read_all(const fs::path& path, size_t max_bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0) throw failure("read", path, errno);
  Bytes bytes;
  size_t used = 0;
  for (;;) {
    bytes.resize(used + std::max<size_t>(65536, used / 2));
    const ssize_t got = ::read(file.number(), bytes.data() + used, bytes.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw failure("read", path, errno);
    if (got == 0) break;
    used += static_cast<size_t>(got);
    if (used > max_bytes) {
      throw UserError("'" + path.string() + "' is longer than the " + std::to_string(max_bytes) +
                      " bytes that are accepted");
    }
  }
  bytes.resize(used);
  return bytes;
}

// A rename would take what a redirection points to away from it, all that it holds included.
void refuse_own_streams(const fs::path& path) {
  struct stat existing {};
  if (::stat(path.c_str(), &existing) != 0) return;
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat own {};
    if (::fstat(stream, &own) != 0 || own.st_dev != existing.st_dev ||
        own.st_ino != existing.st_ino) {
      continue;
    }
    throw UserError("cannot write '" + path.string() + "': it is this program's own standard " +
                    (stream == STDOUT_FILENO ? "output" : "error, where messages go") +
                    "; name another file");
  }
}

// Where the bytes go: a link keeps pointing where it points, and its target is replaced.
[[nodiscard]] fs::path resolve_output(const fs::path& path) {
  if (path.empty()) throw UserError("the name of the output file is empty");
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error && status.type() != fs::file_type::not_found) {
    throw failure("write", path, error.value());
  }
  if (fs::is_directory(status) || !path.has_filename()) {
    throw UserError("cannot write '" + path.string() +
                    "': it is a directory; the name of a file is needed");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw UserError("cannot write '" + path.string() +
                    "': it is not a regular file; one is needed");
  }
  refuse_own_streams(path);
  const fs::path resolved = fs::exists(status) ? fs::canonical(path) : path;
  if (fs::exists(status) && ::access(resolved.c_str(), W_OK) != 0) {
    throw failure("write", path, errno);
  }
  const fs::path directory = resolved.has_parent_path() ? resolved.parent_path() : ".";
  if (!fs::is_directory(directory, error)) {
    throw UserError("cannot write '" + path.string() + "': there is no directory '" +
                    directory.string() + "'");
  }
  if (::access(directory.c_str(), W_OK | X_OK) != 0) throw failure("write", path, errno);
  return resolved;
}

[[nodiscard]] fs::path temporary_beside(const fs::path& path) {
  std::random_device device;
  return path.parent_path() /
         (".selvage-" + std::to_string(device()) + "-" + std::to_string(device()) + ".tmp");
}

struct SystemFailure {
  int error;  // as in errno
};

void write_all(int descriptor, std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) throw SystemFailure{errno};
    bytes = bytes.subspan(static_cast<size_t>(put));
  }
}

// Creates `temporary` with the permissions of the file it will replace, if there is one.
void fill_temporary(const fs::path& temporary, const fs::path& replaced,
                    std::span<const uint8_t> bytes) {
  Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.number() < 0) throw SystemFailure{errno};
  struct stat existing {};
  if (::stat(replaced.c_str(), &existing) == 0 &&
      ::fchmod(file.number(), existing.st_mode & 0777) != 0) {
    throw SystemFailure{errno};
  }
  write_all(file.number(), bytes);
  if (::fsync(file.number()) != 0 || !file.close()) throw SystemFailure{errno};
}

}  // namespace

std::vector<uint8_t> read_file(const fs::path& path, size_t max_bytes) {
  return read_all<std::vector<uint8_t>>(path, max_bytes);
}

std::string read_text_file(const fs::path& path, size_t max_bytes) {
  return read_all<std::string>(path, max_bytes);
}

void check_output(const fs::path& path) { static_cast<void>(resolve_output(path)); }

void write_file(const fs::path& path, std::span<const uint8_t> bytes) {
  const fs::path resolved = resolve_output(path);
  const fs::path temporary = temporary_beside(resolved);
  try {
    fill_temporary(temporary, resolved, bytes);
    if (::rename(temporary.c_str(), resolved.c_str()) != 0) throw SystemFailure{errno};
  } catch (const SystemFailure& failed) {
    ::unlink(temporary.c_str());
    throw failure("write", path, failed.error);
  }
}

void write_text_file(const fs::path& path, std::string_view text) {
  write_file(path, std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
}

}  // namespace selvage::cli
