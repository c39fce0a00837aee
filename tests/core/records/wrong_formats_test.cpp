// SPDX-License-Identifier: MIT

// Wrong files of the networks: each is refused in one line, with file and line.

#include "samples.hpp"

BOOST_AUTO_TEST_SUITE(wrong_formats_test)

using namespace stillpoint::test;

const std::vector<std::string> samples{"ASC", "EW",       "V2",      "V2c", "smc",
                                       "V2A", "afad.txt", "cwa.txt", "asa"};

BOOST_AUTO_TEST_CASE(wrong_files_are_refused) {
  for (const Row& row : rows_of("formats_wrong.txt")) {
    BOOST_TEST_CONTEXT(row.name << ": '" << row.old << "' as '" << row.now << "'") {
      const std::string sample = sample_text(row.name);
      RecordOptions options = row.options;
      options.channel = options.channel.value_or(1);
      const std::string message = refusal_of<FileError>([&] {
        return records::parse_record(row.old.empty() ? sample : replaced(sample, row.old, row.now),
                                     "a", options);
      });
      check_parts(message, row.says);
      BOOST_TEST(message.starts_with("record a, line "), message);
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
  std::istringstream lines(sample_text(sample));
  for (std::string line; text.size() < enough && std::getline(lines, line);) {
    const bool is_unread = line.ends_with(": ") || line.starts_with(" -999 -999") ||
                           line.starts_with("-999.00000") || line.starts_with("    -999    -999") ||
                           (line.ends_with("-999.000000") && ++unknown > reals);
    text += is_unread ? "" : line + "\n";
  }
  return text;
}

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
