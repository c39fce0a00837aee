// SPDX-License-Identifier: MIT

// The largest box within the limits: by bisection of its size on a map, then about candidates.

#include "record/suite_tolerance.hpp"

#include "record/suite_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace stillpoint::design {

namespace {

constexpr int halvings = 12;
/// Of the scale of a box: what a search resolves, first and about the best.
constexpr double first_resolved = 0.04;
constexpr double resolved = 0.005;
constexpr double first_growth = 1.15;
constexpr std::size_t candidates_of_a_size = 2;
constexpr std::size_t candidates_of_a_map = 8;
/// Of the largest on the map: smaller boxes may grow more.
constexpr std::array<double, 3> sizes_tried{1, 0.8, 0.5};
constexpr int most_shrinkages = 10;
constexpr double shrinkage = 0.98;
constexpr std::size_t most_grown = 2;

class Growth {
 public:
  Growth(const Suite& suite, const RecordDesignRequest& task, SuiteFrictions frictions, double most,
         SuiteWatch& watch)
      : suite_(suite),
        task_(task),
        frictions_(frictions),
        most_(most),
        goal_{nullptr, task.limits},
        watch_(watch) {}

  std::optional<LargestBox> run() {
    const SuiteSpace exact = space(0);
    if (!exact.possible()) {
      return std::nullopt;
    }
    SuiteScan scan(suite_, exact, points(exact), task_.threads, watch_);
    scan.look(goal_, HUGE_VAL);
    grid_ = scan.grid();
    figures_ = scan.figures();
    std::vector<std::pair<double, BoxedDamper>> ends;
    for (const auto& [scale, candidate] : candidates()) {
      if (!watch_.stopped()) {
        ends.push_back(grown(0, scale, candidate, first_resolved));
      }
    }
    const auto size = [](const auto& end) { return end.first; };
    std::ranges::stable_sort(ends, std::ranges::greater(), size);
    ends.resize(std::min(ends.size(), most_grown));
    for (auto& [scale, end] : ends) {
      if (end.rank.off == 0) {
        std::tie(scale, end) = grown(scale, scale * (1 + first_resolved / 2), end, resolved);
      }
    }
    std::ranges::stable_sort(ends, std::ranges::greater(), size);
    if (!ends.empty() && ends.front().second.rank.off == 0) {
      ends.insert(ends.begin(), challenged(ends.front()));
    }
    std::optional<LargestBox> best;
    for (const auto& [scale, end] : ends) {
      if (end.rank.off == 0 && !(best && scale <= best->scale)) {
        keep_verified(best, scale, end);
      }
    }
    return best;
  }

 private:
  [[nodiscard]] SuiteSpace space(double scale) const { return {task_, frictions_, scale}; }

  [[nodiscard]] std::int64_t points(const SuiteSpace& of) const {
    constexpr std::int64_t of_a_line = 2000;
    constexpr std::int64_t times_of_three = 4;
    return of.searched() <= 1   ? std::min(of_a_line, task_.scan_points)
           : of.searched() == 2 ? task_.scan_points
                                : times_of_three * task_.scan_points;
  }

  /// The boxes of that size, rounded down to whole steps, on the grid of exact dampers.
  [[nodiscard]] std::vector<BoxedDamper> on_map(double scale, std::size_t most) const {
    const SuiteSpace boxes = space(scale);
    if (!boxes.possible()) {
      return {};
    }
    SuiteGrid grid = grid_;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      GridSide& side = grid.at(i);
      if (side.step > 0) {
        const auto below = std::floor(boxes.axes()[i].down() / side.step);
        const auto above = std::floor(boxes.axes()[i].up() / side.step);
        side.window = static_cast<std::int64_t>(below + above);
        side.lead = below * side.step;
        if (side.window >= side.points) {
          return {};
        }
      }
    }
    return BoxMap(boxes, grid, figures_).best(goal_, most);
  }

  [[nodiscard]] std::vector<std::pair<double, BoxedDamper>> candidates() const {
    double low = 0;
    double high = most_;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (low + high) / 2;
      const std::vector<BoxedDamper> best = on_map(middle, 1);
      (!best.empty() && best.front().rank.off == 0 ? low : high) = middle;
    }
    std::vector<std::pair<double, BoxedDamper>> list;
    for (const double part : low > 0 ? std::span(sizes_tried) : std::span(sizes_tried).first(1)) {
      for (const BoxedDamper& each : on_map(part * low, candidates_of_a_size)) {
        list.emplace_back(part * low, each);
      }
    }
    return list;
  }

  /// Polishes the box of that size about `from`.
  [[nodiscard]] BoxedDamper at_size(double scale, const BoxedDamper& from) {
    const SuiteSpace boxes = space(scale);
    if (!boxes.possible()) {
      BoxedDamper none = from;
      none.rank.off = 1;
      return none;
    }
    constexpr double step = 0.04;
    return SuiteSearch(suite_, task_, boxes, goal_, watch_).polished(from, step, true);
  }

  /// As large as it can be about there, from a size that it has, if it is not 0, and another.
  [[nodiscard]] std::pair<double, BoxedDamper> grown(double low, double next,
                                                     const BoxedDamper& candidate,
                                                     double precision) {
    double high = most_;
    bool bounded = false;
    BoxedDamper best = candidate;
    best.rank.off = low > 0 ? 0 : 1;
    next = std::min(std::max(next, first_resolved), most_);
    while (high - low > precision * std::max(1.0, low) && !watch_.stopped()) {
      BoxedDamper now = at_size(next, best);
      if (now.rank.off == 0) {
        low = next;
        best = now;
      } else {
        high = next;
        bounded = true;
      }
      next = !bounded && low > 0 ? std::min(most_, low * first_growth) : (low + high) / 2;
    }
    return {low, best};
  }

  /// The best of a map of slightly larger boxes, as long as it has one within the limits.
  [[nodiscard]] std::pair<double, BoxedDamper> challenged(std::pair<double, BoxedDamper> best) {
    constexpr int most_challenges = 3;
    constexpr double larger = 1.02;
    for (int i = 0; i < most_challenges && !watch_.stopped(); ++i) {
      const double scale = std::min(most_, larger * best.first);
      const SuiteSpace boxes = space(scale);
      if (scale <= best.first || !boxes.possible()) {
        break;
      }
      SuiteScan scan(suite_, boxes, points(boxes), task_.threads, watch_);
      scan.look(goal_, HUGE_VAL);
      SuiteSearch search(suite_, task_, boxes, goal_, watch_);
      const std::vector<BoxedDamper> found =
          search.all_refined(scan.map().best(goal_, candidates_of_a_map), scan.grid(), HUGE_VAL);
      if (found.empty() || found.front().rank.off > 0) {
        break;
      }
      best = grown(scale, scale * (1 + first_resolved), found.front(), resolved);
    }
    return best;
  }

  void keep_verified(std::optional<LargestBox>& best, double scale, BoxedDamper end) {
    for (int i = 0; i < most_shrinkages && !watch_.stopped(); ++i, scale *= shrinkage) {
      if (best && scale <= best->scale) {
        return;
      }
      const SuiteSpace boxes = space(scale);
      SuiteSearch search(suite_, task_, boxes, goal_, watch_);
      if (auto now = search.verified({end})) {
        best = LargestBox{scale, *now};
        return;
      }
    }
  }

  const Suite& suite_;
  const RecordDesignRequest& task_;
  SuiteFrictions frictions_;
  double most_;
  SuiteGoal goal_;
  SuiteWatch& watch_;
  SuiteGrid grid_{};
  std::vector<SuiteFigures> figures_;
};

}  // namespace

std::optional<LargestBox> largest_box(const Suite& suite, const RecordDesignRequest& task,
                                      SuiteFrictions frictions, double most, SuiteWatch& watch) {
  return Growth(suite, task, frictions, most, watch).run();
}

}  // namespace stillpoint::design
