// SPDX-License-Identifier: MIT
#include "list_line.hpp"

#include <stillpoint/records/text.hpp>
#include <stillpoint/sweep/json_text.hpp>

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace stillpoint::sweep {

namespace {

using records::trimmed;

using nlohmann::json;

/// The parser's callbacks for each part of the text; false ends it.
class RowHandler {
 public:
  explicit RowHandler(JsonRow& row) : row_(row) {}

  bool null() { return refuse_value("null"); }
  bool boolean(bool /*value*/) { return refuse_value("a boolean"); }
  bool string(std::string& /*value*/) { return refuse_value("a string"); }
  bool binary(json::binary_t& /*value*/) { return refuse_value("binary"); }
  bool start_array(std::size_t /*size*/) { return refuse_value("an array"); }
  static bool end_array() { return false; }
  bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
  bool number_float(double value, const std::string& /*text*/) { return number(value); }

  bool start_object(std::size_t /*size*/) {
    if (inside_) {
      return refuse_value("an object");
    }
    inside_ = true;
    return true;
  }
  static bool end_object() { return true; }

  bool key(std::string& key) {
    if (std::ranges::find(row_.fields, key, &std::pair<std::string, double>::first) !=
        row_.fields.end()) {
      return refuse(fmt::format("the key {} appears twice", shown(key)));
    }
    row_.fields.emplace_back(key, 0.0);
    return true;
  }

  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const json::exception& error) {
    return refuse("is not valid JSON: " + parse_error_cause(error.what()));
  }

 private:
  static std::string shown(const std::string& key) { return records::printable(key, 60); }

  bool refuse(std::string error) {
    row_.error = std::move(error);
    return false;
  }
  bool refuse_value(std::string_view kind) {
    return inside_  // behind a key
               ? refuse(fmt::format("{} is {}: must be a number", shown(row_.fields.back().first),
                                    kind))
               : refuse(fmt::format("is {}: must be a JSON object", kind));
  }
  bool number(double value) {
    if (!inside_) {
      return refuse_value("a number");
    }
    row_.fields.back().second = value;
    return true;  // the parser refuses numbers beyond a double
  }

  JsonRow& row_;
  bool inside_{false};
};

}  // namespace

bool CsvLine::next(std::string_view& field) {
  if (!more_) {
    return false;
  }
  const bool in_quotes = trimmed(rest_).starts_with('"');
  const std::size_t quote = in_quotes ? rest_.find('"', rest_.find('"') + 1) : 0;
  const std::size_t comma = rest_.find(',', quote);  // none behind npos
  if (quote == std::string_view::npos) {
    lines_.refuse(lines_.number(), "a quote is opened but not closed");
  }
  more_ = comma != std::string_view::npos;
  field = records::unquoted(rest_.substr(0, comma));
  rest_ = more_ ? rest_.substr(comma + 1) : std::string_view();
  return true;
}

JsonRow parse_json_row(std::string_view text) {
  JsonRow row;
  RowHandler handler(row);
  json::sax_parse(text, &handler);
  if (row.error.empty() && row.fields.empty()) {
    row.error = "is {}: must have keys";
  }
  return row;
}

}  // namespace stillpoint::sweep
