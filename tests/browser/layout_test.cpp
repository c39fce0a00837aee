// SPDX-License-Identifier: MIT
#include "figure_facts.hpp"

// Rules for every page: no errors, nothing outside the window, no overlapping text, everything
// legible in both colour schemes.

namespace {

using namespace stillpoint::browser_test;
using nlohmann::json;

constexpr double pixel_rounding = 0.5;
constexpr double smallest_text = 11;          // pixels
constexpr double contrast_of_text = 4.5;      // WCAG 2, level AA
constexpr double contrast_of_graphics = 3.0;  // the same

/// Of a colour, by WCAG 2: "rgb(r, g, b)", each up to 255.
double luminance(const std::string& colour) {
  static const std::regex form(R"(rgb\((\d+), (\d+), (\d+)\))");
  std::smatch parts;
  BOOST_TEST_REQUIRE(std::regex_match(colour, parts, form), colour);
  const auto linear = [&parts](std::size_t i) {
    const double c = std::stod(parts[i]) / 255;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(1) + 0.7152 * linear(2) + 0.0722 * linear(3);
}

double contrast(const std::string& a, const std::string& b) {
  const double one = luminance(a);
  const double other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

bool is_within(const json& box, const json& room) {
  return box["left"] >= room["left"].get<double>() - pixel_rounding &&
         box["top"] >= room["top"].get<double>() - pixel_rounding &&
         box["right"] <= room["right"].get<double>() + pixel_rounding &&
         box["bottom"] <= room["bottom"].get<double>() + pixel_rounding;
}

bool overlap(const json& a, const json& b) {
  const auto span = [&](const char* from, const char* to) {
    return std::min(a[to].get<double>(), b[to].get<double>()) -
           std::max(a[from].get<double>(), b[from].get<double>());
  };
  return span("left", "right") > pixel_rounding && span("top", "bottom") > pixel_rounding;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(layout)

BOOST_AUTO_TEST_CASE(all_pages_open_with_nothing_wrong) {
  for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
    BOOST_TEST(seen(scheme).size() == pages().reports.size());
    for_each_look(scheme, [scheme](const std::string& look, const json& facts) {
      // No errors, no table that is cut, no line that ends between a number and its unit.
      for (const char* const wrong : {"errors", "cut", "parted"}) {
        BOOST_TEST(facts[wrong].empty(), wrong << ": " << facts[wrong].dump());
      }
      BOOST_TEST(facts["dark"] == (scheme == Scheme::dark));
      BOOST_TEST(!facts["figures"].empty());
      BOOST_TEST(facts["width"] == (look == "print" ? 700 : std::stoi(look)));
    });
  }
}

BOOST_AUTO_TEST_CASE(nothing_extends_beyond_the_window) {
  for_each_look(Scheme::light, [](const std::string& /*look*/, const json& facts) {
    BOOST_TEST(facts["scroll_width"] <= facts["width"]);
    for (const auto& [id, figure] : facts["figures"].items()) {
      BOOST_TEST(figure["box"]["left"] >= 0);
      BOOST_TEST(figure["box"]["right"] <= facts["width"]);
    }
  });
}

BOOST_AUTO_TEST_CASE(text_of_a_figure_has_room_and_is_large_enough_to_read) {
  for_each_figure([](const json& figure) {
    const json& texts = figure["texts"];
    BOOST_TEST(texts.size() >= 8U);  // title, two labels, ticks
    for (std::size_t i = 0; i < texts.size(); ++i) {
      BOOST_TEST(is_within(texts[i]["box"], texts[i]["room"]), texts[i].dump());
      BOOST_TEST(texts[i]["pixels"] >= smallest_text, texts[i].dump());
      for (std::size_t j = 0; j < i; ++j) {
        BOOST_TEST(!overlap(texts[i]["box"], texts[j]["box"]),
                   texts[i]["text"] << " on " << texts[j]["text"]);
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(each_figure_has_a_caption_of_one_sentence) {
  for_each_look(Scheme::light, [](const std::string& /*look*/, const json& facts) {
    BOOST_TEST(!facts["captions"].empty());
    for (const std::string caption : facts["captions"]) {
      BOOST_TEST(caption.ends_with('.'), caption);
      BOOST_TEST(caption.find(". ") == std::string::npos, caption);
    }
  });
}

/// The map of single dampers; paper has no use for its summary.
BOOST_AUTO_TEST_CASE(a_figure_that_is_folded_away_opens_on_demand) {
  constexpr int one_line = 60;  // pixels, with its margins
  constexpr int least_figure = 200;
  const json& looks = seen(Scheme::light)["records"];
  for (const char* const look : {"1280", "400"}) {
    const json& folded = looks[look]["folded"];
    BOOST_TEST_REQUIRE(folded.size() == 1U);
    BOOST_TEST(folded[0]["closed"] > 0);
    BOOST_TEST(folded[0]["closed"] <= one_line);
    BOOST_TEST(folded[0]["opened"] >= one_line + least_figure);
  }
  BOOST_TEST_REQUIRE(looks["print"]["folded"].size() == 1U);
  BOOST_TEST(looks["print"]["folded"][0]["closed"] == 0);
}

BOOST_AUTO_TEST_CASE(no_heading_is_printed_without_what_follows_it) {
  for_each_look(Scheme::light, [](const std::string& look, const json& facts) {
    for (const json& heading : facts["headings"]) {
      BOOST_TEST((look != "print" || heading["after"] == "avoid"), heading.dump());
      BOOST_TEST(heading["with_next"] != "nothing", heading.dump());
    }
  });
}

BOOST_AUTO_TEST_CASE(everything_stands_out) {
  for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
    for_each_look(scheme, [](const std::string& /*look*/, const json& facts) {
      for (const json& text : facts["texts"]) {
        BOOST_TEST(contrast(text["colour"], text["background"]) >= contrast_of_text, text.dump());
      }
    });
    for_each_figure(
        [](const json& figure) {
          std::string paper;
          for (const json& text : figure["texts"]) {
            paper = text["background"];
            const bool on_map = figure["has_map"].get<bool>() && text["rim"] != "none";
            BOOST_TEST((on_map || text["rim"] == "none" || text["rim"] == paper), text.dump());
            const std::string behind = on_map ? text["rim"] : text["background"];
            BOOST_TEST(contrast(text["colour"], behind) >= contrast_of_text, text.dump());
          }
          for (const json& ink : figure["inks"]) {
            BOOST_TEST(contrast(ink, paper) >= contrast_of_graphics, ink << " on " << paper);
          }
        },
        scheme);
  }
}

BOOST_AUTO_TEST_CASE(dark_colours_stay_on_the_screen) {
  const auto paper = [](Scheme scheme, const char* look) {
    return luminance(seen(scheme)["design"][look]["texts"][0]["background"]);
  };
  for (const char* look : {"1280", "400", "print"}) {
    BOOST_TEST(paper(Scheme::light, look) > 0.9);
  }
  BOOST_TEST(paper(Scheme::dark, "1280") < 0.05);
  BOOST_TEST(paper(Scheme::dark, "400") < 0.05);
  BOOST_TEST(paper(Scheme::dark, "print") > 0.9);
}

BOOST_AUTO_TEST_SUITE_END()
