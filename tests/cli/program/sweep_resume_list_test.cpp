// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

// A sweep over a list that stopped at a wrong entry, and continues with the corrected list.
BOOST_AUTO_TEST_SUITE(sweep_resume_list_test)

namespace {

using namespace stillpoint::cli_test;

std::string rows(int count, const std::string& last) {
  std::string text = "f,delta\n";
  for (int i = 1; i < count; ++i) {
    text += std::to_string(i) + "e-5,0.5\n";
  }
  return text + last + "\n";
}

ProgramRun resume(const Sandbox& sandbox, const std::string& list, const Arguments& more = {}) {
  return sandbox.run("sweep --v0 1 --p 1 --list - --output rows.npy --resume" + more,
                     {.input = list});
}

}  // namespace

BOOST_FIXTURE_TEST_SUITE(list, Sandbox)

BOOST_AUTO_TEST_CASE(with_a_wrong_entry_can_be_corrected) {
  constexpr int count = 3000;
  const std::string right = rows(count, "0.1,0.5");
  BOOST_TEST(resume(*this, right).exit_code == 0);
  const std::string whole = read("rows.npy");
  fs::remove(path("rows.npy"));

  check_refusal(resume(*this, rows(count, "-0.1,0.5")),
                {"line 3001: f = -0.1", "kept in rows.npy.part"});
  BOOST_TEST(!fs::exists(path("rows.npy")));

  const auto before = contents();
  std::string other = right;
  other.replace(other.find("1e-5"), 4, "2e-5");
  for (const std::string& wrong : {other, rows(10, "0.1,0.5")}) {
    check_refusal(resume(*this, wrong), {"differ from those"});
    BOOST_TEST(contents() == before);
  }

  const ProgramRun mended = resume(*this, right, "--json");
  BOOST_TEST_REQUIRE(mended.exit_code == 0, mended.err);
  BOOST_TEST(mended.json()["resumed_at"] > 0);
  BOOST_TEST(read("rows.npy") == whole);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(wrong_entry, Sandbox)

/// However many entries are computed at once, all before the wrong one are kept, and the rest
/// of the list may be corrected.
BOOST_AUTO_TEST_CASE(keeps_every_row_before_it) {
  const std::string whole_list = rows(200, "0.1,0.5");
  BOOST_TEST(resume(*this, whole_list).exit_code == 0);
  const std::string whole = read("rows.npy");
  for (const std::string& wrong : {std::string("-0.1,0.5"), std::string("a,0.5")}) {
    for (const int at : {2, 150}) {
      fs::remove(path("rows.npy"));
      const ProgramRun refused = resume(*this, rows(at, wrong) + "0.2,0.5\n");
      BOOST_TEST(refused.exit_code == 2);
      BOOST_TEST(contains(refused.err, "line " + std::to_string(at + 1) + ": f = "), refused.err);
      // The same command would only meet the same line again.
      const std::string kept =
          std::string(at == 2 ? "1 row is" : "149 rows are") +
          " kept in rows.npy.part: correct the list, then give the same command with --resume";
      BOOST_TEST(contains(refused.err, kept), refused.err);
      BOOST_TEST(json::parse(read("rows.npy.part.json"))["rows"] == at - 1);
      const ProgramRun mended = resume(*this, whole_list, "--json");
      BOOST_TEST_REQUIRE(mended.exit_code == 0, mended.err);
      BOOST_TEST(mended.json()["resumed_at"] == at - 1);
      BOOST_TEST(read("rows.npy") == whole);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
