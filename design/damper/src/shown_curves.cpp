// SPDX-License-Identifier: MIT
#include <stillpoint/design/shown_curves.hpp>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>
#include <variant>

namespace stillpoint::design {

namespace {

/// Where a motion in states is at tau; after the last it rests.
double displacement(const std::vector<State>& states, double tau) {
  const auto next = std::ranges::lower_bound(states, tau, {}, &State::tau);
  if (next == states.begin() || next == states.end()) {
    return next == states.end() ? states.back().x : next->x;
  }
  const State& before = *std::prev(next);
  return std::lerp(before.x, next->x, (tau - before.tau) / (next->tau - before.tau));
}

/// Whether all turns are equally far and there are more than two.
bool is_one_orbit(const std::vector<State>& turns) {
  constexpr double alike = 1e-9;
  const auto distance = [](const State& turn) { return std::abs(turn.x); };
  if (turns.size() < 3) {
    return false;
  }
  const auto [least, most] = std::ranges::minmax(turns, {}, distance);
  return distance(most) - distance(least) <= alike * distance(most);
}

/// From turn to turn but one, evenly spaced.
std::vector<Interval> some_loops(const std::vector<State>& turns) {
  const std::size_t step = 2 * (turns.size() / most_single_half_cycles + 1);
  std::vector<Interval> loops;
  for (std::size_t i = 0; i + 2 < turns.size(); i += step) {
    loops.push_back({turns[i].tau, turns[i + 2].tau});
  }
  return loops;
}

/// Between two states on the same side of every edge, without the notch's.
double friction_between(const ShownMotion& motion, const State& one, const State& other) {
  const double middle = std::abs(one.x + other.x) / 2;
  const auto& zones = motion.surface.zones;
  const auto zone = std::ranges::find_if(zones, [&](const auto& now) { return middle < now.to; });
  return zone != zones.end() ? zone->f : motion.oscillator.f;
}

/// W at the instants that show it, up to its end.
std::vector<ShownLoad> loads(const NoExcitation& /*none*/, double /*horizon*/) {
  return {};
}
template <class Law>
std::vector<ShownLoad> loads(const Law& law, double horizon) {
  const double last = std::min(duration(law).value_or(horizon), horizon);
  const std::int64_t count = sample_count(law.lambda, last);
  std::vector<ShownLoad> all;
  for (std::int64_t i = 0; i <= count; ++i) {
    const double tau = last * static_cast<double>(i) / static_cast<double>(count);
    all.push_back({tau, load_at(law, tau)});
  }
  return all;
}
std::vector<ShownLoad> loads(const Record& record, double horizon) {
  std::vector<ShownLoad> all;
  for (std::size_t i = 0; i < record.values.size(); ++i) {
    const double tau =
        record.times.empty() ? static_cast<double>(i) * record.step : record.times[i];
    if (tau > horizon) {
      if (!all.empty()) {
        const auto [before, load] = all.back();
        all.push_back(
            {horizon, std::lerp(load, record.values[i], (horizon - before) / (tau - before))});
      }
      break;
    }
    all.push_back({tau, record.values[i]});
  }
  return all;
}
template <IsPolygon Polygon>
std::vector<ShownLoad> loads(const Polygon& pulse, double horizon) {
  return loads(record_of(pulse, *duration(pulse)), horizon);
}

}  // namespace

bool is_long(const ShownMotion& motion) {
  constexpr std::size_t most_turns = 3 * most_single_half_cycles;
  return motion.passages.size() > most_single_half_cycles || motion.turns.size() > most_turns;
}

bool is_long(const OtherMotion& other) {
  return other.turns.size() > most_single_half_cycles;
}

/// The farthest in each column of time, without those between two that are farther.
std::vector<State> crests(const std::vector<State>& states, const std::vector<State>& turns,
                          double side, bool rests) {
  constexpr double columns = 180;
  const double column = states.back().tau / columns;
  const State& first = states.front();
  const State held = *std::prev(std::ranges::find_if(  // until it first moves
      states, [&](const State& state) { return state.x != first.x; }));
  std::vector<State> all;
  for (const State& turn : turns) {
    if (all.empty() || std::floor(turn.tau / column) != std::floor(all.back().tau / column)) {
      all.push_back(turn);
    } else if (side * turn.x > side * all.back().x) {
      all.back() = turn;
    }
  }
  std::vector<State> line{first, held};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto is_farther = [&](std::size_t other) {
      return other >= all.size() || side * all[other].x > side * all[i].x;
    };
    if (!is_farther(i - 1) || !is_farther(i + 1)) {
      line.push_back(all[i]);
    }
  }
  if (rests) {
    line.push_back(*std::next(states.rbegin()));
  }
  line.push_back({states.back().tau, (rests ? states : line).back().x, 0});
  return line;
}

OtherMotion beside(const ShownMotion& motion, std::vector<State> states) {
  const double last = displacement(states, motion.shown_to);
  std::erase_if(states, [&](const State& state) { return state.tau > motion.shown_to; });
  states.push_back({motion.shown_to, last, 0});
  const Interval reach = extent(states, &State::x);
  return {std::move(states), {}, reach};
}

bool is_apart(const ShownMotion& motion, const std::vector<State>& other) {
  constexpr double visible = 0.02;  // of the peak: a few pixels
  double apart = 0;
  for (const State& state : motion.states) {
    apart = std::max(apart, std::abs(state.x - displacement(other, state.tau)));
  }
  const auto [least, most] = extent(motion.states, &State::x);
  return apart >= visible * std::max(most, -least);
}

ShownOrbit shown_orbit(const ShownMotion& motion) {
  ShownOrbit orbit;
  orbit.repeats = is_one_orbit(motion.turns);
  orbit.some = !orbit.repeats && is_long(motion);
  const double last = orbit.repeats ? motion.turns[2].tau : motion.states.back().tau;
  for (const auto& [from, to] :
       orbit.some ? some_loops(motion.turns) : std::vector<Interval>{{0, last}}) {
    const State* before = nullptr;
    auto state = std::ranges::lower_bound(motion.states, from, {}, &State::tau);
    for (; state != motion.states.end() && state->tau <= to; ++state) {
      const bool jumped = before != nullptr && before->tau == state->tau && before->v != state->v;
      if (jumped) {
        orbit.jumps.push_back({*before, *state});
      }
      if (before == nullptr || jumped) {
        orbit.arcs.emplace_back();
      }
      orbit.arcs.back().push_back(*state);
      before = &*state;
    }
  }
  return orbit;
}

std::vector<ShownEnergy> shown_energies(const ShownMotion& motion) {
  constexpr double rounding = 1e-9;
  const double p = motion.oscillator.p;
  const bool damped = motion.oscillator.zeta > 0;
  const auto energy = [p](const State& state) {
    return (state.v * state.v + p * p * state.x * state.x) / 2;
  };
  const double whole = energy(motion.states.front());
  const auto seen = [=](double part) { return part > rounding * whole ? part : 0; };
  std::vector<ShownEnergy> all;
  const double width = motion.surface.notch_width.value_or(0);
  const State* before = &motion.states.front();
  bool acts = before->x != 0;  // the notch: not while a hit moves the mass out of it
  double friction = 0;
  double taken = 0;
  for (const State& state : motion.states) {
    const double way = std::abs(state.x - before->x);
    friction += friction_between(motion, *before, state) * way;
    acts = acts || std::abs(before->x) >= width / 2 || before->v == 0;
    if (width == 0 && state.tau == before->tau) {
      taken += (before->v - state.v) * (before->v + state.v) / 2;
    } else if (acts && std::abs(before->x + state.x) / 2 < width / 2) {
      taken += motion.oscillator.delta / width * way;
    }
    before = &state;
    const double left = energy(state);
    const double rest = whole - left - friction - taken;  // it loses energy to nothing else
    all.push_back({state.tau, left, friction, seen(taken), damped ? seen(rest) : 0});
  }
  return all;
}

std::vector<ShownForce> shown_forces(const ShownMotion& motion, const Excitation& excitation,
                                     const std::vector<State>& states) {
  const double p = motion.oscillator.p;
  const auto traced_states = traced(motion.oscillator, motion.surface, excitation, states);
  std::vector<ShownForce> all;
  TracedState before = traced_states.front();
  for (const TracedState& now : traced_states) {
    const double drag = 2 * motion.oscillator.zeta * p * now.v;
    const auto add = [&](double friction) {
      all.push_back({now.tau, now.x, friction + drag, friction + drag + p * p * now.x});
    };
    const bool rests = motion.rest && now.tau >= motion.rest->tau && now.v == 0;
    if (now.x != before.x && (rests || now.friction != before.friction)) {
      add(before.friction);  // up to here
    }
    if (rests) {
      break;
    }
    add(now.friction);
    before = now;
  }
  return all;
}

std::vector<ShownLoad> shown_transmitted(const ShownMotion& motion, const Excitation& excitation) {
  std::vector<ShownLoad> all;
  for (const ShownForce& now : shown_forces(motion, excitation, motion.states)) {
    all.push_back({now.tau, -now.whole});
  }
  if (const auto& rest = motion.rest) {
    all.push_back(
        {rest->tau, traced(motion.oscillator, motion.surface, excitation, {*rest}).front().w});
    std::ranges::copy_if(shown_load(excitation, motion.shown_to), std::back_inserter(all),
                         [&](const ShownLoad& now) { return now.tau > rest->tau; });
  }
  return all;
}

std::vector<ShownLoad> shown_load(const Excitation& excitation, double horizon) {
  auto all = std::visit([horizon](const auto& law) { return loads(law, horizon); }, excitation);
  if (all.empty() || all.back().tau < horizon) {  // 0 from its own end on
    all.push_back({all.empty() ? 0 : all.back().tau, 0});
    all.push_back({horizon, 0});
  }
  return all;
}

}  // namespace stillpoint::design
