// SPDX-License-Identifier: MIT
#include "kernel/excitation_run.hpp"
#include "kernel/forced_run.hpp"
#include "kernel/free_run.hpp"
#include "kernel/phase_clock.hpp"

#include <stillpoint/peers/exact.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cassert>
#include <variant>

namespace stillpoint::peers {

namespace {

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<50>, mp::et_off>;

Wide wide(const Real& value) {
  const auto near = static_cast<double>(value);
  return {near, static_cast<double>(Real(value - near))};
}

BasicOscillator<Real> widened(const Oscillator& oscillator) {
  return {Real(oscillator.p), Real(oscillator.f), Real(oscillator.delta)};
}

BasicStart<Real> widened(const Start& start) {
  return {Real(start.x0), Real(start.v0)};
}

struct Widen {
  const Scene& scene;
  ForcedRun<Real, NoWatcher>& run;

  template <class Kind>
  void through(const Kind& kind) const {
    run_until(run, kind, Real(scene.t_end));
  }
  void operator()(const NoExcitation& /*none*/) const {}
  void operator()(const Harmonic& e) const {
    through(BasicHarmonic<Real>{Real(e.k), Real(e.lambda), Real(e.phase),
                                std::optional<Real>(e.duration)});
  }
  void operator()(const HalfSine& e) const {
    through(BasicHalfSine<Real>{Real(e.k), Real(e.lambda)});
  }
  void operator()(const FullSine& e) const {
    through(BasicFullSine<Real>{Real(e.k), Real(e.lambda)});
  }
  void operator()(const Rectangle& e) const {
    through(BasicRectangle<Real>{Real(e.k), Real(e.lambda)});
  }
  void operator()(const Record& e) const {
    through(BasicRecord<Real>{
        {e.values.begin(), e.values.end()}, Real(e.step), {e.times.begin(), e.times.end()}});
  }
};

ExactResult free_result(const Scene& scene, double most_half_cycles) {
  PhaseClock<Real> clock;
  const FreeRun<Real> run =
      free_run(widened(scene.oscillator), widened(scene.start), most_half_cycles, clock);
  assert(run.outcome != Outcome::never_stops);
  const Real p(scene.oscillator.p);
  ExactResult result;
  result.rounded.outcome = run.outcome;
  result.rounded.passages = static_cast<std::int64_t>(run.passages);
  result.rounded.turns = static_cast<std::int64_t>(run.turning_points);
  result.peak = wide(Real(run.farthest / p));
  result.end_time = wide(Real(clock.phase() / p));
  result.x = wide(Real(run.rest / p));
  return result;
}

ExactResult forced_result(const Scene& scene) {
  NoWatcher nobody;
  ForcedRun<Real, NoWatcher> run(widened(scene.oscillator), widened(scene.start), nobody);
  std::visit(Widen{scene, run}, scene.excitation);
  const ForcedState<Real>& state = run.state();
  const Real p(scene.oscillator.p);
  using std::max;
  ExactResult result;
  result.rounded.outcome = state.outcome.value_or(Outcome::running);
  result.rounded.passages = state.passages;
  result.rounded.turns = state.turning_points;
  const bool rests =
      state.v == 0 && !state.fresh && !state.outcome && state.now.minus(state.rest_begin) > 0;
  result.rounded.sticks = state.sticks + (rests ? 1 : 0);
  result.peak = wide(Real(max(state.farthest, Real(abs(state.u))) / p));
  result.end_time = wide(Real((state.outcome ? state.rest_begin : state.now).value() / p));
  result.x = wide(Real(state.u / p));
  result.v = wide(state.v);
  return result;
}

}  // namespace

ExactResult exact(const Scene& scene, double most_half_cycles) {
  ExactResult result = std::holds_alternative<NoExcitation>(scene.excitation)
                           ? free_result(scene, most_half_cycles)
                           : forced_result(scene);
  result.rounded.peak = result.peak.near;
  result.rounded.end_time = result.end_time.near;
  result.rounded.x = result.x.near;
  result.rounded.v = result.v.near;
  return result;
}

}  // namespace stillpoint::peers
