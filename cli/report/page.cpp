// SPDX-License-Identifier: MIT
#include "page.hpp"

#include <fmt/color.h>
#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace stillpoint::cli {

namespace {

constexpr std::size_t label_width = 18;
constexpr std::size_t page_width = 96;

fmt::text_style look_of(Tone tone) {
  switch (tone) {
    case Tone::plain:
      break;
    case Tone::heading:
      return fmt::emphasis::bold;
    case Tone::good:
      return fmt::fg(fmt::terminal_color::green);
    case Tone::bad:
      return fmt::emphasis::bold | fmt::fg(fmt::terminal_color::red);
    case Tone::faint:
      return fmt::emphasis::faint;
  }
  return {};
}

}  // namespace

std::string spelled_out(std::string_view text) {
  constexpr unsigned char first_printable = 0x20;
  constexpr unsigned char del = 0x7f;
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    result +=
        code < first_printable || code == del ? fmt::format("\\x{:02x}", code) : std::string(1, c);
  }
  return result;
}

std::string Style::operator()(Tone tone, std::string_view text) const {
  return coloured_ && tone != Tone::plain ? fmt::format("{}", fmt::styled(text, look_of(tone)))
                                          : std::string(text);
}

Style style_for_standard_output() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool refused = no_color != nullptr && *no_color != '\0';
  const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return Style(!refused && !dumb && ::isatty(STDOUT_FILENO) == 1);
}

void Page::title(std::string_view text) {
  text_ += style_(Tone::heading, text) + "\n";
}

void Page::section(std::string_view heading) {
  text_ += "\n" + style_(Tone::heading, heading) + "\n";
}

void Page::row(std::string_view label, std::string_view text, Tone tone) {
  text_ += fmt::format("  {:<{}}{}\n", label, label_width, style_(tone, text));
}

void Page::line(std::string_view text, Tone tone) {
  while (text.size() > page_width) {
    const std::size_t space = text.rfind(' ', page_width);
    if (space == std::string_view::npos) {
      break;
    }
    text_ += fmt::format("  {}\n", style_(tone, text.substr(0, space)));
    text.remove_prefix(space + 1);
  }
  text_ += fmt::format("  {}\n", style_(tone, text));
}

void Page::table(const std::vector<std::vector<std::string>>& rows,
                 const std::vector<Tone>& tones) {
  assert(rows.size() == tones.size());
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto& row = rows[r];
    std::string now;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool last = i + 1 == row.size();
      const std::string cell = last     ? style_(tones[r], row[i])
                               : i == 0 ? fmt::format("{:<{}}", row[i], widths[i])
                                        : fmt::format("{:>{}}", row[i], widths[i]);
      now += (i == 0 ? "  " : "   ") + cell;
    }
    now.erase(now.find_last_not_of(' ') + 1);
    text_ += now + "\n";
  }
}

std::string figure(double value) {
  return fmt::format("{:.6g}", value);
}

std::string figure(const std::optional<double>& value) {
  return value ? figure(*value) : "none";
}

std::string with_unit(double value, std::string_view unit) {
  struct Prefix {
    double factor;
    std::string_view sign;
  };
  static constexpr std::array prefixes{Prefix{1e9, "G"}, Prefix{1e6, "M"},  Prefix{1e3, "k"},
                                       Prefix{1, ""},    Prefix{1e-3, "m"}, Prefix{1e-6, "u"}};
  const double magnitude = std::abs(value);
  const bool in_range = magnitude >= 1e-6 && magnitude < 1e12;
  if (in_range) {
    for (const Prefix& prefix : prefixes) {
      const bool unusual = unit == "m" && prefix.factor > 1;  // no kilometres
      if (magnitude >= prefix.factor && !unusual) {
        return fmt::format("{:.5g} {}{}", value / prefix.factor, prefix.sign, unit);
      }
    }
  }
  return fmt::format("{:.5g} {}", value, unit);
}

std::string limit_figure(double value, bool upwards) {
  constexpr int digits = 10;
  const double last_digit = std::pow(10.0, std::floor(std::log10(value)) + 1 - digits);
  std::string text = fmt::format("{:.{}g}", value, digits);
  for (double nudge = 0.5; (upwards ? std::stod(text) < value : std::stod(text) > value);
       nudge += 0.5) {
    text = fmt::format("{:.{}g}", value + (upwards ? nudge : -nudge) * last_digit, digits);
  }
  return text;
}

std::string plural(const std::optional<double>& count, std::string_view one) {
  return fmt::format("{} {}{}", whole(count), one, count == 1.0 ? "" : "s");
}

std::string whole(const std::optional<double>& value) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (!value) {
    return "none";
  }
  return *value <= exact ? fmt::format("{:.0f}", *value) : fmt::format("{:.6g}", *value);
}

}  // namespace stillpoint::cli
