// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(reports_test)

// The commands of commands/reports with what their reports have. Below a command stands
//   exit N           its exit code, where it is not 0
//   PLACE = JSON     a value; null also where an array has no such part
//   PLACE ~ NUMBER   within 1e-12 of it, or within what follows
//   PLACE < NUMBER, PLACE > NUMBER, PLACE has WORDS, PLACE size N
//   PLACE as COMMAND the same value as in that command's report; without a place all of it
//   PLACE near COMMAND  the same size as there, within 1e-9
//   out has WORDS, err has WORDS, err lacks WORDS, err size LINES: of the text, and of standard
//   error
// where a place is design/f, or mends/beta/value: parts of an array by their name, kind or input,
// or where they have none by their number. NUMBER*PLACE is a number too. In COMMAND {PLACE} is the
// value in this report, and PLACE: or NUMBER*PLACE: before it means another place in that one.

using namespace stillpoint::cli_test;

json at_place(const json& report, const std::string& place) {
  json now = report;
  std::istringstream steps(place);
  for (std::string step; std::getline(steps, step, '/');) {
    if (now.is_object()) {
      BOOST_TEST_REQUIRE(now.contains(step), place << ": " << step);
      now = json(now[step]);
    } else if (now.is_array() && std::isdigit(step.front()) != 0) {
      now = json(now.at(std::stoul(step)));
    } else if (now.is_array()) {
      const auto found = std::ranges::find_if(now, [&step](const json& part) {
        return part.value("name", "") == step || part.value("kind", "") == step ||
               part.value("input", "") == step || part.value("column", "") == step;
      });
      now = found == now.end() ? json() : json(*found);
    }
  }
  return now;
}

/// A command with its report.
class Reported {
 public:
  explicit Reported(const Wrong& told) : input_{.input = told.input}, arguments_(told.arguments) {
    write_files(sandbox_, told);
    fs::create_directory_symlink(STILLPOINT_DATA_DIR, sandbox_.path("data"));
    run_ = sandbox_.run(arguments_ + "--json", input_);
    check_only_finite(run_.out);
  }

  void check_exit(int code) const { BOOST_TEST(run_.exit_code == code, run_.err); }

  void check(const std::string& line) const {
    static const std::regex form("(\\S*) ?(=|~|<|>|has|lacks|size|as|near) (.*)");
    std::smatch match;
    BOOST_TEST_REQUIRE(std::regex_match(line, match, form), line);
    const std::string place = match[1];
    const std::string how = match[2];
    const std::string what = match[3];
    if (place == "err" && how == "size") {
      BOOST_TEST(run_.err_lines().size() == std::stoul(what), run_.err);
      return;
    }
    if (place == "out" || place == "err") {
      if (place == "out" && text_.empty()) {
        text_ = sandbox_.run(arguments_, input_).out;
      }
      BOOST_TEST(contains(one_line(place == "out" ? text_ : run_.err), what) == (how == "has"),
                 text_ << run_.err);
      return;
    }
    BOOST_TEST_REQUIRE(run_.out.starts_with('{'), run_.err);
    const json found = at_place(run_.json(), place);
    BOOST_TEST(holds(found, place, how, what), line << ", is " << found.dump());
  }

 private:
  [[nodiscard]] bool holds(const json& found, const std::string& place, const std::string& how,
                           const std::string& what) const {
    if (how == "=") {
      return found == json::parse(what);
    }
    if (how == "has") {
      return found.is_string() && contains(found.get<std::string>(), what);
    }
    if (how == "size") {
      return found.size() == std::stoul(what);
    }
    if (how == "as" || how == "near") {
      static const std::regex form("(?:([0-9.e-]+)\\*)?(?:(\\S*): )?(.*)");
      std::smatch match;
      std::regex_match(what, match, form);
      const double times = match[1].matched ? std::stod(match[1]) : 1;
      const json other =
          at_place(report_of(filled(match[3])), match[2].matched ? match[2].str() : place);
      return how == "as"
                 ? without_wall_times(found) == without_wall_times(other)
                 : near(std::abs(found.get<double>()), std::abs(times * other.get<double>()), 1e-9);
    }
    const double number = number_of(what.substr(0, what.find(' ')));
    const std::size_t blank = what.find(' ');
    const double within = blank == std::string::npos ? 1e-12 : std::stod(what.substr(blank));
    return found.is_number() && (how == "~"   ? near(found, number, within)
                                 : how == "<" ? found.get<double>() < number
                                              : found.get<double>() > number);
  }

  [[nodiscard]] const json& report_of(const std::string& command) const {
    json& known = others_[command];
    if (known.is_null()) {
      known = sandbox_.run(Arguments(command.c_str()) + "--json", input_).json();
    }
    return known;
  }

  /// Of "0.9*design/f".
  [[nodiscard]] double number_of(const std::string& text) const {
    const std::size_t sign = text.find('*');
    return std::stod(text) * (sign == std::string::npos
                                  ? 1
                                  : at_place(run_.json(), text.substr(sign + 1)).get<double>());
  }

  [[nodiscard]] std::string filled(std::string command) const {
    static const std::regex blank("\\{([a-z][a-z0-9_/]*)\\}");
    for (std::smatch match; std::regex_search(command, match, blank);) {
      command.replace(static_cast<std::size_t>(match.position()),
                      static_cast<std::size_t>(match.length()),
                      at_place(run_.json(), match[1]).dump());
    }
    return command;
  }

  Sandbox sandbox_;
  Surroundings input_;
  Arguments arguments_;
  ProgramRun run_;
  mutable std::string text_;                    ///< of the same without --json
  mutable std::map<std::string, json> others_;  ///< by their commands
};

BOOST_AUTO_TEST_CASE(each_command_reports_what_is_told_of_it) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(STILLPOINT_COMMANDS "/reports")) {
    for (const Wrong& told : commands_in("reports/" + entry.path().filename().string())) {
      BOOST_TEST_CONTEXT(entry.path().filename() << ": " << told) {
        const Reported report(told);
        int code = 0;
        for (const std::string& line : told.says) {
          if (line.starts_with("exit ")) {
            code = std::stoi(line.substr(5));
          } else {
            report.check(line);
            ++count;
          }
        }
        report.check_exit(code);
      }
    }
  }
  BOOST_TEST(count > 250U);
}

BOOST_AUTO_TEST_SUITE_END()
