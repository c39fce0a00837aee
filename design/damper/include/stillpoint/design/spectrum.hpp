// SPDX-License-Identifier: MIT
#pragma once

// What one damper does under a load when the period changes: docs/records-design.md section 5.

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/figures.hpp>
#include <stillpoint/design/finding.hpp>
#include <stillpoint/design/record_design.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::design {

struct SpectrumRequest {
  LoadCase load;          ///< without its limits and its weaker ones
  std::vector<double> p;  ///< of each point, in place of the p of:
  Oscillator damper{};
  std::optional<double> notch_width{};  ///< not beside a finite hold
  Threads threads{};
};

/// Those of one motion from x = 0, or combined for the motions under all records: of what
/// locks the earliest and the largest. Not at rest within 10 000 half-cycles counts as never.
struct SpectrumPoint {
  Figures with_notch;
  Figures without;  ///< the same with delta = 0
  double p{1};
};

/// A point for each p of the request.
struct Spectrum {
  SpectrumRequest request;                          ///< with the combination that was chosen
  std::vector<std::vector<SpectrumPoint>> motions;  ///< of each of the load, as motions_of
  std::vector<SpectrumPoint> combined;
  std::vector<Finding> findings;

  /// At how many points all motions come to rest.
  [[nodiscard]] std::size_t resting(Figures SpectrumPoint::*member) const;
};

/// `go_on`, if not empty, is called by several threads, but one at a time, with the fraction done;
/// if it returns false the rest is skipped and the spectrum is unusable. Throws InputError.
[[nodiscard]] Spectrum spectrum(const SpectrumRequest& request,
                                const std::function<bool(double)>& go_on = {});

/// In one line: at how many periods the notch lowers and raises each combined figure.
[[nodiscard]] std::string summary(const Spectrum& spectrum);

}  // namespace stillpoint::design
