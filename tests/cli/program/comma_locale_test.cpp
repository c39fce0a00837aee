// SPDX-License-Identifier: MIT
// Programs that link the library, and Python, may run in a locale with a decimal comma. What is
// found and said there is the same.
#include "cli_test.hpp"
#include "input/request.hpp"
#include "json_schema.hpp"
#include "options/scene.hpp"

#include <stillpoint/answers/answer.hpp>
#include <stillpoint/report/document.hpp>

#include <locale>

BOOST_AUTO_TEST_SUITE(comma_locale_test)

using namespace stillpoint;
using namespace stillpoint::cli_test;
using cli::Command;

/// In which C and C++ write a half as 0,5 while it lives.
class CommaLocale {
 public:
  CommaLocale() {
    folder_.write(
        "source",
        "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n");
    const std::string path = folder_.path("").string();
    // It complains, and returns 1, because the source defines nothing else.
    std::system(fmt::format("localedef -c --quiet -i {0}source -f UTF-8 {0}comma", path).c_str());
    ::setenv("LOCPATH", path.c_str(), 1);
    std::locale::global(std::locale(std::locale::classic(), "comma", std::locale::numeric));
    BOOST_TEST_REQUIRE(std::strtod("0,5", nullptr) == 0.5);
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;
  ~CommaLocale() {
    std::locale::global(std::locale::classic());
    ::unsetenv("LOCPATH");
  }

 private:
  test::Folder folder_;
};

std::unique_ptr<answers::Answer> answer(Command command, const json& scene) {
  const cli::Settings given = cli::scene_settings(scene, command);
  switch (command) {
    case Command::region:
      return answers::answer_of(answers::answer(cli::region_input(given)));
    case Command::simulate:
      return answers::answer_of(cli::motion_report(given, {}));
    case Command::spectrum: {
      report::SpectrumReport found = cli::spectrum_input(given);
      found.result = design::spectrum(found.result.request, {});
      return answers::answer_of(std::move(found));
    }
    default:
      return answers::answer_of(answers::answer(cli::design_input(given)));
  }
}

/// Everything that is said, without times of the clock.
std::string said(Command command, const json& scene) {
  const auto found = answer(command, scene);
  const figures::HtmlPage page = found->page();
  std::string all =
      found->json().dump() + "\n" + page.report + page.verdict + page.answer + page.body;
  for (const figures::Figure& figure : page.figures) {
    all += svg(figure, figures::Frame::alone) + figure.caption();
  }
  for (const std::string_view clock : {R"("wall_time_s":)", "evaluations, "}) {
    for (std::size_t at = 0; (at = all.find(clock, at)) != std::string::npos;) {
      at += clock.size();
      all.erase(at, all.find_first_not_of("0123456789.e+-", at) - at);
    }
  }
  return all;
}

/// The designs of the scenes, a point, a region, motions and a spectrum.
std::vector<std::pair<Command, json>> tasks() {
  std::vector<std::pair<Command, json>> all{
      {Command::region, {{"v0", 1}, {"p", 1}, {"beta", 0.9}, {"f", 0.25}, {"delta", 0.3}}},
      {Command::region, {{"v0", "0.8:1"}, {"p", 1}, {"beta", 0.97}, {"arrivals", 14}}},
      {Command::simulate, {{"v0", 1}, {"p", 1}, {"f", 0.02}, {"delta", 0.02}, {"samples", 50}}},
      {Command::simulate, {{"v0", 1}, {"p", 1}, {"f", 0.02}, {"delta", 0}, {"damping", "2.5%"}}},
      {Command::spectrum,
       {{"record", STILLPOINT_DATA_DIR "/records/strong_motion.AT2"},
        {"period", "1s:4s:5"},
        {"f", 0.05},
        {"delta_m", "55mm"}}}};
  for (const fs::path& path : json_files("scenes")) {
    const json scene = data_json(path);
    if (!scene.contains("record") && !scene.contains("cases") && !scene.contains("catalogue") &&
        !scene.contains("damping")) {
      all.emplace_back(Command::design, scene);
    }
  }
  return all;
}

BOOST_AUTO_TEST_CASE(every_answer_is_the_same) {
  const auto all = tasks();
  std::vector<std::vector<std::string>> wanted;
  wanted.reserve(all.size());
  for (const auto& [command, scene] : all) {
    wanted.push_back(lines_of(said(command, scene)));
  }
  const CommaLocale german;
  for (std::size_t i = 0; i < all.size(); ++i) {
    BOOST_TEST_CONTEXT(all[i].second.dump()) {
      const std::vector<std::string> found = lines_of(said(all[i].first, all[i].second));
      BOOST_TEST(found == wanted[i], tt::per_element());
    }
  }
}

/// f2 = (1 - 0.49) / 1.4 is 0.364286, rounded up.
BOOST_AUTO_TEST_CASE(what_is_needed_is_right) {
  const CommaLocale german;
  const auto found = answer(Command::design, {{"v0", 1}, {"p", 1}, {"beta", 0.7}})->json();
  BOOST_TEST(contains(found["region"]["reason"].get<std::string>(), "f >= 0.364286"),
             found["region"]["reason"]);
}

BOOST_AUTO_TEST_SUITE_END()
