// SPDX-License-Identifier: MIT
#include "methods.hpp"

#include <stillpoint/peers/event_run.hpp>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <array>
#include <stdexcept>
#include <string>

namespace stillpoint::bench {

namespace {

using peers::Located;
using peers::State;

void require(int flag, const char* call) {
  if (flag < 0) {
    throw std::runtime_error(std::string(call) + " of SUNDIALS failed with " +
                             std::to_string(flag));
  }
}

class CvodeAdams {
 public:
  static constexpr bool locates_events = true;

  explicit CvodeAdams(double tolerance)
      : context_(new_context()),
        y_(N_VNew_Serial(2, context_)),
        solver_(SUNNonlinSol_FixedPoint(y_, 0, context_)),
        memory_(CVodeCreate(CV_ADAMS, context_)) {
    N_VConst(0, y_);
    require(CVodeInit(memory_, right_hand_side, 0, y_), "CVodeInit");
    require(CVodeSStolerances(memory_, tolerance, tolerance), "CVodeSStolerances");
    require(CVodeSetNonlinearSolver(memory_, solver_), "CVodeSetNonlinearSolver");
    require(CVodeSetUserData(memory_, this), "CVodeSetUserData");
    require(CVodeRootInit(memory_, 2, root_functions), "CVodeRootInit");
    require(CVodeSetNoInactiveRootWarn(memory_), "CVodeSetNoInactiveRootWarn");
    std::array<int, 2> directions{-1, 1};  // s v falls, s x rises
    require(CVodeSetRootDirection(memory_, directions.data()), "CVodeSetRootDirection");
  }
  ~CvodeAdams() {
    CVodeFree(&memory_);
    SUNNonlinSolFree(solver_);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }
  CvodeAdams(const CvodeAdams&) = delete;
  CvodeAdams& operator=(const CvodeAdams&) = delete;
  CvodeAdams(CvodeAdams&&) = delete;
  CvodeAdams& operator=(CvodeAdams&&) = delete;

  template <class AnyMotion>
  void begin(const AnyMotion& motion, double t, const State& state) {
    direction_ = motion.direction;
    now_ = t;
    state_ = state;
    NV_Ith_S(y_, 0) = state[0];
    NV_Ith_S(y_, 1) = state[1];
    require(CVodeReInit(memory_, t, y_), "CVodeReInit");
  }

  template <class AnyMotion>
  peers::Step step(const AnyMotion& motion, double limit) {
    motion_ = &motion;
    rate_ = [](const void* what, const State& now, State& rate, double t) {
      (*static_cast<const AnyMotion*>(what))(now, rate, t);
    };
    const double from = now_;
    require(CVodeSetStopTime(memory_, limit), "CVodeSetStopTime");
    const int flag = CVode(memory_, limit, y_, &now_, CV_ONE_STEP);
    if (flag == CV_TOO_CLOSE) {  // within rounding of the kink: nothing happens in between
      now_ = limit;
      return {from, now_};
    }
    require(flag, "CVode");
    state_ = {NV_Ith_S(y_, 0), NV_Ith_S(y_, 1)};
    return {from, now_, flag == CV_ROOT_RETURN ? located() : Located::nothing};
  }

  [[nodiscard]] const State& state() const { return state_; }

 private:
  static SUNContext new_context() {
    SUNContext context = nullptr;
    require(SUNContext_Create(nullptr, &context), "SUNContext_Create");
    return context;
  }

  Located located() {
    std::array<int, 2> found{};
    require(CVodeGetRootInfo(memory_, found.data()), "CVodeGetRootInfo");
    return found[1] != 0 ? Located::arrival : Located::turn;
  }

  static int right_hand_side(realtype t, N_Vector y, N_Vector rate, void* self) {
    const auto& method = *static_cast<const CvodeAdams*>(self);
    State result;
    method.rate_(method.motion_, {NV_Ith_S(y, 0), NV_Ith_S(y, 1)}, result, t);
    NV_Ith_S(rate, 0) = result[0];
    NV_Ith_S(rate, 1) = result[1];
    return 0;
  }

  static int root_functions(realtype /*t*/, N_Vector y, realtype* values, void* self) {
    const double s = static_cast<const CvodeAdams*>(self)->direction_;
    values[0] = s * NV_Ith_S(y, 1);
    values[1] = s * NV_Ith_S(y, 0);
    return 0;
  }

  SUNContext context_;
  N_Vector y_;
  SUNNonlinearSolver solver_;
  void* memory_;
  const void* motion_{nullptr};
  void (*rate_)(const void*, const State&, State&, double){nullptr};
  double direction_{1};
  double now_{0};
  State state_{};
};

}  // namespace

peers::Result cvode_adams(const peers::Scene& scene, double tolerance) {
  CvodeAdams method(tolerance);
  return peers::run_events(scene, method);
}

}  // namespace stillpoint::bench
