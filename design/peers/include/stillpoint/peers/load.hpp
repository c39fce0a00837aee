// SPDX-License-Identifier: MIT
#pragma once

// W(tau) for integrators: smooth stretches with known ends.

#include <stillpoint/core/excitation.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <type_traits>
#include <variant>

namespace stillpoint::peers {

inline constexpr double for_ever = std::numeric_limits<double>::infinity();

struct NoLoad {
  double operator()(double /*t*/) const { return 0; }
  [[nodiscard]] static double stretch_end() { return for_ever; }
  /// The largest |W| from here on; infinite if it is not known, because more is to come.
  [[nodiscard]] static double largest() { return 0; }
  [[nodiscard]] static double next_look(double /*t*/) { return for_ever; }
  static bool next_stretch() { return false; }
};

/// Any sine, or its square: one kind, since integrators compile for long.
struct Wave : Harmonic {
  bool squared{false};
};
inline double load_at(const Wave& wave, double t) {
  const double sine = std::sin(wave.lambda * t + wave.phase);
  return wave.k * (wave.squared ? sine * sine : sine);
}

/// By the formula of the excitation up to its end, then 0.
template <class Law>
class LawLoad {
 public:
  explicit LawLoad(const Law& law) : law_(law), end_(duration(law).value_or(for_ever)) {}

  double operator()(double t) const { return load_at(law_, t); }
  [[nodiscard]] double stretch_end() const { return end_; }
  /// The largest |W| from here on; infinite if something else still comes.
  [[nodiscard]] double largest() const { return end_ == for_ever ? std::abs(law_.k) : for_ever; }
  /// When to look again at the load of a mass at rest: each crest is among the looks.
  [[nodiscard]] double next_look(double t) const {
    if constexpr (IsPolygon<Law>) {
      return for_ever;
    } else {
      constexpr double apart = std::numbers::pi / 16;
      constexpr double rounding = 1e-6;
      const double looks = std::floor((law_.lambda * t + law_.phase) / apart + rounding) + 1;
      return (looks * apart - law_.phase) / law_.lambda;
    }
  }
  /// Moves on to what follows; true: W jumps there.
  bool next_stretch() {
    law_.k = 0;
    end_ = for_ever;
    return true;
  }

 private:
  Law law_;
  double end_;
};

/// Straight lines between samples.
class RecordLoad {
 public:
  explicit RecordLoad(const Record& record) : record_(&record), end_(time(0)) {}

  double operator()(double t) const { return w_ + slope_ * (t - begin_); }
  [[nodiscard]] double stretch_end() const { return end_; }
  [[nodiscard]] double largest() const { return over() ? 0 : for_ever; }
  /// Checking the samples is enough: the largest load between is at one of them.
  [[nodiscard]] static double next_look(double /*t*/) { return for_ever; }
  bool next_stretch() {
    const std::size_t i = next_++;
    begin_ = end_;
    if (over()) {
      const bool jump = w_ + slope_ != 0;
      w_ = slope_ = 0;
      end_ = for_ever;
      return jump;
    }
    end_ = time(next_);
    w_ = record_->values[i];
    slope_ = (record_->values[i + 1] - w_) / (end_ - begin_);
    return i == 0;
  }

 private:
  [[nodiscard]] bool over() const { return next_ >= record_->values.size(); }
  [[nodiscard]] double time(std::size_t i) const {
    return record_->times.empty() ? record_->step * static_cast<double>(i) : record_->times[i];
  }

  const Record* record_;
  std::size_t next_{0};
  double begin_{0};
  double end_;
  double w_{0};
  double slope_{0};
};

/// Calls `action` with the load of an excitation.
template <class Action>
auto with_load(const Excitation& excitation, Action action) {
  return std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (std::is_same_v<Kind, NoExcitation>) {
          return action(NoLoad());
        } else if constexpr (std::is_same_v<Kind, Record>) {
          return action(RecordLoad(kind));
        } else if constexpr (IsSine<Kind>) {
          return action(
              LawLoad(Wave{{kind.k, kind.lambda, kind.phase, duration(kind)}, IsSquare<Kind>}));
        } else if constexpr (std::is_same_v<Kind, Rectangle>) {
          return action(LawLoad(kind));
        } else {
          const Record record = record_of(kind, *duration(kind));
          return action(RecordLoad(record));
        }
      },
      excitation);
}

}  // namespace stillpoint::peers
