// SPDX-License-Identifier: MIT
#include "standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace stillpoint::cli {

namespace {

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

void open_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // A file gets the lowest number that is free: that of this stream.
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) < 0) {
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
