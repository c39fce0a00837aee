// SPDX-License-Identifier: MIT
#include "design/sweep/sweep_spec.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/open_rows.hpp>

BOOST_AUTO_TEST_SUITE(sweep_leftover_test)

using namespace stillpoint::sweep_test;

struct Files : Folder {
  [[nodiscard]] bool has(const char* name) const { return std::filesystem::exists(path(name)); }

  [[nodiscard]] SweepSpec spec() const {
    SweepSpec spec = free_spec(Axis(0.01, 0.3, 100, Axis::Spacing::linear),
                               Axis(0, 0.5, 100, Axis::Spacing::linear));
    spec.output = path("rows.csv");
    spec.identity = R"({"f": "0.01:0.3:100"})";
    return spec;
  }

  /// Runs the sweep and stops it after some rows.
  [[nodiscard]] LeftRows stopped() const {
    const auto sink = open_rows(spec());
    std::stop_source stop;
    const SweepSummary summary = run(
        spec(), *sink,
        {.stop = stop.get_token(), .progress = [&](const SweepState&) { stop.request_stop(); }});
    BOOST_TEST((summary.end == SweepEnd::stopped));
    return sink->leave();
  }

  [[nodiscard]] std::string whole() const {
    MemorySink sink;
    run(spec(), sink);
    return sink.text;
  }
};

BOOST_FIXTURE_TEST_SUITE(file, Files)

BOOST_AUTO_TEST_CASE(appears_when_it_is_complete) {
  const auto sink = open_rows(spec());
  BOOST_TEST(has("rows.csv.part"));
  run(spec(), *sink);
  BOOST_TEST(read("rows.csv") == whole());
  BOOST_TEST(!has("rows.csv.part"));
  BOOST_TEST(!has("rows.csv.part.json"));
}

BOOST_AUTO_TEST_CASE(of_a_stopped_sweep_is_resumed_into_the_same_bytes) {
  const LeftRows left = stopped();
  BOOST_TEST(left.count > 0);
  BOOST_TEST(left.file.value() == path("rows.csv.part"));
  BOOST_TEST(!has("rows.csv"));
  SweepSpec rest = spec();
  rest.resume = true;
  rest.threads = 2;
  const auto sink = open_rows(rest);
  BOOST_TEST(sink->found().rows == left.count);
  BOOST_TEST(run(rest, *sink).resumed_at == left.count);
  BOOST_TEST(read("rows.csv") == whole());
}

BOOST_AUTO_TEST_CASE(with_an_impossible_number_of_rows_is_refused) {
  const std::string rows = "\"rows\":" + std::to_string(stopped().count) + ",";
  const std::string checkpoint = read("rows.csv.part.json");
  const std::size_t place = checkpoint.find(rows);
  BOOST_TEST_REQUIRE(place != std::string::npos);
  SweepSpec rest = spec();  // of 10 000 entries
  rest.resume = true;
  for (const char* const other : {"-1", "-9223372036854775808", "10001", "9223372036854775807",
                                  "9223372036854775808", "1.75e20", "1.5", "true"}) {
    std::string wrong = checkpoint;
    wrong.replace(place, rows.size(), std::string("\"rows\":") + other + ",");
    write("rows.csv.part.json", wrong);
    BOOST_TEST_CONTEXT(other) {
      BOOST_CHECK_THROW(static_cast<void>(open_rows(rest)), records::FileError);
    }
  }
}

BOOST_AUTO_TEST_CASE(of_another_sweep_is_left_alone) {
  static_cast<void>(stopped());
  const std::string part = read("rows.csv.part");
  BOOST_CHECK_THROW(static_cast<void>(open_rows(spec())), records::FileError);
  SweepSpec other = spec();
  other.resume = true;
  other.identity = R"({"f": "0.01:0.3:101"})";
  test::check_contains(test::refusal_of<records::FileError>([&] { return open_rows(other); }),
                       {R"(f was "0.01:0.3:100", is "0.01:0.3:101")"});
  BOOST_TEST(read("rows.csv.part") == part);
}

BOOST_AUTO_TEST_CASE(that_is_wrong_is_refused_before_anything_is_created) {
  SweepSpec wrong = spec();
  wrong.columns = {};
  BOOST_CHECK_THROW(static_cast<void>(open_rows(wrong)), InputError);
  wrong = spec();
  wrong.identity = "f";
  BOOST_CHECK_THROW(static_cast<void>(open_rows(wrong)), InputError);
  wrong = spec();
  wrong.output = path("no/rows.csv");
  BOOST_CHECK_THROW(static_cast<void>(open_rows(wrong)), records::FileError);
  wrong.output = "-";
  BOOST_CHECK_THROW(static_cast<void>(open_rows(wrong)), InputError);
  BOOST_TEST(!has("rows.csv.part"));
}

BOOST_AUTO_TEST_CASE(of_a_sweep_without_rows_leaves_nothing) {
  const auto sink = open_rows(spec());
  std::stop_source stop;
  stop.request_stop();
  run(spec(), *sink, {.stop = stop.get_token()});
  BOOST_TEST(sink->leave().count == 0);
  BOOST_TEST(!has("rows.csv.part"));
  BOOST_TEST(!has("rows.csv.part.json"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
