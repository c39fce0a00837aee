// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/mpfr.hpp>

namespace stillpoint::test {

/// 50 digits, the reference of doubles in the tests.
using Exact = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

}  // namespace stillpoint::test
