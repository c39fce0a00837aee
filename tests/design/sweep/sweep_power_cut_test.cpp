// SPDX-License-Identifier: MIT
// In which order files reach the disk. What the C library would do is done after it is noted.
#include "design/sweep/sweep_spec.hpp"

#include <stillpoint/sweep/open_rows.hpp>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

std::vector<std::string>* notes = nullptr;

std::string name_of(const std::filesystem::path& path) {
  return path.filename().string();
}

void note(const char* what, const std::filesystem::path& path) {
  if (notes != nullptr) {
    notes->push_back(what + (" " + name_of(path)));
  }
}

std::filesystem::path path_of(int descriptor) {
  return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor));
}

}  // namespace

// Found before those of the C library, whose parameters have reserved names.
// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name)
extern "C" {
int fsync(int descriptor) {
  note("fsync", path_of(descriptor));
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}
int fdatasync(int descriptor) {
  note("fsync", path_of(descriptor));
  return static_cast<int>(::syscall(SYS_fdatasync, descriptor));
}
int rename(const char* from, const char* to) noexcept {
  note("rename", to);
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
int remove(const char* path) noexcept {
  note("remove", path);
  return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, path, 0));
}
}
// NOLINTEND(readability-inconsistent-declaration-parameter-name)

BOOST_AUTO_TEST_SUITE(sweep_power_cut_test)

using namespace stillpoint::sweep_test;

/// A name is on the disk with its directory, and must not be before what it names. A checkpoint
/// must not be before the rows that it counts, nor go before the name of the whole file.
BOOST_FIXTURE_TEST_CASE(leaves_names_of_what_is_written, Folder) {
  SweepSpec spec = free_spec(Axis(0.01, 0.3, 20, Axis::Spacing::linear),
                             Axis(0, 0.5, 20, Axis::Spacing::linear));
  spec.output = path("rows.csv");
  spec.identity = "{}";
  std::vector<std::string> seen;
  notes = &seen;
  {
    const auto sink = open_rows(spec);
    std::stop_source stop;
    run(spec, *sink,
        {.stop = stop.get_token(), .progress = [&](const SweepState&) { stop.request_stop(); }});
    sink->leave();
  }
  spec.resume = true;
  run(spec, *open_rows(spec));
  notes = nullptr;
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  const std::string folder = "fsync " + name_of(path("rows.csv").parent_path());
  const std::vector<std::string> checkpoint{"fsync rows.csv.part.json.new",
                                            "rename rows.csv.part.json", folder};
  std::vector<std::string> wanted = checkpoint;  // of no rows
  wanted.emplace_back("fsync rows.csv.part");
  wanted.insert(wanted.end(), checkpoint.begin(), checkpoint.end());
  wanted.insert(wanted.end(),
                {"fsync rows.csv.part", "rename rows.csv", folder, "remove rows.csv.part.json"});
  BOOST_TEST(seen == wanted, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
