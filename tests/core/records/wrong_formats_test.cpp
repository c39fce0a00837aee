// SPDX-License-Identifier: MIT

// Wrong files of the networks: each is refused in one line, with file and line.

#include "samples.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_file.hpp>

BOOST_AUTO_TEST_SUITE(wrong_formats_test)

namespace {

using namespace stillpoint::test;

/// For a sample: what replaces what, and what the refusal says as in a Bad.
struct Wrong {
  std::string old;
  std::string now;
  std::string says;
  RecordOptions options{};
};

const std::map<std::string, std::vector<Wrong>> wrong_samples{
    {"ASC",
     {
         {"SAMPLING_INTERVAL_S: 0.020000\n", "",
          "line 63: the header ends here without SAMPLING_INTERVAL_S"},
         {"INTERVAL_S: 0.020000", "INTERVAL_S:", "line 64:...without SAMPLING"},
         {"0.020000", "0", "line 29: SAMPLING_INTERVAL_S = 0: must be more than 0"},
         {"0.020000", "-1", "line 29:...= -1: must be more than 0"},
         {"0.020000", "20 ms", "line 29, column 22: \"20 ms\" is not a number"},
         {"0.020000", "0,02",
          "line 29, column 22: \"0,02\" is not a number; write a decimal comma as a point"},
         {"0.020000", "nan", "line 29,...\"nan\" is not a finite number"},
         {"NDATA: 100\n", "", "line 63:...without NDATA"},
         {"NDATA: 100", "NDATA: 0", "line 30: NDATA = 0...from 1 to 1000000000"},
         {"NDATA: 100", "NDATA: 1e300", "line 30: NDATA = 1e300...to 1000000000"},
         {"NDATA: 100", "NDATA: 999999999",
          "line 164: too few values: the file ends after 100, but NDATA = 999999999 on line 30"},
         {"NDATA: 100", "NDATA: 99", "line 164: too many values: more than NDATA = 99 on line 30"},
         {"UNITS: cm/s^2\n", "", "line 63:...without UNITS"},
         {"cm/s^2", "mg", "line 33: the units \"mg\" are unknown"},
         {"cm/s^2", "cm/s", "line 33:...are those of a velocity"},
         {"TYPE: ACCEL", "TYPE: VEL", "line 50: DATA_TYPE...must be ACCELERATION"},
         {"\n4.949514\n", "\nx\n", "line 70, column 1: \"x\" is not a number; value 6 of 100"},
         {"\n4.949514\n", "\nNaN\n", "line 70,...not a finite number"},
         {"\n4.949514\n", "\n1e308\n", "line 70,...is out of range"},
         {"",
          "",
          "line 33: the values are in cm/s2, but record-units = g",
          {.units = RecordUnits::g}},
         {"", "", "line 29: the file gives SAMPLING_INTERVAL_S", {.step = 0.01}},
     }},
    {"EW",
     {
         {"Memo.", "Note.", "line 17:...must end with the line Memo."},
         {"Sampling Freq(Hz)", "Sampling", "line 17:...without Sampling Freq"},
         {"50Hz", "0Hz", "line 11:...\"0Hz\": must be a number, more than 0"},
         {"50Hz", "fast", "line 11:...\"fast\": must be a number"},
         {"Duration", "Lasted", "line 17:...without Duration Time(s)"},
         {"Scale Factor", "Scale", "line 17:...without Scale Factor"},
         {"(gal)/", "/", "line 14:...\"3920/6182761\": must be A(gal)/B"},
         {"3920", "3,920", "line 14:...\"3,920(gal)\": must be...thousands without a comma"},
         {"6182761", "0", "line 14:...\"0\": must be a number, more than 0"},
         {"3920", "1e200", "line 14:...is out of range"},
         {"Time(s)  2", "Time(s)  2.01",
          "line 12: Sampling Freq times Duration Time = 100.5: must be a whole number"},
         {"Time(s)  2", "Time(s)  3",
          "line 30: too few values: the file ends after 100...= 150 on line 12"},
         {"Time(s)  2", "Time(s)  1", "line 24: too many values...= 50 on line 12"},
         {" 8073 ", " 80x3 ", "line 18, column 14: \"80x3\" is not a number; value 2"},
         {" 8073 ", " 80.5 ", "line 18,...must be a whole number"},
         {" 8073 ", " 9e99 ", "line 18,...is not a count"},
     }},
    {"V2",
     {
         {"points of accel data",
          "points of data",
          "line 134: there is no channel...the last is number 1",
          {.channel = 3}},
         {"   100 points of accel data", "  -100 points of accel data",
          "line 46: the count of points = -100: must be a whole number"},
         {"   100 points of accel data", "   Ten points of accel data",
          "line 46, column 4: \"Ten\" is not a number"},
         {"   100 points of accel data", " 1,000 points of accel data",
          "line 46, column 2: \"1,000\" is not a number...thousands without a comma"},
         {"at 0.020 sec", "at 0,020 sec",
          "line 46, column 47: \"0,020\" is not a number; write a decimal comma as a point"},
         {"data equally spaced at 0.020 sec", "data", "line 46: the step is missing"},
         {"at 0.020 sec", "at 20 msec", "line 46: the step is missing"},
         {"at 0.020 sec", "at 0.000 sec", "line 46: step = 0: must be more than 0"},
         {", in cm/sec2.", "", "line 46: the units are missing...give record-units"},
         {"in cm/sec2.", "in g/10.", "line 46: the units \"g/10\" are unknown"},
         {"   100 points of accel data", "   108 points of accel data",
          "line 60, column 4: \"100 points of veloc data...is not a number; value 101 of 108"},
         {"   100 points of accel data", "    92 points of accel data",
          "line 58: too many values: more than the count of points = 92 on line 46"},
         {"   0.36285", "   0.36x85", "line 47, column 24: \"0.36x85\" is not a number"},
         {"   0.36285", "       NaN", "line 47, column 28: \"NaN\" is not a finite"},
     }},
    {"V2c",
     {
         {"Real-header values", "Samples", "line 45: Real-header values are missing"},
         {"    20.000000", "  -999.000000",
          "line 31: 100 points of 0.01 s (Real-header value 34) take 1 s, but value 35 says 2 s"},
         {"    20.000000", "     0.020000",
          "line 36: 100 points of 2e-05 s (Real-header value 62) take 0.002 s, but value 63 says 2 "
          "s"},
         {"    20.000000", "    20.0x0000", "line 36, column 18: \"20.0x0000\" is not a number"},
         {"     0.010000", "     0.0x0000", "line 31, column 45: \"0.0x0000\" is not a number"},
         {"cm/sec2(04)", "counts (50)", "line 45: the units \"counts\" are unknown"},
         {"100 acceleration pts", "101 acceleration pts",
          "line 56, column 1: \"End-of-data for Chan  1 acceleration\"...is not a number; value "
          "101 of 101"},
         {"100 acceleration pts", " 90 acceleration pts", "line 36: 90 points of 0.02 s"},
         {"100 acceleration pts", " 99 acceleration pts",
          "line 55: too many values: more than the count of points = 99 on line 45"},
         {"   0.046", "     inf", "line 46, column 14: \"inf\" is not a finite"},
         {"acceleration pts", "velocity pts",
          "line 112: the file ends here without a line that says how many accelerations follow"},
     }},
    {"smc",
     {
         {"2 CORRECTED ACCELEROGRAM", "3 VELOCITY",
          "line 1: \"3 VELOCITY\" is not an acceleration"},
         {"  5.0000000E+01", "  1.7000000E+38",
          "line 18: real number 2, the samples in a second, is 1.7000000E+38"},
         {"  5.0000000E+01", "  0.0000000E+00", "line 18: real number 2"},
         {"       100", "    -32768", "line 14: whole number 17, the count of values, = -32768"},
         {"       100", "       104", "line 41: too few values: the file ends after"},
         {"       100", "        96",
          "line 41: too many values: more than whole number 17, the count of values, = 96 on line "
          "14"},
         {"| synthetic\n", "", "line 40: too few values"},
         {" 4.6219E-2", " 4.62:9E-2", "line 29, column 12: \"4.62:9E-2\""},
     }},
    {"V2A",
     {
         {"     100       0       0     100", "     100       0       0       0",
          "line 20: whole number 34 = 0: must be a whole number"},
         {"     100       0       0     100", "     100       0       0     101",
          "line 37: too many values: more than whole number 34 = 101 on line 20"},
         {"     100       0       0     100", "     100       0       0     110",
          "line 57: 19 lines stand between the accelerations and here, but...35 and 36 make 20"},
         {"     100       0       0     100", "     100       0       0      80",
          "line 57: 22 lines stand between the accelerations and here, but...35 and 36 make 20"},
         {"  0.0200", "  0.0000", "line 23: real number 26, the step, = 0: must be more than 0"},
         {" -1307.9", " -13x7.9", "line 29, column 58: \"-13x7.9\" is not a number"},
     }},
    {"afad.txt",
     {
         {"NUMBER OF DATA\t:\t100", "NUMBER OF DATA\t:\tmany",
          "line 13,...\"many\" is not a number"},
         {"NUMBER OF DATA\t:\t100", "NUMBER OF DATA\t:\t101",
          "line 118: too few values: the file ends after 300, but 3 columns times NUMBER OF DATA = "
          "303 on line 13"},
         {"NUMBER OF DATA\t:\t100", "NUMBER OF DATA\t:\t99",
          "line 118: too many values: more than 3 columns times NUMBER OF DATA = 297"},
         {"\t:\t0.020000", "\t:\t0", "line 14: SAMPLING INTERVAL = 0: must be more than 0"},
         {"    0.362847", "    0.36x847", "line 21, column 5: \"0.36x847\" is not a number"},
         {"", "", "line 14: the values are in cm/s2", {.units = RecordUnits::g}},
     }},
    {"cwa.txt",
     {
         {"#AmplitudeUnit:  gal.", "#AmplitudeUnit:  count",
          "line 6: the units \"count\" are unknown"},
         {"#AmplitudeUnit", "#Amplitude", "line 8: the header ends here without #AmplitudeUnit:"},
         {"#SampleRate(Hz): 50", "#SampleRate(Hz): 0", "line 5: 1 over the SampleRate"},
         {"#DataSequence", "#Data", "line 8: the header ends here without #DataSequence:"},
         {"     0.020     0.012", "     0.020", "line 108: too few values"},
     }},
    {"asa",
     {
         {"NUM. TOTAL DE MUESTRAS", "MUESTRAS",
          "line 109: the header ends here without NUM. TOTAL"},
         {"/100/100/100/", "/101/100/100/",
          "too few values...NUM. TOTAL DE MUESTRAS = 303 on line 72"},
         {"/0.02/0.02/0.02/", "/0.02/0.02", "must have as many values as NUM. TOTAL DE MUESTRAS"},
         {"/0.02/0.02/0.02/", "/0/0.02/0.02/", "line 47: INTERVALO DE MUESTREO = 0"},
         {"(cm/s/s)", "(cuentas)", "line 80: the units \"cuentas\" are unknown"},
         {"ORIENTACION C1", "ORIENTADO C1", "line 109: the header ends here without ORIENTACION"},
     }},
};

void check_wrong(const std::string& sample, const Wrong& wrong) {
  const std::string text =
      wrong.old.empty() ? text_of(sample) : replaced(text_of(sample), wrong.old, wrong.now);
  RecordOptions options = wrong.options;
  options.channel = wrong.options.channel.value_or(1);
  const std::string message =
      refusal_of<FileError>([&] { return records::parse_record(text, "a", options); });
  check_parts(message, wrong.says);
  BOOST_TEST(message.starts_with("record a, line "), message);
}

const std::vector<std::string> samples{"ASC", "EW",       "V2",      "V2c", "smc",
                                       "V2A", "afad.txt", "cwa.txt", "asa"};

}  // namespace

BOOST_DATA_TEST_CASE(wrong_files_are_refused, data::make(samples), sample) {
  for (const Wrong& wrong : wrong_samples.at(sample)) {
    BOOST_TEST_CONTEXT("'" << wrong.old << "' as '" << wrong.now << "'") {
      check_wrong(sample, wrong);
    }
  }
}

// ---- what is known and not read

BOOST_AUTO_TEST_CASE(other_formats_are_refused_by_name) {
  const auto check = [](const std::string& bytes, const std::string& says) {
    check_says(refusal_of<FileError>([&] { return records::parse_record(bytes, "a"); }), {says});
  };
  for (const bool big : {false, true}) {
    std::string sac(632, '\0');
    sac.replace(0, 4, "\x0A\xD7\x23\x3C");  // a step of 0.01
    sac[big ? 307 : 304] = 6;
    check(sac, "a: is a SAC file, which is not read");
  }
  check("000001D ABCD   HNE" + std::string(494, '\1'), "is a miniSEED file, which is not read");
  check(std::string("MS\x03\0\0", 5), "is a miniSEED file");
  check("PK\x03\x04...", "is a zip archive: take the record out of it");
  check("\x1F\x8B...", "is compressed: unpack it");
  check("WID2 2000/01/01", "is a GSE2 file");
  check("Uncorrected Accelerogram Data    Processed: 02/13/12\n", "volume 1), which is not read");
  check("VOLUME I OF UNCORRECTED ACCELEROGRAM DATA OF A\n", "volume 1), which is not read");
  check("RESPONSE AND FOURIER AMPLITUDE SPECTRA\n", "holds spectra (volume 3)");
  check("5 RESPONSE SPECTRA\n", "is not an acceleration");
  std::string usc = "CORRECTED ACCELEROGRAM   NONE\n";
  for (int line = 12; line <= 40; ++line) {
    usc += "SYNTHETIC" + std::string(63, ' ') + std::to_string(line) + "\n";
  }
  check(usc, "line 1: is a volume 2 of USC, which is not read");
}

// ---- any damage

namespace {

/// Reading may succeed or throw these; anything else fails the test.
void read_or_refuse(std::string_view text) {
  try {
    static_cast<void>(records::parse_record(text, "a", {.channel = 1}));
  } catch (const FileError&) {
  } catch (const InputError&) {  // columns without a step
  }
}

/// Whether nothing is wrong up to the values, which may be cut off.
bool values_reached(const std::string& text) {
  try {
    static_cast<void>(records::parse_record(text, "a", {.channel = 1}));
    return true;
  } catch (const FileError& error) {
    return contains(error.what(), "too few values") ||
           contains(error.what(), "lines stand between");
  }
}

/// Without the lines of a header that nobody reads, and cut off in the first block.
std::string essence(const std::string& sample) {
  constexpr std::size_t enough = 1800;
  constexpr int reals = 11;  // lines of unknown numbers down to the one with the step
  std::string text;
  int unknown = 0;
  std::istringstream lines(text_of(sample));
  for (std::string line; text.size() < enough && std::getline(lines, line);) {
    const bool is_unread = line.ends_with(": ") || line.starts_with(" -999 -999") ||
                           line.starts_with("-999.00000") || line.starts_with("    -999    -999") ||
                           (line.ends_with("-999.000000") && ++unknown > reals);
    text += is_unread ? "" : line + "\n";
  }
  return text;
}

}  // namespace

BOOST_DATA_TEST_CASE(damaged_files_are_read_or_refused, data::make(samples), sample) {
  const std::string text = essence(sample);
  BOOST_TEST(values_reached(text));
  for (std::size_t length = 0; length < text.size(); ++length) {
    read_or_refuse(std::string_view(text).substr(0, length));
  }
  constexpr std::string_view damage = "\n 9-.#E(\xFF";
  std::string damaged = text;
  for (std::size_t at = 0; at < text.size(); at += 2) {
    damaged[at] = damage[at % damage.size()];
    read_or_refuse(damaged);
    damaged[at] = text[at];
  }
}

BOOST_AUTO_TEST_SUITE_END()
