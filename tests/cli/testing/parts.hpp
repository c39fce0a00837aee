// SPDX-License-Identifier: MIT
#pragma once

#include "refusal.hpp"

namespace stillpoint::cli_test {

/// Sweeps in parts, and the parts joined again.
struct Parts : Sandbox {
  /// How the names of their files end.
  explicit Parts(std::string extension);

  /// Computes part i of n into I-of-N.EXTENSION.
  [[nodiscard]] ProgramRun part(const Arguments& task, int i, int n, const Arguments& more = {},
                                const std::string& extension = "") const;
  /// Computes all parts, the last one first; their names.
  [[nodiscard]] Arguments split(const Arguments& task, int n,
                                const std::string& extension = "") const;
  /// Joins them into the file merged.
  [[nodiscard]] ProgramRun merge(const Arguments& parts, const Arguments& more = {}) const;

  /// Asserts that n parts make the bytes of the whole.
  void check_merged(const Arguments& task, int n, const std::string& extension = "") const;
  /// Asserts that they cannot be joined, why, and that nothing is written.
  void check_refused(const Arguments& parts, const Texts& says, const Arguments& more = {}) const;

 private:
  std::string extension_;
};

}  // namespace stillpoint::cli_test
