// SPDX-License-Identifier: MIT
#include "record_texts.hpp"
#include "testing/folder.hpp"

#include <stillpoint/records/record_scaling.hpp>

#include <unistd.h>

#include <bit>

BOOST_AUTO_TEST_SUITE(record_file_test)

using namespace stillpoint::test;

// ---- there and back

BOOST_AUTO_TEST_CASE(what_is_written_is_read_to_the_last_bit) {
  std::mt19937_64 random(20);
  Samples values;
  Samples times{0};
  while (values.size() < 3001) {
    // Every exponent of a value that a motion can follow and every fraction, by bits.
    const auto value = std::bit_cast<double>(random());
    if (std::isnormal(value) && std::abs(value) <= 1e150) {
      values.push_back(value);
      times.push_back(times.back() + static_cast<double>(1 + random() % 1000) / 1e5);
    }
  }
  times.pop_back();
  std::string at2 = titles + quantity + "NPTS= 3001, DT= .01 SEC\n";
  std::string two;
  std::string one;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string value = in_full(values[i]);
    at2 += "  " + value + (i % 5 == 4 ? "\n" : "");
    two += in_full(times[i]) + "\t" + value + "\n";
    one += value + "\n";
  }
  BOOST_TEST((record_of("a.AT2", at2).values == values));
  BOOST_TEST((record_of("b.txt", two).values == values));
  BOOST_TEST((record_of("b.txt", two).times == times));
  BOOST_TEST(record_of("c.txt", one, {.step = 0.01}).values == values);
}

// ---- files and options

BOOST_AUTO_TEST_CASE(file_that_cannot_be_read) {
  const Folder folder;
  const auto refusal = [&](const char* name) {
    return refusal_of<FileError>([&] { return records::read_record(folder.path(name)); });
  };
  check_says(refusal("none.AT2"), {"record ", "none.AT2: cannot be read: No such file"});
  fs::create_directory(folder.path("folder"));
  check_says(refusal("folder"), {"folder: cannot be read: Is a directory"});
  std::ofstream(folder.path("sealed.AT2")) << header << three;
  fs::permissions(folder.path("sealed.AT2"), fs::perms::none);
  if (::access(folder.path("sealed.AT2").c_str(), R_OK) == 0) {
    BOOST_TEST_MESSAGE("skipped: this user may read everything");
    return;
  }
  check_says(refusal("sealed.AT2"), {"sealed.AT2: cannot be read: Permission denied"});
}

BOOST_AUTO_TEST_CASE(file_that_is_too_large) {
  const Folder folder;
  std::ofstream(folder.path("large.AT2")).close();
  fs::resize_file(folder.path("large.AT2"), records::largest_record_bytes + 1);
  check_says(refusal_of<FileError>([&] { return records::read_record(folder.path("large.AT2")); }),
             {"large.AT2: is too large", "67108864 bytes"});
}

BOOST_AUTO_TEST_CASE(options_out_of_bounds) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refusal = [](const RecordOptions& options) {
    return refusal_of<InputError>([&] { return file_of("a.txt", "1\n", options); });
  };
  for (const double step : {0.0, -0.1, nan, infinity}) {
    check_says(refusal({.step = step}), {"record-step = ", "must be from 1e-150 to 1e+150"});
  }
  const auto step_below = [](double step, double p) {
    return RecordOptions{.step = step, .clock = {.p = p}};
  };
  check_says(refusal(step_below(0.9e-140, 1e-10)), {"from 1e-140 to 1e+150 s"});
  check_says(refusal(step_below(0.9e-150, 1e10)), {"from 1e-150 to 1e+150 s"});
  for (const double scale : {0.0, 1e-101, -1e101, nan, infinity}) {
    check_says(refusal({.scale = scale}), {"record-scale = ", "from 1e-100 to 1e+100"});
  }
  for (const double gravity : {0.0, -9.8, nan, infinity}) {
    check_says(refusal({.gravity_m_per_s2 = gravity}), {"gravity = "});
  }
}

BOOST_AUTO_TEST_CASE(units_have_names) {
  for (const RecordUnits unit :
       {RecordUnits::g, RecordUnits::m_per_s2, RecordUnits::cm_per_s2, RecordUnits::mm_per_s2}) {
    BOOST_TEST(parse<RecordUnits>(records::name(unit)) == std::optional(unit));
  }
  for (const char* wrong : {"", "G", "cm/s", "gal"}) {
    BOOST_TEST(!parse<RecordUnits>(wrong).has_value());
  }
}

// ---- the records of the repository

std::string kept(const char* name) {
  return std::string(STILLPOINT_DATA_DIR "/records/") + name;
}

BOOST_AUTO_TEST_CASE(near_fault_pulse_is_the_derivative_of_its_velocity) {
  const Record record = records::read_record(kept("near_fault_pulse.txt")).record;
  BOOST_TEST_REQUIRE(record.values.size() == 1201U);
  BOOST_TEST(record.step == 0.01);
  // v = A/2 (1 + cos(pi s / 2)) cos(pi s + pi/2) with A = 0.9 m/s, s = t - 4 and |s| <= 2. The
  // trapezoidal rule is off by h^2/12 |v''|, and |v''| <= 0.45 (1 + 9/8 + 1/8) pi^2 < 10 m/s^3.
  constexpr double tolerance_m_per_s = 1e-4;
  constexpr double pi = std::numbers::pi;
  double velocity = 0;
  for (std::size_t i = 1; i < record.values.size(); ++i) {
    velocity += 9.80665 * record.step * (record.values[i - 1] + record.values[i]) / 2;
    const double s = static_cast<double>(i) * record.step - 4;
    const double expected =
        std::abs(s) <= 2 ? -0.45 * (1 + std::cos(pi * s / 2)) * std::sin(pi * s) : 0;
    BOOST_TEST(std::abs(velocity - expected) <= tolerance_m_per_s,
               "at s = " << s << ": " << velocity << ", not " << expected);
  }
}

BOOST_AUTO_TEST_CASE(strong_motion_is_as_its_script_says) {
  const RecordFile file = records::read_record(kept("strong_motion.AT2"));
  BOOST_TEST(file.units == RecordUnits::g);
  BOOST_TEST(file.record.values.size() == 2000U);
  BOOST_TEST(file.record.step == 0.01);
  BOOST_TEST(records::peak_acceleration(file.record) == 0.35);
  BOOST_TEST(file.description.starts_with("SYNTHETIC RECORD, NO EARTHQUAKE"));
}

BOOST_AUTO_TEST_SUITE_END()
