// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(matrix_test)

using namespace stillpoint::cli_test;

// docs/commands.md says what each load can be asked for: each cell of its table is run.

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream stream(row.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' ');
    cells.push_back(cell.substr(first, cell.find_last_not_of(' ') - first + 1));
  }
  return cells;
}

struct Matrix : Sandbox {
  Matrix() {
    write("a.txt", "0 0.3\n0.5 -0.2\n1 0.1\n1.5 0\n");
    write("parts.csv", "name,f,delta_m\nA,0.05,0.005\nB,0.1,0.002\n");
    write("cases.json", R"([{"name": "hit", "velocity": 0.1, "residual_m": 0.03},
                            {"name": "records", "record": "a.txt", "max_displacement": 0.12}])");
  }

  /// What asks for a load, without what the option itself gives.
  static Arguments load(std::size_t column, const std::string& option) {
    const bool given = contains(option, "-period ") && !contains(option, "--tolerance");
    const std::string period = given ? "" : " --period 2.8";
    const std::string stroke =
        option.starts_with("--max-displacement") || option.starts_with("spectrum")
            ? ""
            : " --max-displacement 100mm";
    const std::string text =
        column == 1 ? (option.starts_with("--velocity") ? "" : "--velocity 0.2") + stroke
        : column == 2
            ? "--pulse half-sine" + std::string(option.starts_with("--k") ? "" : " --k 0.1") +
                  (option.starts_with("--pulse-duration") ? "" : " --pulse-duration 0.4") + stroke
        : column == 3 ? "--record a.txt" + stroke
                      : std::string();
    return (text + period).c_str();
  }
};

BOOST_FIXTURE_TEST_CASE(each_cell_is_as_it_says, Matrix) {
  const std::string text = text_of(STILLPOINT_DATA_DIR "/../docs/commands.md");
  std::size_t rows = 0;
  std::istringstream lines(text.substr(text.find("| option | hit | pulse |")));
  for (std::string line; std::getline(lines, line) && line.starts_with('|');) {
    const std::vector<std::string> cells = cells_of(line);
    if (!cells[0].starts_with('`')) {
      continue;
    }
    ++rows;
    const std::string option = cells[0].substr(1, cells[0].size() - 2);
    const std::size_t own =
        option.starts_with("--") ? 0 : std::min(option.find(' '), option.size());
    const std::string command = own == 0 ? "design" : option.substr(0, own);
    const bool searches = command == "design";
    for (std::size_t column = 1; column < cells.size(); ++column) {
      BOOST_TEST_CONTEXT(option << ", column " << column) {
        Arguments all{command};
        std::ranges::move(load(column, option), std::back_inserter(all));
        std::ranges::move(Arguments(option.substr(own).c_str()), std::back_inserter(all));
        if (column == 4) {
          all.insert(all.end(), {"--cases", read("cases.json")});
          // What a case of its own would have instead.
          if (option.starts_with("--velocity") || option.starts_with("--k")) {
            const bool hit = option.starts_with("--velocity");
            all = {"design", "--period", "2.8", "--cases",
                   hit ? R"([{"name": "a", "velocity": [0.19, 0.2], "max_displacement": 0.1}])"
                       : R"([{"name": "a", "pulse": "half-sine", "k": [0.09, 0.1],
                              "pulse_duration": 0.4, "max_displacement": 0.1}])"};
          } else if (option.starts_with("--pulse-duration")) {
            all = {"design", "--period", "2.8", "--cases",
                   R"([{"name": "a", "pulse": "half-sine", "k": 0.1,
                        "pulse_duration": [0.38, 0.4], "max_displacement": 0.1}])"};
          }
        } else if (contains(option, "width-m") && cells[column] == "case") {
          all.insert(all.end(), {"--residual-m", "20mm"});
        }
        if (searches && (column > 2 || cells[column] == "case")) {
          all.insert(all.end(), {"--scan-points", "300"});
        }
        if (searches && cells[column] == "case" && !contains(option, "--objective")) {
          all.insert(all.end(), {"--objective", "amplitude"});  // robust takes longer
        }
        all.emplace_back("--json");
        const ProgramRun answer = run(all);
        if (cells[column].starts_with("no: ")) {
          BOOST_TEST(answer.exit_code == 2, answer.out << answer.err);
          const std::string why = cells[column].substr(4);
          BOOST_TEST((why.starts_with("no ") || contains(text, "- *" + why + "*: ")), why);
          continue;
        }
        BOOST_TEST((answer.exit_code == 0 || answer.exit_code == 3), answer.err);
        if (searches && option != "--catalogue parts.csv") {
          const bool searched = cells[column] == "case" || column > 2;
          BOOST_TEST((answer.json()["search"]["algorithm"] == "boxes") == searched);
        }
      }
    }
  }
  BOOST_TEST(rows > 30U);
}

BOOST_AUTO_TEST_SUITE_END()
