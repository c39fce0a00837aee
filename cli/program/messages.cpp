// SPDX-License-Identifier: MIT
#include "messages.hpp"

#include <stillpoint/report/document.hpp>

#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <system_error>

namespace stillpoint::cli {

namespace {

std::atomic<bool> silent{false};

}  // namespace

void hush() {
  silent = true;
}

bool hushed() {
  return silent;
}

void write_error(const std::string& text) {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

std::string words_of(const std::exception& error) {
  const auto* const of_system = dynamic_cast<const std::system_error*>(&error);
  // What the system says of a thread, and of nothing else that is done here.
  return of_system != nullptr && of_system->code() == std::errc::resource_unavailable_try_again
             ? fmt::format(
                   "no thread can be started ({}): end other programs, or raise the limits "
                   "that ulimit -u and ulimit -s show",
                   of_system->code().message())
             : error.what();
}

void say(const std::string& text) {
  write_error(fmt::format("stillpoint: {}\n", report::spelled_out(text)));
}

void remark(const std::string& text) {
  if (!silent && !text.empty()) {
    say(text);
  }
}

}  // namespace stillpoint::cli
