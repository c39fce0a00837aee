// SPDX-License-Identifier: MIT
#include "at2_parts.hpp"
#include "value_block.hpp"

#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace stillpoint::records {

namespace {

/// A word of the line with NPTS and DT: the text in capitals, or a number.
struct HeaderWord {
  std::string text;
  std::string_view number;
};

bool begins_number(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '+' || c == '-';
}

/// ".0200SEC" as ".0200" and "SEC".
std::size_t number_length(std::string_view word) {
  const std::size_t end = std::min(word.find_first_not_of("0123456789.+-EeDd"), word.size());
  return scan_fortran_number(word.substr(0, end)).fault == NumberFault::none ? end : 0;
}

std::vector<HeaderWord> header_words(std::string_view line) {
  std::vector<HeaderWord> words;
  for (std::string_view word : words_of(line, " \t,;:=()")) {
    const std::size_t length = begins_number(word.front()) ? number_length(word) : 0;
    if (length > 0) {
      words.push_back({"", word.substr(0, length)});
      word.remove_prefix(length);
    }
    word = word.substr(0, word.find_last_not_of('.') + 1);
    if (!word.empty()) {
      words.push_back({upper_case(word), ""});
    }
  }
  return words;
}

/// "0,01" would be two words, of which only the first would count.
void refuse_commas_in_numbers(const RecordReader& reader) {
  for (const std::string_view word : words_of(reader.line(), " \t;:=()")) {
    if (!comma_note(word).empty()) {
      reader.refuse_number(word.substr(0, word.find_last_not_of(',') + 1), NumberFault::no_number);
    }
  }
}

/// The words NPTS and DT of a line with their numbers, one after each word ("NPTS= 2000, DT= .02
/// SEC") or both in front ("2000 0.02 NPTS, DT").
class CountLine {
 public:
  explicit CountLine(const RecordReader& reader)
      : reader_(reader),
        words_(header_words(reader.line())),
        npts_(index("NPTS")),
        dt_(index("DT")) {
    if (dt_ == words_.size()) {
      reader_.refuse("NPTS without DT: both must be on this line, as in NPTS= 2000, DT= .02 SEC");
    }
    numbers_first_ =
        std::min(npts_, dt_) == 2 && !words_[0].number.empty() && !words_[1].number.empty();
  }

  [[nodiscard]] HeaderText count() const { return number_of("NPTS", npts_, npts_ > dt_); }

  [[nodiscard]] HeaderText step() const {
    require_seconds();
    return number_of("DT", dt_, dt_ > npts_);
  }

 private:
  [[nodiscard]] std::size_t index(std::string_view text) const {
    const auto found = std::ranges::find(words_, text, &HeaderWord::text);
    return static_cast<std::size_t>(found - words_.begin());
  }

  [[nodiscard]] HeaderText number_of(std::string_view key, std::size_t at, bool is_second) const {
    const std::size_t place = numbers_first_ ? (is_second ? 1 : 0) : at + 1;
    if (place >= words_.size() || words_[place].number.empty()) {
      reader_.refuse(fmt::format("{} has no number", key));
    }
    return {words_[place].number, reader_};
  }

  /// A factor of 1000 must not slip through.
  void require_seconds() const {
    const std::size_t place = numbers_first_ ? std::max(npts_, dt_) + 1 : dt_ + 2;
    if (place >= words_.size()) {
      return;
    }
    const std::string_view unit = words_[place].text;
    constexpr std::array others{"MS", "MILLI", "US", "MICRO", "MIN", "HZ", "SPS"};
    if (std::ranges::any_of(others,
                            [unit](std::string_view other) { return unit.starts_with(other); })) {
      reader_.refuse(fmt::format("DT in {}: must be in SEC", quoted(unit)));
    }
  }

  const RecordReader& reader_;
  std::vector<HeaderWord> words_;
  std::size_t npts_;
  std::size_t dt_;
  bool numbers_first_{false};
};

}  // namespace

bool has_npts(std::string_view line) {
  std::string text = upper_case(line);
  for (char& c : text) {
    c = (c >= 'A' && c <= 'Z') || c == '_' ? c : ' ';
  }
  return std::ranges::count(words_of(text, " "), std::string_view("NPTS")) > 0;
}

At2Counts read_at2_counts(const RecordReader& reader) {
  refuse_commas_in_numbers(reader);
  const CountLine line(reader);
  return {line.count(), line.step()};
}

}  // namespace stillpoint::records
