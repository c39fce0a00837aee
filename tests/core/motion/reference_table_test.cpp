// SPDX-License-Identifier: MIT
#include "motion.hpp"
#include "reference_rows.hpp"
#include "testing/backward_error.hpp"

// data/reference/free_motion.csv was made by a time-domain solution at 40 digits that shares
// nothing with the kernel. It checks the rules that the 50-digit run of the kernel's own template
// cannot.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(reference_table_test)

// The table has 40 digits; 50 digits less the condition of the near ties must agree to:
const Exact table_tolerance("1e-35");  // relative to condition and value
// The table takes decisions closer than 1e-45 for ties, which 50 digits may round either way.
const Exact tie_margin("1e-45");

struct Row {
  std::string name;
  Scene<> scene;
  Run<Exact> run;
};

Outcome to_outcome(const std::string& text) {
  for (const Outcome outcome : {Outcome::stopped_at_zero, Outcome::stopped_in_dead_zone,
                                Outcome::never_stops, Outcome::caught_at_start}) {
    if (text == name(outcome)) {
      return outcome;
    }
  }
  throw std::runtime_error("no outcome: " + text);
}

Row to_row(const ReferenceRow& row) {
  const auto count = [&](std::size_t i) { return row.cells.at(i).empty() ? 0 : row[i]; };
  const auto exact = [&](std::size_t i) {
    return row.cells.at(i).empty() ? std::nullopt : std::optional(Exact(row.cells[i]));
  };
  return {row.cells.at(0),
          {row[1], row[2], row[3], row[4], row[5]},
          {{to_outcome(row.cells.at(14)), count(8), count(9), count(10)},
           {exact(6), exact(7), exact(11), exact(12), exact(13)},
           std::nullopt}};
}

const std::vector<Row>& table() {
  static const std::vector<Row> rows = [] {
    std::vector<Row> list;
    std::ranges::transform(
        reference_rows(
            "free_motion.csv",
            "name,x0,v0,p,f,delta,peak_amplitude,peak_acceleration,half_cycles,"
            "turning_points,zero_passages,stop_time,stop_position,arrival_speed,outcome"),
        std::back_inserter(list), to_row);
    return list;
  }();
  return rows;
}

/// Within the bounds of stillpoint/core/oscillator.hpp; the table goes beyond them.
bool in_range(const Scene<>& scene) {
  const double reach = std::abs(scene.p * scene.x0);
  const double speed = std::abs(scene.v0);
  const double phi = scene.f / scene.p;
  const bool f_fits =
      scene.f == 0 ||
      (phi >= smallest_friction_speed && phi <= largest_speed &&
       (speed == 0 || phi <= speed || speed * (speed / phi) >= smallest_peak_speed));
  const bool x0_fits = scene.x0 == 0 || (reach >= smallest_speed && reach <= largest_speed);
  return f_fits && x0_fits;
}

BOOST_AUTO_TEST_CASE(the_table_is_there_and_has_every_outcome) {
  BOOST_TEST(table().size() >= 100U);
  for (const Outcome outcome : {Outcome::stopped_at_zero, Outcome::stopped_in_dead_zone,
                                Outcome::never_stops, Outcome::caught_at_start}) {
    BOOST_TEST(std::any_of(table().begin(), table().end(),
                           [&](const Row& row) { return row.run.end.outcome == outcome; }),
               name(outcome));
  }
}

BOOST_AUTO_TEST_CASE(the_50_digit_run_agrees_with_the_independent_table) {
  for (const Row& row : table()) {
    BOOST_TEST_CONTEXT(row.name << ' ' << row.scene) {
      const Run<Exact> run = run_in(widened<Exact>(row.scene));
      if (run.end != row.run.end) {
        BOOST_TEST((run.margin && *run.margin <= tie_margin),
                   "got " << run.end << ", expected " << row.run.end);
        continue;
      }
      const std::array<Exact, 5> sums = conditions(row.scene, run);
      for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto& got = run.metrics[i];
        const auto& expected = row.run.metrics[i];
        BOOST_TEST(got.has_value() == expected.has_value(), metric_names[i]);
        if (got && expected) {
          const Exact error = abs(Exact(*got - *expected));
          const Exact bound = table_tolerance * (abs(*expected) + sums[i]);
          BOOST_TEST(error <= bound, metric_names[i] << " = " << got->str(40) << ", expected "
                                                     << expected->str(40));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(double_keeps_the_promise_about_the_independent_table) {
  for (const Row& row : table()) {
    if (!in_range(row.scene)) {
      continue;
    }
    BOOST_TEST_CONTEXT(row.name << ' ' << row.scene) {
      const Run<double> run = as_run(response(row.scene));
      const Run<Exact> exact = run_in(widened<Exact>(row.scene));
      Run<Exact> expected = row.run;
      expected.margin = exact.margin;
      if (ends_agree(run, expected) && exact.end == expected.end) {
        metrics_agree(run, expected, conditions(row.scene, exact));
      }
    }
  }
}

// Of whole numbers and powers of two: the tie is exact in double, and so must the decision be. With
// p = 3 and beside a tie the sums round.
BOOST_AUTO_TEST_CASE(exact_ties_are_decided_to_the_last_bit) {
  int ties = 0;
  for (const Row& row : table()) {
    if (row.name.starts_with("tie_") && row.name.find("_ulp_") == std::string::npos &&
        row.name != "tie_first_arrival_p3") {
      ++ties;
      ends(response(row.scene), row.run.end);
    }
  }
  BOOST_TEST(ties == 21);
}

BOOST_AUTO_TEST_CASE(rows_beyond_the_range_of_the_kernel_are_refused) {
  for (const Row& row : table()) {
    if (!in_range(row.scene)) {
      BOOST_CHECK_THROW((void)response(row.scene), InputError);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
