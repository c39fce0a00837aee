// SPDX-License-Identifier: MIT
#include "methods.hpp"

#include <stillpoint/peers/event_run.hpp>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <memory>
#include <new>
#include <stdexcept>

namespace stillpoint::bench {

namespace {

using peers::State;

template <auto Release>
struct Free {
  template <class Object>
  void operator()(Object* object) const {
    Release(object);
  }
};
template <class Object, auto Release>
using Owned = std::unique_ptr<Object, Free<Release>>;

/// The right-hand side as GSL calls it; `parameters` is the motion.
template <class AnyMotion>
int right_hand_side(double t, const double* y, double* rate, void* parameters) {
  State result;
  (*static_cast<const AnyMotion*>(parameters))({y[0], y[1]}, result, t);
  rate[0] = result[0];
  rate[1] = result[1];
  return GSL_SUCCESS;
}

class Rk8pd {
 public:
  static constexpr bool locates_events = false;
  static constexpr bool has_dense_output = false;

  explicit Rk8pd(double tolerance)
      : step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2)),
        control_(gsl_odeiv2_control_y_new(tolerance, tolerance)),
        evolve_(gsl_odeiv2_evolve_alloc(2)) {
    if (!step_ || !control_ || !evolve_) {
      throw std::bad_alloc();
    }
  }

  template <class AnyMotion>
  void begin(const AnyMotion& /*motion*/, double t, const State& state) {
    // The manual asks for both resets after a discontinuity.
    gsl_odeiv2_step_reset(step_.get());
    gsl_odeiv2_evolve_reset(evolve_.get());
    now_ = t;
    state_ = state;
  }

  template <class AnyMotion>
  peers::Step step(const AnyMotion& motion, double limit) {
    before_ = now_;
    from_ = state_;
    const gsl_odeiv2_system equations = system(motion);
    if (gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(), &equations, &now_,
                                limit, &next_, state_.data()) != GSL_SUCCESS) {
      throw std::runtime_error("GSL's integrator gave up");
    }
    return {before_, now_};
  }

  [[nodiscard]] const State& state() const { return state_; }

  template <class AnyMotion>
  State at(const AnyMotion& motion, double t) {
    if (t == before_ || t == now_) {
      return t == now_ ? state_ : from_;
    }
    State state = from_;
    State error;
    const gsl_odeiv2_system equations = system(motion);
    if (gsl_odeiv2_step_apply(step_.get(), before_, t - before_, state.data(), error.data(),
                              evolve_->dydt_in, nullptr, &equations) != GSL_SUCCESS) {
      throw std::runtime_error("GSL's step gave up");
    }
    return state;
  }

 private:
  /// GSL takes its parameters as void*, and never changes them.
  template <class AnyMotion>
  static gsl_odeiv2_system system(const AnyMotion& motion) {
    return {right_hand_side<AnyMotion>, nullptr, 2,
            const_cast<AnyMotion*>(&motion)};  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  }

  Owned<gsl_odeiv2_step, gsl_odeiv2_step_free> step_;
  Owned<gsl_odeiv2_control, gsl_odeiv2_control_free> control_;
  Owned<gsl_odeiv2_evolve, gsl_odeiv2_evolve_free> evolve_;
  double next_{1e-2};
  double before_{0};
  double now_{0};
  State from_{};
  State state_{};
};

}  // namespace

peers::Result gsl_rk8pd(const peers::Scene& scene, double tolerance) {
  Rk8pd method(tolerance);
  return peers::run_events(scene, method);
}

}  // namespace stillpoint::bench
