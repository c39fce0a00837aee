// SPDX-License-Identifier: MIT
#include "kernel/excitation_run.hpp"
#include "kernel/forced_run.hpp"
#include "kernel/free_run.hpp"
#include "kernel/on_surface.hpp"
#include "kernel/phase_clock.hpp"
#include "kernel/widened.hpp"

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

ExactResult free_result(const Scene& scene, double most_half_cycles) {
  PhaseClock<Real> clock;
  const FreeRun<Real> run = free_run(widened<Real>(scene.oscillator), widened<Real>(scene.start),
                                     most_half_cycles, clock);
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

ForcedState<Real> end_of_run(const Scene& scene, double most_half_cycles) {
  NoWatcher nobody;
  const BasicExcitation<Real> excitation = widened<Real>(scene.excitation);
  return on_surface(widened<Real>(scene.oscillator), widened<Real>(scene.surface),
                    widened<Real>(scene.start), nobody, {}, [&](auto& run) {
                      if (std::holds_alternative<NoExcitation>(excitation)) {
                        run.allow_half_cycles(most_half_cycles);
                      }
                      std::visit([&](const auto& kind) { run_until(run, kind, Real(scene.t_end)); },
                                 excitation);
                      return run.state();
                    });
}

ExactResult forced_result(const Scene& scene, double most_half_cycles) {
  const ForcedState<Real> state = end_of_run(scene, most_half_cycles);
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
  const bool by_map = std::holds_alternative<NoExcitation>(scene.excitation) &&
                      paper_motion(scene.oscillator, scene.surface);
  ExactResult result =
      by_map ? free_result(scene, most_half_cycles) : forced_result(scene, most_half_cycles);
  result.rounded.peak = result.peak.near;
  result.rounded.end_time = result.end_time.near;
  result.rounded.x = result.x.near;
  result.rounded.v = result.v.near;
  return result;
}

}  // namespace stillpoint::peers
