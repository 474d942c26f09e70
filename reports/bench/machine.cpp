#include "reports/bench/machine.h"

#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <string>
#include <thread>

#include "selvage.h"

namespace selvage::reports {

namespace {

// The value of the first line "key : value" of a file of such lines, or of KEY="value".
std::string value_in(const char* path, const std::string& key, char separator) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const size_t at = line.find(separator);
    if (at == std::string::npos || line.compare(0, key.size(), key) != 0) continue;
    const size_t begin = line.find_first_not_of(" \t\"", at + 1);
    const size_t end = line.find_last_not_of(" \t\"");
    if (begin != std::string::npos) return line.substr(begin, end - begin + 1);
  }
  return "unknown";
}

std::string now_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &utc)};
}

}  // namespace

nlohmann::ordered_json describe_machine() {
  utsname system{};
  uname(&system);
  return {{"date", now_utc()},
          {"cpu", value_in("/proc/cpuinfo", "model name", ':')},
          {"cpu_family_model_stepping", value_in("/proc/cpuinfo", "cpu family", ':') + "/" +
                                            value_in("/proc/cpuinfo", "model\t", ':') + "/" +
                                            value_in("/proc/cpuinfo", "stepping", ':')},
          {"cache", value_in("/proc/cpuinfo", "cache size", ':')},
          {"cores", std::thread::hardware_concurrency()},
          {"memory", value_in("/proc/meminfo", "MemTotal", ':')},
          {"system", value_in("/etc/os-release", "PRETTY_NAME", '=')},
          {"kernel", std::string(system.sysname) + " " + system.release + " " + system.machine},
          {"compiler", SELVAGE_REPORTS_COMPILER},
          {"flags_mapper", SELVAGE_REPORTS_FLAGS},
          {"flags_others", SELVAGE_REPORTS_FLAGS " -O3"},
          {"selvage", selvage_version()},
          {"benchmark", "Google Benchmark " SELVAGE_REPORTS_BENCHMARK_VERSION}};
}

}  // namespace selvage::reports
