// SPDX-License-Identifier: MIT
#pragma once

#include "pages.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint::browser_test {

/// For what is drawn with two decimals, at about 0.7 to 1.2 pixels per unit.
constexpr double pixel_tolerance = 0.5;

inline void check_near(const nlohmann::json& seen, const nlohmann::json& due, double tolerance) {
  for (std::size_t i = 0; i < 2; ++i) {
    const double off = seen[i].get<double>() - due[i].get<double>();
    BOOST_TEST(std::abs(off) <= tolerance, "seen at " << seen << ", due at " << due);
  }
}

/// Calls check(look, facts of the page).
template <class Check>
void for_each_look(Scheme scheme, const Check& check) {
  for (const auto& page : seen(scheme).items()) {
    for (const auto& look : page.value().items()) {
      BOOST_TEST_CONTEXT(page.key() << " " << look.key()) {
        check(look.key(), look.value());
      }
    }
  }
}

/// Calls check(facts of the figure) at both widths of the window.
template <class Check>
void for_each_figure(const Check& check, Scheme scheme = Scheme::light) {
  for_each_look(scheme, [&check](const std::string& look, const nlohmann::json& facts) {
    if (look == "print") {
      return;
    }
    for (const auto& figure : facts["figures"].items()) {
      BOOST_TEST_CONTEXT(figure.key()) {
        check(figure.value());
      }
    }
  });
}

/// The same of those that have numbers on both axes.
template <class Check>
void for_each_ticked_figure(const Check& check) {
  for_each_figure([&check](const nlohmann::json& figure) {
    const auto& ticks = figure["rest"]["ticks"];
    if (std::ranges::any_of(ticks, [](const auto& tick) { return tick["axis"] == "y"; })) {
      check(figure);
    }
  });
}

/// An axis by its ticks, as a reader takes it: pixels = slope * value + origin, or of log10(value).
class TickedAxis {
 public:
  /// For "x" or "y" in a state of a figure.
  TickedAxis(const nlohmann::json& state, const std::string& axis)
      : logarithmic_(state["scales"][axis == "x" ? 0 : 1] == "logarithmic") {
    nlohmann::json first;
    nlohmann::json last;
    for (const nlohmann::json& tick : state["ticks"]) {
      if (tick["axis"] == axis) {
        (first.is_null() ? first : last) = tick;
      }
    }
    BOOST_TEST_REQUIRE(last.is_object(), "fewer than two ticks");
    slope_ = (last["seen"].get<double>() - first["seen"].get<double>()) /
             (even(last["value"]) - even(first["value"]));
    origin_ = first["seen"].get<double>() - slope_ * even(first["value"]);
  }

  [[nodiscard]] double place(double value) const { return slope_ * even(value) + origin_; }
  [[nodiscard]] double value(double place) const {
    const double at = (place - origin_) / slope_;
    return logarithmic_ ? std::pow(10.0, at) : at;
  }
  [[nodiscard]] double slope() const { return slope_; }

 private:
  [[nodiscard]] double even(double value) const { return logarithmic_ ? std::log10(value) : value; }

  bool logarithmic_;
  double slope_{0};
  double origin_{0};
};

}  // namespace stillpoint::browser_test
