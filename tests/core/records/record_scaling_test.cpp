// SPDX-License-Identifier: MIT
#include "record_texts.hpp"
#include "testing/folder.hpp"

#include <stillpoint/records/record_suite.hpp>

BOOST_AUTO_TEST_SUITE(record_scaling_test)

using namespace stillpoint::test;
using records::spectral_acceleration;

constexpr double pi = std::numbers::pi;

double off(double value, double expected) {
  return std::abs(value / expected - 1);
}

BOOST_AUTO_TEST_CASE(peak_has_no_sign) {
  BOOST_TEST(records::peak_acceleration({{0.1, -0.4, 0.3}, 0.01, {}}) == 0.4);
  BOOST_TEST(records::peak_acceleration({{0, 0}, 0.01, {}}) == 0);
}

// Under a constant load the first turn overshoots the rest by exp(-pi zeta/sqrt(1 - zeta^2)). A
// push of next to no time leaves the velocity k dt, which takes the oscillator to k dt/p
// exp(-zeta/s atan2(s, zeta)), s = sqrt(1 - zeta^2), when it is over; between samples W is
// straight.
BOOST_AUTO_TEST_CASE(spectrum_of_a_constant_load_and_of_a_push) {
  constexpr double zeta = records::spectrum_damping;
  const double s = std::sqrt(1 - zeta * zeta);
  for (const double p : {0.3, 1.0, 7.0}) {
    BOOST_TEST(off(spectral_acceleration({{0.3, 0.3}, 1.2 * pi / p, {}}, p),
                   0.3 * (1 + std::exp(-pi * zeta / s))) <= 1e-14);
    const double dt = 1e-9 / p;
    const double reached = 0.3 * dt * p * std::exp(-zeta / s * std::atan2(s, zeta));
    for (const Record& push : {Record{{-0.3, -0.3}, dt, {}}, Record{{0, 0.3, 0}, dt, {}},
                               Record{{0, 0.3, 0}, 0, {7, 7 + 0.5 * dt, 7 + 2 * dt}}}) {
      BOOST_TEST(off(spectral_acceleration(push, p), reached) <= 1e-5);
    }
  }
}

// A stiff oscillator follows the load, a soft one stands still while the ground moves.
BOOST_AUTO_TEST_CASE(limits_of_the_spectrum) {
  const Record record{{0, 0.1, 0.35, -0.2, 0}, 1, {}};
  BOOST_TEST(off(spectral_acceleration(record, 6.2), 0.35) <= 0.2);
  // Far below the frequencies of the load y = p^2 (ground displacement), which goes on growing.
  BOOST_TEST(spectral_acceleration(record, 1e-3) <= 1e-3);
  BOOST_TEST(spectral_acceleration({{0.4}, 1, {}}, 1) == 0);
}

BOOST_AUTO_TEST_CASE(period_must_be_resolved) {
  const Record record{{0, 1, 0}, 0.5, {}};
  BOOST_TEST(spectral_acceleration(record, 2 * pi / 0.5) > 0);
  check_says(refusal_of<InputError>([&] { return spectral_acceleration(record, 2 * pi / 0.49); }),
             {"record-spectrum-period = 0.49", "at least 0.5, the mean time between two values"});
  BOOST_TEST(*records::mean_interval({{0, 1, 0}, 0, {0, 1, 3}}) == 1.5);
}

/// Those that have an ending of records and do not begin with text.
BOOST_AUTO_TEST_CASE(folder_is_its_records) {
  const Folder folder;
  using Files = std::vector<std::pair<std::string, std::string>>;
  const Files kept{
      {"C.v2", "1\n"},
      {"a.AT2", "wrong, but its ending says what it should be\n"},
      {"b.txt", "# a comment\n\n0 1\n"},
      {"c.csv", "time,acceleration\n0,1\n"},  // a record that needs a # in front of its heading
      {"d.EW", "1\n"},
      {"d.csv", "t;a\n0;1\n"},
      {"e.dat", "NPTS= 1, DT= .1 SEC\n1\n"},
      {"f.txt", "0,1 0,2\n"},
  };
  const Files left{
      {"README.txt", "Records of two earthquakes.\nSee the report.\n1\n"},
      {"comments.txt", "# nothing but comments\n"},
      {"flatfile.csv", "-- Summary of the records --\n\nResult ID,RSN,Tp\n1,953,\n"},
  };
  const auto paths = [&](const Files& files) {
    std::vector<std::string> list;
    for (const auto& [name, text] : files) {
      folder.write(name, text);
      list.push_back(folder.path(name));
    }
    return list;
  };
  const std::string path = fs::path(folder.path("x")).parent_path().string();
  const std::vector<std::string> records = paths(kept);
  const std::vector<std::string> texts = paths(left);
  paths({{"d.UD", "1\n"}, {"readme.md", "1\n"}, {".hidden.txt", "1\n"}});
  fs::create_directory(folder.path("e.txt"));
  BOOST_TEST(records::record_files(path) == records, tt::per_element());
  BOOST_TEST(records::folder_files(path).plain_text == texts, tt::per_element());
  BOOST_TEST(records::record_files("none.txt") == std::vector<std::string>{"none.txt"});
  check_says(refusal_of<FileError>([&] { return records::record_files(folder.path("e.txt")); }),
             {"e.txt: this folder has no record", ".AT2 .ASC"});
  for (const std::string& record : records) {
    fs::remove(record);
  }
  check_says(refusal_of<FileError>([&] { return records::record_files(path); }),
             {"this folder has no record", "README.txt begins with text"});
}

/// What is doubtful in a file of that text.
std::vector<std::string> doubts(const std::string& text, const RecordOptions& options = {},
                                const records::RecordScale& scale = {},
                                const std::string& name = "a.txt") {
  const Folder folder;
  folder.write(name, text);
  return records::suite_doubts({{folder.path(name)}}, scale, options);
}

BOOST_AUTO_TEST_CASE(files_that_are_read_may_be_doubtful) {
  const auto check_only = [](const std::vector<std::string>& found,
                             const std::vector<std::string>& parts) {
    BOOST_TEST_REQUIRE(found.size() == 1U);
    check_says(found.front(), parts);
  };
  // In g unless it is said otherwise: 2 g is the most that is believed.
  check_only(doubts("0 0\n1 -341.7\n"),
             {"a.txt: the largest value is 341.7 g if", "--record-units cm/s2?"});
  check_only(doubts("0 0\n1 6\n"), {"6 g if its values are in g", "--record-units m/s2?"});
  BOOST_TEST(doubts("0 0\n1 2\n").empty());
  const RecordOptions in_cm{.units = records::RecordUnits::cm_per_s2};
  BOOST_TEST(doubts("0 0\n1 2900\n", in_cm).empty());
  check_only(doubts("0 0\n1 -3000\n", in_cm),
             {"a.txt: has a peak of 3.059 g; more than 3 g is doubtful"});
  BOOST_TEST(doubts("0 0\n1 341\n", {}, {.target = {.peak = 0.4}}).empty());
  for (const records::RecordScale& scale :
       {records::RecordScale{.factor = -5}, records::RecordScale{.target = {.peak = 2.5}}}) {
    check_only(doubts("0 0\n1 0.5\n", {}, scale),
               {"a.txt: is multiplied by ", "5, to a peak of 2.5 g"});
  }
  BOOST_TEST(doubts("0 0\n1 0.5\n", {}, {.factor = 4}).empty());
  // The factor of a spectrum is known where its period is: here 1e13, and 1.
  const double p = 2 * std::numbers::pi;
  const std::string weak = "0 0\n0.1 1e-14\n0.2 0\n";
  const double own = records::spectral_acceleration(record_of("a.txt", weak), p);
  check_only(doubts(weak, {}, {.target = {.spectrum = 1e13 * own}, .spectrum_p = p}),
             {"a.txt: is multiplied by 1e+13, to a peak of 0.1 g"});
  BOOST_TEST(doubts(weak, {}, {.target = {.spectrum = own}, .spectrum_p = p}).empty());
  const std::string counted = "NPTS= 1, DT= .1 SEC\n400\n";
  check_only(doubts("A title\n" + counted), {"400 g"});
  check_only(doubts("ACCELERATION IN UNITS OF G\n" + counted), {"has a peak of 400 g"});

  std::string even;
  std::string in_ms;
  std::string with_gap;
  for (int i = 0; i < 101; ++i) {
    const std::string value = i > 90 ? " 0\n" : i % 2 == 0 ? " 0.1\n" : " -0.1\n";
    in_ms += in_full(10.0 * i) + value;
    even += in_full(std::round(i / 0.03) / 1000) + value;  // 0.033, 0.067
    with_gap += i >= 60 && i < 66 ? "" : in_full(0.5 * i) + value;
  }
  BOOST_TEST(doubts(even).empty());
  check_only(doubts(in_ms), {"a.txt: its values are 10 s apart on average; are its times in ms?"});
  check_only(doubts("# t, a\n" + with_gap),
             {"a.txt: the time jumps from 29.5 to 33", "other steps are 0.5"});
  const Folder folder;
  folder.write("a.txt", "# t, a\n" + with_gap);
  folder.write("notes.txt", "Notes of the site visit.\n");
  const std::string whole = fs::path(folder.path("x")).parent_path().string();
  const auto found = records::suite_doubts({{whole}}, {}, {});
  BOOST_TEST_REQUIRE(found.size() == 2U);
  check_says(found[0], {"notes.txt: is left out because it begins with text"});
}

/// w = 0.3 sin(1.6 pi t) exp(-((t-8)/4)^2) + offset, as times and values, for `count` values.
std::string wave(int count, double offset = 0) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double t = 0.01 * i;
    const double fade = (t - 8) / 4;
    text += in_full(t) + " " +
            in_full(0.3 * std::sin(1.6 * std::numbers::pi * t) * std::exp(-fade * fade) + offset) +
            "\n";
  }
  return text;
}

BOOST_AUTO_TEST_CASE(shapes_that_are_no_ground_motion_are_doubtful) {
  const auto doubt = [](const std::string& text) {
    const auto found = doubts(text);
    BOOST_TEST(found.size() <= 1U);
    return found.empty() ? "" : found.front();
  };
  BOOST_TEST(doubt(wave(2000)) == "");
  // The wave has a crest where 1.6 t is 1/2 more than a whole number, at 7.8125 s, and passes
  // through 0 where it is one, at 8.125 s: wherever it is cut off between them.
  for (int count = 782; count <= 814; ++count) {
    check_says(doubt(wave(count)),
               {"a.txt: has 0.29", " at its end", "its peak is 0.299", "is it cut off?"});
  }
  check_says(doubt(wave(2000, 0.02)), {"a.txt: has the mean 0.020", "was the offset"});
  check_says(doubt(wave(2000, -0.02)), {"has the mean -0.01"});
  BOOST_TEST(doubt(wave(2000, 0.002)) == "");
  std::string spectrum;
  for (int i = 1; i <= 40; ++i) {
    spectrum += in_full(0.1 * i) + " " + in_full(0.6 / i) + "\n";
  }
  check_says(doubt(spectrum), {"a.txt: has values of one sign only: is it a spectrum"});
  check_says(doubt("# acc in m/s2\n" + wave(2000)),
             {"names the units m/s2", "--record-units m/s2?"});
}

BOOST_AUTO_TEST_CASE(vertical_components_are_said) {
  const RecordOptions of_others{.step = 0.01, .step_for_others = true};
  for (const char* const name :
       {"A-UP.AT2", "A_DWN.AT2", "A-V.AT2", "a-z.AT2", "up.AT2", "A.ud.AT2"}) {
    const auto found = doubts(header + three, of_others, {}, name);
    BOOST_TEST_REQUIRE(found.size() == 1U, name);
    check_says(found.front(), {"is a vertical component by its name"});
  }
  for (const char* const name : {"A-H1.AT2", "A090.AT2", "SUPER.AT2", "A-UP2.AT2"}) {
    BOOST_TEST(doubts(header + three, of_others, {}, name).empty(), name);
  }
  for (const char* const station : {"SOME STATION, UP", "SOME STATION, DWN", "SOME STATION, V"}) {
    std::string text = "PEER NGA\nNOWHERE, ";
    text.append(station)
        .append("\n")
        .append(quantity)
        .append("NPTS= 3, DT= .01 SEC\n")
        .append(three);
    BOOST_TEST(doubts(text, of_others, {}, "a.AT2").size() == 1U, station);
  }
  for (const auto& [sample, vertical] : {std::pair{"V2A#3", true},
                                         {"V2A#1", false},
                                         {"afad.txt#3", true},
                                         {"afad.txt#1", false},
                                         {"cwa.txt#1", true},
                                         {"cwa.txt#3", false},
                                         {"asa#3", true},
                                         {"asa#2", false}}) {
    const auto found = records::suite_doubts(
        {{std::string(STILLPOINT_DATA_DIR "/records/short_pulse.") + sample}}, {}, {});
    BOOST_TEST(found.size() == (vertical ? 1U : 0U), sample);
  }
}

BOOST_AUTO_TEST_SUITE_END()
