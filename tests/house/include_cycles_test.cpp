// SPDX-License-Identifier: MIT
// A component is a header with the source file of its name. No component uses itself by way of
// others.
#include "sources.hpp"

BOOST_AUTO_TEST_SUITE(include_cycles_test)

using namespace stillpoint::test;

/// core/motion of a file in it.
fs::path room_of(const fs::path& file) {
  const fs::path place = file.lexically_relative(root);
  return root / *place.begin() / *std::next(place.begin());
}

/// The headers of the project that a file includes: beside it, in the room's own folders, or in the
/// include folder of any room.
std::vector<fs::path> included_by(const fs::path& file, const std::vector<fs::path>& all) {
  static const std::regex directive(R"(#include ["<]([^">]+)[">])");
  const fs::path room = room_of(file);
  std::vector<fs::path> found;
  std::ifstream lines(file);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_match(line, match, directive)) {
      continue;
    }
    std::vector<fs::path> places{file.parent_path() / match[1].str(), room / "src" / match[1].str(),
                                 room / match[1].str()};
    std::ranges::copy_if(all, std::back_inserter(places), [&](const fs::path& header) {
      return header.string().ends_with("/include/" + match[1].str());
    });
    const auto place = std::ranges::find_if(places, [](const auto& at) { return fs::exists(at); });
    if (place != places.end()) {
      found.push_back(place->lexically_normal());
    }
  }
  return found;
}

using Uses = std::map<fs::path, std::set<fs::path>>;

/// What each component uses, by the path of its header, or of its source file if it has none.
Uses uses() {
  const std::vector<fs::path> all = sources();
  Uses found;
  for (const fs::path& file : all) {
    const std::vector<fs::path> headers = included_by(file, all);
    const auto own = std::ranges::find_if(headers, [&](const fs::path& header) {
      return file.extension() == ".cpp" && header.stem() == file.stem() &&
             room_of(header) == room_of(file);
    });
    const fs::path component = own == headers.end() ? file : *own;
    found[component].insert(headers.begin(), headers.end());
    found[component].erase(component);
  }
  return found;
}

/// Components of which each uses the next, and the last one the first; empty without a cycle.
std::vector<fs::path> cycle(Uses left) {
  const auto is_left = [&](const fs::path& used) { return left.contains(used); };
  for (std::size_t before = 0; before != left.size();) {
    before = left.size();  // what uses nothing that is left is in no cycle
    std::erase_if(left, [&](const auto& component) {
      return std::ranges::none_of(component.second, is_left);
    });
  }
  std::vector<fs::path> path;
  for (fs::path at = left.empty() ? fs::path() : left.begin()->first; !at.empty();) {
    const auto seen = std::ranges::find(path, at);
    if (seen != path.end()) {
      return {seen, path.end()};
    }
    path.push_back(at);
    at = *std::ranges::find_if(left[at], is_left);
  }
  return {};
}

BOOST_AUTO_TEST_CASE(no_component_uses_itself_by_way_of_others) {
  const Uses all = uses();
  BOOST_TEST(all.size() > 300U);
  for (const fs::path& component : cycle(all)) {
    BOOST_ERROR("in a cycle: " << component.lexically_relative(root).string());
  }
}

BOOST_AUTO_TEST_SUITE_END()
