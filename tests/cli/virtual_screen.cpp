#include "virtual_screen.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace selvage::cli::test {
namespace {

// D-Bus and the X libraries, which SDL loads, keep some memory for as long as the process lives.
[[nodiscard]] std::string without_leaks() {
  const char* options = std::getenv("ASAN_OPTIONS");
  return std::string(options == nullptr ? "" : options) + ":detect_leaks=0";
}

[[noreturn]] void run(std::vector<std::string>& arguments, const std::string& display, int output) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  dup2(output, STDOUT_FILENO);
  if (display.empty()) {  // the server, which warns of much
    dup2(open("screen.log", O_CREAT | O_WRONLY | O_CLOEXEC, 0644), STDERR_FILENO);
  }
  if (!display.empty()) {
    setenv("DISPLAY", display.c_str(), 1);
    setenv("SDL_VIDEODRIVER", "x11", 1);
    setenv("ASAN_OPTIONS", without_leaks().c_str(), 1);
  }
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  execvp(words[0], words.data());
  _exit(127);
}

// Of an X window dump: 25 big-endian words of header, then a name, colours, rows.
class Dump {
 public:
  explicit Dump(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
    if (bytes_.size() < 100) throw std::runtime_error("no picture in " + path);
  }
  [[nodiscard]] uint32_t word(size_t index) const {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value = value << 8 | at(4 * index + i);
    return value;
  }
  [[nodiscard]] uint8_t at(size_t offset) const { return static_cast<uint8_t>(bytes_.at(offset)); }

 private:
  std::string bytes_;
};

}  // namespace

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

Child::Child(std::vector<std::string> arguments, const std::string& display) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  pid_ = fork();
  if (pid_ == 0) run(arguments, display, ends[1]);
  close(ends[1]);
  output_ = ends[0];
  if (pid_ < 0) throw std::runtime_error("no process");
}

Child::~Child() {
  if (pid_ > 0) {
    kill(pid_, SIGTERM);
    if (!await_end()) kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close(output_);
}

// It and all that it started have closed their ends of the pipe.
bool Child::await_end() const {
  pollfd wait{output_, POLLIN, 0};
  char buffer[4096];
  do {
    if (poll(&wait, 1, kPatience_s * 1000) <= 0) return false;
  } while (read(output_, buffer, sizeof buffer) > 0);
  return true;
}

std::string Child::read_line() {
  for (;;) {
    if (const size_t end = read_.find('\n'); end != std::string::npos) {
      const std::string line = read_.substr(0, end);
      read_.erase(0, end + 1);
      return line;
    }
    pollfd wait{output_, POLLIN, 0};
    if (poll(&wait, 1, kPatience_s * 1000) <= 0) throw std::runtime_error("no line in time");
    char buffer[4096];
    const ssize_t count = read(output_, buffer, sizeof buffer);
    if (count <= 0) throw std::runtime_error("the program ended instead of printing a line");
    read_.append(buffer, static_cast<size_t>(count));
  }
}

int Child::exit_code() {
  if (!await_end()) throw std::runtime_error("no end in time");
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// It tells the number of a free display when it is ready. Keys held down do not repeat (-r).
VirtualScreen::VirtualScreen(int width_px, int height_px)
    : server_({"Xvfb", "-displayfd", "1", "-r", "-nolisten", "tcp", "-fbdir", ".", "-screen", "0",
               std::to_string(width_px) + "x" + std::to_string(height_px) + "x24"},
              ""),
      display_(":" + server_.read_line()) {}

Raster VirtualScreen::picture() const {
  const Dump dump("Xvfb_screen0");
  const auto width_px = static_cast<int32_t>(dump.word(4));
  const auto height_px = static_cast<int32_t>(dump.word(5));
  const size_t pitch = dump.word(12), start = dump.word(0) + size_t{12} * dump.word(19);
  if (dump.word(7) != 0 || dump.word(11) != 32) throw std::runtime_error("unknown pixels");
  Raster picture = filled(width_px, height_px, {});
  for (int32_t y = 0; y < height_px; ++y) {
    for (int32_t x = 0; x < width_px; ++x) {
      const size_t pixel = start + static_cast<size_t>(y) * pitch + static_cast<size_t>(x) * 4;
      picture.set(x, y, {dump.at(pixel + 2), dump.at(pixel + 1), dump.at(pixel)});
    }
  }
  return picture;
}

void VirtualScreen::xdotool(const std::string& arguments) const {
  const std::string command = "DISPLAY=" + display_ + " timeout " + std::to_string(kPatience_s) +
                              " xdotool " + arguments + " >/dev/null";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

void VirtualScreen::await_window(const std::string& name) const {
  xdotool("search --sync --onlyvisible --name '^" + name + "$' windowfocus --sync");
}

void VirtualScreen::press(const std::string& keys) const { xdotool("key " + keys); }

}  // namespace selvage::cli::test
