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
/// beyond a double. Throws FileError.
class JsonCheck {
 public:
  JsonCheck(std::string_view text, const records::FilePlace& file)
      : text_(text), file_(file), read_(text.data()) {}

  [[nodiscard]] json value() {
    const auto look = [this](int depth, json::parse_event_t event, const json& parsed) {
      if (event == json::parse_event_t::key) {
        add_key(static_cast<std::size_t>(depth), parsed.get<std::string>());
      } else if (event == json::parse_event_t::object_start ||
                 event == json::parse_event_t::array_start) {
        enter(static_cast<std::size_t>(depth) + 1);
      }
      return true;
    };
    try {
      return json::parse(NotingIterator(text_.data(), read_),
                         NotingIterator(text_.data() + text_.size(), read_), look, true, true);
    } catch (const json::parse_error& error) {
      const std::size_t before = std::max<std::size_t>(error.byte, 1) - 1;
      throw records::FileError(
          place_at(text_.data() + std::min(before, text_.size())),
          fmt::format("is not valid JSON{}: {}",
                      last_.empty() ? "" : fmt::format(" after the key {}", shown_key(last_)),
                      parse_error_cause(error.what())));
    } catch (const json::out_of_range& error) {
      const std::string_view token = records::split(error.what(), '\'').at(1);
      const std::string_view read(text_.data(), static_cast<std::size_t>(read_ - text_.data()));
      throw records::FileError(place_at(text_.data() + read.rfind(token)),
                               fmt::format("{} = {}: must have a magnitude up to 1.8e308",
                                           shown_key(last_), shown_key(token)));
    }
  }

  [[nodiscard]] KeyPlaces take_places() { return std::move(places_); }

 private:
  void enter(std::size_t depth) {
    constexpr std::size_t deepest = 16;  // a scene has three
    if (depth > deepest) {
      throw records::FileError(
          file_,
          fmt::format("is nested deeper than {} levels: no {} needs so many", deepest, file_.kind));
    }
    seen_.resize(depth);
    seen_.back().clear();
  }

  void add_key(std::size_t depth, const std::string& key) {
    last_ = key;
    records::FilePlace place = place_of_key();
    if (!seen_[depth - 1].insert(key).second) {
      throw records::FileError(
          std::move(place),
          fmt::format("{} is set twice: a key may appear only once", shown_key(key)));
    }
    if (depth == 1) {
      outer_ = key;
      places_.emplace(key, std::move(place));
    } else if (depth == 2) {
      places_.emplace(fmt::format("{}.{}", outer_, key), std::move(place));
    }
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
    return place_at(quote);
  }

  /// Behind all those that were asked for before.
  records::FilePlace place_at(const char* at) {
    for (; counted_ < at; ++counted_) {
      if (*counted_ == '\n') {
        ++line_;
        line_begin_ = counted_ + 1;
      }
    }
    records::FilePlace place = file_;
    place.line = line_;
    place.column = static_cast<std::size_t>(at - line_begin_) + 1;
    return place;
  }

  std::string_view text_;
  const records::FilePlace& file_;
  const char* read_;  ///< so far
  /// The lines before this, and where the last of them begins.
  const char* counted_{text_.data()};
  const char* line_begin_{text_.data()};
  std::size_t line_{1};
  KeyPlaces places_;
  std::string outer_;                        ///< the last key of the text's object
  std::string last_;                         ///< key
  std::vector<std::set<std::string>> seen_;  ///< the keys of each object that is open, and more
};

}  // namespace

KeyPlaces require_json_object(std::string_view text, const records::FilePlace& file) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) {
    throw records::FileError(file, "is empty, must be a JSON object");
  }
  JsonCheck check(text, file);
  const json value = check.value();
  if (!value.is_object()) {
    throw records::FileError(file,
                             fmt::format("is a JSON {}, must be an object", value.type_name()));
  }
  return check.take_places();
}

}  // namespace stillpoint::sweep
