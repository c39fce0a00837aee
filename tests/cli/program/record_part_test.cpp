// SPDX-License-Identifier: MIT
// Designs under records in parts, and the parts joined again.
#include "cli_test.hpp"
#include "parts.hpp"

#include <fmt/format.h>

BOOST_AUTO_TEST_SUITE(record_part_test)

namespace {

using namespace stillpoint::cli_test;

/// One variable, so that the searches take a moment. With little friction nothing settles.
const Arguments task(
    "design --record a.txt --record b.txt --period 2.8s --hold 0.05g --search-f 0:0.2 --residual-m "
    "20mm --search-delta-m 0:0 --scan-points 61");

/// The report less the times of the wall clock, as its text: the numbers to the last bit.
std::string timeless(const std::string& text) {
  json report = json::parse(text);
  BOOST_TEST(report.at("search").erase("wall_time_s") == 1U);
  if (!report.at("cross_check").is_null()) {
    BOOST_TEST(report.at("cross_check").at("methods").at(0).erase("wall_time_s") == 1U);
  }
  return report.dump();
}

}  // namespace

struct RecordParts : Parts {
  RecordParts() : Parts("design", "json") {
    write("a.txt", "0 0\n0.3 0.25\n0.8 -0.2\n1.4 0.1\n2 0\n");
    write("b.txt", "0 0\n0.2 -0.15\n0.9 0.3\n1.1 -0.1\n1.5 0\n");
  }

  void check_merged_design(const Arguments& design, int exit_code,
                           const std::vector<int>& counts) const {
    const ProgramRun whole = run(design + "--output whole");
    BOOST_TEST_REQUIRE(whole.exit_code == exit_code, whole.err);
    for (const int n : counts) {
      BOOST_TEST_CONTEXT(n << " parts") {
        const ProgramRun answer = merge(split(design, n));
        BOOST_TEST(answer.exit_code == exit_code, answer.err);
        BOOST_TEST(timeless(read("merged")) == timeless(read("whole")));
      }
    }
  }
};

BOOST_FIXTURE_TEST_SUITE(parts, RecordParts)

BOOST_AUTO_TEST_CASE(merge_to_the_design_of_one_run) {
  check_merged_design(task, 0, {1, 2, 7});
}

/// What the limits would have to be is searched for from the same scan.
BOOST_AUTO_TEST_CASE(merge_to_no_design) {
  check_merged_design(task + "--max-displacement 1mm", 3, {3});
}

BOOST_AUTO_TEST_CASE(say_what_they_are) {
  const ProgramRun printed = run(task + "--part 2/4");
  const json found = printed.json();
  BOOST_TEST(found.at("schema") == "stillpoint/record-scan/1");
  BOOST_TEST(found.at("dampers") == 61);
  BOOST_TEST(found.at("figures").at("residual").size() == 15U);  // 16 + 15 + 15 + 15
  const ProgramRun answer = part(task, 2, 4);
  BOOST_TEST(answer.out == "2-of-4.json: 15 of 61 dampers\n");
  BOOST_TEST(read("2-of-4.json") == printed.out);
  BOOST_TEST(part(task, 70, 70).out == "70-of-70.json: 0 of 61 dampers\n");
}

BOOST_AUTO_TEST_CASE(are_shown_like_a_single_run) {
  const Arguments names = split(task, 2);
  const ProgramRun answer = merge(names, {"--json", "--html", "page.html", "--threads", "1"});
  BOOST_TEST_REQUIRE(answer.exit_code == 0, answer.err);
  BOOST_TEST(answer.out == read("merged"));
  BOOST_TEST(read("page.html").find("<svg") != std::string::npos);
  check_refused(names, {"no scene", "html"}, {"--hold", "0.1g"});
  check_refused(names, {"no scene", "html"}, {"--part", "1/2"});
}

BOOST_AUTO_TEST_CASE(that_are_complete_are_not_computed_again) {
  static_cast<void>(split(task, 2));
  const auto written = fs::last_write_time(path("1-of-2.json"));
  BOOST_TEST(part(task, 1, 2, {"--resume"}).out == "1-of-2.json: 31 of 61 dampers\n");
  BOOST_TEST((fs::last_write_time(path("1-of-2.json")) == written));
  const auto before = contents();
  check_refusal(run(task + "--part 2/2 --output 1-of-2.json"), {"1-of-2.json", "1/2", "{part}"});
  BOOST_TEST(contents() == before);
  write("1-of-2.json", read("1-of-2.json").substr(0, 100));
  BOOST_TEST(part(task, 1, 2, {"--resume"}).exit_code == 0);
  BOOST_TEST(contents() == before);
}

BOOST_AUTO_TEST_CASE(that_are_missing_repeated_or_truncated_are_refused) {
  const Arguments names = split(task, 3);  // the third comes first
  check_refused({names[0], names[2]}, {"2/3", "is missing"});
  check_refused(names + Arguments{names[1]}, {names[1], "is part 2/3", "and so is"});
  check_refused({}, {"PART"});
  check_refused(names + "none", {"none", "No such file"});
  const std::string whole = read(names[1]);
  const std::size_t step = whole.size() / 23;
  for (std::size_t size = 0; size < whole.size() - 1; size += step) {
    write(names[1], whole.substr(0, size));
    check_refused(names, {names[1], "not a complete part"});
  }
  for (std::size_t place = 0; place < whole.size() - 1; place += step) {
    std::string changed = whole;
    changed[place] = static_cast<char>(changed[place] ^ 1);
    write(names[1], changed);
    check_refused(names, {names[1], "not a complete part"});
  }
}

BOOST_AUTO_TEST_CASE(of_other_tasks_are_refused) {
  const Arguments names = split(task, 2);
  const auto check_foreign = [&](const Arguments& more, Texts says) {
    static_cast<void>(run(task + "--part 2/2 --output foreign" + more));
    says.insert(says.end(), {"foreign", names[1]});
    check_refused({names[1], "foreign"}, says);
    fs::remove(path("foreign"));
  };
  check_foreign({"--max-displacement", "1"}, {"belongs to a different design", "max-displacement"});
  check_foreign({"--objective", "residual"}, {"belongs to a different design", "objective"});
  static_cast<void>(run(task + "--part 3/3 --output foreign"));
  check_refused({names[1], "foreign"}, {"foreign", "3/3", names[1], "1/2"});
  static_cast<void>(
      run("sweep --v0 1 --p 1 --f 0.1,0.2 --delta 0 --reduce --part 2/2 --output foreign"));
  check_refused({names[1], "foreign"}, {"foreign", "not a complete part of a design"});
  check_refusal(run({"sweep", "merge", "merged", names[0], names[1]}),
                {names[0], "not a complete part"});
}

/// Each part has seen them, and so does the search.
BOOST_AUTO_TEST_CASE(of_records_that_have_changed_are_refused) {
  Arguments names = split(task, 2);
  write("b.txt", "0 0\n0.2 -0.15\n0.9 0.31\n1.1 -0.1\n1.5 0\n");
  check_refused(names, {names[0], "other records", "record_digest"});
  static_cast<void>(part(task, 2, 2));
  check_refused(names, {names[1], "belongs to a different design", "record_digest"});
}

BOOST_AUTO_TEST_CASE(are_not_overwritten) {
  const Arguments names = split(task, 2);
  check_refused(names, {"html", names[0]}, {"--html", names[0]});
  fs::create_symlink(names[0], path("merged"));
  check_refused(names, {"merged", "overwrite"});
}

BOOST_AUTO_TEST_SUITE_END()

namespace {

const Wrong wrong_record_parts[] = {
    {"design --v0 1 --p 1 --beta 0.9 --part 1/2", {"part needs a design under records"}},
    {task + "--part 3/2", {"part", "3/2", "1 <= I <= N"}},
    {task + "--part 1/2 --html a.html", {"part", "page"}},
    {task + "--resume", {"resume", "--part"}},
    {"design --record a.txt --period 2 --scan-points 0", {"scan-points", "0", "from 1"}}};

}  // namespace

BOOST_DATA_TEST_CASE_F(RecordParts, wrong_parts_are_refused, data::make(wrong_record_parts),
                       wrong) {
  check_refused({}, {"PART"});
  stillpoint::cli_test::check_refused(*this, wrong);
}

BOOST_AUTO_TEST_SUITE_END()
