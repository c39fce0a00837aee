// SPDX-License-Identifier: MIT
// The text of a report: the answer first, short enough for a terminal, the rest on demand.
#include "cli_test.hpp"

#include <stillpoint/report/digits.hpp>

BOOST_AUTO_TEST_SUITE(answer_test)

namespace {

using namespace stillpoint::cli_test;

constexpr std::size_t columns = 80;
constexpr std::size_t lines_at_most = 32;
constexpr std::size_t lines_of_a_spectrum = 8;  ///< above that: a row for each period

}  // namespace

BOOST_FIXTURE_TEST_CASE(of_each_scene_fits_a_terminal, Sandbox) {
  for (const auto& entry : fs::directory_iterator(STILLPOINT_DATA_DIR "/scenes")) {
    if (entry.path().extension() != ".json") {
      continue;
    }
    const bool spectrum = entry.path().filename().string().starts_with("spectrum");
    const char* const command = spectrum ? "spectrum" : "design";
    const std::string text = run({command, entry.path().string()}).out;
    const auto lines = lines_of(text);
    BOOST_TEST(lines.size() <= lines_at_most + (spectrum ? lines_of_a_spectrum : 0), text);
    BOOST_TEST(lines.back() == "  --verbose shows more.");
    for (const std::string& line : lines) {
      BOOST_TEST(line.size() <= columns, line);
    }
    const std::string full = run({command, entry.path().string(), "--verbose"}).out;
    BOOST_TEST(lines_of(full).size() > lines.size());
    BOOST_TEST(!contains(full, "--verbose"));
    // If a scene is not for region or simulate, these print nothing.
    const std::string region = run({"region", entry.path().string(), "--verbose"}).out;
    const std::string motion = run({"simulate", entry.path().string(), "--verbose", "--f", "0.02",
                                    contains(full, " mm") ? "--delta-m" : "--delta", "0.001"})
                                   .out;
    for (const std::string& text_of_all : {full, region, motion}) {
      for (const std::string& line : lines_of(text_of_all)) {
        BOOST_TEST(line.size() <= columns, entry.path() << ": " << line);
      }
    }
  }
}

BOOST_FIXTURE_TEST_CASE(of_a_design_says_what_to_build_what_it_does_and_how_far_to_trust_it,
                        Sandbox) {
  const std::string text = run({"design", STILLPOINT_DATA_DIR "/scenes/isolator.json"}).out;
  const auto lines = lines_of(text);
  BOOST_TEST(lines.at(1).starts_with("  Build a friction force of 283.81 kN and a notch"), text);
  check_contains(
      text, {"137.37 mm, 91.58 % of the 150 mm", "at x = 0 after 1.5287 s", "0.09465 g outside",
             "at most 0.325 g inside one", "+-34.18 %", "hits of 0.341 to 0.429 m/s", "agree: "});
}

/// 6.87 mm is the peak: a notch of 20 mm would be wider than the motion.
BOOST_FIXTURE_TEST_CASE(of_a_small_motion_names_a_notch_within_it, Sandbox) {
  write("machine.json", run("init machine").out);
  const std::string text = run("design machine.json").out;
  // f + delta/w = 0.183906 + 2.3442, and the spring at 0.5 mm 64e6/80e3 0.0005/9.80665 = 0.0408
  BOOST_TEST(contains(one_line(text), "2.57 g inside one 1 mm wide"), text);
}

BOOST_FIXTURE_TEST_CASE(of_a_design_within_an_acceleration_names_the_least_notch, Sandbox) {
  const Arguments asked{"design", STILLPOINT_DATA_DIR "/scenes/isolator.json", "--acceleration-max",
                        "0.12"};
  const std::string text = run(asked).out;
  BOOST_TEST(contains(text, "0.12 g inside one"), text);
  // p^2 (delta - w^2) = 0.00145609: delta / (sqrt(0.12^2 + that) - f) = 0.325088 times
  // H = 178.2535 mm
  BOOST_TEST(contains(one_line(text), "57.949 mm wide"), text);
}

/// The hits of the range that the paper's notch holds are in it as well.
BOOST_FIXTURE_TEST_CASE(of_ranges_names_the_notch_within_an_acceleration, Sandbox) {
  const Arguments asked(
      "design --velocity 0:0.4 --period 2.8 --max-displacement 150mm --acceleration-max 0.2");
  const std::string text = one_line(run(asked).out);
  std::smatch found;
  BOOST_TEST_REQUIRE(
      std::regex_search(text, found, std::regex("; 0.2 g inside one ([.0-9]+) mm wide ")), text);
  const double width = std::stod(found[1]);
  const auto felt = [&](double wide) {
    return reported(asked +
                    Arguments{"--notch-width-m",
                              in_full(wide) + "mm"})["built_notch"]["largest_acceleration"]
                                                    ["response"]["peak_absolute_acceleration"]
                                                        .get<double>();
  };
  BOOST_TEST(felt(width) <= 0.2);
  BOOST_TEST(felt(0.999 * width) > 0.2);
  BOOST_TEST(near(reported(asked)["physical"]["notch_width_min_m"], 1e-3 * width, 1e-4));
  BOOST_TEST(contains(one_line(run({"design", STILLPOINT_DATA_DIR "/scenes/isolator.json",
                                    "--acceleration-max", "0.2"})
                                   .out),
                      "; 0.2 g inside one 32.868 mm wide "));
}

BOOST_FIXTURE_TEST_CASE(of_a_comparison_gives_the_error_of_the_kernel, Sandbox) {
  const std::string text = run("accuracy --v0 1 --p 1 --f 0.26 --delta 0.37").out;
  BOOST_TEST(lines_of(text).at(1).starts_with("  simulate is off by "), text);
}

BOOST_FIXTURE_TEST_CASE(of_a_sweep_says_how_many_end_well, Sandbox) {
  const Arguments motions("sweep --v0 1 --p 1 --f 0.26 --output rows.csv");
  BOOST_TEST(lines_of(run(motions + "--delta 0,0.37").out).at(1) ==
             "  1 of 2 motions stop at x = 0, 1 off centre.");
  BOOST_TEST(lines_of(run(motions + "--delta 0.37,0.6").out).at(1) ==
             "  1 of 2 motions stop at x = 0, 1 never starts.");
  BOOST_TEST(lines_of(run(motions + "--delta 0.37,0.38").out).at(1) ==
             "  All 2 motions stop at x = 0.");
  const auto designs = [&](const char* beta) {
    return lines_of(run(Arguments("sweep --v0 1 --p 1 --reduce --beta") + beta).out).at(1);
  };
  BOOST_TEST(designs("0.5,0.9") == "  1 of 2 entries have an admissible design.");
  BOOST_TEST(designs("0.8,0.9") == "  All 2 entries have an admissible design.");
  // f above 1/sqrt(8) = 0.354: none returns.
  BOOST_TEST(
      lines_of(run("sweep --v0 1 --p 1 --f 0.4 --delta 0,0.1 --output rows.csv").out).at(1) ==
      "  All 2 motions stop off centre.");
}

/// One stops at x = 0, where the notch then holds it against the load; friction holds the other.
BOOST_FIXTURE_TEST_CASE(of_a_sweep_counts_a_lock_once, Sandbox) {
  const Arguments loaded(
      "sweep --v0 1 --p 1 --f 0.3 --excitation harmonic --k 0.01 --lambda 1 --duration 20 "
      "--reduce");
  const auto says = [&](const char* delta) {
    return one_line(run(loaded + "--delta" + delta).out);
  };
  check_contains(says("0,0.4"),
                 {" Locked: in 1 of 2 motions the notch holds the mass to the end of the load. Of "
                  "the rest, 0 stop at x = 0, 1 off centre. "});
  check_contains(says("0.4,0.41"),
                 {" Locked: in all 2 motions the notch holds the mass to the end of the load. "});
  const json counts = run(loaded + "--delta 0,0.4 --json").json();
  BOOST_TEST(counts["outcomes"]["stopped_at_zero"] == 1);
  BOOST_TEST(counts["locked_outcomes"]["stopped_at_zero"] == 1);
  BOOST_TEST(counts["locked_outcomes"]["stopped_in_dead_zone"] == 0);
}

BOOST_FIXTURE_TEST_CASE(of_a_damper_that_locks_begins_with_that, Sandbox) {
  const ProgramRun answer =
      run("simulate --v0 1 --p 1 --f 0.3 --delta 0.4 --excitation harmonic --k 0.05 --lambda 3 "
          "--t-end 20");
  BOOST_TEST(lines_of(answer.out).at(1).starts_with("  It locks at x = 0 after "), answer.out);
}

/// A notch with a width holds it where it stopped, not at x = 0.
BOOST_FIXTURE_TEST_CASE(of_a_damper_that_locks_in_a_wide_notch_says_where, Sandbox) {
  const Arguments locked(
      "simulate --v0 1 --p 1 --f 0.26 --delta 0.37 --notch-width 0.1 --excitation harmonic --k "
      "0.01 --lambda 1 --t-end 20");
  const ProgramRun answer = run(locked);
  const json response = run(locked + "--json").json()["response"];
  BOOST_TEST_REQUIRE(response["stop_position"] != 0);
  BOOST_TEST(lines_of(answer.out).at(1).starts_with("  It locks at x = 0.0"), answer.out);
  check_contains(one_line(answer.out), {" caution The notch locks the mass at x = 0.0"});
}

BOOST_FIXTURE_TEST_CASE(of_a_damper_that_is_locked_throughout_says_so, Sandbox) {
  const Arguments locked(
      "simulate --v0 0.01 --p 1 --f 0.01 --delta 0.1 --hold 0.1 --excitation rectangle --k 0.11 "
      "--lambda 1");  // just as much as the notch holds
  const ProgramRun answer = run(locked);
  check_contains(one_line(answer.out),
                 {" It is locked throughout the load. caution The notch locks the mass at x = 0 "
                  "throughout the load; the structure then feels up to 0.11 g. ",
                  " At the notch the velocity jumps by up to 0.01; "});
  BOOST_TEST(run(locked + "--json").json()["response"]["locked_from"] == 0);
  // A run that is cut, where the load is 0.2 sin 0.2 = 0.0397.
  check_contains(one_line(run("simulate --v0 0.5 --p 1 --f 0.05 --delta 0.2 --hold 0.1 "
                              "--excitation harmonic --k 0.2 --lambda 0.01 --t-end 20")
                              .out),
                 {" at x = 0 throughout the load; the structure then feels up to 0.03973 g. ",
                  " At the notch the velocity jumps by up to 0.5; "});
}

/// In the first lines and as a warning, like one that locks.
BOOST_FIXTURE_TEST_CASE(of_a_hit_that_the_notch_holds_begins_with_that, Sandbox) {
  const Arguments held("simulate --v0 0.1 --p 1 --f 0.1 --delta 0.1");
  const ProgramRun answer = run(held);
  BOOST_TEST(lines_of(answer.out).at(1).starts_with("  It never starts: "), answer.out);
  // The hit is felt as an impulse.
  const std::string words =
      "caution: The notch catches the hit, as any below 0.4472: the structure feels it in full, "
      "0.1 "
      "times the mass.";
  BOOST_TEST(run(held + "--json").err == "stillpoint: " + words + "\n");
  BOOST_TEST(run(held + "--json --quiet").err.empty());
  check_contains(one_line(answer.out), {words.substr(words.find("The"))});
  BOOST_TEST(!contains(answer.out, "transmitted"), answer.out);
}

BOOST_FIXTURE_TEST_CASE(of_a_load_below_friction_says_that_nothing_moves, Sandbox) {
  const ProgramRun answer =
      run("simulate --p 1 --f 0.5 --delta 0.1 --excitation harmonic --k 0.2 --lambda 1 --t-end 20 "
          "--html page.html");
  const std::string words =
      "The mass never moves: friction holds it throughout the load, and the structure feels up to "
      "0.2 g.";
  check_contains(one_line(answer.out), {" It never moves. ", words});
  BOOST_TEST(contains(read("page.html"), ">The mass never moves: "));
}

/// Friction at rest is p^2 x0 = 0.04 of f = 0.05; in the notch, at its very edge, 0.05 of 0.12.
BOOST_FIXTURE_TEST_CASE(of_a_start_where_friction_holds_it_says_that_it_never_moves, Sandbox) {
  const auto answer = [&](const char* more) {
    return run(Arguments("simulate --v0 0 --p 1 --delta 0.01 --html page.html") + more);
  };
  const ProgramRun held = answer("--x0 0.04 --f 0.05");
  const std::string& off_centre = held.out;
  check_contains(off_centre, {"  The mass never moves: friction holds it at x = 0.04.\n"});
  BOOST_TEST(!contains(off_centre, "peak"), off_centre);  // nor an acceleration
  BOOST_TEST(!contains(off_centre, "acceleration"), off_centre);
  check_contains(answer("--x0 0.05 --f 0.02 --notch-width 0.1").out,
                 {"  The mass never moves: the notch holds it at x = 0.05.\n"});
  BOOST_TEST(contains(read("page.html"), "Nothing moves, so there is nothing to draw."));
}

/// Neither a peak of 0 nor an acceleration of 0 g: the structure feels an impulse, or nothing.
BOOST_FIXTURE_TEST_CASE(of_a_mass_that_never_moves_gives_no_figures_of_a_motion, Sandbox) {
  const Arguments simulate("simulate --p 1 --verbose");
  for (const char* const still :
       {"--v0 0.1 --f 0.1 --delta 0.1", "--v0 0 --x0 0.04 --f 0.05 --delta 0",
        "--f 0.5 --delta 0 --excitation harmonic --k 0.2 --lambda 1 --t-end 20"}) {
    const std::string text = run(simulate + still).out;
    for (const char* const absent : {"peak", "stop time", "stop position", "half cycles", " 0 g"}) {
      BOOST_TEST(!contains(text, absent), absent << " in " << text);
    }
  }
}

/// In resonance |x| grows by pi k/2 - 2 f a half-cycle; beyond the beginning of another one it does
/// not change.
BOOST_FIXTURE_TEST_CASE(of_a_harmonic_says_how_it_swings, Sandbox) {
  const auto answer = [&](const char* more) {
    const Arguments simulate("simulate --v0 0 --p 1 --excitation harmonic --k 0.1");
    return one_line(run(simulate + more).out);
  };
  const std::string grows = answer("--f 0.05 --delta 0 --lambda 1 --t-end 100");
  check_contains(
      grows, {"It is still moving at the end of the run. ", " note The peaks grow, the last to "});
  check_contains(answer("--f 0.02 --delta 0 --lambda 0.7 --t-end 300"),
                 {" note The peaks settle at "});
  check_contains(answer("--f 0 --delta 0 --lambda 0.9 --t-end 200"),
                 {" The last peaks lie between "});
  check_contains(answer("--f 0.09 --delta 0 --lambda 1 --t-end 100"),
                 {"at rest at the end of the run. ", " The peaks settle at "});
  for (const char* const other :
       {"--f 0.02 --delta 0 --lambda 0.7 --t-end 20",  // too few
        "--f 0.02 --delta 0 --lambda 0.7 --t-end 300 --max-half-cycles 20"}) {
    BOOST_TEST(!contains(answer(other), " peaks "), other);
  }
}

/// Where it ends, the first lines say; the impulse of each stays in the table.
BOOST_FIXTURE_TEST_CASE(of_a_motion_keeps_its_half_cycles_in_one_table, Sandbox) {
  const std::string text = run("simulate --v0 0 --x0 -0.5 --p 1 --f 0.05 --delta 0.01").out;
  const auto lines = lines_of(text);
  const auto heads = std::ranges::find_if(
      lines, [](const std::string& line) { return contains(line, "impulse/mass"); });
  BOOST_TEST_REQUIRE((heads != lines.end()));
  BOOST_TEST(heads->starts_with("      starts"), text);
  BOOST_TEST(contains(text, " none\n"), text);
}

BOOST_FIXTURE_TEST_CASE(of_a_motion_says_how_close_it_is_to_another_outcome, Sandbox) {
  const Arguments near("simulate --v0 1 --p 1 --f 0 --delta 0.4999");
  BOOST_TEST(contains(run(near).out, "If all inputs shift by 0.0067 %, "));
  const Arguments far("simulate --v0 1 --p 1 --f 0.26 --delta 0.37");
  BOOST_TEST(!contains(run(far).out, "could change"));
  BOOST_TEST(contains(one_line(run(far + "--verbose").out), " decision margin 0.09"));
  // Under a load the margin is no tolerance: only one that rounding could use up is worth a note.
  const Arguments shaken(
      "simulate --v0 0.5 --p 1 --f 0.18 --delta 0 --excitation harmonic --k 0.2 "
      "--lambda 0.35 --t-end 200");
  BOOST_TEST(run(shaken + "--json").json()["response"]["decision_margin"] < 0.01);
  BOOST_TEST(!contains(run(shaken).out, "could change"));
}

BOOST_FIXTURE_TEST_CASE(of_a_point_says_what_it_violates, Sandbox) {
  const std::string text = run("region --v0 1 --p 1 --beta 0.9 --f 0.5 --delta 0.6").out;
  check_contains(
      one_line(text),
      {" The damper is not admissible: it is held by the notch: delta is 20 % too large. ",
       " stop - - not reached "});
  check_contains(one_line(run("region --v0 1 --p 1 --beta 0.9 --f 0.3 --delta 1e-6").out),
                 {": it passes x = 0: delta is far too small."});
  BOOST_TEST(contains(text, "violated"));
}

using stillpoint::report::limit_digits;

/// Delta1 = (S - 2f)^2/2 = 0.0986, Delta2 = 1/2; and f3 = 0.354.
BOOST_FIXTURE_TEST_CASE(of_an_f_alone_says_which_delta_goes_with_it, Sandbox) {
  const Arguments region("region --v0 1 --p 1 --beta 0.9");
  const auto answer = [&](const char* more) { return lines_of(run(region + more).out).at(1); };
  const double radius = std::hypot(1, 0.3);
  BOOST_TEST(answer("--f 0.3").starts_with(
      "  At f = 0.3, delta of " + limit_digits((radius - 0.6) * (radius - 0.6) / 2, true, 6) +
      " to 0.5 is admissible."));
  BOOST_TEST(answer("--f 0.4").starts_with("  At f = 0.4 no delta is admissible. "));
  // Without f it comes back with v0, and delta > 1/2 is caught at the start.
  BOOST_TEST(answer("--f 0").starts_with("  At f = 0 no delta is admissible. "));
  BOOST_TEST(answer("--f 0.2 --delta-max 0.15").starts_with("  At f = 0.2 no delta"));
  const double worst = std::hypot(1, 0.27);  // of the box
  BOOST_TEST(answer("--f 0.3 --tolerance 0.1")
                 .starts_with("  At f = 0.3, delta of " +
                              limit_digits((worst - 0.54) * (worst - 0.54) / 2 / 0.9, true, 6) +
                              " to 0.454545 keeps the tolerance"));
}

/// With hardly any friction only Delta = 1/2 stops it: an f in the middle says more. By the exact
/// criterion the arrival speed v is the limit; the second arrival comes if v^2 - 2 Delta >= 8 f^2.
BOOST_FIXTURE_TEST_CASE(of_a_region_says_which_delta_goes_with_some_f, Sandbox) {
  const auto answer = [&](const char* more) {
    const std::string all = run(Arguments("region --v0 1 --p 1 --criterion exact ") + more).out;
    return all.substr(0, all.find("\n\n"));
  };
  const auto half_square = [](double f) {
    const double radius = std::hypot(1, f) - 2 * f;
    return (radius - f) * (radius + f) / 2;
  };
  const std::string one = answer("--beta 2");
  BOOST_TEST(contains(one, "Feasible f: up to 0.353553. At f = 0.176776, delta of " +
                               limit_digits(half_square(0.176776), true, 6)),
             one);
  const std::string two = answer("--beta 2 --arrivals 2 --f 0.1");
  BOOST_TEST(contains(two, " to " + limit_digits(half_square(0.1) - 0.04, false, 6)), two);
  BOOST_TEST(contains(two, " or " + limit_digits(half_square(0.1), true, 6) + " to 0.5"), two);
  const std::string many = answer("--beta 2 --arrivals 9 --f 0.01");
  BOOST_TEST(contains(many, "or in 6 lower ranges is admissible."), many);
  const std::string four = answer("--beta 2 --arrivals 4 --f 0.01");
  BOOST_TEST(contains(four, "or in a lower range is admissible."), four);
}

BOOST_FIXTURE_TEST_CASE(of_a_design_says_what_delta_and_its_tolerance_are, Sandbox) {
  const Arguments design("design --velocity 0.4 --period 2.8 --max-displacement 150mm");
  BOOST_TEST(has_finding(reported("design --velocity 1.2 --period 0.1 --max-displacement 15mm"),
                         "friction_above_weight"));
  const Arguments point(
      "region --velocity 1.2 --period 0.1 --max-displacement 15mm --delta-m 10mm");
  BOOST_TEST(has_finding(reported(point + "--f 2"), "friction_above_weight"));
  BOOST_TEST(!has_finding(reported(point + "--f 1"), "friction_above_weight"));
  // The largest tolerance of delta alone is that at f3, beyond which nothing returns.
  check_contains(one_line(run(design + "--tolerance-delta 0.2").out),
                 {"+-77.77 % of delta, with f exactly as given ",
                  " caution Too exact to be built: f is on the edge of the region. "});
  check_contains(one_line(run(design + "--tolerance-f 0.2").out),
                 {"+-34.18 % of f, with delta exactly as given "});
  // Stiffer springs bring it back.
  BOOST_TEST(
      !has_finding(reported("design --v0 1 --p 1:2.5 --beta 0.9 --residual 0.5"), "notch_unused"));
  // Any rest is, so that only the dead zone bounds f.
  check_contains(one_line(run("region --v0 1 --p 1 --beta 0.9 --residual 0.9 --f 0.8 --delta 0.2 "
                              "--verbose")
                              .out),
                 {" dead zone f < 0.9 0.1 met", " residual any f - met"});
  // A rest at the first peak is within the residual.
  BOOST_TEST(has_finding(reported("design --velocity 0.4 --period 2.8 --max-displacement 190mm "
                                  "--residual-m 120mm --tolerance 0.2"),
                         "notch_unused"));
}

BOOST_FIXTURE_TEST_CASE(of_a_damper_on_an_edge_is_true_and_reads_well, Sandbox) {
  const auto answer = [&](const char* more) {
    return one_line(run(Arguments("region") + more).out);
  };
  check_contains(answer("--v0 1 --p 1 --beta 0.8 --f 0.3 --delta 0.5"),
                 {"The damper is admissible: f or delta must be exact: "});
  // Without friction the mass comes back with all of V0^2/2 = 0.5.
  check_contains(answer("--v0 1 --p 1 --beta 0.8 --f 0 --delta 0.5"),
                 {" delta needed ", " stop delta > 0.5 0 violated "});
  // A single f is left.
  const std::string single = answer("--v0 1 --p 1 --beta 0.7071067811865476");
  BOOST_TEST(contains(single, "Feasible f: 0.35355339"), single);
  BOOST_TEST(!contains(single, "0.353554"), single);
  check_contains(answer("--v0 1 --p 1 --beta 0.70710679 --f 0.3535533 --delta 0.2"),
                 {"peak 0.70710684, 100 % of the 0.70710679 allowed ", " f >= 0.35355338 -7.7",
                  " f <= 0.35355339 "});
}

/// The largest f of the task is in its bounds; no delta and no hit helps beyond it.
BOOST_FIXTURE_TEST_CASE(of_too_large_an_f_with_a_residual_names_f, Sandbox) {
  const std::string scene = STILLPOINT_DATA_DIR "/scenes/residual.json";
  check_contains(one_line(run({"region", scene, "--f", "0.2", "--delta-m", "5mm"}).out),
                 {"it rests too far off: f is 5.83 times the limit.", "residual f <= 0.0342924 -"});
  check_contains(
      one_line(run("region --v0 1 --p 1 --beta 0.9 --residual 0.05 --f 0.4 --delta 0.3").out),
      {"it rests too far off: f is 7.5 % too large.", "residual f <= 0.372358 -",
       "stop - - not reached"});
  check_contains(
      one_line(run("region --v0 0:1 --p 1 --beta 2 --residual 0.05 --f 0.5 --delta 0.9").out),
      {" The notch catches all hits of the range, which the structure feels in full: up to 1 times "
       "the mass. "});
}

/// After the strongest hit it rests at -7.8 mm, after 0.44 m/s at 41.8 mm.
BOOST_FIXTURE_TEST_CASE(a_rest_within_a_residual_is_told_for_every_hit_of_a_range, Sandbox) {
  const Arguments task("--velocity 0.2:0.5 --period 2.8 --max-displacement 200mm");
  const auto told = [&](const char* command) {
    return one_line(run(Arguments(command) + task).out);
  };
  check_contains(
      told("design --residual-m 50mm --arrivals 2"),
      {" rest at x = -7.7572 mm after ", " (strongest hit); within 50 mm after any other "});
  BOOST_TEST(!contains(told("region --residual-m 50mm --f 0.02 --delta-m 1mm"), "any other"));
  BOOST_TEST(!contains(told("region --f 0.03 --delta-m 1mm"), "any other"));
}

BOOST_AUTO_TEST_SUITE_END()
