// SPDX-License-Identifier: MIT
#pragma once

// What the metrics of a run ask of each kind of excitation, one overload per kind: how long it
// lasts, and its largest load, docs/forced.md section 10.

#include "kernel/drive_phase.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/functions.hpp"
#include "kernel/phase_clock.hpp"
#include "kernel/record_intervals.hpp"

#include <stillpoint/core/excitation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <variant>

namespace stillpoint {

namespace detail {

/// p times `time`, or `end` if that comes first or there is no such time.
template <class Real>
ExactSum<Real> earlier(const Real& p, const Real& time, const ExactSum<Real>& end) {
  if (time == std::numeric_limits<Real>::infinity()) {
    return end;
  }
  const ExactSum<Real> phase = ExactSum<Real>::product(p, time);
  return phase.minus(end) < 0 ? phase : end;
}

}  // namespace detail

/// The excitation is 0 from here on; infinity if it never ends.
template <class Real>
Real duration_of(const NoExcitation& /*excitation*/) {
  return Real(0);
}
template <class Real>
Real duration_of(const BasicHarmonic<Real>& excitation) {
  return excitation.duration.value_or(std::numeric_limits<Real>::infinity());
}
template <class Real, IsPulse Pulse>
Real duration_of(const Pulse& pulse) {
  return Real(2 * Pulse::turns) * pi<Real>() / pulse.lambda;
}
template <class Real>
Real duration_of(const BasicRecord<Real>& record) {
  if (!record.times.empty()) {
    return record.times.back();
  }
  return record.step * Real(record.values.size() - 1);
}

// (F30): the largest |W| from `from` until `until`, which is later and not after the end of the
// excitation.

template <class Real>
Real largest_load(const NoExcitation& /*none*/, const Real& /*p*/, const ExactSum<Real>& /*from*/,
                  const ExactSum<Real>& /*until*/) {
  return Real(0);
}

/// |k| where a crest lies between, otherwise that of an end.
template <class Real, IsSine Sine>
Real largest_load(const Sine& sine, const Real& p, const ExactSum<Real>& from,
                  const ExactSum<Real>& until) {
  using std::max;
  DrivePhase<Real> psi(sine.lambda, p, Real(sine.phase));
  psi.advance(from);
  const Real half = pi<Real>();
  Real to_crest = half / 2 - psi.psi();  // between -half / 2 and 3 half / 2; crests are half apart
  if (to_crest < 0) {
    to_crest += half;
  } else if (!(to_crest < half)) {
    to_crest -= half;
  }
  const Real length = until.minus(from);
  if (!(psi.ratio() * length < to_crest)) {
    return magnitude(sine.k);
  }
  const Real begin = magnitude(psi.sin_cos().sine);
  psi.advance(length);
  const Real most = max(begin, magnitude(psi.sin_cos().sine));
  return magnitude(sine.k) * (IsSquare<Sine> ? Real(most * most) : most);
}

/// At a sample, or at an end, which may lie between two.
template <class Real>
Real largest_load(const BasicRecord<Real>& record, const Real& p, const ExactSum<Real>& from,
                  const ExactSum<Real>& until) {
  using std::max;
  const RecordTimes<Real> times(record, p);
  const ExactSum<Real> begin = from.minus(times.at(0)) < 0 ? times.at(0) : from;
  if (record.values.size() < 2 || !(until.minus(begin) > 0)) {
    return Real(0);
  }
  const auto load = [&](const ExactSum<Real>& when) {
    const std::size_t i = times.latest(when);
    if (i + 1 == record.values.size()) {
      return record.values[i];
    }
    const Real part = when.minus(times.at(i)) / times.length(i);
    return Real(record.values[i] + (record.values[i + 1] - record.values[i]) * part);
  };
  const Real largest = max(magnitude(load(begin)), magnitude(load(until)));
  std::array<Real, 8> most{};  // several, which do not wait for each other
  most.fill(largest);
  const std::size_t end = times.latest(until) + 1;
  std::size_t i = times.latest(begin) + 1;
  for (; i + most.size() <= end; i += most.size()) {
    for (std::size_t k = 0; k < most.size(); ++k) {
      most[k] = max(most[k], magnitude(record.values[i + k]));
    }
  }
  for (; i < end; ++i) {
    most[0] = max(most[0], magnitude(record.values[i]));
  }
  return *std::max_element(most.begin(), most.end());
}

template <class Real, IsPolygon Polygon>
Real largest_load(const Polygon& pulse, const Real& p, const ExactSum<Real>& from,
                  const ExactSum<Real>& until) {
  return largest_load(record_of(pulse, duration_of<Real>(pulse)), p, from, until);
}

/// For any kind of excitation, for Transmitted. It refers to the excitation.
template <class Real, class... Kinds>
auto largest_load_of(const std::variant<Kinds...>& excitation, const Real& p) {
  return [&excitation, p](const ExactSum<Real>& from, const ExactSum<Real>& until) {
    return std::visit(
        [&](const auto& kind) {
          const ExactSum<Real> last = detail::earlier(p, duration_of<Real>(kind), until);
          return last.minus(from) > 0 ? largest_load(kind, p, from, last) : Real(0);
        },
        excitation);
  };
}

/// The same, compiled by itself, since a run hardly ever calls it.
std::function<double(const ExactSum<double>&, const ExactSum<double>&)> load_while_held(
    const Excitation& excitation, double p);

}  // namespace stillpoint
