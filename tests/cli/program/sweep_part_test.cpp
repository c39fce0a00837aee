// SPDX-License-Identifier: MIT
// Sweeps in parts, and the parts joined again; commands/sessions/parts.txt has what is said of
// them.
#include "cli_test.hpp"
#include "limits.hpp"

#include <fmt/format.h>

BOOST_AUTO_TEST_SUITE(sweep_part_test)

using namespace stillpoint::cli_test;

const Arguments grid("sweep --v0 1 --p 1 --f 0.02:0.35:13 --delta 0:0.5:5");

struct Parts : Sandbox {
  /// Computes all parts, the last one first, into I-of-N.EXTENSION; their names.
  [[nodiscard]] Arguments split(const Arguments& sweep, int n, const std::string& extension) const {
    Arguments names;
    for (int i = n; i >= 1; --i) {
      succeed(sweep + Arguments{"--part", fmt::format("{}/{}", i, n), "--output",
                                "{part}." + extension, "--threads", std::to_string(1 + i % 3)});
      names.push_back(fmt::format("{:0{}}-of-{}.{}", i, std::to_string(n).size(), n, extension));
    }
    return names;
  }

  /// Joins them into the file merged.
  [[nodiscard]] ProgramRun merge(const Arguments& parts) const {
    return run(Arguments("sweep merge merged") + parts);
  }

  /// Asserts that n parts make the bytes of the whole.
  void check_merged(const Arguments& sweep, int n, const std::string& extension) const {
    BOOST_TEST_CONTEXT(n << " parts, " << extension) {
      const std::string whole = "whole." + extension;
      succeed(sweep + Arguments{"--output", whole});
      const ProgramRun answer = merge(split(sweep, n, extension));
      BOOST_TEST(answer.exit_code == 0, answer.err);
      BOOST_TEST((read("merged") == read(whole)));
    }
  }

  /// Asserts that they cannot be joined, why, and that nothing is written.
  void check_refused(const Arguments& parts, const Texts& says) const {
    const auto before = contents();
    check_refusal(merge(parts), says);
    BOOST_TEST(contents() == before);
  }
};

BOOST_FIXTURE_TEST_SUITE(parts, Parts)

BOOST_AUTO_TEST_CASE(of_any_sweep_merge_to_the_bytes_of_the_whole) {
  write("list.csv", "f,delta\n0.1,0.2\n\n0.3,0.1\n0.02,0.03\n0.05,0\n0.2,0.25\n");
  write("betas.csv", "beta\n0.8\n0.5\n0.9\n0.95\n1.2\n");
  write("a.txt", "0 0\n1 0.5\n2 -0.25\n3 0\n");
  write("b, c.txt", "0 0\n1 -0.25\n2 0.75\n3 0\n");
  const Arguments three("sweep --v0 1 --p 1 --f 0,0.1,0.2 --delta 0.3");
  const Arguments front("sweep --v0 1 --p 1 --tolerance 0.05 --trade-off 4");
  const Arguments reduced(
      "sweep --v0 1 --p 1 --f 0:0.35:15 --delta 0:0.6:13 --times --reduce --histogram "
      "peak_amplitude:0.7:0.95:6 --histogram stop_time:1:40:5:log");
  struct Row {
    Arguments sweep;
    std::vector<std::string> extensions;
    std::vector<int> counts;
  };
  for (const auto& [sweep, extensions, counts] : std::vector<Row>{
           {grid, {"csv", "npy"}, {1, 4, 12}},
           {three, {"csv", "npy"}, {5}},  // more than entries
           {"sweep --v0 1 --p 1 --list list.csv", {"csv", "npy"}, {3}},
           {"sweep --v0 1 --p 1 --beta 0.6:0.9:7", {"npy"}, {2}},
           {"sweep --p 1 --f 0.05:0.2:5 --delta 0 --excitation harmonic --k 0.2 --lambda 0.35 "
            "--t-end 20",
            {"csv"},
            {2}},
           {"sweep --p 1 --f 0.03,0.1 --delta 0.02 --record a.txt --record 'b, c.txt' "
            "--record-scale 0.5:2:4",
            {"csv", "npy"},
            {3}},
           // 20 rows in 3 and 7 parts: a part begins in the middle of a front.
           {front + "--beta 0.8:1.2:5", {"csv"}, {3, 7}},
           {front + "--list betas.csv", {"csv"}, {3, 7}},
           {reduced, {"json"}, {1, 2, 7}},
           {"sweep --v0 0.5:1:2 --p 1 --beta 0.4:0.9:4 --reduce", {"json"}, {10}},
           {"sweep --v0 1 --p 1 --list list.csv --reduce", {"json"}, {3}},
           {"sweep --velocity 200mm/s:400mm/s:5 --period 2.8s --f 0.02 --delta-m 1mm:6mm:6 "
            "--reduce",
            {"json"},
            {2}}}) {
    for (const std::string& extension : extensions) {
      for (const int count : counts) {
        check_merged(sweep, count, extension);
      }
    }
  }
}

/// Wherever it is cut.
BOOST_AUTO_TEST_CASE(that_are_truncated_are_refused) {
  for (const char* extension : {"csv", "npy"}) {
    const Arguments names = split(grid, 2, extension);
    const std::string& torn = names[0];
    const std::string whole = read(torn);
    const std::size_t step = whole.size() / 23;
    for (std::size_t size = 0; size < whole.size(); size += step) {
      write(torn, whole.substr(0, size));
      check_refused(names, {torn, "not a complete part"});
    }
    write(torn, whole.substr(0, whole.size() - 1));
    check_refused(names, {torn, "not a complete part"});
    write(torn, whole + "\n");
    check_refused(names, {torn, "not a complete part"});
    write(torn, whole.substr(1));
    check_refused(names, {torn, "not a complete part"});
  }
}

BOOST_AUTO_TEST_CASE(whose_seal_has_non_integers_are_refused) {
  const Arguments names = split(grid, 2, "csv");
  const std::string whole = read(names[0]);
  for (const std::string_view key :
       {"part", "entries", "rows", "bytes", "outcomes", "locked", "digest"}) {
    const std::size_t place =
        whole.find_first_of("0123456789", whole.rfind(fmt::format("\"{}\":", key)));
    const std::size_t end = whole.find_first_not_of("0123456789", place);
    for (const std::string_view number : {"1.75e20", "1.5", "18446744073709551616"}) {
      std::string changed = whole;
      write(names[0], changed.replace(place, end - place, number));
      BOOST_TEST_CONTEXT(key << " " << number) {
        check_refused(names, {names[0], "not a complete part"});
      }
    }
  }
}

/// At any byte, as on a full disk.
BOOST_AUTO_TEST_CASE(whose_merge_is_interrupted_leave_the_old_file_unchanged) {
  for (const char* extension : {"csv", "npy"}) {
    const Arguments names = split(grid, 3, extension);
    const std::string whole = [&] {
      BOOST_TEST_REQUIRE(merge(names).exit_code == 0);
      return read("merged");
    }();
    write("merged", "old");
    const std::size_t step = whole.size() / 7;
    for (std::size_t size = 1; size < whole.size(); size += step) {
      const WriteLimit limit(size, SIG_IGN);
      check_refused(names, {"merged", "cannot be written"});
    }
    static_cast<void>(
        run(Arguments("sweep merge merged") + names,
            {.signal_when = [&] { return fs::exists(path("merged.part")); }, .signal = SIGKILL}));
    BOOST_TEST((read("merged") == "old" || read("merged") == whole));
    BOOST_TEST(merge(names).exit_code == 0);  // whatever a killed one left
    BOOST_TEST((read("merged") == whole));
    fs::remove(path("merged"));
    BOOST_TEST(contents().size() == names.size());
    for (const std::string& name : names) {
      fs::remove(path(name));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

/// No address space has room for such stacks.
BOOST_FIXTURE_TEST_CASE(threads_that_cannot_be_started_are_said, Sandbox) {
  const Limit stacks(RLIMIT_STACK, rlim_t{1} << 56U);
  check_refusal(run(grid + "--output rows.csv --threads 1"),
                {"no thread can be started (Resource temporarily unavailable)", "ulimit"});
  BOOST_TEST(contents().empty());
}

BOOST_AUTO_TEST_SUITE_END()
