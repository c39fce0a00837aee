// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include "browser.hpp"
#include "sweep_table.hpp"

#include <array>
#include <cmath>
#include <sstream>

namespace stillpoint::browser_test {

namespace {

using cli_test::Arguments;
using nlohmann::json;

struct Wanted {
  const char* name;
  Arguments arguments;
  int exit_code;
};

std::vector<Wanted> wanted() {
  const std::string data = STILLPOINT_DATA_DIR;
  const std::string deep = data + "/records/../records/../records/../records/";  // a long path
  const std::string pulse = data + "/records/near_fault_pulse.txt";
  return {
      {"design", {"design", data + "/scenes/isolator.json"}, 0},
      {"infeasible", {"design", data + "/scenes/infeasible.json"}, 3},
      {"arrivals", "design --v0 1 --p 1 --beta 1 --arrivals 20", 0},
      {"free", "simulate --v0 1 --p 1 --f 0.02 --delta 0.02", 0},
      {"forced", "simulate --period 2.8 --f 0.02 --delta-m 0.001" + Arguments{"--record", pulse},
       0},
      {"spectrum",
       {"spectrum", data + "/scenes/spectrum.json", "--record", pulse, "--record",
        data + "/records/strong_motion.AT2"},
       0},
      {"region", "region --v0 1 --p 1 --beta 0.9 --f 0.26 --delta 0.37", 0},
      {"pulse", {"design", data + "/scenes/pulse.json", "--notch-width-m", "0.03"}, 0},
      {"sweep", "sweep --v0 1 --p 1 --f 0.001:0.35:40:log --delta 0:0.5:30 --output map.csv", 0},
      {"trade_off", {"design", data + "/scenes/trade_off.json"}, 0},
      {"varying", {"design", data + "/scenes/residual.json"}, 0},
      {"records",
       "design --period 2.8 --max-displacement 0.4 --notch-width-m 0.1 --scan-points 400" +
           Arguments{"--record", deep + "near_fault_pulse.txt", "--record",
                     deep + "strong_motion.AT2"},
       0},
  };
}

struct Look {
  const char* name;
  int width;
};
constexpr std::array looks{Look{"1280", 1280}, Look{"400", 400}, Look{"print", 700}};
constexpr int height = 9000;  // the whole page is in the window

/// A page with all pages in frames, which can have any width; windows are wider than 500 pixels.
std::string page_of_frames(const Pages& made) {
  json points = json::object();
  std::ostringstream frames;
  for (const auto& [name, report] : made.reports) {
    points[name] = points_of_interest(name);
    for (const Look& look : looks) {
      frames << "<iframe src=\"probed_" << name << ".html\" name=\"" << name << ' ' << look.name
             << "\" width=\"" << look.width << "\" height=\"" << height
             << "\" style=\"border:0\"></iframe>\n";
    }
  }
  return "<!DOCTYPE html>\n<meta charset=\"utf-8\"/>\n<script>\n'use strict';\nconst points = " +
         points.dump() + R"(, seen = {};
function asked(page, figure) { return points[page][figure] || []; }
function tell(page, look, facts) { (seen[page] ||= {})[look] = facts; }
addEventListener('load', () => {
  document.getElementById('seen').textContent = JSON.stringify(seen).replaceAll('<', '\\u003c');
});
</script>
<script type="application/json" id="seen"></script>
)" + frames.str();
}

/// What the page of frames wrote into itself.
json facts(const std::string& dump) {
  const std::string before = R"(<script type="application/json" id="seen">)";
  const std::size_t begin = dump.find(before);
  BOOST_TEST_REQUIRE(begin != std::string::npos);
  const std::size_t end = dump.find("</script>", begin);
  return json::parse(dump.substr(begin + before.size(), end - begin - before.size()));
}

json look_at_all(Scheme scheme) {
  const cli_test::Sandbox& sandbox = pages().sandbox;
  for (const auto& [name, report] : pages().reports) {
    std::string page = sandbox.read(name + ".html");
    const std::string head = "<head>\n";
    page.insert(page.find(head) + head.size(),
                "<script>" + cli_test::text_of(STILLPOINT_PROBE) + "</script>\n");
    sandbox.write("probed_" + name + ".html", page);
  }
  sandbox.write("frames.html", page_of_frames(pages()));
  Arguments options{"--dump-dom", "--allow-file-access-from-files"};  // frames are files
  if (scheme == Scheme::dark) {
    options.emplace_back("--blink-settings=preferredColorScheme=0");
  }
  const Visit visited = visit(sandbox, "frames.html", options);
  BOOST_TEST_REQUIRE(visited.exit_code == 0);
  BOOST_TEST(visited.console.empty(), visited.console);
  json all = facts(visited.out);
  BOOST_TEST_REQUIRE(all.size() == pages().reports.size());
  return all;
}

}  // namespace

Pages::Pages() {
  for (const Wanted& page : wanted()) {
    const auto run = sandbox.run(page.arguments +
                                 Arguments{"--json", "--html", std::string(page.name) + ".html"});
    BOOST_TEST_REQUIRE(run.exit_code == page.exit_code, run.err);
    reports[page.name] = run.json();
  }
}

const Pages& pages() {
  static const Pages made;
  return made;
}

const json& seen(Scheme scheme) {
  static const json light = look_at_all(Scheme::light);
  if (scheme == Scheme::light) {
    return light;
  }
  static const json dark = look_at_all(Scheme::dark);
  return dark;
}

double millimetres(const json& report) {
  return 1e3 * report["physical"]["length_unit_m"].get<double>();
}

std::vector<MapRow> map_rows() {
  constexpr std::size_t every = 37;  // all columns and rows are visited
  const auto table = cli_test::read_csv(pages().sandbox.read("map.csv"));
  std::vector<MapRow> rows;
  for (std::size_t i = 0; i < table.rows.size(); i += every) {
    rows.push_back({table.number(i, "f"), table.number(i, "delta"), table.number(i, "half_cycles"),
                    table.at(i, "outcome")});
  }
  return rows;
}

json points_of_interest(const std::string& page) {
  if (page == "design") {
    const json& report = pages().reports.at(page);
    const double unit = millimetres(report);
    json points = json::array();
    for (const char* bound : {"delta1_published", "delta1_exact"}) {
      points.push_back({report["design"]["f"], report[bound].get<double>() * unit});
    }
    return {{"region", points}};
  }
  if (page == "free") {
    // The first arc from (0, 1): x = sin t - f (1 - cos t), x' its derivative.
    constexpr double f = 0.02;
    constexpr double t = 0.7;
    const double x = std::sin(t) - f * (1 - std::cos(t));
    const double v = std::cos(t) - f * std::sin(t);
    return {{"motion", {{t, x}}}, {"phase", {{x, v}}}, {"energy", {{t, (x * x + v * v) / 2}}}};
  }
  if (page == "sweep") {
    json points = json::array();
    for (const MapRow& row : map_rows()) {
      points.push_back({row.f, row.delta});
    }
    return {{"map", points}};
  }
  return json::object();
}

}  // namespace stillpoint::browser_test
