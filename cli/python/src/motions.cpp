// SPDX-License-Identifier: MIT
// Free motions of many dampers, from arrays to arrays.

#include "dampers.hpp"
#include "interruptible.hpp"
#include "parts.hpp"
#include "values.hpp"

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/sweep/quantity.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace stillpoint::python {

namespace {

constexpr const char* motions_doc =
    R"(motions(f, delta, v0, p, *, times=False, acceleration=False, half_cycle_limit=1e8, threads=0)
--

The free motions from x = 0 of many dampers, dimensionless.

f, delta, v0, p   numbers or float64 arrays that broadcast together; arrays in C order are not copied
times             stop_time as well
acceleration      peak_absolute_acceleration as well
half_cycle_limit  refuse a motion that may have more half-cycles
threads           0: one per hardware thread; results do not depend on it

Returns Fields of arrays of the common shape: peak_amplitude, half_cycles, outcome (the index in
stillpoint.outcomes, uint8), stop_position. If a motion never stops, half_cycles and stop_time
are infinite and stop_position is 0. Raises InputError, which names the wrong entry.)";

using Block = Eigen::Map<const Eigen::ArrayXd>;

/// free_batch of the entries from `begin` to `end`. Uses the overload for a single v0 and p if it
/// can.
void run_block(const Dampers& given, py::ssize_t begin, py::ssize_t end,
               const BatchOptions& options, BatchResult& result) {
  const auto part = [&](Place place) {
    return Block(given.arrays[place].data() + begin, end - begin);
  };
  if (given.single(at_v0) && given.single(at_p)) {
    free_batch(*given.arrays[at_v0].data(), *given.arrays[at_p].data(), part(at_f), part(at_delta),
               options, result);
  } else {
    free_batch(part(at_v0), part(at_p), part(at_f), part(at_delta), options, result);
  }
}

/// A result of all blocks, and the memory of its array, which is found with the interpreter's lock.
struct Column {
  const char* name;
  Eigen::ArrayXd BatchResult::*values;
  Doubles array;
  double* memory{array.mutable_data()};
};

/// In blocks, so that an interrupt is seen between two of them.
void run_all(const Dampers& given, const BatchOptions& options, const std::vector<Column>& columns,
             std::uint8_t* outcomes, const std::stop_token& stop) {
  constexpr py::ssize_t block = 262'144;
  BatchResult result;
  for (py::ssize_t begin = 0; begin < given.size && !stop.stop_requested(); begin += block) {
    const py::ssize_t end = std::min(begin + block, given.size);
    try {
      run_block(given, begin, end, options, result);
    } catch (const Cancelled&) {
      return;  // the interrupt is thrown instead
    } catch (const std::exception&) {
      run_block(given, 0, end, options, result);  // throws again, with the entry of the whole
    }
    for (const Column& column : columns) {
      const Eigen::ArrayXd& values = result.*column.values;
      std::copy_n(values.data(), values.size(), column.memory + begin);
    }
    std::transform(
        result.outcome.data(), result.outcome.data() + result.outcome.size(), outcomes + begin,
        [](Outcome outcome) { return static_cast<std::uint8_t>(sweep::sweep_outcome(outcome)); });
  }
}

py::dict motions(const py::object& f, const py::object& delta, const py::object& v0,
                 const py::object& p, bool times, bool acceleration, double half_cycle_limit,
                 int threads) {
  Dampers given = dampers({f, delta, v0, p});
  given.spread(at_f);
  given.spread(at_delta);
  if (!given.single(at_v0) || !given.single(at_p)) {
    given.spread(at_v0);
    given.spread(at_p);
  }
  BatchOptions options;
  options.times = times;
  options.acceleration = acceleration;
  options.half_cycle_limit = half_cycle_limit;
  options.threads = threads_of(threads);
  const auto column = [&given](const char* name, Eigen::ArrayXd BatchResult::*values) {
    return Column{name, values, Doubles(given.shape)};
  };
  std::vector<Column> columns{column("peak_amplitude", &BatchResult::peak_amplitude),
                              column("half_cycles", &BatchResult::half_cycles),
                              column("stop_position", &BatchResult::stop_position)};
  if (times) {
    columns.push_back(column("stop_time", &BatchResult::stop_time));
  }
  if (acceleration) {
    columns.push_back(
        column("peak_absolute_acceleration", &BatchResult::peak_absolute_acceleration));
  }
  py::array_t<std::uint8_t> outcome(given.shape);
  interruptible([&, outcomes = outcome.mutable_data()](const std::stop_token& stop) {
    options.go_on = [&stop] { return !stop.stop_requested(); };
    run_all(given, options, columns, outcomes, stop);
  });
  py::dict all = fields();
  for (const Column& now : columns) {
    all[now.name] = now.array;
    if (now.values == &BatchResult::half_cycles) {
      all["outcome"] = outcome;
    }
  }
  return all;
}

}  // namespace

void add_motions(py::module_& module) {
  py::list names;
  for (std::size_t i = 0; i < sweep::sweep_outcome_count; ++i) {
    names.append(py::str(std::string(sweep::sweep_outcome_name(i))));
  }
  module.attr("outcomes") = py::tuple(names);
  module.def("motions", &motions, py::arg("f"), py::arg("delta"), py::arg("v0"), py::arg("p"),
             py::kw_only(), py::arg("times") = false, py::arg("acceleration") = false,
             py::arg("half_cycle_limit") = BatchOptions().half_cycle_limit, py::arg("threads") = 0,
             motions_doc);
}

}  // namespace stillpoint::python
