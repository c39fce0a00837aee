// SPDX-License-Identifier: MIT
//
// Each function reduces its argument by a table of sixteenths (thirty-seconds for exp) and ends in
// a few terms of Taylor's series; sums of two doubles carry what the reduction would lose.

#include <stillpoint/core/double_pair.hpp>
#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace stillpoint::elementary {

namespace {

using Pair = DoublePair;

/// The upper 26 bits of a, |a| < 2^995, by Veltkamp: products of halves are exact.
double upper_half(double a) {
  const double t = 134217729 * a;  // 2^27 + 1
  return t - (t - a);
}

/// The nearest whole number, ties to even, of |x| < 2^51, by the rounding of a sum.
double nearest(double x) {
  constexpr double shift = 6755399441055744;  // 1.5 2^52
  return (x + shift) - shift;
}

constexpr Pair half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

// The tables. A wrong digit in one shows in elementary_test.

/// atan(i / 16).
constexpr std::array<Pair, 17> atan_of{{{0x0p+0, 0x0p+0},
                                        {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
                                        {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                        {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
                                        {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                        {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
                                        {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                        {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
                                        {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                        {0x1.0657e94db30dp-1, -0x1.d5b495f6349e6p-56},
                                        {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                        {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
                                        {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                        {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
                                        {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                        {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
                                        {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};

/// 2^(i / 32).
constexpr std::array<Pair, 32> exp2_of{{{0x1p+0, 0x0p+0},
                                        {0x1.059b0d3158574p+0, 0x1.d73e2a475b465p-55},
                                        {0x1.0b5586cf9890fp+0, 0x1.8a62e4adc610bp-54},
                                        {0x1.11301d0125b51p+0, -0x1.6c51039449b3ap-54},
                                        {0x1.172b83c7d517bp+0, -0x1.19041b9d78a76p-55},
                                        {0x1.1d4873168b9aap+0, 0x1.e016e00a2643cp-54},
                                        {0x1.2387a6e756238p+0, 0x1.9b07eb6c70573p-54},
                                        {0x1.29e9df51fdee1p+0, 0x1.612e8afad1255p-55},
                                        {0x1.306fe0a31b715p+0, 0x1.6f46ad23182e4p-55},
                                        {0x1.371a7373aa9cbp+0, -0x1.63aeabf42eae2p-54},
                                        {0x1.3dea64c123422p+0, 0x1.ada0911f09ebcp-55},
                                        {0x1.44e086061892dp+0, 0x1.89b7a04ef80dp-59},
                                        {0x1.4bfdad5362a27p+0, 0x1.d4397afec42e2p-56},
                                        {0x1.5342b569d4f82p+0, -0x1.07abe1db13cadp-55},
                                        {0x1.5ab07dd485429p+0, 0x1.6324c054647adp-54},
                                        {0x1.6247eb03a5585p+0, -0x1.383c17e40b497p-54},
                                        {0x1.6a09e667f3bcdp+0, -0x1.bdd3413b26456p-54},
                                        {0x1.71f75e8ec5f74p+0, -0x1.16e4786887a99p-55},
                                        {0x1.7a11473eb0187p+0, -0x1.41577ee04992fp-55},
                                        {0x1.82589994cce13p+0, -0x1.d4c1dd41532d8p-54},
                                        {0x1.8ace5422aa0dbp+0, 0x1.6e9f156864b27p-54},
                                        {0x1.93737b0cdc5e5p+0, -0x1.75fc781b57ebcp-57},
                                        {0x1.9c49182a3f09p+0, 0x1.c7c46b071f2bep-56},
                                        {0x1.a5503b23e255dp+0, -0x1.d2f6edb8d41e1p-54},
                                        {0x1.ae89f995ad3adp+0, 0x1.7a1cd345dcc81p-54},
                                        {0x1.b7f76f2fb5e47p+0, -0x1.5584f7e54ac3bp-56},
                                        {0x1.c199bdd85529cp+0, 0x1.11065895048ddp-55},
                                        {0x1.cb720dcef9069p+0, 0x1.503cbd1e949dbp-56},
                                        {0x1.d5818dcfba487p+0, 0x1.2ed02d75b3707p-55},
                                        {0x1.dfc97337b9b5fp+0, -0x1.1a5cd4f184b5cp-54},
                                        {0x1.ea4afa2a490dap+0, -0x1.e9c23179c2893p-54},
                                        {0x1.f50765b6e454p+0, 0x1.9d3e12dd8a18bp-54}}};

/// log(i / 16), from i = 11.
constexpr std::array<Pair, 13> log_of{{{-0x1.7fafa3bd8151cp-2, 0x1.219024acd3b77p-58},
                                       {-0x1.269621134db92p-2, -0x1.e0efadd9db02bp-56},
                                       {-0x1.a93ed3c8ad9e3p-3, -0x1.bcafa9de97203p-57},
                                       {-0x1.1178e8227e47cp-3, 0x1.0e63a5f01c691p-58},
                                       {-0x1.08598b59e3a07p-4, 0x1.dd7009902bf32p-58},
                                       {0x0p+0, 0x0p+0},
                                       {0x1.f0a30c01162a6p-5, 0x1.85f325c5bbacdp-59},
                                       {0x1.e27076e2af2e6p-4, -0x1.61578001e0162p-60},
                                       {0x1.5ff3070a793d4p-3, -0x1.bc60efafc6f6ep-58},
                                       {0x1.c8ff7c79a9a22p-3, -0x1.4f689f8434012p-57},
                                       {0x1.1675cababa60ep-2, 0x1.ce63eab883717p-61},
                                       {0x1.4618bc21c5ec2p-2, 0x1.f42decdeccf1dp-56},
                                       {0x1.739d7f6bbd007p-2, -0x1.8c76ceb014b04p-56}}};

struct SinCosEntry {
  Pair sine;
  Pair cosine;
};

/// sin(i / 16), cos(i / 16).
constexpr std::array<SinCosEntry, 14> sin_cos_of{
    {{{0x0p+0, 0x0p+0}, {0x1p+0, 0x0p+0}},
     {{0x1.ffaaaeeed4edbp-5, -0x1.2d16d32684b69p-59},
      {0x1.ff0015549f4d3p-1, 0x1.328387b99426fp-55}},
     {{0x1.feaaeee86ee36p-4, -0x1.afcb2bcc6f03bp-59},
      {0x1.fc015527d5bd3p-1, 0x1.b68f35094efb8p-55}},
     {{0x1.7dc102fbaf2b5p-3, 0x1.5ab50e23c97c3p-59},
      {0x1.f706bdf9ece1cp-1, -0x1.698c80c36dcb4p-55}},
     {{0x1.faaeed4f31577p-3, -0x1.15d88508e32b8p-57},
      {0x1.f01549f7deea1p-1, 0x1.d3c1e99e5cafdp-55}},
     {{0x1.3ad129769d3d8p-2, 0x1.03d550487839ap-63}, {0x1.e733ea0193d4p-1, -0x1.6428b3546ce13p-55}},
     {{0x1.7710255764214p-2, -0x1.6ead7314bb6cep-57},
      {0x1.dc6b7eb995912p-1, 0x1.4b364776dcd35p-58}},
     {{0x1.b1d8305321617p-2, -0x1.ae242cb99f519p-56},
      {0x1.cfc6cfa52ad9fp-1, 0x1.8b5b5508f2a0dp-55}},
     {{0x1.eaee8744b05fp-2, -0x1.789b43c9b027dp-58}, {0x1.c1528065b7d5p-1, -0x1.892111312e828p-55}},
     {{0x1.110d0c4b69c3bp-1, 0x1.d918998809981p-55}, {0x1.b11d04162a4c6p-1, 0x1.1dd561efbc0c2p-56}},
     {{0x1.2b91dea88421ep-1, -0x1.fa371db216abp-55},
      {0x1.9f368ed912f85p-1, -0x1.1d200c5791606p-55}},
     {{0x1.44eb381cf386bp-1, -0x1.3ed6c1e6a5505p-55}, {0x1.8bb105a5dc9p-1, 0x1.863e03e9474c1p-55}},
     {{0x1.5cffc16bf8f0dp-1, 0x1.96cb370eb578ap-55},
      {0x1.769fec655211fp-1, -0x1.827d5cf8c68c5p-57}},
     {{0x1.73b7680dea578p-1, -0x1.2248306dc12a2p-56},
      {0x1.6018526f563dfp-1, 0x1.46ca5e0e432dp-55}}}};

/// sin and cos of an angle of which |high| <= pi / 4, by i / 16 and the rest d.
SinCos of_eighth_turn(Pair angle) {
  const double high = std::abs(angle.high);
  const double low = std::copysign(1.0, angle.high) * angle.low;
  const double sixteenths = nearest(16 * high);
  const SinCosEntry& entry = sin_cos_of[static_cast<std::size_t>(sixteenths)];
  const double d = high - sixteenths / 16;
  const double z = d * d;
  const double zz = z * z;
  const double sine_rest = low + d * z * ((-1.0 / 6 + z * (1.0 / 120)) - zz * (1.0 / 5040));
  const double versine =
      z * ((1.0 / 2 - z * (1.0 / 24)) + zz * (1.0 / 720 - z * (1.0 / 40320))) + low * d;

  const auto [s, s_low] = entry.sine;
  const auto [c, c_low] = entry.cosine;
  const Pair sine = ordered_sum(s, c * d);
  const double sine_low = s_low + (c_low * d + (c * sine_rest - s * versine));
  const Pair cosine = ordered_sum(c, -(s * d));
  const double cosine_low = c_low - (s_low * d + (s * sine_rest + c * versine));
  return {std::copysign(sine.high + (sine.low + sine_low), angle.high),
          cosine.high + (cosine.low + cosine_low)};
}

/// x - quarters pi / 2, |quarters| < 2^20.
Pair less_quarters(double x, double quarters) {
  // pi / 2 in parts of 33 bits: their products with the quarters are exact.
  constexpr double first = 0x1.921fb544p+0;
  constexpr double second = 0x1.0b4611a6p-34;
  constexpr double rest = 0x1.3198a2e037073p-69;
  const Pair angle = two_sum(x - quarters * first, -(quarters * second));
  if (std::abs(angle.high) > 0x1p-20) {
    return {angle.high, angle.low - quarters * rest};
  }
  // So close to a multiple that the remainder needs its own digits.
  constexpr double third = 0x1.3198a2ep-69;
  constexpr double fourth = 0x1.b839a252049c1p-104;
  const Pair next = two_sum(angle.high, -(quarters * third));
  return two_sum(next.high, (next.low + angle.low) - quarters * fourth);
}

/// n / d to twice the digits of a double.
Pair quotient(Pair n, Pair d) {
  const double inverse =
      1 / d.high;  // in parallel with the next division, which does not wait for it
  const double high = n.high / d.high;
  const Pair product = two_product(high, d.high);
  const double rest = ((n.high - product.high) - product.low) + (n.low - high * d.low);
  return {high, rest * inverse};
}

/// atan(b / a), a >= b > 0: by t = i / 16 next to b / a and the angle between, whose tangent is
/// (b - a t) / (a + b t).
Pair arc_tangent(double b, double a) {
  if (b < a * 0x1p-28) {
    return {b / a, 0};  // to a relative 2^-57
  }
  if (!(a > 0x1p-800 && a < 0x1p+800)) {  // the products below would not be exact
    const double scale = a < 1 ? 0x1p+700 : 0x1p-700;
    a *= scale;
    b *= scale;
  }
  const double sixteenths = nearest(16 * (b / a));
  const double t = sixteenths / 16;
  const double a1 = upper_half(a);
  Pair tangent{((b - a1 * t) - (a - a1) * t) / (a + b * t), 0};
  if (t < 0.25) {  // its error is no longer small beside the angle's own last place
    const double b1 = upper_half(b);
    const Pair n = two_sum(b - a1 * t, -((a - a1) * t));
    const Pair sum = two_sum(a, b1 * t);
    const Pair d = two_sum(sum.high, (b - b1) * t);
    tangent = quotient(n, {d.high, d.low + sum.low});
  }
  const double z = tangent.high * tangent.high;
  const double zz = z * z;
  const double series =
      tangent.high * z *
      ((-1.0 / 3 + z * (1.0 / 5)) - zz * ((1.0 / 7 - z * (1.0 / 9)) + zz * (1.0 / 11)));
  const auto [high, low] = atan_of[static_cast<std::size_t>(sixteenths)];
  const Pair angle = ordered_sum(high, tangent.high);
  return {angle.high, angle.low + (low + (tangent.low + series))};
}

/// e^x for x as a sum.
double exp_of(Pair x) {
  if (!(std::abs(x.high) < 800)) {
    return std::exp(x.high);  // infinity or 0: the C library has no choice
  }
  constexpr double parts_of_unit = 32 / std::numbers::ln2;
  const double parts = nearest(x.high * parts_of_unit);
  // ln 2 / 32 in two parts: the product of the first, of 36 bits, is exact.
  const Pair less = two_sum(x.high - parts * 0x1.62e42fefap-6, -(parts * 0x1.cf79abc9e3b3ap-45));
  const Pair rest = two_sum(less.high, less.low + x.low);
  const double r = rest.high;
  const double rr = r * r;
  const double series =
      rr * ((1.0 / 2 + r * (1.0 / 6)) +
            rr * ((1.0 / 24 + r * (1.0 / 120)) + rr * (1.0 / 720 + r * (1.0 / 5040))));
  const int whole = static_cast<int>(parts);
  const auto [high, low] = exp2_of[static_cast<std::size_t>(whole & 31)];
  const Pair linear = two_product(high, r);
  const Pair sum = ordered_sum(high, linear.high);
  const double more = linear.low + low * r + high * (rest.low + series);
  return std::ldexp(sum.high + (sum.low + (low + more)), (whole - (whole & 31)) / 32);
}

/// log x, 0 < x < infinity.
Pair log_of_positive(double x) {
  int exponent{0};
  double m = std::frexp(x, &exponent);
  if (m < std::numbers::sqrt2 / 2) {
    m *= 2;
    exponent -= 1;
  }
  const double sixteenths = nearest(16 * m);
  const double c = sixteenths / 16;
  const Pair s = quotient({m - c, 0}, two_sum(m, c));
  const double z = s.high * s.high;
  const double zz = z * z;
  const double series =
      s.high * z * ((1.0 / 3 + z * (1.0 / 5)) + zz * ((1.0 / 7 + z * (1.0 / 9)) + zz * (1.0 / 11)));
  const auto [high, low] = log_of[static_cast<std::size_t>(sixteenths) - 11];
  // ln 2 in two parts: the product of the first, of 40 bits, is exact.
  const Pair powers = two_sum(exponent * 0x1.62e42fefa2p-1, high);
  const Pair sum = two_sum(powers.high, 2 * s.high);
  return two_sum(sum.high, sum.low + (powers.low + (low + exponent * 0x1.9ef35793c7673p-41 +
                                                    2 * (s.low + series))));
}

}  // namespace

SinCos sin_cos(double x) {
  constexpr double eighth_turn = std::numbers::pi / 4;
  if (std::abs(x) <= eighth_turn) {
    return of_eighth_turn({x, 0});
  }
  if (!(std::abs(x) <= 1e6)) {
    return {std::sin(x), std::cos(x)};
  }
  const double quarters = nearest(x * (2 / std::numbers::pi));
  const SinCos at = of_eighth_turn(less_quarters(x, quarters));
  constexpr std::array<double, 5> sign{1, 1, -1, -1, 1};
  const auto quadrant = static_cast<std::size_t>(static_cast<int>(quarters) & 3);
  const bool swapped = (quadrant & 1) != 0;
  return {sign[quadrant] * (swapped ? at.cosine : at.sine),
          sign[quadrant + 1] * (swapped ? at.sine : at.cosine)};
}

double atan2(double y, double x) {
  double a = std::abs(x);
  double b = std::abs(y);
  // At 0 and infinity the C library has no choice: these are multiples of pi / 4, rounded.
  if (!(a > 0 && b > 0 && std::max(a, b) <= std::numeric_limits<double>::max())) {
    return std::atan2(y, x);
  }
  const bool steep = b > a;
  if (steep) {
    std::swap(a, b);
  }
  const Pair within = arc_tangent(b, a);
  double angle = within.high + within.low;
  if (steep || x < 0) {
    const double sign = steep == (x < 0) ? 1 : -1;
    const double quarters = steep ? 1 : 2;
    const Pair sum = two_sum(quarters * half_pi.high, sign * within.high);
    angle = sum.high + (sum.low + (quarters * half_pi.low + sign * within.low));
  }
  return std::copysign(angle, y);
}

double asin(double x) {
  return atan2(x, std::sqrt((1 - x) * (1 + x)));
}
double acos(double x) {
  return atan2(std::sqrt((1 - x) * (1 + x)), x);
}

double exp(double x) {
  return exp_of({x, 0});
}

double log(double x) {
  if (!(x > 0 && x <= std::numeric_limits<double>::max())) {
    return std::log(x);
  }
  return log_of_positive(x).high;
}

double pow(double x, double y) {
  return exp(y * log(x));
}

double between(double low, double high, double part, double of) {
  const Pair from = log_of_positive(low);
  const Pair to = log_of_positive(high);
  const Pair way = two_sum(to.high, -from.high);
  const Pair share = quotient({part, 0}, {of, 0});
  const Pair gone = two_product(share.high, way.high);
  const Pair at = two_sum(from.high, gone.high);
  const double rest = share.high * (way.low + (to.low - from.low)) + share.low * way.high;
  return exp_of({at.high, at.low + (from.low + (gone.low + rest))});
}

double hypot(double x, double y) {
  const double largest = std::max(std::abs(x), std::abs(y));
  if (!(largest > 0 && largest <= std::numeric_limits<double>::max())) {
    return std::hypot(x, y);
  }
  const int exponent = std::ilogb(largest);
  const double a = std::ldexp(x, -exponent);
  const double b = std::ldexp(y, -exponent);
  return std::ldexp(std::sqrt(a * a + b * b), exponent);
}

}  // namespace stillpoint::elementary
