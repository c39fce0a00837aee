// SPDX-License-Identifier: MIT
#include "machine.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gsl/gsl_version.h>
#include <boost/version.hpp>
#ifdef STILLPOINT_BENCH_CVODE
#include <sundials/sundials_config.h>
#endif

#include <ctime>
#include <fstream>
#include <string_view>
#include <thread>

namespace stillpoint::bench {

namespace {

/// What follows `key` and `separator` in the first line of a file that begins with it.
std::string value_in(const char* file_name, std::string_view key, char separator,
                     const char* otherwise) {
  std::ifstream file(file_name);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key)) {
      const std::size_t begin = line.find_first_not_of(" \"", line.find(separator) + 1);
      const std::size_t end = line.find_last_not_of('"');
      return begin == std::string::npos ? otherwise : line.substr(begin, end + 1 - begin);
    }
  }
  return otherwise;
}

std::string compiler() {
#ifdef __clang__
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown compiler";
#endif
}

}  // namespace

Machine this_machine() {
  Machine machine;
  machine.processor = value_in("/proc/cpuinfo", "model name", ':', "unknown processor");
  machine.cores = std::thread::hardware_concurrency();
  machine.system = value_in("/etc/os-release", "PRETTY_NAME", '=', "unknown system");
  machine.compiler = compiler();
  machine.flags = STILLPOINT_BENCH_FLAGS;
  machine.libraries = {
      fmt::format("Boost {}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000),
      "GSL " GSL_VERSION};
#ifdef STILLPOINT_BENCH_CVODE
  machine.libraries.emplace_back("SUNDIALS " SUNDIALS_VERSION);
#endif
  machine.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
  return machine;
}

}  // namespace stillpoint::bench
