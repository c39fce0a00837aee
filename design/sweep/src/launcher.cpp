// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/launcher.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

namespace {

/// For any variable: far beyond every launcher, and differences stay exact.
constexpr std::int64_t farthest = 1'000'000'000'000;

/// What one launcher says.
struct Word {
  std::string_view launcher;
  SweepPart part;
};

class Launchers {
 public:
  Launchers(const Environment& environment, std::optional<std::int64_t> count)
      : environment_(environment), count_(count) {
    // Within a job of Slurm mpirun starts the ranks, and what Slurm says is of the job.
    if (!add_ranks("Open MPI", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE") &&
        !add_ranks("MPICH", "PMI_RANK", "PMI_SIZE")) {
      add_ranks("a step of Slurm", "SLURM_PROCID", "SLURM_NTASKS");
    }
    add_array();
    add_job();
  }

  [[nodiscard]] SweepPart part() {
    if (words_.empty()) {
      refuse(
          job_ ? fmt::format(
                     "GNU parallel says that this is job {}, but not how many jobs there are: give "
                     "auto/N",
                     *job_)
               : "no launcher says which part this is: start it with Slurm, mpirun or GNU "
                 "parallel, or give I/N");
    }
    // A single process says little: each task of an array is the only one of its step.
    std::stable_partition(words_.begin(), words_.end(),
                          [](const Word& word) { return word.part.count > 1; });
    const Word& first = words_.front();
    for (const Word& word : words_) {
      if (word.part != first.part && word.part.count > 1) {
        refuse(fmt::format("{} says {}, but {} says {}: give I/N", first.launcher, text(first.part),
                           word.launcher, text(word.part)));
      }
    }
    if (count_.value_or(first.part.count) != first.part.count) {
      refuse(fmt::format("{} says {}: give I/N", first.launcher, text(first.part)));
    }
    return first.part;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError("part", count_ ? fmt::format("auto/{}", *count_) : "auto", why);
  }

  [[nodiscard]] std::optional<std::int64_t> value(const char* name) const {
    const char* const text = environment_(name);
    if (text == nullptr) {
      return std::nullopt;
    }
    const std::int64_t number = records::parse_integer(name, text);
    if (number < -farthest || number > farthest) {
      throw InputError(name, text, fmt::format("must be from {} to {}", -farthest, farthest));
    }
    return number;
  }

  /// `number` from 1, as the variable `name` has it with an offset.
  void add(std::string_view launcher, const char* name, std::int64_t number, std::int64_t count) {
    if (number < 1 || number > count || count > most_sweep_parts) {
      throw InputError(name, environment_(name),
                       fmt::format("makes part {} of {}: give --part I/N", number, count));
    }
    words_.push_back({launcher, {number, count}});
  }

  /// Ranks count from 0.
  bool add_ranks(std::string_view launcher, const char* rank, const char* size) {
    const auto number = value(rank);
    const auto count = value(size);
    if (number && count) {
      add(launcher, rank, *number + 1, *count);
    }
    return number && count;
  }

  /// Tasks are numbered from MIN on, in steps.
  void add_array() {
    const char* const id = "SLURM_ARRAY_TASK_ID";
    const auto task = value(id);
    const auto count = value("SLURM_ARRAY_TASK_COUNT");
    if (!task || !count) {
      return;
    }
    const std::int64_t from_first = *task - value("SLURM_ARRAY_TASK_MIN").value_or(1);
    const std::int64_t step = std::max<std::int64_t>(value("SLURM_ARRAY_TASK_STEP").value_or(1), 1);
    if (from_first % step != 0) {
      throw InputError(id, environment_(id), "is not a step of the array: give --part I/N");
    }
    add("an array of Slurm", id, from_first / step + 1, *count);
  }

  void add_job() {
    const char* const sequence = "PARALLEL_SEQ";
    job_ = value(sequence);
    if (job_ && count_) {
      add("GNU parallel", sequence, *job_, *count_);
    }
  }

  const Environment& environment_;
  std::optional<std::int64_t> count_;  ///< as asked for
  std::vector<Word> words_;
  std::optional<std::int64_t> job_;
};

}  // namespace

SweepPart launched_part(const Environment& environment, std::optional<std::int64_t> count) {
  return Launchers(environment, count).part();
}

namespace {

/// N of "auto/N".
std::int64_t count_of(const std::string& asked) {
  const auto count = records::scan_integer(asked.substr(asked.find('/') + 1));
  if (!count || *count < 1 || *count > most_sweep_parts) {
    throw InputError("part",
                     fmt::format("\"{}\"", records::printable(asked, records::longest_word)),
                     fmt::format("must be auto/N with 1 <= N <= {}", most_sweep_parts));
  }
  return *count;
}

}  // namespace

SweepPart asked_part(const std::string& asked, const Environment& environment) {
  constexpr std::string_view automatic = "auto";
  if (asked == automatic) {
    return launched_part(environment);
  }
  if (asked.starts_with("auto/")) {
    return launched_part(environment, count_of(asked));
  }
  return parse_part(asked);
}

}  // namespace stillpoint::sweep
