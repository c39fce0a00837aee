// SPDX-License-Identifier: MIT
#include "run_program.hpp"

#include "json_schema.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>
#include <stop_token>
#include <thread>

namespace stillpoint::cli_test {

namespace {

void require(bool success, const char* what, int error = errno) {
  if (!success) {
    throw std::system_error(error, std::generic_category(), what);
  }
}

/// Closed with its last owner.
using Descriptor = std::shared_ptr<const int>;

Descriptor descriptor(int number) {
  return {new int(number), [](const int* held) {
            ::close(*held);  // -1 is none
            delete held;
          }};
}

/// What the parent reads and what the program writes to.
struct Channel {
  Descriptor reader;
  Descriptor writer;
};

Channel pipe_channel() {
  std::array<int, 2> ends{};
  require(::pipe2(ends.data(), O_CLOEXEC) == 0, "pipe2");
  return {descriptor(ends[0]), descriptor(ends[1])};
}

Channel terminal_channel() {
  int terminal = -1;
  int shell = -1;
  require(::openpty(&terminal, &shell, nullptr, nullptr, nullptr) == 0, "openpty");
  require(::fcntl(terminal, F_SETFD, FD_CLOEXEC) == 0, "fcntl");
  require(::fcntl(shell, F_SETFD, FD_CLOEXEC) == 0, "fcntl");
  return {descriptor(terminal), descriptor(shell)};
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A file without a name that holds `text`, at its beginning.
File input_file(const std::string& text) {
  File file(std::tmpfile(), &std::fclose);
  require(file != nullptr, "tmpfile");
  require(std::fwrite(text.data(), 1, text.size(), file.get()) == text.size(), "fwrite");
  require(std::fflush(file.get()) == 0, "fflush");
  require(::lseek(::fileno(file.get()), 0, SEEK_SET) == 0, "lseek");
  return file;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  list.reserve(texts.size() + 1);
  for (std::string& text : texts) {
    list.push_back(text.data());
  }
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> environment(const Surroundings& surroundings) {
  // The first value of a name stays.
  std::map<std::string, std::string> variables(surroundings.environment.begin(),
                                               surroundings.environment.end());
  variables.emplace("TERM", "xterm");
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string assignment = *entry;
    const std::size_t sign = assignment.find('=');
    const std::string name = assignment.substr(0, sign);
    if (name != "NO_COLOR" && sign != std::string::npos) {
      variables.emplace(name, assignment.substr(sign + 1));
    }
  }
  std::vector<std::string> list;
  for (const auto& [name, value] : variables) {
    list.push_back(name);
    list.back().append("=").append(value);
  }
  return list;
}

/// Starts the program in that directory with three streams from standard input on,
/// and with SIGINT as for one in the foreground, wherever the tests run.
pid_t start(const std::string& program, const std::filesystem::path& directory,
            const std::array<int, 3>& streams, char* const* words, char* const* variables) {
  const pid_t child = ::fork();
  require(child >= 0, "fork");
  if (child > 0) {
    return child;
  }
  bool ready = ::chdir(directory.c_str()) == 0 && ::signal(SIGINT, SIG_DFL) != SIG_ERR;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    ready = ready && ::dup2(streams[i], static_cast<int>(i)) >= 0;
  }
  if (ready) {
    ::execve(program.c_str(), words, variables);
  }
  ::_exit(127);
}

using Clock = std::chrono::steady_clock;

/// Whether the process has a handler for SIGINT.
bool handles_interrupt(pid_t child) {
  std::ifstream status("/proc/" + std::to_string(child) + "/status");
  const std::string field = "SigCgt:";
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(field)) {
      const auto caught = std::stoull(line.substr(field.size()), nullptr, 16);
      return (caught >> (SIGINT - 1U) & 1U) != 0;
    }
  }
  return false;
}

/// Sends the signal once its time has come, an interrupt once the program handles it, unless the
/// program has `ended` before.
void send_signal(pid_t child, const Surroundings& surroundings, const std::stop_token& ended) {
  const auto due = [&] {
    return surroundings.interrupt ? handles_interrupt(child) : surroundings.signal_when();
  };
  while ((surroundings.interrupt || surroundings.signal_when) && !ended.stop_requested()) {
    if (due()) {
      ::kill(child, surroundings.signal);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// Reads both until the program has closed them, and calls `heard` after each piece; false where
/// that takes too long.
bool read_both(int out, int err, ProgramRun& run, Clock::time_point deadline,
               const std::function<void()>& heard) {
  std::array<pollfd, 2> watched{pollfd{out, POLLIN, 0}, pollfd{err, POLLIN, 0}};
  const std::array<std::string*, 2> texts{&run.out, &run.err};
  std::vector<char> buffer(std::size_t{1} << 16U);
  while (watched[0].fd >= 0 || watched[1].fd >= 0) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) {
      return false;
    }
    const int ready = ::poll(watched.data(), watched.size(), static_cast<int>(left));
    require(ready >= 0 || errno == EINTR, "poll");
    for (std::size_t i = 0; ready > 0 && i < watched.size(); ++i) {
      if (watched[i].fd < 0 || watched[i].revents == 0) {
        continue;
      }
      const ssize_t count = ::read(watched[i].fd, buffer.data(), buffer.size());
      if (count > 0) {
        texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
        heard();
      } else if (count == 0 || errno != EINTR) {
        watched[i].fd = -1;  // closed; a terminal says so with EIO
      }
    }
  }
  return true;
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    require(errno == EINTR, "waitpid");
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Every report of every test goes through its schema: on standard output, and in the file asked
/// for.
void check_reports(const Sandbox& sandbox, const Arguments& arguments, const ProgramRun& run) {
  if (run.exit_code < 0 || run.exit_code == 2) {
    return;  // a run that was killed, or that has nothing to report
  }
  check_report_schema(run.out);
  const auto option = std::ranges::find(arguments, "--output");
  if (option != arguments.end() && option + 1 != arguments.end()) {
    const std::filesystem::path file = sandbox.path(*(option + 1));
    std::error_code none;
    if (std::filesystem::is_regular_file(file, none)) {
      check_report_schema(sandbox.read(*(option + 1)));
    }
  }
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> ProgramRun::err_lines() const {
  return lines_of(err);
}

std::string built_program() {
  return STILLPOINT_PROGRAM;
}

ProgramRun Sandbox::run(const Arguments& arguments, const Surroundings& surroundings) const {
  const std::string program = surroundings.program.empty() ? built_program() : surroundings.program;
  Arguments words = Arguments{program} + arguments;
  std::vector<std::string> variables = environment(surroundings);
  const File input = input_file(surroundings.input);
  Channel out = surroundings.output_is_terminal ? terminal_channel() : pipe_channel();
  Channel err = surroundings.error_is_terminal ? terminal_channel() : pipe_channel();
  const pid_t child = start(program, path(""), {::fileno(input.get()), *out.writer, *err.writer},
                            pointers(words).data(), pointers(variables).data());
  out.writer.reset();
  err.writer.reset();
  const auto deadline = Clock::now() + surroundings.patience;
  std::jthread sender([&surroundings, child](const std::stop_token& ended) {
    send_signal(child, surroundings, ended);
  });
  ProgramRun result;
  bool awaited = !surroundings.interrupt_at.empty();
  const bool in_time = read_both(*out.reader, *err.reader, result, deadline, [&] {
    if (awaited && contains(result.err, surroundings.interrupt_at)) {
      ::kill(child, SIGINT);
      awaited = false;
    }
  });
  if (!in_time) {
    ::kill(child, SIGKILL);
  }
  sender.request_stop();
  sender.join();  // before the number of the child may become another's
  result.exit_code = wait_for(child);
  check_reports(*this, arguments, result);
  return result;
}

ProgramRun Sandbox::ending(int exit_code, const Arguments& arguments,
                           const Surroundings& surroundings) const {
  ProgramRun done = run(arguments, surroundings);
  BOOST_TEST_REQUIRE(done.exit_code == exit_code,
                     "exit code " << done.exit_code << ", not " << exit_code << ": " << done.err);
  return done;
}

ProgramRun Sandbox::succeed(const Arguments& arguments, const Surroundings& surroundings) const {
  return ending(0, arguments, surroundings);
}

std::map<std::string, std::string> Sandbox::contents() const {
  constexpr std::uintmax_t large = std::uintmax_t{1} << 20U;
  std::map<std::string, std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path(""))) {
    const std::string name = entry.path().lexically_relative(path("")).string();
    if (entry.is_symlink()) {
      found[name] = std::filesystem::read_symlink(entry.path()).string();
    } else if (entry.is_directory()) {
      found[name] = "/";
    } else if (::access(entry.path().c_str(), R_OK) != 0) {
      found[name] = "unreadable";
    } else {
      found[name] = entry.file_size() > large ? std::to_string(entry.file_size()) : read(name);
    }
  }
  return found;
}

boost::test_tools::assertion_result if_terminals(boost::unit_test::test_unit_id /*unit*/) {
  int terminal = -1;
  int shell = -1;
  if (::openpty(&terminal, &shell, nullptr, nullptr, nullptr) != 0) {
    return false;
  }
  ::close(terminal);
  ::close(shell);
  return true;
}

Arguments::Arguments(const char* line) {
  static const std::regex word("'([^']*)'|(\\S+)");
  for (std::cregex_iterator match(line, line + std::strlen(line), word), none; match != none;
       ++match) {
    push_back((*match)[1].matched ? (*match)[1].str() : (*match)[2].str());
  }
}

Arguments operator+(Arguments head, const Arguments& tail) {
  head.insert(head.end(), tail.begin(), tail.end());
  return head;
}

std::string in_full(double value) {
  std::array<char, 32> digits{};
  char* const begin = digits.data();
  return {begin, std::to_chars(begin, begin + digits.size(), value).ptr};
}

}  // namespace stillpoint::cli_test
