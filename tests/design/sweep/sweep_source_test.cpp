// SPDX-License-Identifier: MIT
#include "design/sweep/sweep_spec.hpp"

#include <stillpoint/records/file_error.hpp>

BOOST_AUTO_TEST_SUITE(sweep_source_test)

using namespace stillpoint::sweep_test;
using enum Quantity;

struct Lists : Folder {
  [[nodiscard]] std::shared_ptr<List> list(const std::string& text) const {
    write("list", text);
    return std::make_shared<List>(path("list"));
  }

  [[nodiscard]] SweepSpec spec(const std::string& text) const {
    SweepSpec spec;
    spec.list = list(text);
    for (const Quantity input : {v0, p, x0, f, delta}) {
      if (!spec.list->has(input)) {
        spec.axes.push_back({input, Axis({input == x0 ? 0.0 : 1.0})});
      }
    }
    spec.columns = {f, delta};
    return spec;
  }

  /// Asserts that reading the list throws, at which line, and what the message says.
  void check_wrong(const std::string& text, std::size_t line, const std::string& says) const {
    const auto read = [&] {
      std::vector<double> values;
      for (const auto lines = list(text); lines->next(values);) {
      }
    };
    BOOST_CHECK_EXCEPTION(read(), records::FileError, [&](const records::FileError& error) {
      BOOST_TEST(error.place().kind == "list");
      BOOST_TEST(error.place().path == path("list"));
      BOOST_TEST(error.place().line.value_or(0) == line, error.what());
      return std::string(error.what()).find(says) != std::string::npos;
    });
  }
};

BOOST_FIXTURE_TEST_SUITE(list, Lists)

BOOST_AUTO_TEST_CASE(is_csv_or_arrays) {
  const auto columns =
      std::make_shared<const ListColumns>(ListColumns{{"f", {0.1, 0.3}}, {"delta", {0.2, 0}}});
  for (const auto& lines : {list("f,delta\n0.1,0.2\n\n0.3,0\n"), std::make_shared<List>(columns)}) {
    BOOST_TEST((lines->columns() == std::vector{f, delta}));
    std::vector<double> values;
    BOOST_TEST_REQUIRE(lines->next(values));
    BOOST_TEST((values == std::vector{0.1, 0.2}));
    BOOST_TEST_REQUIRE(lines->next(values));
    BOOST_TEST((values == std::vector{0.3, 0.0}));
    BOOST_TEST(!lines->next(values));
  }
}

/// The rest is in tests/cli/program/commands/sessions/sweeps.txt.
BOOST_AUTO_TEST_CASE(a_wrong_one_is_refused_with_its_line) {
  check_wrong("", 0, "is empty");
  check_wrong("f\n0.1,2\n", 2, "has 2 values, but the header names 1 column");
  check_wrong("f,delta\n0.1,\"0.2\n", 2, "a quote is opened but not closed");
  check_wrong("f,\"delta\n", 1, "a quote is opened but not closed");
}

BOOST_AUTO_TEST_CASE(gives_its_rows_in_order) {
  std::string text = "f,delta\n";
  std::string expected = text;
  for (int i = 1; i <= 5000; ++i) {  // more than one block
    const std::string row = std::to_string(i) + ",1\n";
    text += row;
    expected += row;
  }
  MemorySink sink;
  BOOST_TEST(run(spec(text), sink).state.rows == 5000);
  BOOST_TEST(sink.text == expected);
}

BOOST_AUTO_TEST_CASE(with_a_wrong_line_gives_the_rows_before_it) {
  for (const std::string wrong : {"-1,1", "x,1", "1"}) {
    MemorySink sink;
    BOOST_CHECK_EXCEPTION(
        run(spec("f,delta\n1,1\n2,1\n" + wrong + "\n3,1\n"), sink), records::FileError,
        [](const records::FileError& error) { return error.place().line == std::size_t{4}; });
    BOOST_TEST(sink.text == "f,delta\n1,1\n2,1\n");
  }
}

BOOST_AUTO_TEST_CASE(resumed_must_begin_with_the_same_entries) {
  const std::string first = "f,delta\n1,1\n2,1\n";
  MemorySink sink;
  const SweepState found = run(spec(first), sink).state;
  MemorySink rest(found);
  run(spec(first + "3,1\n"), rest);
  BOOST_TEST(rest.text == "3,1\n");
  for (const std::string other : {"f,delta\n1,1\n", "f,delta\n1,1\n2,2\n3,1\n"}) {
    MemorySink refused(found);
    BOOST_CHECK_THROW(run(spec(other), refused), records::FileError);
    BOOST_TEST(refused.text.empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
