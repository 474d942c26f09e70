#include "cli/file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>
#include <utility>

#include "support.h"

namespace selvage::cli::test {
namespace {

using File = InDirectory;
using Bytes = std::vector<uint8_t>;
using Names = std::vector<std::string>;

TEST_F(File, IsReadAsItWasWritten) {
  for (const size_t size : {0u, 1u, 65535u, 65536u, 65537u, 1000000u}) {
    Bytes bytes(size);
    for (size_t i = 0; i < size; ++i) bytes[i] = static_cast<uint8_t>(i * 31 >> 3);
    write_file("out", bytes);
    EXPECT_EQ(read_file("out"), bytes);
  }
  EXPECT_EQ(files(), Names{"out"});
}

TEST_F(File, ThatIsMissingIsNamed) {
  const std::string error = error_of([] { static_cast<void>(read_file("no/such.png")); });
  EXPECT_EQ(error, "cannot read 'no/such.png': No such file or directory");
}

TEST_F(File, ThatIsADirectoryCannotBeRead) {
  expect_contains(error_of([] { static_cast<void>(read_file(".")); }), "Is a directory");
}

TEST_F(File, LongerThanTheLimitIsRefused) {
  put("ten", "0123456789");
  EXPECT_EQ(read_text_file("ten", 10), "0123456789");
  expect_contains(error_of([] { static_cast<void>(read_text_file("ten", 9)); }), "longer than");
  expect_contains(error_of([] { static_cast<void>(read_file("/dev/zero", 1 << 20)); }),
                  "longer than");
}

TEST_F(File, CannotBeWrittenIntoAMissingDirectory) {
  const std::string error = error_of([] { write_file("no/such/out.png", Bytes{1}); });
  EXPECT_EQ(error, "cannot write 'no/such/out.png': there is no directory 'no/such'");
  EXPECT_EQ(error_of([] { check_output("no/such/out.png"); }), error);
  EXPECT_EQ(files(), Names{});
}

TEST_F(File, CannotBeWrittenOverADirectory) {
  std::filesystem::create_directory("out");
  for (const char* name : {"out", "out/", "."}) {
    expect_contains(error_of([&] { write_file(name, Bytes{1}); }), "it is a directory");
    expect_contains(error_of([&] { check_output(name); }), "it is a directory");
  }
  EXPECT_EQ(files(), Names{"out"});
}

TEST_F(File, CannotBeWrittenBelowAFile) {
  put("plain", "kept");
  const std::string error = error_of([] { write_file("plain/out", Bytes{1}); });
  expect_contains(error, "cannot write 'plain/out'");
  EXPECT_EQ(get("plain"), "kept");
}

// A rename over a device would replace it.
TEST_F(File, CannotBeWrittenOverADevice) {
  ASSERT_EQ(mkfifo("pipe", 0600), 0);
  for (const char* name : {"/dev/null", "pipe"}) {
    expect_contains(error_of([&] { write_file(name, Bytes{1}); }), "not a regular file");
  }
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

// What a redirection points to would be replaced, and whatever it held before lost.
TEST_F(File, CannotBeWrittenOverTheOwnStandardOutput) {
  put("log.png", "kept");
  std::filesystem::create_symlink("/proc/self/fd/1", "link.png");
  const auto refused = [](const char* name) {
    const std::string error = error_of([&] { write_file(name, Bytes{1}); });
    EXPECT_EQ(error_of([&] { check_output(name); }), error);
    return error;
  };
  for (const auto& [stream, is] :
       {std::pair(STDOUT_FILENO, "output"), std::pair(STDERR_FILENO, "error, where messages go")}) {
    const int before = dup(stream), log = open("log.png", O_WRONLY | O_APPEND);
    dup2(log, stream);
    const std::string by_name = refused("log.png");
    const std::string by_link = stream == STDOUT_FILENO ? refused("link.png") : by_name;
    dup2(before, stream);
    close(before);
    close(log);
    EXPECT_EQ(by_name, "cannot write 'log.png': it is this program's own standard " +
                           std::string(is) + "; name another file");
    expect_contains(by_link, is);
    EXPECT_EQ(get("log.png"), "kept");
  }
}

TEST_F(File, NeedsAName) {
  expect_contains(error_of([] { write_file("", Bytes{1}); }), "name of the output file is empty");
}

TEST_F(File, KeepsPermissionsAndLinks) {
  put("real", "old");
  ASSERT_EQ(chmod("real", 0640), 0);
  std::filesystem::create_symlink("real", "link");
  write_file("link", Bytes{'n', 'e', 'w'});
  EXPECT_TRUE(std::filesystem::is_symlink("link"));
  EXPECT_EQ(get("real"), "new");
  struct stat status {};
  ASSERT_EQ(stat("real", &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

// In a child whose files may not grow beyond 4096 bytes: the write fails in the middle.
int write_with_no_room(const Bytes& bytes) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{4096, 4096};
    std::signal(SIGXFSZ, SIG_IGN);
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(9);
    try {
      write_file("out", bytes);
    } catch (const UserError& error) {
      _exit(std::string(error.what()) == "cannot write 'out': File too large" ? 7 : 8);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(File, ThatCannotBeFinishedLeavesNothingBehind) {
  EXPECT_EQ(write_with_no_room(Bytes(100000)), 7);
  EXPECT_EQ(files(), Names{});
  EXPECT_EQ(write_with_no_room(Bytes(4096)), 0);  // the limit itself is not what failed
  EXPECT_EQ(files(), Names{"out"});
}

TEST_F(File, ThatCannotBeFinishedKeepsTheOldOne) {
  put("out", "old");
  EXPECT_EQ(write_with_no_room(Bytes(100000)), 7);
  EXPECT_EQ(get("out"), "old");
  EXPECT_EQ(files(), Names{"out"});
}

TEST_F(File, IsCompleteAtEveryMoment) {
  const std::string old_text(300000, 'a');
  const std::string new_text(200000, 'b');
  put("out", old_text);
  std::atomic<bool> done{false};
  std::atomic<int> torn{0};
  std::thread reader([&] {
    while (!done) {
      const std::string seen = get("out");
      if (seen != old_text && seen != new_text) ++torn;
    }
  });
  for (int i = 0; i < 20; ++i) {
    const std::string& text = i % 2 == 0 ? new_text : old_text;
    write_file("out", Bytes(text.begin(), text.end()));
  }
  done = true;
  reader.join();
  EXPECT_EQ(torn, 0);
}

}  // namespace
}  // namespace selvage::cli::test
