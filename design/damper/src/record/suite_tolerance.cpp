// SPDX-License-Identifier: MIT

// The largest box within the limits: on the map of a scan, on finer maps about the likeliest, and
// then by samples, sizes in decreasing order, places without a damper that is known to break a
// limit.

#include "record/suite_tolerance.hpp"

#include "record/suite_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace stillpoint::design {

namespace {

constexpr int halvings = 12;
/// Of the size of a box: from one that is tried to the next, at first and about the best.
constexpr double shrinkage = 0.98;
constexpr double least_shrinkage = 0.998;
constexpr int most_shrinkages = 40;
constexpr int most_shrinkages_of_one = 4000;  // damper, without a map, by the least
/// Sizes on the map are too large, as its points are not all dampers; they are seldom too small.
constexpr double larger = 1.04;
/// The likeliest on the map, of the largest size there and of smaller ones, which may grow more.
constexpr std::size_t candidates_of_a_size = 2;
constexpr std::array<double, 3> sizes_tried{1, 0.8, 0.5};
/// Of a map about a box: steps to the box, and to each side of it, by the number of axes.
constexpr std::array<std::int64_t, most_axes + 1> near_windows{1, 64, 16, 8, 4, 4, 4};
constexpr std::array<std::int64_t, most_axes + 1> near_reaches{1, 16, 6, 3, 1, 1, 1};
constexpr int near_maps = 2;
constexpr int most_challenges = 4;
constexpr std::array growths{1.04, 1.02, 1.01, 1.005};
/// Of the largest size, in which dampers of few digits are looked for, and how many.
constexpr std::array parts_rounded{1.0, 0.998, 0.995, 0.99};
constexpr int most_digits = 5;
constexpr double first_push = 0.04;  // of a value
/// Where there is no box on the map, it is looked for with this size; of an exact value that is
/// searched, the step.
constexpr double least_size = 0.04;
constexpr double exact_step = 0.01;
/// Places of a map where a size is tried, and how far apart they are, in boxes.
constexpr std::size_t places_of_a_size = 64;
constexpr double places_apart = 0.05;

class Growth {
 public:
  Growth(const Suites& suite, const RecordDesignRequest& task, SuiteFrictions frictions,
         Interval scales, bool thorough, SuiteWatch& watch)
      : suite_(suite),
        task_(task),
        frictions_(frictions),
        least_(scales.low),
        most_(scales.high),
        thorough_(thorough),
        goal_{nullptr, {}, limits_of(task)},
        watch_(watch),
        exact_(task, frictions, 0),
        breaking_(exact_) {}

  std::optional<LargestBox> on(const SuiteScan& scan) {
    grid_ = scan.grid();
    figures_ = scan.figures();
    for (const auto& [scale, damper] : candidates()) {
      grow(scale, damper);
      if (!thorough_) {
        return best_;
      }
    }
    for (int i = 0; i < most_challenges && best_; ++i) {
      const double before = best_->scale;
      map_about(before, best_->verified.box.damper);
      shrink(std::min(larger * before, most_), least_shrinkage);
      if (best_->scale == before) {
        break;
      }
    }
    for (const double by : growths) {
      push(by);
    }
    round();
    return best_;
  }

  /// Of about that size about that damper, with few digits; empty if it does not hold.
  std::optional<LargestBox> about(double scale, const SuiteDamper& damper) {
    for (const double by : {0.0, 1e-9, 1e-7, 1e-5}) {
      const double now = std::min(scale, most_) * (1 - by);
      const SuiteSpace boxes = space(now);
      if (boxes.possible()) {
        SuiteSearch search(suite_, task_, boxes, goal_, watch_);
        if (holds(search, search.unbroken(boxes.nearest(damper)), now)) {
          round();
          return best_;
        }
      }
    }
    return std::nullopt;
  }

  std::optional<LargestBox> run() {
    if (!exact_.possible()) {
      return std::nullopt;
    }
    constexpr std::int64_t of_a_line = 2000;
    SuiteScan scan(suite_, exact_, points_of_scan(task_, exact_, of_a_line), task_.threads, watch_);
    scan.look(goal_, HUGE_VAL);
    return on(scan);
  }

 private:
  void grow(double scale, const SuiteDamper& damper) {
    SuiteDamper about = damper;
    if (scale == 0) {
      scale = least_size;
      const SuiteSpace boxes = space(scale);
      if (!boxes.possible()) {
        return;
      }
      SuiteSearch search(suite_, task_, boxes, goal_, watch_);
      const BoxedDamper found = search.polished({damper, {}, {}}, least_size, true);
      if (found.rank.off > 0) {
        return;
      }
      about = found.damper;
    }
    for (int i = 0; i < near_maps && exact_.searched() > 0 && !watch_.stopped(); ++i) {
      map_about(scale, about);
      scale = std::max(scale / 2, largest_on_map());
      const std::vector<BoxedDamper> found = on_map(scale, 1);
      if (found.empty()) {
        return;
      }
      about = found.front().damper;
    }
    shrink(scale, exact_.searched() > 0 ? shrinkage : least_shrinkage);
  }

  /// Until a box holds, or is not larger than the best.
  void shrink(double scale, double by) {
    const int most = exact_.searched() > 0 ? most_shrinkages : most_shrinkages_of_one;
    for (int i = 0; i < most && !watch_.stopped(); ++i, scale *= by) {
      const SuiteSpace boxes = space(scale);
      if (scale <= (best_ ? best_->scale / least_shrinkage : least_)) {
        break;
      }
      SuiteSearch search(suite_, task_, boxes, goal_, watch_, !thorough_);
      search.learn(breaking_);
      const bool found = std::ranges::any_of(
          on_map(scale, places_of_a_size, places_apart), [&](const BoxedDamper& each) {
            return holds(search, search.unbroken(each.damper), scale);
          });
      breaking_ = search.known().breaking(goal_.limits);
      if (found) {
        break;
      }
    }
  }

  /// Whether the box of that size does as it is built: then it is the best.
  bool holds(SuiteSearch& search, const BoxedDamper& box, double scale) {
    if (box.rank.off > 0) {
      return false;
    }
    const SuiteDamper damper = search.ready(box).damper;
    if (design::largest(suite_.figures(damper)).margin < least_suite_margin) {
      return false;  // whatever the others of its box do
    }
    const VerifiedBox now = search.tried(damper);
    const SuiteSpace boxes = space(scale);  // a place of a map may be of smaller ones
    if (now.box.rank.off > 0 || !boxes.includes(boxes.place(now.box.damper))) {
      return false;
    }
    best_ = LargestBox{scale, now};
    return true;
  }

  /// Larger by that factor, moved off the places of a map, as long as there is a box.
  void push(double by) {
    for (bool larger_holds = best_.has_value(); larger_holds && !watch_.stopped();) {
      const double scale = std::min(by * best_->scale, most_);
      const SuiteSpace boxes = space(scale);
      if (!boxes.possible() || scale <= best_->scale) {
        return;
      }
      SuiteSearch search(suite_, task_, boxes, goal_, watch_);
      search.learn(breaking_);
      larger_holds = holds(search, search.polished(best_->verified.box, first_push, true), scale);
      breaking_ = search.known().breaking(goal_.limits);
    }
  }

  /// To digits that can be ordered, where a box hardly smaller has them. The largest of all fits
  /// about one point.
  void round() {
    if (!best_ || exact_.searched() == 0) {
      return;
    }
    const LargestBox largest = *best_;
    const double least = task_.requires_tolerance ? std::min(1.0, largest.scale) : 0;
    for (const double part : parts_rounded) {
      const double scale = std::max(part * largest.scale, least);
      const SuiteSpace boxes = space(scale);
      SuiteSearch search(suite_, task_, boxes, goal_, watch_);
      search.learn(breaking_);
      const BoxedDamper box = search.unbroken(largest.verified.box.damper);
      const BoxedDamper built = search.rounded(box, most_digits);
      const bool other = built.damper.f != box.damper.f || built.damper.delta != box.damper.delta;
      if (other && holds(search, built, scale)) {
        return;
      }
    }
  }

  void map_about(double scale, const SuiteDamper& damper) {
    const SuiteSpace boxes = space(scale);
    SuiteGrid like{};
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const SuiteAxis& axis = boxes.axes()[i];
      GridSide& side = like.at(i);
      const std::int64_t steps = axis.searched() ? near_windows.at(boxes.size()) : 2;
      const double box = axis.down() + axis.up();
      side.window = axis.toleranced() ? steps : 0;
      side.step = axis.toleranced() ? box / static_cast<double>(steps) : exact_step;
    }
    grid_ = grid_about(boxes, like, damper, near_reaches.at(boxes.size()));
    figures_ = grid_figures(suite_, boxes, grid_, task_.threads, watch_);
  }

  [[nodiscard]] SuiteSpace space(double scale) const { return {task_, frictions_, scale}; }

  /// The boxes of that size, rounded down to whole steps, on the grid of exact dampers.
  [[nodiscard]] std::vector<BoxedDamper> on_map(double scale, std::size_t most,
                                                double apart = 1) const {
    const SuiteSpace boxes = space(scale);
    if (!boxes.possible()) {
      return {};
    }
    SuiteGrid grid = grid_;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      GridSide& side = grid.at(i);
      if (side.step > 0 && boxes.axes()[i].searched()) {
        const auto below = std::floor(boxes.axes()[i].down() / side.step);
        const auto above = std::floor(boxes.axes()[i].up() / side.step);
        side.window = static_cast<std::int64_t>(below + above);
        side.lead = below * side.step;
        if (side.window >= side.points) {
          return {};
        }
      }
    }
    return BoxMap(boxes, grid, figures_).best(goal_, most, apart);
  }

  [[nodiscard]] double largest_on_map() const {
    double low = 0;
    double high = most_;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (low + high) / 2;
      const std::vector<BoxedDamper> best = on_map(middle, 1);
      (!best.empty() && best.front().rank.off == 0 ? low : high) = middle;
    }
    return low;
  }

  [[nodiscard]] std::vector<std::pair<double, SuiteDamper>> candidates() const {
    const double low = largest_on_map();
    std::vector<std::pair<double, SuiteDamper>> list;
    for (const double part : sizes_tried) {
      for (const BoxedDamper& each : on_map(part * low, low > 0 ? candidates_of_a_size : 1)) {
        list.emplace_back(part * low, each.damper);
      }
      if (low == 0) {
        break;
      }
    }
    return list;
  }

  const Suites& suite_;
  const RecordDesignRequest& task_;
  SuiteFrictions frictions_;
  double least_;
  double most_;
  bool thorough_;
  SuiteGoal goal_;
  SuiteWatch& watch_;
  SuiteSpace exact_;
  KnownDampers breaking_;
  std::optional<LargestBox> best_;
  SuiteGrid grid_{};
  GridFigures figures_;
};

}  // namespace

std::optional<LargestBox> largest_box(const Suites& suite, const RecordDesignRequest& task,
                                      SuiteFrictions frictions, Interval scales,
                                      const SuiteScan* scan, SuiteWatch& watch) {
  Growth growth(suite, task, frictions, scales, scan == nullptr, watch);
  return scan != nullptr ? growth.on(*scan) : growth.run();
}

std::optional<LargestBox> largest_box_about(const Suites& suite, const RecordDesignRequest& task,
                                            const DamperAlongF& known, double most,
                                            SuiteWatch& watch) {
  Growth growth(suite, task, frictions_of(known.damper), {0, most}, true, watch);
  return growth.about(known.scale, known.damper);
}

}  // namespace stillpoint::design
