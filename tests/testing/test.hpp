// SPDX-License-Identifier: MIT
#pragma once

// What nearly every test uses.

#include "testing/contains.hpp"
#include "testing/printing.hpp"
#include "testing/refusal.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <ostream>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace tt = boost::test_tools;

namespace stillpoint::test {

namespace data = boost::unit_test::data;
namespace fs = std::filesystem;

}  // namespace stillpoint::test
