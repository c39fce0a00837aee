// SPDX-License-Identifier: MIT
// What forbids the dampers of a region, docs/theory.md sections 7, 12 and 13:
//
//   Delta above start                     the weakest hit does not leave the notch
//   f below first                         the peak exceeds beta
//   f above strong                        the weakest hit does not come back, whatever Delta is, or
//                                         the dead zone is wider than beta
//   Delta below stop                      the strongest hit passes the last arrival allowed
//   above it, below the strip             the published criterion asks for more Delta
//   the rest between and above strips     some hit rests off centre, or beyond the residual
#include "figures/region_column.hpp"
#include "figures/report_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::AreaLook;
using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

constexpr int edge_steps = 200;

class Sides {
 public:
  Sides(Figure& figure, const DrawnRegion& drawn, const FigureUnits& units)
      : figure_(figure),
        drawn_(drawn),
        units_(units),
        first_(std::max(drawn.region.f2, 0.0)),
        start_(shown_delta(drawn.region.delta2.value())) {
    const double largest = design::largest_stopping_f(drawn.problem);
    const double f1 = drawn.region.f1;
    strong_ = design::dead_zone_binds(drawn.problem) ? f1 : largest;
    held_ = drawn.problem.residual ? std::max(strong_, f1) : largest < f1 ? HUGE_VAL : f1;
  }

  void operator()() {
    // Where both sides forbid the same f, or a limit those that are too weak, that is the gap.
    const double allowed = design::largest_f_allowed(drawn_.problem, drawn_.limits);
    const double weak = std::min(first_, strong_);
    upright("too weak: exceeds " + units_.length_words(drawn_.problem.beta), 0,
            std::min(weak, allowed));
    upright(
        drawn_.problem.residual ? "too strong: rests too far off" : "too strong: does not return",
        std::max(first_, strong_), held_);
    upright("too strong: dead zone exceeds " + units_.length_words(drawn_.problem.beta),
            std::max(first_, held_), figure_.x.most);
    upright(drawn_.problem.residual
                ? "gap: no f is admissible"
                : "gap: no f returns within " + units_.length_words(drawn_.problem.beta),
            strong_, first_, Ink::orange, AreaLook::filled);
    if (start_ < figure_.y.most) {
      add("notch holds at the start", {{figure_.x.least, start_},
                                       {figure_.x.most, start_},
                                       {figure_.x.most, figure_.y.most},
                                       {figure_.x.least, figure_.y.most}});
    }
    double last = std::min(strong_, figure_.x.most);
    if (allowed < last) {
      const auto given = design::limit_edges(drawn_.problem, drawn_.limits);
      const auto least = std::ranges::find_if(given, [allowed](const design::LimitEdge& one) {
        return one.kind->bounds_f() && one.edge == allowed;
      });
      const std::string beyond(least->kind->beyond);
      upright("gap: too weak; " + beyond, allowed, weak, Ink::orange, AreaLook::filled);
      upright(beyond, std::max(allowed, first_), last, Ink::amber);
      last = allowed;
    }
    between(std::max(first_, figure_.x.least), last);
  }

 private:
  [[nodiscard]] double shown_delta(double delta) const {
    return std::clamp(delta * units_.length, figure_.y.least, figure_.y.most);
  }

  void add(std::string name, std::vector<FigurePoint> outline, Ink ink = Ink::grey,
           AreaLook look = AreaLook::hatched) {
    figure_.areas.push_back({std::move(name), std::move(outline), ink, look});
  }

  /// All Delta that start, between two f.
  void upright(const std::string& name, double from, double to, Ink ink = Ink::grey,
               AreaLook look = AreaLook::hatched) {
    from = std::max(from, figure_.x.least);
    to = std::min(to, figure_.x.most);
    if (from < to && figure_.y.least < start_) {
      add(name, {{from, figure_.y.least}, {to, figure_.y.least}, {to, start_}, {from, start_}}, ink,
          look);
    }
  }

  /// The spans of Delta of one kind over f, in as many pieces as they have.
  template <class SpanOf>
  void spans(const std::string& name, const std::vector<RegionColumn>& columns,
             const SpanOf& span_of, Ink ink = Ink::grey, AreaLook look = AreaLook::hatched) {
    constexpr double visible = 1e-4;  // of the axis
    std::vector<FigurePoint> below;
    std::vector<FigurePoint> above;
    double widest = 0;
    const auto finish = [&] {
      if (widest > visible * (figure_.y.most - figure_.y.least)) {
        below.insert(below.end(), above.rbegin(), above.rend());
        add(name, std::move(below), ink, look);
      }
      below.clear();
      above.clear();
      widest = 0;
    };
    for (const RegionColumn& column : columns) {
      const std::optional<Interval> span = span_of(column);
      if (!span) {
        finish();
        continue;
      }
      const double low = shown_delta(span->low);
      const double high = std::max(low, shown_delta(span->high));
      below.push_back({column.f, low});
      above.push_back({column.f, high});
      widest = std::max(widest, high - low);
    }
    finish();
  }

  /// Where the motion does what the published criterion does not admit, up to `top`.
  void add_by_criterion_alone(const std::vector<RegionColumn>& exact, double top) {
    if (drawn_.problem.criterion == design::Criterion::exact) {
      return;
    }
    std::vector<RegionColumn> published;
    published.reserve(exact.size());
    for (const RegionColumn& at : exact) {
      published.push_back(region_column(drawn_.problem, at.f));
    }
    for (std::size_t n = 0; n < exact.front().strips.size(); ++n) {
      spans(
          std::string(by_criterion_alone), exact,
          [&](const RegionColumn& at) {
            const auto& asked = published[static_cast<std::size_t>(&at - exact.data())].strips[n];
            auto span = n > 0 && at.strips[0] ? std::nullopt : at.strips[n];
            if (span) {
              span->high = std::min({span->high, asked ? asked->low : HUGE_VAL, top});
            }
            return span;
          },
          Ink::amber);
    }
  }

  /// Where only Delta decides.
  void between(double from, double to) {
    if (!(from < to)) {
      return;
    }
    std::vector<double> grid(edge_steps + 1);
    for (int i = 0; i <= edge_steps; ++i) {
      grid[static_cast<std::size_t>(i)] = from + (to - from) * i / edge_steps;
    }
    design::Problem exact = drawn_.problem;  // what the motion does
    exact.criterion = design::Criterion::exact;
    const std::vector<RegionColumn> over_f = region_columns(exact, grid);
    const double start = drawn_.region.delta2.value();
    const double top = std::min(start, design::largest_delta_allowed(drawn_.limits));
    spans("notch too weak", over_f, [&](const RegionColumn& at) {
      return std::optional(Interval{0, std::min(at.stop, top)});
    });
    add_by_criterion_alone(over_f, top);
    spans(
        "above the largest Δ", over_f,
        [&](const RegionColumn& at) {
          return std::optional(Interval{std::max(at.stop, top), start});
        },
        Ink::amber);
    spans(
        "gap: no notch is strong enough", over_f,
        [&](const RegionColumn& at) {
          return std::optional(Interval{top, std::min(at.stop, start)});
        },
        Ink::orange, AreaLook::filled);
    const bool ranges = drawn_.problem.v0_low || drawn_.problem.p_high;
    const std::string name = std::string(ranges ? "some hits rest" : "rests") +
                             (drawn_.problem.residual ? " too far off" : " off centre");
    for (std::size_t n = 0; n < over_f.front().strips.size(); ++n) {
      spans(name, over_f, [n, top](const RegionColumn& at) {
        auto span = below_strip(at, n);
        if (span) {
          span->high = std::min(span->high, top);
        }
        return span;
      });
    }
  }

  Figure& figure_;
  const DrawnRegion& drawn_;
  const FigureUnits& units_;
  double first_;
  double start_;
  double strong_{0};
  double held_{HUGE_VAL};  ///< friction could hold the mass at the limit from this f on
};

}  // namespace

void add_sides(Figure& figure, const DrawnRegion& drawn, const FigureUnits& units) {
  Sides(figure, drawn, units)();
}

}  // namespace stillpoint::report
