// SPDX-License-Identifier: MIT

// rotor.hpp in lanes: the same operations in the same order.

// Read once for each instruction set, as Highway requires.
#if defined(STILLPOINT_LANE_ROTOR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STILLPOINT_LANE_ROTOR_INL
#undef STILLPOINT_LANE_ROTOR_INL
#else
#define STILLPOINT_LANE_ROTOR_INL
#endif

#include "kernel/lane_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace stillpoint::HWY_NAMESPACE {

struct VectorRotor {
  V cosine;
  V sine;
  V quarters;
};

HWY_INLINE V unit_scale(V size) {
  const Bits bits;
  const auto exponent = hn::And(hn::BitCast(bits, size), hn::Set(bits, 0x7ff0000000000000));
  return hn::BitCast(D(), hn::Sub(hn::Set(bits, 0x7fe0000000000000), exponent));
}

HWY_INLINE void turn(VectorRotor& rotor, V c, V s) {
  const V x = hn::Sub(hn::Mul(rotor.cosine, c), hn::Mul(rotor.sine, s));
  const V y = hn::Add(hn::Mul(rotor.sine, c), hn::Mul(rotor.cosine, s));
  const M beyond = hn::Lt(x, hn::Zero(D()));
  const V cosine = hn::IfThenElse(beyond, y, x);
  const V sine = hn::IfThenElse(beyond, hn::Neg(x), y);
  rotor.quarters = hn::Add(rotor.quarters, hn::IfThenElseZero(beyond, all(1)));
  const V scale = unit_scale(hn::Add(cosine, sine));
  rotor.cosine = hn::Mul(cosine, scale);
  rotor.sine = hn::Mul(sine, scale);
}

/// The angle of `a` minus that of `b` is that of x + i y, without their quarter turns.
struct VectorDirection {
  V x;
  V y;
};

HWY_INLINE VectorDirection between(const VectorRotor& a, const VectorRotor& b) {
  const V x = hn::Add(hn::Mul(a.cosine, b.cosine), hn::Mul(a.sine, b.sine));
  const V y = hn::Sub(hn::Mul(a.sine, b.cosine), hn::Mul(a.cosine, b.sine));
  const V scale = unit_scale(hn::Add(x, hn::Abs(y)));
  return {hn::Mul(x, scale), hn::Mul(y, scale)};
}

}  // namespace stillpoint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
