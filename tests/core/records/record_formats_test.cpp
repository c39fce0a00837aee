// SPDX-License-Identifier: MIT

// The formats of the networks: ESM, K-NET, CSMIP, COSMOS and SMC. The samples of data/records hold
// one pulse, 250 cm/s2 sin^2(pi t / 2) sin(3 pi t), in all of them.

#include "refusal.hpp"
#include "samples.hpp"
#include "testing/printing.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_file.hpp>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(record_formats_test)

namespace {

namespace records = stillpoint::records;
namespace data = boost::unit_test::data;
using records::FileError;
using records::RecordFile;
using records::RecordOptions;
using records::RecordUnits;
using stillpoint::test::check_says;
using stillpoint::test::path_of;
using stillpoint::test::refusal_of;
using stillpoint::test::replaced;
using stillpoint::test::text_of;

constexpr double cm_per_s2 = 980.665;  // in one g

double pulse(std::size_t i) {
  const double t = 0.02 * static_cast<double>(i);
  const double envelope = std::sin(std::numbers::pi * t / 2);
  return 250 * envelope * envelope * std::sin(3 * std::numbers::pi * t);
}

/// `factor` times the pulse in g; `tolerance` is half a digit of the last place, in cm/s2.
void check_pulse(const RecordFile& file, double factor, double tolerance) {
  BOOST_TEST(file.record.step == 0.02);
  BOOST_TEST(file.record.times.empty());
  BOOST_TEST_REQUIRE(file.record.values.size() == 100U);
  for (std::size_t i = 0; i < 100; ++i) {
    const double off = file.record.values[i] * cm_per_s2 - factor * pulse(i);
    BOOST_TEST(std::abs(off) <= tolerance, "value " << i << " is off by " << off);
  }
}

struct Sample {
  const char* name;
  double tolerance;  ///< cm/s2
  const char* description;
};

std::ostream& operator<<(std::ostream& stream, const Sample& sample) {
  return stream << sample.name;
}

// Half a unit of the last place written, and 1e-9 for the arithmetic. Of K-NET half a count, twice,
// because the mean of the rounded counts is off as well; of SMC half of 0.01.
const std::vector<Sample> samples{
    {"ASC", 0.5e-6 + 0.5e-6 + 1e-9, "SYNTHETIC, NO EARTHQUAKE XX NONE HNE"},
    {"EW", 2 * 0.5 * 3920 / 6182761, "SYNTHETIC E-W; the mean of the counts, 8000, is taken off"},
    {"V2#1", 0.5e-5 + 0.5e-6 + 1e-9, "Station No. 00000 SYNTHETIC; Chan 1: 90 Deg"},
    {"V2c", 0.5e-3 + 0.5e-6 + 1e-9, "Statn No: 00- 0 Code:XX-NONE SYNTHETIC; Sta Chan 1: 90 deg"},
    {"smc", 0.5e-2 + 0.5e-6 + 1e-9, "SYNTHETIC, NO EARTHQUAKE; made by make_records.py"},
};

}  // namespace

BOOST_DATA_TEST_CASE(sample_holds_the_pulse, data::make(samples), sample) {
  const RecordFile file = records::read_record(path_of(sample.name));
  BOOST_TEST(file.units == RecordUnits::cm_per_s2);
  BOOST_TEST(file.description.starts_with(sample.description), file.description);
  check_pulse(file, 1, sample.tolerance);
}

BOOST_AUTO_TEST_CASE(channels_are_told_by_number) {
  check_pulse(records::read_record(path_of("V2#2")), -0.5, 1e-5);
  const auto refusal = [](const std::string& name) {
    return refusal_of<FileError>([&] { return records::read_record(path_of(name)); });
  };
  check_says(refusal("V2"), {"line 134: a second channel begins here, and there are 2", "#1 to "});
  check_says(refusal("V2#3"), {"line 134: the last channel is number 2", "no number 3"});
  check_says(refusal("ASC#2"), {"holds one record", "no channel 2"});
  check_says(refusal("V2#0"), {"V2#0: cannot be read"});
  check_says(refusal("V2#x"), {"V2#x: cannot be read"});
  check_says(refusal("V2#2.5"), {"V2#2.5: cannot be read"});
}

// ---- other forms that are right

namespace {

struct Variant {
  const char* name;
  const char* sample;
  std::string old;
  std::string now;
  double tolerance;  ///< cm/s2, as of the samples
  double factor{1};
};

std::ostream& operator<<(std::ostream& stream, const Variant& variant) {
  return stream << variant.name;
}

const std::vector<Variant> right{
    {"esm_of_version_1", "ASC", "ORIGINAL_DATA_CREATOR: \n", "", 2e-6},
    {"esm_in_m_s2", "ASC", "UNITS: cm/s^2", "UNITS: m/s^2", 2e-4, 100},
    {"knet_with_another_frequency_unit", "EW", "50Hz", "50", 1e-3},
    {"knet_with_a_broken_duration", "EW", "50Hz\nDuration Time(s)  2\n",
     "50 Hz\nDuration Time(s)  2.00\n", 1e-3},
    {"knet_with_a_trailer", "EW", "7428     7927\n", "7428     7927\n\nEND\n", 1e-3},
    {"csmip_in_capitals", "V2", "accel data equally spaced at 0.020 sec, in cm/sec2. (8f10.5)\n",
     "ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)\n", 1e-5},
    {"cosmos_with_other_units", "V2c", "cm/sec2(04)", "cm/s^2 (4)", 1e-3},
    {"cosmos_in_g", "V2c", "cm/sec2(04)", "g (02)", 1, cm_per_s2},
    {"cosmos_without_format", "V2c", ",Format=(10F8.3)", "", 1e-3},
    {"cosmos_without_length", "V2c", "     2.000000", "  -999.000000", 1e-3},
};

}  // namespace

BOOST_DATA_TEST_CASE(other_forms_are_read, data::make(right), variant) {
  const std::string text = replaced(text_of(variant.sample), variant.old, variant.now);
  const RecordOptions first{.channel = 1};
  check_pulse(records::parse_record(text, "record", first), variant.factor, variant.tolerance);
  std::string crlf;
  for (const char c : text) {
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  check_pulse(records::parse_record(crlf, "record", first), variant.factor, variant.tolerance);
}

BOOST_AUTO_TEST_CASE(fields_without_a_format_part_at_a_sign) {
  const std::string two = replaced(text_of("V2c"), "-85.765-101.656-115.076-125.000",
                                   "-85.765 -101.656-115.076-125.000");
  const std::string words = replaced(two, ",Format=(10F8.3)", "");
  BOOST_TEST(records::parse_record(words, "record").record.values ==
                 records::parse_record(text_of("V2c"), "record").record.values,
             boost::test_tools::per_element());
  // With a width the blank moves the fields behind it.
  check_says(refusal_of<FileError>([&] { return records::parse_record(two, "record"); }),
             {"line 48, column 33:", "is not a number"});
}

namespace {

/// 50 Hz for so many seconds.
std::string knet_heading(const std::string& duration) {
  const std::string& text = text_of("EW");
  return replaced(text.substr(0, text.find("    8000     8073")), "Time(s)  2",
                  "Time(s)  " + duration);
}

}  // namespace

BOOST_AUTO_TEST_CASE(mean_of_counts_is_taken_off) {
  const std::string text = knet_heading("0.06");
  const RecordFile file = records::parse_record(text + "1 2 6\n", "record");  // the mean is 3
  const double gal = 3920.0 / 6182761;
  const std::vector<double> expected{-2 * gal / cm_per_s2, -gal / cm_per_s2, 3 * gal / cm_per_s2};
  BOOST_TEST_REQUIRE(file.record.values.size() == 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    BOOST_TEST(std::abs(file.record.values[i] - expected[i]) <= 1e-15 * std::abs(expected[i]));
  }
}

// 0.58 times 50 is 29 - 4e-15.
BOOST_AUTO_TEST_CASE(duration_is_a_decimal) {
  std::string counts;
  for (int i = 0; i < 29; ++i) {
    counts += "7 ";
  }
  const RecordFile file = records::parse_record(knet_heading("0.58") + counts, "record");
  BOOST_TEST(file.record.values == std::vector<double>(29, 0.0), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
