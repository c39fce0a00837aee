// SPDX-License-Identifier: MIT
#pragma once

// What the fuzzers share: numbers from the bytes of an input, a file in memory, and what must hold
// for every refusal.

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>

#include <fmt/format.h>

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace stillpoint::fuzz {

/// Ends the program, as a sanitizer does, unless `holds`.
template <class... Parts>
void require(bool holds, fmt::format_string<Parts...> what, Parts&&... parts) {
  if (!holds) {
    fmt::print(stderr, "fuzz: {}\n", fmt::format(what, std::forward<Parts>(parts)...));
    std::abort();
  }
}

[[nodiscard]] inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// A message fits on a few lines of a terminal, whatever the input.
inline void require_short(std::string_view message) {
  constexpr std::size_t longest = 2000;
  require(!message.empty() && message.size() <= longest, "a message of {} bytes: {}",
          message.size(), message.substr(0, longest));
}

struct NoError {
  [[nodiscard]] static const char* what() { return ""; }
};

/// Runs `action`. False where it refuses its input, by one of the program's errors or by `More`;
/// any other exception is a fault and ends the program.
template <class More = NoError, class Action>
bool accepted(const Action& action) {
  std::string refusal;
  try {
    action();
    return true;
  } catch (const InputError& error) {
    refusal = error.what();
  } catch (const TooManyHalfCycles& error) {
    refusal = error.what();
  } catch (const records::FileError& error) {
    refusal = error.what();
  } catch (const More& error) {
    refusal = error.what();
  }
  require_short(refusal);
  return false;
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {std::bit_cast<const char*>(data), size};
}

/// Splits off what stands before `separator`, which goes; without one everything.
inline std::string_view take(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view head = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return head;
}

/// For what reads a path.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    require(descriptor_ >= 0, "no memory file");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(descriptor_); }

  /// Puts `text` in place of what is there.
  void hold(std::string_view text) const {
    require(::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, text.data(), text.size(),
                                                         0) == static_cast<ssize_t>(text.size()),
            "a memory file cannot be written");
  }
  [[nodiscard]] std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

 private:
  int descriptor_;
};

/// Numbers from the bytes of an input, and 0 after its end.
class Numbers {
 public:
  Numbers(const std::uint8_t* data, std::size_t size) : rest_(text_of(data, size)) {}

  [[nodiscard]] bool any() const { return !rest_.empty(); }

  /// 0, 1, ..., count - 1.
  unsigned below(unsigned count) { return static_cast<unsigned>(bits(1)) % count; }
  bool once_in(unsigned times) { return below(times) == 1; }

  /// In [low, high].
  double uniform(double low, double high) {
    constexpr double most = 0xFFFFFFFFU;
    return low + (high - low) * (static_cast<double>(bits(4)) / most);
  }
  /// Evenly in the exponent.
  double power_of_ten(double low, double high) { return std::pow(10.0, uniform(low, high)); }
  /// Any double at all.
  double raw() { return std::bit_cast<double>(bits(8)); }
  /// Some steps of the last place beside a value.
  double beside(double value) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) + below(7) - 3);
  }

 private:
  std::uint64_t bits(std::size_t bytes) {
    std::array<char, 8> word{};
    bytes = std::min(bytes, rest_.size());
    rest_.copy(word.data(), bytes);
    rest_.remove_prefix(bytes);
    return std::bit_cast<std::uint64_t>(word);
  }

  std::string_view rest_;
};

}  // namespace stillpoint::fuzz
