// SPDX-License-Identifier: MIT

// In theta = p tau and y = p^2 u the oscillator is
//
//     y'' + 2 zeta y' + y = -W,
//
// (1) of docs/records.md, and W is linear between two values. A step of theta is divided into parts
// of at most half a radian, in which the Taylor series (2) of y converges to the last bit.

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/records/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace stillpoint::records {

namespace {

constexpr double zeta = spectrum_damping;

/// Of a part: y'' then has at most one zero in it, as its zeros are pi/sqrt(1 - zeta^2) apart.
constexpr double longest_part = 0.5;

/// The series over one part, in s = theta/length from 0 to 1: y = sum d_n s^n.
class Series {
 public:
  /// y and y' at the beginning, W there and its change.
  Series(double y, double rate, double load, double change, double length) : length_(length) {
    const double square = length * length;
    d_[0] = y;
    d_[1] = rate * length;
    for (std::size_t n = 0; n + 2 < d_.size(); ++n) {
      const auto k = static_cast<double>(n);
      const double forcing = n == 0 ? load : n == 1 ? change : 0;
      d_[n + 2] = -((forcing + d_[n]) * square + 2 * zeta * (k + 1) * d_[n + 1] * length) /
                  ((k + 1) * (k + 2));
    }
  }

  [[nodiscard]] double y(double s) const { return derivative(0, s); }
  [[nodiscard]] double rate() const { return derivative(1, 1) / length_; }

  /// The largest |y| inside and at the end.
  [[nodiscard]] double largest() const {
    double most = std::abs(y(1));
    const double bend = zero(2, 0, 1).value_or(1);  // y' is monotone on both sides of it
    for (const auto& [from, to] : {std::pair{0.0, bend}, std::pair{bend, 1.0}}) {
      if (const auto turn = zero(1, from, to)) {
        most = std::max(most, std::abs(y(*turn)));
      }
    }
    return most;
  }

 private:
  /// With length^n/n! at most 0.5^17/17! = 2e-20, what is left out is below a double's last bit.
  static constexpr std::size_t terms = 17;

  /// By s.
  [[nodiscard]] double derivative(std::size_t order, double s) const {
    double sum = 0;
    for (std::size_t n = d_.size(); n-- > order;) {
      double factor = 1;
      for (std::size_t i = 0; i < order; ++i) {
        factor *= static_cast<double>(n - i);
      }
      sum = sum * s + factor * d_[n];
    }
    return sum;
  }

  /// Where a derivative changes its sign between `from` and `to`, by bisection to the last bit.
  [[nodiscard]] std::optional<double> zero(std::size_t order, double from, double to) const {
    const double first = derivative(order, from);
    if (!((first < 0 && derivative(order, to) > 0) || (first > 0 && derivative(order, to) < 0))) {
      return std::nullopt;
    }
    constexpr int halvings = 50;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (from + to) / 2;
      ((derivative(order, middle) > 0) == (first > 0) ? from : to) = middle;
    }
    return from;
  }

  std::array<double, terms> d_{};
  double length_;
};

/// An oscillator that starts at rest.
class LinearOscillator {
 public:
  /// W goes from `load` to `load + change` while theta grows by `angle`.
  void follow(double load, double change, double angle) {
    const double parts = std::max(std::ceil(angle / longest_part), 1.0);
    for (double part = 0; part < parts; ++part) {
      const Series series(y_, rate_, load + change * (part / parts), change / parts, angle / parts);
      most_ = std::max(most_, series.largest());
      y_ = series.y(1);
      rate_ = series.rate();
    }
  }

  [[nodiscard]] double most() const { return most_; }

 private:
  double y_{0};
  double rate_{0};
  double most_{0};
};

}  // namespace

double peak_acceleration(const Record& record) {
  double peak = 0;
  for (const double value : record.values) {
    peak = std::max(peak, std::abs(value));
  }
  return peak;
}

double mean_value(const Record& record) {
  double sum = 0;
  double length = 0;
  for (std::size_t i = 0; i + 1 < record.values.size(); ++i) {
    const double step = record.times.empty() ? record.step : record.times[i + 1] - record.times[i];
    sum += step * (record.values[i] + record.values[i + 1]) / 2;
    length += step;
  }
  return length > 0 ? sum / length : 0;
}

std::optional<double> mean_interval(const Record& record) {
  if (record.values.size() < 2) {
    return std::nullopt;
  }
  return record.times.empty() ? record.step
                              : (record.times.back() - record.times.front()) /
                                    static_cast<double>(record.times.size() - 1);
}

namespace {

/// A period may have come from a quotient: an ulp or two do not matter.
bool resolved(double period, double shortest) {
  constexpr double rounding = 1e-12;
  return period >= shortest * (1 - rounding);
}

/// The spectrum that is scaled to the target.
double own_spectrum(const Record& record, const std::string& path, const RecordClock& clock,
                    std::optional<double> p) {
  if (!p) {
    throw InputError::missing("record-spectrum-period",
                              "the motions may have several periods: give the one at which the "
                              "spectrum is scaled");
  }
  const double period = 2 * std::numbers::pi * clock.per_tau / *p;
  const double shortest = mean_interval(record).value_or(0) * clock.per_tau;
  if (!resolved(period, shortest)) {
    throw InputError(
        "record-spectrum-period", fmt::format("{} {}", period, clock.unit),
        fmt::format("must be at least {:.6g} {}, the mean time between two values of record {}",
                    shortest, clock.unit, path));
  }
  return spectral_acceleration(record, *p);
}

void require_target(const char* name, const std::optional<double>& target) {
  if (target) {
    require_physical(name, Dimension::gravities, *target);
  }
}

}  // namespace

double spectral_acceleration(const Record& record, double p) {
  const double period = 2 * std::numbers::pi / p;
  const double shortest = mean_interval(record).value_or(0);  // any
  if (!resolved(period, shortest)) {
    throw InputError(
        "record-spectrum-period", period,
        fmt::format("in tau must be at least {:.6g}, the mean time between two values", shortest));
  }
  const auto interval = [&record](std::size_t i) {
    return record.times.empty() ? record.step : record.times[i + 1] - record.times[i];
  };
  LinearOscillator oscillator;
  for (std::size_t i = 0; i + 1 < record.values.size(); ++i) {
    oscillator.follow(record.values[i], record.values[i + 1] - record.values[i], p * interval(i));
  }
  oscillator.follow(0, 0, 3.5);  // its first turn is at most pi/sqrt(1 - zeta^2) = 3.15 later
  return oscillator.most();
}

double factor_to_target(const RecordScale& scale, const Record& record, const std::string& path,
                        const RecordClock& clock) {
  const auto& [peak, spectrum] = scale.target;
  require_target("record-peak", peak);
  require_target("record-spectrum", spectrum);
  if (!scale.target.is_given()) {
    return 1;
  }
  const double own =
      spectrum ? own_spectrum(record, path, clock, scale.spectrum_p) : peak_acceleration(record);
  if (own == 0) {
    throw FileError({"record", path}, spectrum
                                          ? "moves no oscillator, so its spectrum cannot be scaled"
                                          : "is 0 throughout, so it cannot be scaled to a peak");
  }
  return (spectrum ? *spectrum : *peak) / own;
}

}  // namespace stillpoint::records
