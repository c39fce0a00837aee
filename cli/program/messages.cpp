// SPDX-License-Identifier: MIT
#include "messages.hpp"

#include <stillpoint/report/document.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

namespace stillpoint::cli {

namespace {

std::atomic<bool> silent{false};

std::atomic<bool> nobody_reads{false};  // without a lock, as a handler needs it
static_assert(std::atomic<bool>::is_always_lock_free);

/// Unless the program was started with the signal ignored, which has the same effect. A handler,
/// unlike that, is not handed on to a browser.
void handle(int signal, void (*handler)(int)) {
  if (std::signal(signal, handler) == SIG_IGN) {
    std::signal(signal, SIG_IGN);
  }
}

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

void open_closed_streams(bool output_is_lost) {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // A file gets the lowest number that is free: that of this stream.
    const int use = stream == STDOUT_FILENO && output_is_lost ? O_RDONLY : O_RDWR;
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", use) < 0) {
      throw std::system_error(errno, std::generic_category(), "/dev/null");
    }
  }
}

void outlive_failed_writes() {
  handle(SIGXFSZ, [](int /*signal*/) {});
  handle(SIGPIPE, [](int /*signal*/) { nobody_reads = true; });
}

void end_if_nobody_reads() {
  if (nobody_reads) {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
}

}  // namespace stillpoint::cli
