// SPDX-License-Identifier: MIT

// The formats of the networks. The samples of data/records hold
// one pulse, 250 cm/s2 sin^2(pi t / 2) sin(3 pi t), in all of them.

#include "samples.hpp"

BOOST_AUTO_TEST_SUITE(record_formats_test)

using namespace stillpoint::test;

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
  double factor{1};  ///< of the pulse
  RecordUnits units{RecordUnits::cm_per_s2};
};

std::ostream& operator<<(std::ostream& stream, const Sample& sample) {
  return stream << sample.name;
}

// Half a unit of the last place written, and 1e-9 for the arithmetic. Of K-NET half a count, twice,
// because the mean of the rounded counts is off as well; of SMC half of 0.01.
const std::vector<Sample> samples{
    {"ASC", 0.5e-6 + 0.5e-6 + 1e-9, "SYNTHETIC, NO EARTHQUAKE XX NONE HNE"},
    {"EW", 2 * 0.5 * 3920 / 6182761, "SYNTHETIC E-W; the mean of the counts, 8000, is subtracted"},
    {"V2#1", 0.5e-5 + 0.5e-6 + 1e-9, "Station No. 00000 SYNTHETIC; Chan 1: 90 Deg"},
    {"V2c", 0.5e-3 + 0.5e-6 + 1e-9, "Statn No: 00- 0 Code:XX-NONE SYNTHETIC; Sta Chan 1: 90 deg"},
    {"smc", 0.5e-2 + 0.5e-6 + 1e-9, "SYNTHETIC, NO EARTHQUAKE; made by make_records.py"},
    {"V2A#1", 0.5e-2 + 0.5e-6 + 1e-9,
     "Corrected accelerogram SYNTHETIC_NONE_20 no earthquake; Component N90E", 1,
     RecordUnits::mm_per_s2},
    {"V2A#2", 0.5e-2 + 0.5e-6 + 1e-9,
     "Corrected accelerogram SYNTHETIC_NONE_20 no earthquake; Component N00E", -0.5,
     RecordUnits::mm_per_s2},
    {"afad.txt#1", 0.5e-6 + 0.5e-6 + 1e-9, "NOWHERE, N-S"},
    {"afad.txt#3", 0.5e-6 + 0.5e-6 + 1e-9, "NOWHERE, U-D", 0.25},
    {"cwa.txt#2", 0.5e-3 + 0.5e-6 + 1e-9, "NONE SYNTHETIC, N(+)"},
    {"cwa.txt#3", 0.5e-3 + 0.5e-6 + 1e-9, "NONE SYNTHETIC, E(+)", -0.5},
    {"asa#1", 0.5e-3 + 0.5e-6 + 1e-9, "NONE, N00E;L"},
    {"asa#2", 0.5e-3 + 0.5e-6 + 1e-9, "NONE, N90E;T", -0.5},
};

BOOST_DATA_TEST_CASE(sample_holds_the_pulse, data::make(samples), sample) {
  const RecordFile file = records::read_record(path_of(sample.name));
  BOOST_TEST(file.units == sample.units);
  BOOST_TEST(file.description.starts_with(sample.description), file.description);
  check_pulse(file, sample.factor, sample.tolerance);
}

BOOST_AUTO_TEST_CASE(channels_are_told_by_number) {
  check_pulse(records::read_record(path_of("V2#2")), -0.5, 1e-5);
  const auto refusal = [](const std::string& name) {
    return refusal_of<FileError>([&] { return records::read_record(path_of(name)); });
  };
  check_says(refusal("V2"), {"line 134: the second of 2 channels begins here", "#1 to "});
  for (const char* const table : {"V2A", "afad.txt", "cwa.txt", "asa"}) {
    check_says(refusal(table), {"choose one by its number", "#1 to #3"});
    check_says(refusal(table + std::string("#4")), {"there is no channel 4: the last is number 3"});
  }
  check_says(refusal("V2#3"), {"line 134: there is no channel 3", "the last is number 2"});
  check_says(refusal("ASC#2"), {"holds one record", "no channel 2"});
  check_says(refusal("V2#0"), {"V2#0: cannot be read"});
  check_says(refusal("V2#x"), {"V2#x: cannot be read"});
  check_says(refusal("V2#2.5"), {"V2#2.5: cannot be read"});
}

// ---- other forms that are right

/// A .V2c that gives `ms` for the step of its values and `s` for that of the recorder.
std::string cosmos_with_steps(const std::string& ms, const std::string& s) {
  return replaced(replaced(sample_text("V2c"), "    20.000000", ms), "     0.010000", s);
}

/// As exact as the sample that they are made of.
BOOST_AUTO_TEST_CASE(other_forms_are_read) {
  for (const Row& row : rows_of("formats_right.txt")) {
    const std::string text = replaced(sample_text(row.name), row.old, row.now);
    const auto sample = std::ranges::find_if(
        samples, [&](const Sample& now) { return std::string(now.name).starts_with(row.name); });
    const double tolerance = sample->tolerance * std::max(1.0, row.options.scale);
    for (const std::string& same : {text, with_line_ends(text, "\r\n"),
                                    with_line_ends(text, "\r\r\n"), with_line_ends(text, "\r")}) {
      BOOST_TEST_CONTEXT(row.name << ": '" << row.old << "' as '" << row.now << "'") {
        check_pulse(records::parse_record(same, "record", {.channel = 1}), row.options.scale,
                    tolerance);
      }
    }
  }
}

// Processing may have changed the steps of the recorder.
BOOST_AUTO_TEST_CASE(step_of_cosmos_is_that_of_the_values) {
  const auto read = [](const std::string& ms, const std::string& s) {
    return records::parse_record(cosmos_with_steps(ms, s), "a");
  };
  const std::string unknown = "  -999.000000";
  check_pulse(read("    20.000000", "     0.005000"), 1, 1e-3);
  check_pulse(read("    20.000000", unknown), 1, 1e-3);
  check_pulse(read(unknown, "     0.020000"), 1, 1e-3);
  check_says(refusal_of<FileError>([&] { return read(unknown, unknown); }),
             {"line 31: Real-header value 34, the step, = -999: must be more than 0"});
}

BOOST_AUTO_TEST_CASE(units_that_csmip_leaves_out_are_those_of_the_option) {
  const std::string text = replaced(sample_text("V2"), ", in cm/sec2.", ".");
  const RecordOptions given{.units = RecordUnits::cm_per_s2, .channel = 1};
  check_pulse(records::parse_record(text, "a", given), 1, 1e-5);
}

// Laid out like the networks' own files, with our numbers.
BOOST_AUTO_TEST_CASE(layouts_of_published_files_are_read) {
  const std::vector<double> expected{1, -0.5, 0.25};
  const auto check = [&](const std::string& text, double step) {
    const RecordFile file = records::parse_record(text, "record");
    BOOST_TEST(file.units == RecordUnits::cm_per_s2);
    BOOST_TEST(file.record.step == step);
    BOOST_TEST_REQUIRE(file.record.values.size() == 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      BOOST_TEST(std::abs(file.record.values[i] - expected[i]) <= 5e-5, i);  // five digits
    }
  };
  const auto repeated = [](int times, const std::string& part) {
    std::string text;
    for (int i = 0; i < times; ++i) {
      text += part;
    }
    return text;
  };
  // DYNA 1.2 by DYNA 1.0: keys without a value, colons and slashes in values.
  check(
      "EVENT_NAME: NOWHERE\nMAGNITUDE_W: \nVS30_M/S: \nSAMPLING_INTERVAL_S: 0.005000\n"
      "NDATA: 3\nUNITS: cm/s^2\nINSTRUMENT: sensor = X [Unknown] | digitizer = Y\n"
      "PGA_CM/S^2: 980.665\nHEADER_FORMAT: DYNA 1.2\nDATA_TYPE: ACCELERATION\n"
      "ORIGINAL_DATA_MEDIATOR: http://nowhere/\nUSER1: x.py --le 0.100 a:b\nUSER5: \n"
      "980.665000\n-490.332500\n245.166250\n",
      0.005);
  // Fields of 10 columns whose exponent has one digit, so that none is parted by a blank.
  const std::string unknown = repeated(5, "  0.1700000E+39") + "\n";
  check("2 CORRECTED ACCELEROGRAM\n" + repeated(10, "*\n") + repeated(8, "    -32768") + "\n" +
            repeated(5, "         1") + "       360       101         1\n         3" +
            repeated(7, "    -32768") + "\n" + repeated(3, repeated(8, "    -32768") + "\n") +
            "  0.1700000E+39  0.2000000E+03" + repeated(3, "  0.1700000E+39") + "\n" +
            repeated(9, unknown) + "|a comment\n 9.8067E+2-4.9033E+2 2.4517E+2\n",
        1.0 / 200);
  // One value a line in 15 columns; the reals in 20 lines of five; a recorder with longer steps.
  const std::string missing = repeated(5, "    -999.000000") + "\n";
  check("Corrected acceleration    (Format v01.20 with 13 text lines)\n" + repeated(12, "text\n") +
            " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" +
            repeated(10, repeated(10, "    -999") + "\n") +
            " 100 Real-header values follow on  20 lines, Format= (5F15.6)\n" +
            repeated(6, missing) +
            "    -999.000000       0.000000    -999.000000       0.020000       0.015000\n" +
            repeated(5, missing) +
            "    -999.000000       5.000000       0.015000     980.665000       0.000000\n" +
            repeated(7, missing) + "   1 Comment line(s) follow, each starting with a \"|\":\n" +
            "| Recorder: none\n       3 acceleration pts, approx  0 secs, units=cm/sec2(04)," +
            "Format=(1E15.6)\n   9.806650e+02\n  -4.903325e+02\n   2.451662e+02\n" +
            "End-of-data for Chan  ? acceleration\n",
        0.005);
}

BOOST_AUTO_TEST_CASE(fields_without_a_format_part_at_a_sign) {
  const std::string two = replaced(sample_text("V2c"), "-85.765-101.656-115.076-125.000",
                                   "-85.765 -101.656-115.076-125.000");
  const std::string words = replaced(two, ",Format=(10F8.3)", "");
  BOOST_TEST(records::parse_record(words, "record").record.values ==
                 records::parse_record(sample_text("V2c"), "record").record.values,
             tt::per_element());
  // With a width the blank moves the fields behind it.
  check_says(refusal_of<FileError>([&] { return records::parse_record(two, "record"); }),
             {"line 48, column 33:", "is not a number"});
}

BOOST_AUTO_TEST_CASE(a_long_line_of_values_that_touch_is_read_once) {
  // Reading the rest of the line again for each value would take 400 000 times 400 kB on average: a
  // minute.
  constexpr std::size_t count = 400'000;
  const std::string length = "     2.000000";
  const std::string unknown = "  -999.000000";
  const std::string sample =
      replaced(replaced(sample_text("V2c"), length, unknown), length, unknown);
  std::string text = sample.substr(0, sample.find("     100 acceleration pts")) +
                     std::to_string(count) + " acceleration pts, units=g (02)\n";
  for (std::size_t i = 0; i < count; ++i) {
    text += "-1";
  }
  const std::vector<double> values = records::parse_record(text, "record").record.values;
  BOOST_TEST(values.size() == count);
  BOOST_TEST(std::ranges::count(values, -1) == static_cast<std::ptrdiff_t>(count));
}

/// 50 Hz for this many seconds.
std::string knet_heading(const std::string& duration) {
  const std::string text = sample_text("EW");
  return replaced(text.substr(0, text.find("    8000     8073")), "Time(s)  2",
                  "Time(s)  " + duration);
}

BOOST_AUTO_TEST_CASE(mean_of_counts_is_subtracted) {
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
  BOOST_TEST(file.record.values == std::vector<double>(29, 0.0), tt::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
