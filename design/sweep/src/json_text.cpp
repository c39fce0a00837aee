// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/json_text.hpp>

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace stillpoint::sweep {

namespace {

using nlohmann::json;

std::string shown_key(std::string_view key) {
  return records::printable(key, records::longest_word);
}

/// The cause in the parser's message: "... - unexpected end of input; ...".
std::string parse_error_cause(std::string_view message) {
  // "[...] parse error at ...: ... - CAUSE; last read: ..."
  constexpr std::string_view dash = " - ";
  if (const std::size_t begin = message.find(dash); begin != std::string_view::npos) {
    message.remove_prefix(begin + dash.size());
  }
  return records::printable(message.substr(0, message.find("; last read")), 150);
}

/// Reads a text and notes how much of it has been read.
class NotingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  NotingIterator(const char* at, const char*& read) : at_(at), read_(&read) {}

  reference operator*() const { return *at_; }
  NotingIterator& operator++() {
    *read_ = ++at_;
    return *this;
  }
  friend bool operator==(const NotingIterator& a, const NotingIterator& b) {
    return a.at_ == b.at_;
  }

 private:
  const char* at_;
  const char** read_;
};

/// Scans a text for what json::parse ignores or reports badly: equal keys, of which it keeps the
/// last; deep values, which it would print by recursion until the stack overflows; and numbers
/// beyond a double. Throws FileError. The parser calls a function for each part of the
/// text.
class JsonCheck {
 public:
  JsonCheck(std::string_view text, const records::FilePlace& file)
      : text_(text), file_(file), read_(text.data()) {
    json::sax_parse(NotingIterator(text.data(), read_),
                    NotingIterator(text.data() + text.size(), read_), this,
                    json::input_format_t::json, true, true);
  }

  [[nodiscard]] KeyPlaces take_places() { return std::move(places_); }

  static bool null() { return true; }
  static bool boolean(bool /*value*/) { return true; }
  static bool string(std::string& /*value*/) { return true; }
  static bool binary(json::binary_t& /*value*/) { return true; }
  static bool number_integer(std::int64_t /*value*/) { return true; }
  static bool number_unsigned(std::uint64_t /*value*/) { return true; }
  static bool number_float(double /*value*/, const std::string& /*text*/) { return true; }
  bool start_object(std::size_t /*size*/) { return enter(); }
  bool start_array(std::size_t /*size*/) { return enter(); }
  bool end_object() { return leave(); }
  bool end_array() { return leave(); }

  bool key(const std::string& key) {
    last_ = key;
    records::FilePlace place = place_of_key();
    if (!seen_.back().insert(key).second) {
      throw records::FileError(
          std::move(place),
          fmt::format("{} is set twice: a key may appear only once", shown_key(key)));
    }
    if (seen_.size() == 1) {
      outer_ = key;
      places_.emplace(key, std::move(place));
    } else if (seen_.size() == 2) {
      places_.emplace(fmt::format("{}.{}", outer_, key), std::move(place));
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const json::exception& error) {
    if (dynamic_cast<const json::out_of_range*>(&error) != nullptr) {
      refuse(position - std::min(position, token.size()) + 1,
             fmt::format("{} = {}: must have a magnitude up to 1.8e308", shown_key(last_),
                         shown_key(token)));
    }
    refuse(position,
           fmt::format("is not valid JSON{}: {}",
                       last_.empty() ? "" : fmt::format(" after the key {}", shown_key(last_)),
                       parse_error_cause(error.what())));
  }

 private:
  bool enter() {
    constexpr std::size_t deepest = 16;  // a scene has three
    seen_.emplace_back();
    if (seen_.size() > deepest) {
      refuse({}, fmt::format("is nested deeper than {} levels: no {} needs so many", deepest,
                             file_.kind));
    }
    return true;
  }
  bool leave() {
    seen_.pop_back();
    return true;
  }

  /// The place of the key that has just been read, up to its closing quote.
  records::FilePlace place_of_key() {
    const auto is_quote = [this](const char* at) {
      return *at == '"' && (at == text_.data() || at[-1] != '\\');
    };
    const char* quote = read_ - 2;
    while (!is_quote(quote)) {
      --quote;
    }
    for (; counted_ < quote; ++counted_) {
      if (*counted_ == '\n') {
        ++line_;
        line_begin_ = counted_ + 1;
      }
    }
    records::FilePlace place = file_;
    place.line = line_;
    place.column = static_cast<std::size_t>(quote - line_begin_) + 1;
    return place;
  }

  /// The text may be one line of a file.
  [[nodiscard]] std::size_t first_line() const { return file_.line.value_or(1); }

  /// `position` counts the bytes that are read.
  [[noreturn]] void refuse(std::optional<std::size_t> position, std::string_view message) const {
    records::FilePlace place = file_;
    if (position) {
      const std::string_view before =
          text_.substr(0, std::min(std::max<std::size_t>(*position, 1) - 1, text_.size()));
      const std::size_t newline = before.rfind('\n');
      place.line = first_line() + static_cast<std::size_t>(std::ranges::count(before, '\n'));
      place.column =
          newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
    }
    throw records::FileError(std::move(place), message);
  }

  std::string_view text_;
  const records::FilePlace& file_;
  const char* read_;  ///< so far
  /// The lines before this, and where the last of them begins.
  const char* counted_{text_.data()};
  const char* line_begin_{text_.data()};
  std::size_t line_{first_line()};
  KeyPlaces places_;
  std::string outer_;                        ///< the last key of the text's object
  std::string last_;                         ///< key
  std::vector<std::set<std::string>> seen_;  ///< the keys of each object that is open
};

}  // namespace

KeyPlaces require_json_object(std::string_view text, const records::FilePlace& file) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) {
    throw records::FileError(file, "is empty, must be a JSON object");
  }
  JsonCheck check(text, file);
  const json value = text[first] == '{' ? json::object() : json::parse(text, nullptr, true, true);
  if (!value.is_object()) {
    throw records::FileError(file,
                             fmt::format("is a JSON {}, must be an object", value.type_name()));
  }
  return check.take_places();
}

}  // namespace stillpoint::sweep
