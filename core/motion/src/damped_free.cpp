// SPDX-License-Identifier: MIT
#include "damped_free.hpp"

#include "kernel/certain_passages.hpp"
#include "kernel/damped_swing-inl.hpp"
#include "kernel/damped_terms.hpp"
#include "kernel/phase_clock.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace stillpoint {

namespace {

using Swing = HWY_NAMESPACE::DampedSwing<double>;

constexpr std::uint64_t between_looks = 1U << 16U;  // passages: some milliseconds

/// The decisions of a run, as ForcedRun weighs them; none if nobody asks.
class Decisions {
 public:
  Decisions(const DampedFree& motion, bool wanted) : motion_(motion), wanted_(wanted) {
    if (motion.speed > 0 && motion.notch > 0) {
      between(motion.speed * motion.speed, motion.notch);
    }
  }

  [[nodiscard]] const TippingMargin<double>& margin() const { return margin_; }

  /// `peak` away from x = 0, after a slide that took so long: does it turn there, and is it held?
  void turn(double peak, double slid, double farthest) {
    if (wanted_) {
      const double time = std::min(slid, 2.0);
      margin_.decide(peak, farthest + motion_.phi * (time * time / 2));
      between(peak, motion_.held);
    }
  }

  void arrival(double energy, double farthest) {
    if (wanted_) {
      between(energy, motion_.notch);
      margin_.decide(energy, energy + farthest * farthest);  // against a turn before x = 0
    }
  }

 private:
  void between(double a, double b) { margin_.decide(std::abs(a - b), a + b); }

  const DampedFree& motion_;
  bool wanted_;
  TippingMargin<double> margin_;
};

/// Adds what a batch has not got to the response.
class DampedRun {
 public:
  DampedRun(const DampedFree& motion, const FreeOptions& options)
      : motion_(motion), limit_(options.half_cycle_limit), decisions_(motion, options.margin) {}

  [[nodiscard]] Response response() {
    follow();
    Response response = response_of(motion_, end_);
    response.peak_acceleration = largest_acceleration(motion_);
    response.peak_absolute_acceleration = response.peak_acceleration;
    if (motion_.notch == 0 && end_.passages > 0) {
      arrival_ = swing_.arrival(end_.peak).speed;
    }
    if (end_.passages > 0 || end_.at_zero) {
      response.arrival_speed = arrival_;
    }
    const double jump = motion_.notch == 0 || end_.passages == 0
                            ? 0.0
                            : motion_.notch / (passed_ + speed_);  // the last passage takes most
    response.jump = end_.at_zero ? std::max(arrival_, jump) : jump;
    if (decisions_.margin().any()) {
      response.decision_margin = decisions_.margin().value();
    }
    return response;
  }

 private:
  void require_few_passages() const {
    const double turn = first_peak(motion_) * motion_.p;
    const double certain =
        certain_passages(turn, motion_.held, motion_.notch, motion_.cycle.zeta, limit_ - 1,
                         [&](double u) { return 4 * motion_.phi * u; });
    if (certain > limit_ - 1) {
      throw TooManyHalfCycles::at_least(certain, limit_);
    }
  }

  void follow() {
    require_few_passages();
    speed_ = motion_.speed;
    end_.peak = motion_.peak;
    while (half_cycle()) {
      end_.passages += 1;
      if (end_.passages > limit_ - 1) {
        const double phase = motion_.cycle.swing * end_.passages + end_.phase;
        throw TooManyHalfCycles::under_excitation(limit_, phase / motion_.p);
      }
      if (static_cast<std::uint64_t>(end_.passages) % between_looks == 0) {
        cancellation_point();
      }
    }
  }

  /// Up to x = 0 on the other side, and past it: true if it goes on from there.
  bool half_cycle() {
    double slid = motion_.cycle.swing;
    if (speed_ > 0 && (motion_.notch > 0 || end_.passages == 0)) {
      const auto up = swing_.reach(speed_);
      end_.peak = swing_.peak(up);
      end_.phase += up.time;
      slid = end_.passages == 0 ? up.time : slid;
    }
    end_.farthest = std::max(end_.farthest, end_.peak);
    end_.excursion = swing_.next(end_.peak);
    decisions_.turn(end_.peak, slid, end_.farthest);
    if (end_.peak <= motion_.held) {
      return false;
    }
    if (end_.excursion < 0) {
      decisions_.turn(-end_.excursion, motion_.cycle.swing, end_.farthest);
      return false;
    }
    if (motion_.notch == 0) {
      end_.peak = end_.excursion;
      return true;
    }
    const auto back = swing_.arrival(end_.excursion);
    const double left = back.energy - motion_.notch;
    end_.phase -= back.time;
    arrival_ = back.speed;
    decisions_.arrival(back.energy, end_.farthest);
    if (!(left > 0)) {
      end_.at_zero = true;
      return false;
    }
    passed_ = back.speed;
    speed_ = std::sqrt(left);
    return true;
  }

  const DampedFree& motion_;
  Swing swing_{motion_.phi, motion_.cycle.zeta, motion_.cycle.decay};
  double limit_;
  Decisions decisions_;
  double speed_{0};    ///< with which it leaves x = 0
  double arrival_{0};  ///< at x = 0, the last
  double passed_{0};   ///< the same, the last after which it went on
  DampedEnd end_;
};

}  // namespace

DampedCycle damped_cycle(double zeta) {
  const double swing = pi<double>() / swing_rate(zeta);
  return {zeta, swing, elementary::exp(-zeta * swing)};
}

std::optional<DampedFree> damped_free(const Oscillator& oscillator, const Start& start,
                                      const DampedCycle& cycle) {
  constexpr double clear = 1 + 1e-14;
  constexpr double most = 0x1p200;  // fourth powers of speeds stay within the range of a double
  const auto within = [](double value) { return value >= 1 / most && value <= most; };
  const double phi = oscillator.f / oscillator.p;
  const double notch = 2 * oscillator.delta;
  const double speed = std::abs(start.v0);
  const double peak = oscillator.p * std::abs(start.x0);
  const double held = oscillator.breakaway * phi;
  const bool from_zero = peak == 0 && within(speed) && speed * speed > notch;
  const bool from_turn = speed == 0 && within(peak) && peak > held * clear;
  const bool slowed = (phi == 0 || within(phi)) && (phi > 0 || notch > 0);
  if (!(cycle.zeta > 0) || !slowed || !(from_zero || from_turn)) {
    return std::nullopt;
  }
  return DampedFree{.p = oscillator.p,
                    .side = (from_zero ? start.v0 : start.x0) < 0 ? -1 : 1,
                    .phi = phi,
                    .held = held,
                    .notch = notch,
                    .cycle = cycle,
                    .speed = speed,
                    .peak = peak};
}

double first_peak(const DampedFree& motion) {
  const Swing swing{motion.phi, motion.cycle.zeta, motion.cycle.decay};
  return (motion.speed > 0 ? swing.peak(swing.reach(motion.speed)) : motion.peak) / motion.p;
}

double largest_acceleration(const DampedFree& motion) {
  if (motion.speed == 0) {
    return (motion.peak - motion.phi) * motion.p;
  }
  const double felt = motion.phi + 2 * motion.cycle.zeta * motion.speed;
  const double grows = motion.speed - 2 * motion.cycle.zeta * felt;
  const double most =
      grows > 0 ? Swing{felt, motion.cycle.zeta, motion.cycle.decay}.reach(grows).level : felt;
  return most * motion.p;
}

Response response_of(const DampedFree& motion, const DampedEnd& end) {
  Response response;
  const bool swings_back = !end.at_zero && end.peak > motion.held;
  response.outcome = end.at_zero ? Outcome::stopped_at_zero : Outcome::stopped_in_dead_zone;
  response.stops_at_zero = end.at_zero;
  response.peak_amplitude = end.farthest / motion.p;
  response.half_cycles = end.passages + 1;
  response.turning_points = end.passages + (motion.speed > 0 ? 1 : 0) + (swings_back ? 1 : 0);
  response.zero_passages = end.passages;
  const double swings = end.passages + (end.at_zero || swings_back ? 1 : 0);
  response.stop_time = (motion.cycle.swing * swings + end.phase) / motion.p;
  const double rest = swings_back ? -end.excursion : end.peak;
  const double pairs = end.passages / 2;
  response.stop_position =
      end.at_zero ? 0.0
                  : (std::floor(pairs) == pairs ? motion.side : -motion.side) * rest / motion.p;
  return response;
}

Response damped_response(const DampedFree& motion, const FreeOptions& options) {
  Response response = DampedRun(motion, options).response();
  if (!options.times) {
    response.stop_time.reset();
  }
  return response;
}

}  // namespace stillpoint
