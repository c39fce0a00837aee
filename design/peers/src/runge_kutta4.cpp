// SPDX-License-Identifier: MIT
#include <stillpoint/peers/event_run.hpp>
#include <stillpoint/peers/methods.hpp>

#include <cstddef>

namespace stillpoint::peers {

namespace {

class FixedStep {
 public:
  static constexpr bool locates_events = false;
  static constexpr bool has_dense_output = false;

  /// `before` up to `change`, then `step`.
  FixedStep(double step, double before, double change)
      : step_(before), later_(step), change_(change) {}

  template <class AnyMotion>
  void begin(const AnyMotion& motion, double t, const State& state) {
    grid_ = now_ = t;
    count_ = 0;
    load_ = motion.load(t);
    state_ = state;
  }

  /// Steps lie on a grid from where the piece or its last kink was: summing up 1e6 lengths would
  /// add an error of its own.
  template <class AnyMotion>
  Step step(const AnyMotion& motion, double limit) {
    before_ = now_;
    from_ = state_;
    if (step_ != later_ && now_ >= change_) {
      step_ = later_;
      grid_ = now_;
      count_ = 0;
    }
    count_ += 1;
    now_ = grid_ + count_ * step_;
    if (now_ > limit - sliver * step_) {
      grid_ = now_ = limit;
      count_ = 0;
    }
    load_before_ = load_;
    load_ = motion.load(now_);
    state_ = advanced(motion, now_, load_);
    return {before_, now_};
  }

  [[nodiscard]] const State& state() const { return state_; }

  template <class AnyMotion>
  State at(const AnyMotion& motion, double t) {
    if (t == before_ || t == now_) {
      return t == now_ ? state_ : from_;
    }
    return advanced(motion, t, motion.load(t));
  }

 private:
  // A shorter rest of a step before a kink is not a step of its own: it is rounding.
  static constexpr double sliver = 1e-6;

  /// The method from the start of the step to `t`, where W is `load`. Written out, so that W is
  /// evaluated twice per step and not four times.
  template <class AnyMotion>
  [[nodiscard]] State advanced(const AnyMotion& motion, double t, double load) const {
    const double h = t - before_;
    const double middle = motion.load(before_ + h / 2);
    const auto moved = [&](const State& by, double length) {
      return State{from_[0] + length * by[0], from_[1] + length * by[1]};
    };
    const State k1 = motion.rate_of(from_, load_before_);
    const State k2 = motion.rate_of(moved(k1, h / 2), middle);
    const State k3 = motion.rate_of(moved(k2, h / 2), middle);
    const State k4 = motion.rate_of(moved(k3, h), load);
    const auto mean = [&](std::size_t i) { return (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]) / 6; };
    return {from_[0] + h * mean(0), from_[1] + h * mean(1)};
  }

  double step_;
  double later_;
  double change_;
  double grid_{0};
  double count_{0};
  double before_{0};
  double now_{0};
  double load_before_{0};
  double load_{0};
  State from_{};
  State state_{};
};

}  // namespace

Result runge_kutta4(const Scene& scene, double step, std::int64_t most,
                    const std::optional<double>& under_load) {
  FixedStep method(step, under_load.value_or(step), duration(scene.excitation).value_or(0));
  return run_events(scene, method, most);
}

}  // namespace stillpoint::peers
