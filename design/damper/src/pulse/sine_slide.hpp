// SPDX-License-Identifier: MIT
#pragma once

// A slide under a sine in closed form, and its first event: docs/theory.md section 16. In units of
// k and p.

#include <stillpoint/core/elementary.hpp>

#include <cmath>
#include <numbers>

// | here   | means                                                                 |
// |--------|-----------------------------------------------------------------------|
// | y, v   | -x and -x': the pulse moves the mass towards y > 0                     |
// | c      | where the friction alone would hold the mass, -f outwards, f inwards   |
// | h      | the time since a slide began                                          |
// | psi    | lambda t, the phase of the load sin psi                                |
// | ...ByF | derivatives over f, (68)                                              |

namespace stillpoint::design {

struct SlideMotion {
  double y{0};
  double v{0};
  double a{0};  ///< v'
  double j{0};  ///< v''
};

/// An instant of a slide.
struct SlideMoment {
  double h{0};
  SlideMotion motion;
};

/// Of a place and a speed at a given time.
struct MotionByF {
  double y{0};
  double v{0};
};

/// Of where and when a slide begins.
struct SlideBeginByF {
  double y{0};
  double t{0};
};

/// A phase of the load with its sine and cosine.
struct LoadPhase {
  static constexpr double second_crest = 1.5 * std::numbers::pi;  ///< of a full sine

  double psi{0};
  elementary::SinCos of{0, 1};
};

/// (62): a slide from rest under sin(psi + lambda h), about c.
class SineSlide {
 public:
  SineSlide(double lambda, const LoadPhase& begin, double c, double y)
      : lambda_(lambda),
        is_resonant_(std::abs(lambda - 1) < 1.0 / 16),
        over_square_(is_resonant_ ? 0 : 1 / ((lambda - 1) * (lambda + 1))),
        psi_(begin.psi),
        begin_(begin.of),
        c_(c),
        y_(y) {}

  [[nodiscard]] SlideMotion at(double h) const;
  /// (68), with c moving by `sign`.
  [[nodiscard]] MotionByF by_f(double h, double sign, const SlideBeginByF& begin) const {
    const auto [sine, cosine] = elementary::sin_cos(h);
    const double kick = (begin_.sine + c_ - y_) * begin.t;
    return {sign + (begin.y - sign) * cosine - kick * sine,
            (sign - begin.y) * sine - kick * cosine};
  }
  [[nodiscard]] double time_to(double psi) const { return (psi - psi_) / lambda_; }
  [[nodiscard]] double phase(double h) const { return psi_ + lambda_ * h; }

 private:
  /// By the form that does not divide by lambda^2 - 1.
  void add_near_resonance(SlideMotion& now, double h, const elementary::SinCos& own,
                          const elementary::SinCos& of_load) const;

  double lambda_;
  bool is_resonant_;
  double over_square_;  ///< 1/(lambda^2 - 1)
  double psi_;
  elementary::SinCos begin_;
  double c_;
  double y_;
};

enum class SlideEvent { turn, arrival, load_over };

struct Slid {
  SlideEvent event{SlideEvent::load_over};
  SlideMoment at;
};

/// The first event of a slide from rest until the load of the phase `last` ends.
[[nodiscard]] Slid slid(const SineSlide& slide, bool outwards, double last);

}  // namespace stillpoint::design
