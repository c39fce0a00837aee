// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

BOOST_FIXTURE_TEST_SUITE(pictures_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using boost::property_tree::ptree;

const Arguments plain("design --v0 1 --p 1 --beta 0.8");

ptree parsed(const std::string& text) {
  std::istringstream stream(text.substr(!contains(text, "<html") ? 0 : text.find("<html")));
  ptree tree;
  BOOST_REQUIRE_NO_THROW(boost::property_tree::read_xml(stream, tree));
  return tree;
}

/// Nothing is loaded from anywhere.
void check_offline(const std::string& page) {
  for (const char* other : {"http:", "https:", "src=", "@import"}) {
    BOOST_TEST(!contains(page, other), other);
  }
  for (std::size_t at = 0; (at = page.find("url(", at)) != std::string::npos; ++at) {
    BOOST_TEST(page.at(at + 4) == '#');  // what stands in the page itself
  }
  check_only_finite(page.substr(0, page.find("<script")));
}

/// A page that is well-formed and loads nothing.
std::string checked(std::string page) {
  check_offline(page);
  parsed(page);
  return page;
}

BOOST_AUTO_TEST_CASE(of_a_design_are_all_there) {
  succeed(plain + "--html page.html --svg figures");
  const std::string page = checked(read("page.html"));
  for (const char* figure : {"region", "hits", "motion", "phase", "energy"}) {
    BOOST_TEST(contains(page, "aria-labelledby=\"" + std::string(figure) + "-title"));
    const std::string alone = read("figures/" + std::string(figure) + ".svg");
    const ptree tree = parsed(alone);
    BOOST_TEST(!tree.get<std::string>("svg.title").empty());
    BOOST_TEST(!tree.get<std::string>("svg.desc").empty());
  }
}

/// Those that the README shows.
BOOST_AUTO_TEST_CASE(of_the_docs_are_what_the_program_draws) {
  const fs::path scene = fs::path(STILLPOINT_DATA_DIR) / "scenes/isolator.json";
  succeed({"design", scene.string(), "--svg", "figures"});
  for (const char* name : {"region.svg", "hits.svg", "motion.svg", "phase.svg", "energy.svg"}) {
    BOOST_TEST(text_of(fs::path(STILLPOINT_DATA_DIR) / "../docs/pictures" / name) ==
                   read("figures/" + std::string(name)),
               name << ": ./dev run design data/scenes/isolator.json --svg docs/pictures");
  }
}

BOOST_AUTO_TEST_CASE(of_any_motion_are_finite) {
  const Arguments simulate("simulate --p 1 --html page.html");
  for (const Arguments& motion :
       std::vector<Arguments>{{"--v0", "1", "--f", "0", "--delta", "0"},
                              {"--v0", "1", "--f", "1e-9", "--delta", "0"},
                              {"--v0", "0.1", "--f", "0.1", "--delta", "1"},
                              {"--v0", "1e100", "--f", "1e99", "--delta", "0"},
                              {"--v0", "0", "--x0", "-1", "--f", "0.1", "--delta", "0"},
                              {"--v0", "0.5", "--f", "0.18", "--delta", "0", "--excitation",
                               "harmonic", "--k", "0.2", "--lambda", "0.35", "--t-end", "3000"},
                              {"--f", "0.1", "--delta", "0.01", "--excitation", "rectangle", "--k",
                               "0.5", "--lambda", "2"}}) {
    succeed(simulate + motion);
    const std::string page = checked(read("page.html"));
    BOOST_TEST(page.size() < 1'000'000U);
  }
}

BOOST_AUTO_TEST_CASE(give_the_same_page_from_their_input) {
  const Arguments titled = plain + Arguments{"--title", "</pre><script>x</script> & \"y\""};
  succeed(titled + "--html one.html");
  const std::string page = read("one.html");
  parsed(page);
  BOOST_TEST(!contains(page, "<script>x"));
  BOOST_TEST(contains(page, "<pre>Damper design: &lt;/pre&gt;"));  // of the folded text
  std::string scene = page.substr(page.find("<pre>") + 5);
  scene = scene.substr(0, scene.find("</pre>"));
  for (const auto& [name, sign] :
       {std::pair{"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
    scene = std::regex_replace(scene, std::regex(name), sign);
  }
  write("scene.json", scene);
  succeed("design scene.json --html two.html");
  const auto figures = [](const std::string& text) {
    return text.substr(0, text.find("<h2>Cross"));
  };
  BOOST_TEST(figures(read("two.html")) == figures(page));
}

BOOST_AUTO_TEST_CASE(of_a_large_sweep_stay_small) {
  succeed(
      "sweep --v0 1 --p 1 --f 1e-3:0.4:1000 --delta 0:0.55:1000 --output map.npy --html "
      "page.html --svg figures");
  const std::string page = checked(read("page.html"));
  BOOST_TEST(page.size() < 1'000'000U);
  BOOST_TEST(read("figures/map.svg").size() < 1'000'000U);
}

BOOST_AUTO_TEST_CASE(of_a_long_record_stay_small) {
  std::string record;
  for (int i = 0; i < 200'000; ++i) {
    record += std::to_string(0.2 * std::sin(0.3 * i)) + "\n";
  }
  write("record.txt", record);
  succeed(
      "simulate --p 0.01 --f 0.001 --delta 0 --record record.txt --record-step 0.01 --html "
      "page.html");
  BOOST_TEST(read("page.html").size() < 1'000'000U);
}

BOOST_AUTO_TEST_SUITE_END()
