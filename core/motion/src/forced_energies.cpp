// SPDX-License-Identifier: MIT
#include "kernel/free_run.hpp"
#include "kernel/slip_keeper.hpp"
#include "kernel/zoned_friction.hpp"
#include "motion_watchers.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/motion_energies.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <variant>

namespace stillpoint {

namespace {

double energy(double u, double v) {
  return (v * v + u * u) / 2;
}

/// Calls `use` with the places and weights of Gauss's rule of ten points on `steps` parts of
/// [0, length].
template <class Use>
void by_gauss(double length, double steps, const Use& use) {
  struct Node {
    double place, weight;
  };
  constexpr std::array<Node, 5> nodes{{{0.14887433898163122, 0.29552422471475287},
                                       {0.43339539412924719, 0.26926671930999635},
                                       {0.67940956829902441, 0.21908636251598204},
                                       {0.86506336668898451, 0.14945134915058059},
                                       {0.97390652851717172, 0.06667134430868814}}};
  const double half = length / steps / 2;
  for (double step = 0; step < steps; ++step) {
    const double middle = (2 * step + 1) * half;
    for (const auto& [place, weight] : nodes) {
      use(middle - place * half, weight * half);
      use(middle + place * half, weight * half);
    }
  }
}

double limit_of(const ForcedOptions& options) {
  return options.half_cycle_limit.value_or(FreeOptions().half_cycle_limit);
}

MotionEnergies free_energies(const Oscillator& oscillator, const Start& start, double limit) {
  SlipKeeper keeper;
  const FreeRun<double> run = free_run(oscillator, start, limit, keeper);
  if (run.outcome == Outcome::never_stops) {
    return {keeper.fastest(), {}};
  }
  Energies energies;
  energies.start = energy(oscillator.p * start.x0, start.v0);
  energies.end = energy(run.rest, 0);
  const double slid = keeper.slid(run);
  energies.slip_path = slid / oscillator.p;
  energies.friction = oscillator.f / oscillator.p * slid;
  energies.notch = oscillator.delta * run.passages;
  if (run.outcome == Outcome::caught_at_start) {
    energies.notch = energies.start;
  } else if (run.outcome == Outcome::stopped_at_zero) {
    energies.notch += run.arrival.value_or(0) / 2;
  }
  return {keeper.fastest(), energies};
}

/// The largest speed from a turn on where only damping takes energy.
double fastest_from(double u, double zeta) {
  return std::abs(u) * elementary::exp(-zeta * elementary::acos(zeta) / swing_rate(zeta));
}

void add(Energies& sum, const Energies& more) {
  for (const auto part : {&Energies::friction, &Energies::notch, &Energies::slip_path}) {
    sum.*part += more.*part;
  }
  sum.end = more.end;
}

/// Adds up the energies of a run, piece by piece.
class EnergyWatcher final : public Finder<MotionEnergies> {
 public:
  EnergyWatcher(const Oscillator& oscillator, const Surface& surface, const Start& start,
                const ForcedOptions& options)
      : oscillator_(oscillator),
        free_to_end_(!options.t_end),
        limit_(limit_of(options)),
        zeta_(oscillator.zeta),
        start_(energy(oscillator.p * start.x0, start.v0)),
        delta_(surface.notch_width ? 0 : oscillator.delta),
        fastest_(std::abs(start.v0)),
        law_(oscillator, surface, start) {
    if (start.x0 == 0 && start.v0 != 0 && holds_at_start(delta_, start.v0)) {
      notch_.add(energy(0, start.v0));
    }
  }

  void event(EventKind kind, const ExactSum<double>& /*now*/, double /*u*/, double v) override {
    if (kind == EventKind::arrival) {
      notch_.add(std::min(delta_, energy(0, v)));
    }
    if (v == 0) {
      law_.rest();
    }
  }

  void follow(const WatchedPiece& piece) override {
    std::visit([&](const auto* motion) { slide_along(*motion, piece); }, piece.motion);
  }

  void end(const ForcedState<double>& state) override {
    result_.peak_velocity = fastest_;
    if (state.outcome == Outcome::never_stops) {
      result_.peak_velocity = std::max(fastest_, fastest_from(state.u, zeta_));
      return;
    }
    const double p = oscillator_.p;
    Energies all{friction_.value(), notch_.value(), damping_.value(),
                 load_.value(),     start_,         energy(state.u, state.v),
                 slid_.value() / p};
    if (free_to_end_ && state.mode == ForcedMode::resting) {
      const MotionEnergies rest = free_energies(oscillator_, {state.u / p, 0}, limit_);
      result_.peak_velocity = std::max(fastest_, rest.peak_velocity);
      if (!rest.energies) {
        return;
      }
      add(all, *rest.energies);
    }
    result_.energies = all;
  }

  [[nodiscard]] MotionEnergies found() override { return result_; }

 private:
  template <class Motion>
  void slide_along(const Motion& motion, const WatchedPiece& piece) {
    const auto from = motion.at(0.0);
    const auto to = motion.at(piece.length);
    const double middle = motion.at(piece.length / 2).y;
    const double alone = law_.phi_alone(middle);
    const double slid = to.y - from.y;
    slid_.add(slid);
    friction_.add(alone * slid);
    notch_.add((law_.phi_ahead(middle) - alone) * slid);
    if constexpr (requires { from.w; }) {
      load_.add(-(piece.direction * piece.load - from.w) * slid);  // of a constant load besides
      under_sine(motion, from, to, piece.length);
    } else {
      under_line(motion, from, to, piece);
    }
  }

  /// Between two samples of a record, under a rectangle or free.
  template <class Motion, class Point>
  void under_line(const Motion& motion, const Point& from, const Point& to,
                  const WatchedPiece& piece) {
    if constexpr (std::is_same_v<Motion, DampedPiece<double>>) {
      fastest_ = motion.largest_speed({PieceEvent::none, piece.length, to}, fastest_);
    } else {
      const DampedPiece<double> same(from, motion.rate(), 0, undamped_);
      fastest_ = same.largest_speed({PieceEvent::none, piece.length, to}, fastest_);
    }
    const double load = piece.direction * piece.load;
    if (zeta_ == 0 && load == 0 && motion.rate() == 0) {
      return;
    }
    by_gauss(piece.length, std::ceil(piece.length / longest_step), [&](double h, double weight) {
      work(weight, motion.at(h).v, load + motion.rate() * h);
    });
  }

  template <class Motion, class Point>
  void under_sine(const Motion& motion, const Point& from, const Point& to, double length) {
    const double r = motion.r();
    const double steps = std::ceil(length / motion.time_scale() / longest_step);
    constexpr double most_steps = 64;
    if (steps > most_steps) {  // (F37), of fast loads without damping
      const auto primitive = [r](const Point& at) {
        return (at.w * (at.a + at.w / 2) - r * at.q * at.v) / (1 - r * r);
      };
      load_.add(primitive(to) - primitive(from));
      // The ripple is about the same everywhere, so the top of the slow part decides.
      const double c = r / (r * r - 1);
      const double top = elementary::atan2(from.a + c * r * from.w, from.v - c * from.q);
      const double turn = 7 / r;
      const double begin = std::clamp(top - turn, 0.0, length - turn);
      look_for_speed(motion, begin, std::min(begin + 2 * turn, length));
      return;
    }
    look_for_speed(motion, 0, length);
    by_gauss(length, steps, [&](double h, double weight) {
      const auto at = motion.at(h);
      work(weight, at.v, at.w);
    });
  }

  void work(double weight, double v, double w) {
    damping_.add(weight * 2 * zeta_ * v * v);
    load_.add(-weight * w * v);
  }

  /// v obeys the equation of y with the load differentiated: docs/damping.md section 3.
  template <class Motion>
  void look_for_speed(const Motion& motion, double begin, double end) {
    const double parts = std::ceil((end - begin) / motion.time_scale());
    const double step = (end - begin) / parts;
    auto from = motion.at(begin);
    for (double part = 1; part <= parts; ++part) {
      const auto to = motion.at(begin + part * step);
      const DampedCurve<double> curve(from, motion.r(), zeta_);
      const DampedCurve<double> speed(curve.derivative(from), motion.r(), zeta_);
      fastest_ = speed.largest(curve.derivative(to), step, fastest_);
      from = to;
    }
  }

  static constexpr double longest_step = 2;  // ten points leave 1e-17 of the product of two sines

  const Oscillator& oscillator_;
  bool free_to_end_;  ///< where the run ends the map goes on
  double limit_;
  double zeta_;
  DampedSwing<double> undamped_{0};
  double start_;
  double delta_;  ///< of a notch without width
  double fastest_;
  ZonedFriction<double> law_;
  ExactSum<double> slid_;
  ExactSum<double> friction_;
  ExactSum<double> notch_;
  ExactSum<double> damping_;
  ExactSum<double> load_;
  MotionEnergies result_;
};

}  // namespace

std::unique_ptr<Finder<MotionEnergies>> energy_watcher(const Oscillator& oscillator,
                                                       const Surface& surface, const Start& start,
                                                       const ForcedOptions& options) {
  return std::make_unique<EnergyWatcher>(oscillator, surface, start, options);
}

MotionEnergies motion_energies(const Oscillator& oscillator, const Start& start,
                               const Excitation& excitation, const ForcedOptions& options,
                               const Surface& surface) {
  require_valid(oscillator, start, excitation, options.t_end);
  require_valid(oscillator, surface);
  const bool paper = paper_motion(oscillator, surface);
  if (paper && !options.t_end && std::holds_alternative<NoExcitation>(excitation)) {
    return free_energies(oscillator, start, limit_of(options));
  }
  const auto watcher = energy_watcher(oscillator, surface, start, options);
  WatchedOptions wanted{options};
  wanted.to_end = {watcher.get()};
  watched_motion(oscillator, surface, start, excitation, wanted);
  return watcher->found();
}

}  // namespace stillpoint
