// SPDX-License-Identifier: MIT
#include "messages.hpp"

#include <stillpoint/report/document.hpp>

#include <fmt/format.h>

#include <atomic>
#include <cstdio>

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
  // Nobody is left to be told that this failed.
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
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
