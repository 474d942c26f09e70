#include "reports/bench/machine.h"

#include <sys/utsname.h>

#include <array>
#include <ctime>
#include <sstream>
#include <thread>

#include "reports/bench/kernels.h"
#include "selvage.h"

namespace selvage::reports {

namespace {

// The value of the first line "key : value" of such lines, or of KEY="value".
std::string value_in(const std::string& text, const std::string& key, char separator) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const size_t at = line.find(separator);
    if (at == std::string::npos || line.compare(0, key.size(), key) != 0) continue;
    const size_t begin = line.find_first_not_of(" \t\"", at + 1);
    const size_t end = line.find_last_not_of(" \t\"");
    if (begin != std::string::npos) return line.substr(begin, end - begin + 1);
  }
  return "unknown";
}

// Those of the processor's features that a mapper's kernels may be built for.
std::string simd_of(const std::string& cpuinfo) {
  constexpr std::array known{"sse2",     "ssse3",       "sse4_1",  "sse4_2",   "avx",
                             "avx2",     "fma",         "avx512f", "avx512bw", "avx512dq",
                             "avx512vl", "avx512_vbmi", "asimd",   "sve",      "sve2"};
  std::istringstream have(value_in(cpuinfo, "flags", ':') + " " +
                          value_in(cpuinfo, "Features", ':'));
  std::string found;
  for (std::string flag; have >> flag;) {
    for (const char* name : known) {
      if (flag == name) found += (found.empty() ? "" : " ") + flag;
    }
  }
  return found.empty() ? "unknown" : found;
}

std::string names_of(const std::vector<selvage_kernel>& kernels) {
  std::string names;
  for (const selvage_kernel kernel : kernels) {
    if (!names.empty()) names += ' ';
    names += kernel_name(kernel);
  }
  return names;
}

std::string now_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &utc)};
}

}  // namespace

Machine describe_machine(const SystemTexts& texts) {
  utsname system{};
  uname(&system);
  return {{"date", now_utc()},
          {"cpu", value_in(texts.cpuinfo, "model name", ':')},
          {"cpu_family_model_stepping", value_in(texts.cpuinfo, "cpu family", ':') + "/" +
                                            value_in(texts.cpuinfo, "model\t", ':') + "/" +
                                            value_in(texts.cpuinfo, "stepping", ':')},
          {"cpu_simd", simd_of(texts.cpuinfo)},
          {"cache", value_in(texts.cpuinfo, "cache size", ':')},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"memory", value_in(texts.meminfo, "MemTotal", ':')},
          {"system", value_in(texts.os_release, "PRETTY_NAME", '=')},
          {"kernel", std::string(system.sysname) + " " + system.release + " " + system.machine},
          {"compiler", SELVAGE_REPORTS_COMPILER},
          {"flags_mapper", SELVAGE_REPORTS_FLAGS},
          {"flags_others", SELVAGE_REPORTS_FLAGS " -O3"},
          {"selvage", selvage_version()},
          {"selvage_kernels", names_of(kernels_here())},
          {"selvage_kernels_untested", names_of(kernels_elsewhere())},
          {"highway", SELVAGE_REPORTS_HIGHWAY_VERSION},
          {"threads", SELVAGE_REPORTS_THREADS},
          {"benchmark", "Google Benchmark " SELVAGE_REPORTS_BENCHMARK_VERSION}};
}

}  // namespace selvage::reports
