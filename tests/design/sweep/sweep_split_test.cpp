// SPDX-License-Identifier: MIT
// What parts of a sweep are, and which of them a launcher gives to a process.
#include "design/sweep/sweep_spec.hpp"

#include <stillpoint/sweep/launcher.hpp>
#include <stillpoint/sweep/part.hpp>
#include <stillpoint/sweep/state.hpp>

BOOST_AUTO_TEST_SUITE(sweep_split_test)

namespace {

using namespace stillpoint::sweep_test;
using Variables = std::map<std::string, std::string>;

SweepPart launched(const Variables& variables, std::optional<std::int64_t> count = {}) {
  const auto value = [&variables](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  };
  return launched_part(value, count);
}

void check_launched(const Variables& variables, const std::string& part,
                    std::optional<std::int64_t> count = {}) {
  BOOST_TEST(text(launched(variables, count)) == part);
}

void check_refused(const Variables& variables, const std::vector<std::string>& says,
                   std::optional<std::int64_t> count = {}) {
  test::check_contains(test::refusal_of<InputError>([&] { return launched(variables, count); }),
                       says);
}

const Variables mpi{{"OMPI_COMM_WORLD_RANK", "2"}, {"OMPI_COMM_WORLD_SIZE", "4"}};
const Variables mpich{{"PMI_RANK", "2"}, {"PMI_SIZE", "4"}};
const Variables step{{"SLURM_PROCID", "2"}, {"SLURM_NTASKS", "4"}};
const Variables one_task{{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "1"}};
const Variables job{{"PARALLEL_SEQ", "3"}};

Variables array(const char* id, const char* count, const char* first, const char* each = "1") {
  return {{"SLURM_ARRAY_TASK_ID", id},
          {"SLURM_ARRAY_TASK_COUNT", count},
          {"SLURM_ARRAY_TASK_MIN", first},
          {"SLURM_ARRAY_TASK_STEP", each}};
}

Variables both(Variables one, const Variables& other) {
  one.insert(other.begin(), other.end());
  return one;
}

}  // namespace

BOOST_AUTO_TEST_CASE(parts_cover_each_entry_once_and_are_equal_to_within_one) {
  constexpr std::int64_t most_entries = 1'000'000'000'000'000;
  std::mt19937_64 random(14);
  for (int i = 0; i < 200; ++i) {
    const std::int64_t count = 1 + static_cast<std::int64_t>(random() % 300);
    const auto entries = static_cast<std::int64_t>(random() % (i % 2 == 0 ? 500 : most_entries));
    std::int64_t next = 0;
    for (std::int64_t number = 1; number <= count; ++number) {
      const EntryRange range = range_of({number, count}, entries);
      BOOST_TEST_REQUIRE(range.first == next);
      BOOST_TEST_REQUIRE(range.count >= entries / count);
      BOOST_TEST_REQUIRE(range.count <= entries / count + 1);
      next += range.count;
    }
    BOOST_TEST_REQUIRE(next == entries);
  }
  const EntryRange last = range_of({most_sweep_parts, most_sweep_parts}, most_entries);
  BOOST_TEST(last.first + last.count == most_entries);
}

BOOST_AUTO_TEST_CASE(the_name_of_a_part_is_as_wide_as_that_of_the_last) {
  BOOST_TEST(with_part("rows.csv", {3, 8}) == "rows.csv");
  BOOST_TEST(with_part("{part}/{part}.csv", {3, 8}) == "3-of-8/3-of-8.csv");
  BOOST_TEST(with_part("a{part}", {3, 1000}) == "a0003-of-1000");
}

BOOST_AUTO_TEST_CASE(a_digest_of_bytes_does_not_depend_on_their_pieces) {
  std::mt19937_64 random(14);
  std::string text(1000, ' ');
  for (char& byte : text) {
    byte = static_cast<char>(random() % 256);
  }
  ByteDigest whole;
  whole.add(text);
  for (int i = 0; i < 100; ++i) {
    ByteDigest pieces;
    for (std::size_t place = 0; place < text.size();) {
      const std::size_t size = random() % 30;
      pieces.add(std::string_view(text).substr(place, size));
      place += size;
    }
    BOOST_TEST_REQUIRE((pieces == whole));
    std::string changed = text;
    char& one = changed[random() % text.size()];
    one = static_cast<char>(one ^ static_cast<char>(1 + random() % 255));
    ByteDigest other;
    other.add(changed);
    BOOST_TEST_REQUIRE((other != whole));
  }
}

BOOST_AUTO_TEST_CASE(each_launcher_says_which_part) {
  check_launched(mpi, "3/4");
  check_launched(mpich, "3/4");
  check_launched(step, "3/4");
  check_launched(array("7", "4", "5"), "3/4");
  check_launched(array("0", "4", "0"), "1/4");
  check_launched(array("9", "4", "0", "3"), "4/4");  // 0,3,6,9
  check_launched(job, "3/4", 4);
  check_launched(one_task, "1/1");
}

BOOST_AUTO_TEST_CASE(nested_launchers) {
  check_launched(both(array("2", "4", "1"), one_task), "2/4");
  check_launched(both(mpi, array("1", "1", "1")), "3/4");
  check_launched(both(mpi, mpich), "3/4");
  check_launched(both(mpi, {{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "2"}}),
                 "3/4");                  // mpirun in a job
  check_launched(both(mpi, job), "3/4");  // of a parallel that started mpirun, or submitted the job
  check_launched(mpi, "3/4", 4);
  check_launched(both(mpi, job), "3/4", 4);
}

BOOST_AUTO_TEST_CASE(what_contradicts_or_is_missing_is_refused) {
  check_refused({}, {"part = auto", "no launcher", "I/N"});
  check_refused({{"SLURM_PROCID", "1"}}, {"no launcher"});
  check_refused(job, {"GNU parallel", "job 3", "auto/N"});
  check_refused(both(mpi, array("1", "4", "1")), {"Open MPI says 3/4", "array of Slurm says 1/4"});
  check_refused(both(step, array("1", "8", "1")), {"step of Slurm says 3/4", "1/8"});
  check_refused(both(mpi, {{"PARALLEL_SEQ", "1"}}), {"Open MPI says 3/4", "parallel says 1/4"}, 4);
  check_refused(mpi, {"auto/8", "Open MPI says 3/4"}, 8);
  check_refused(one_task, {"auto/8", "1/1"}, 8);
  check_refused(job, {"PARALLEL_SEQ", "3", "part 3 of 2"}, 2);
  check_refused(array("9", "2", "1"), {"SLURM_ARRAY_TASK_ID", "9", "part 9 of 2"});
  check_refused(array("4", "2", "1", "2"), {"SLURM_ARRAY_TASK_ID", "4", "step"});
  check_refused({{"PMI_RANK", "4"}, {"PMI_SIZE", "4"}}, {"PMI_RANK", "part 5 of 4"});
  check_refused({{"PMI_RANK", "x"}, {"PMI_SIZE", "4"}}, {"PMI_RANK", "x"});
  // One more than this is not a whole number, nor is anything between these.
  const std::string most = "9223372036854775807";
  check_refused({{"PMI_RANK", most}, {"PMI_SIZE", "4"}}, {"PMI_RANK = " + most, "1000000000000"});
  check_refused(array("2", "4", ("-" + most).c_str()),
                {"SLURM_ARRAY_TASK_MIN = -" + most, "1000000000000"});
}

BOOST_AUTO_TEST_CASE(the_numbers_of_a_part_are_whole_in_any_form) {
  BOOST_TEST((parse_part("1e0/2") == SweepPart{1, 2}));
  BOOST_TEST((parse_part("3/1e3") == SweepPart{3, 1000}));
  for (const char* wrong : {"1.5/2", "1/2.5", "1/1e7", "2/1e0", "0e0/2", "/2", "1/", "1", "",
                            "1/2/3", "nan/2", "1/inf", "1/1e400"}) {
    BOOST_CHECK_THROW(static_cast<void>(parse_part(wrong)), InputError);
  }
}

BOOST_AUTO_TEST_SUITE_END()
