// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/json_text.hpp>

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
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

/// Reads a text through for what json::parse passes over or words badly: equal keys, of which it
/// keeps the last, a deep value, which it would print by recursion until the stack ends, and
/// numbers beyond a double. Throws FileError. The parser calls a function for each part of the
/// text.
class JsonCheck {
 public:
  JsonCheck(std::string_view text, const records::FilePlace& file) : text_(text), file_(file) {
    json::sax_parse(text, this, json::input_format_t::json, true, true);
  }

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
    if (!seen_.back().insert(key).second) {
      refuse({}, fmt::format("{} is set twice: a key can stand only once", shown_key(key)));
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
                       cause(error.what())));
  }

 private:
  bool enter() {
    constexpr std::size_t deepest = 16;  // a scene has three
    seen_.emplace_back();
    if (seen_.size() > deepest) {
      refuse({},
             fmt::format("is nested deeper than {} levels, which no {} is", deepest, file_.kind));
    }
    return true;
  }
  bool leave() {
    seen_.pop_back();
    return true;
  }

  /// Of the library's message "[...] parse error at ...: ... - CAUSE; last read: ...".
  static std::string cause(std::string_view message) {
    constexpr std::string_view dash = " - ";
    if (const std::size_t begin = message.find(dash); begin != std::string_view::npos) {
      message.remove_prefix(begin + dash.size());
    }
    return records::printable(message.substr(0, message.find("; last read")), 150);
  }

  /// `position` counts the bytes that are read.
  [[noreturn]] void refuse(std::optional<std::size_t> position, std::string_view message) const {
    records::FilePlace place = file_;
    if (position) {
      const std::string_view before =
          text_.substr(0, std::min(std::max<std::size_t>(*position, 1) - 1, text_.size()));
      const std::size_t newline = before.rfind('\n');
      place.line = 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
      place.column =
          newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
    }
    throw records::FileError(std::move(place), message);
  }

  std::string_view text_;
  const records::FilePlace& file_;
  std::string last_;                         ///< key
  std::vector<std::set<std::string>> seen_;  ///< the keys of each object that is open
};

}  // namespace

void require_json_object(std::string_view text, const records::FilePlace& file) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) {
    throw records::FileError(file, "is empty, must be a JSON object");
  }
  const JsonCheck check(text, file);
  if (const json value = json::parse(text, nullptr, true, true); !value.is_object()) {
    throw records::FileError(file,
                             fmt::format("is a JSON {}, must be an object", value.type_name()));
  }
}

}  // namespace stillpoint::sweep
