// SPDX-License-Identifier: MIT
#include "batch_work.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace stillpoint {

namespace {

EntryValues each(const BatchValues& values) {
  return {values.data(), 1};
}

/// `error` in entry i; a value that stands for all entries is not an error of that entry alone.
InputError in_entry(const InputError& error, std::ptrdiff_t i, const BatchEntries& entries) {
  for (const auto& [field, values] :
       {std::pair("v0", &entries.v0), std::pair("p", &entries.p), std::pair("f", &entries.f),
        std::pair("delta", &entries.delta), std::pair("notch-width", &entries.notch_width),
        std::pair("damping", &entries.zeta)}) {
    if (error.field() == field && values->stride != 0) {
      return error.in_entry(i);
    }
  }
  return error;
}

std::string message_of(const std::exception_ptr& cause) {
  try {
    std::rethrow_exception(cause);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "unknown error";
  }
}

}  // namespace

void require_entries(const char* field, const BatchValues& values, std::ptrdiff_t size) {
  if (values.size() != size) {
    throw InputError(field, fmt::format("an array of {}", values.size()),
                     fmt::format("must have as many entries as f, {}", size));
  }
}

BatchEntries entries_of(const double& v0, const double& p, const BatchValues& f,
                        const BatchValues& delta) {
  require_entries("delta", delta, f.size());
  return {{&v0, 0}, {&p, 0}, each(f), each(delta), f.size()};
}

BatchEntries entries_of(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                        const BatchValues& delta) {
  require_entries("v0", v0, f.size());
  require_entries("p", p, f.size());
  require_entries("delta", delta, f.size());
  return {each(v0), each(p), each(f), each(delta), f.size()};
}

void damp(BatchEntries& entries, const Eigen::ArrayXd& zeta) {
  if (zeta.size() > 0) {
    require_entries("damping", zeta, entries.size);
    entries.zeta = {zeta.data(), 1};
  }
}

void run_batch(const BatchEntries& entries, std::ptrdiff_t block, const Threads& threads,
               const std::function<bool()>& go_on,
               const std::function<void(EntryThreads&)>& worker) {
  EntryThreads work(entries.size, block, go_on);
  try {
    work.run(threads, [&] {
      // A single entry may take long.
      std::optional<Cancellable> cancellable;
      if (go_on) {
        cancellable.emplace([&work] { return work.wanted(); });
      }
      worker(work);
    });
    if (work.stopped()) {
      throw Cancelled();
    }
  } catch (const EntryError& failed) {
    try {
      std::rethrow_exception(failed.cause());
    } catch (const InputError& error) {
      throw in_entry(error, failed.entry(), entries);
    } catch (const TooManyHalfCycles& error) {
      throw error.in_entry(failed.entry());
    }
  }
}

EntryError::EntryError(std::ptrdiff_t entry, const std::exception_ptr& cause)
    : std::runtime_error(message_of(cause)), entry_(entry), cause_(cause) {}

bool EntryThreads::wanted() {
  if (go_on_ && !stopped_ && !go_on_()) {
    stopped_ = true;
  }
  return !stopped_;
}

EntryRange EntryThreads::next() {
  const std::ptrdiff_t begin = goes_on() ? std::min(size_, next_.fetch_add(block_)) : size_;
  return {begin, std::min(size_, begin + block_)};
}

void EntryThreads::guard(std::ptrdiff_t i, const std::function<void()>& entry) {
  try {
    entry();
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    if (!error_ || i < failed_entry_) {
      failed_entry_ = i;
      error_ = std::current_exception();
    }
    failed_ = true;
  }
}

void EntryThreads::run(const Threads& threads, const std::function<void()>& worker) {
  if (threads && *threads < 1) {
    throw InputError("threads", *threads, "must be 1 or more");
  }
  const auto at_once = static_cast<std::ptrdiff_t>(std::thread::hardware_concurrency());
  const std::ptrdiff_t wanted = threads ? *threads : at_once;
  const auto guarded = [&] {
    try {
      worker();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      worker_error_ = worker_error_ ? worker_error_ : std::current_exception();
      failed_ = true;
    }
  };
  const std::ptrdiff_t blocks = (size_ + block_ - 1) / block_;
  {
    std::vector<std::jthread> others;
    try {
      for (std::ptrdiff_t i = 1; i < std::min(wanted, blocks); ++i) {
        others.emplace_back(guarded);
      }
    } catch (const std::system_error& error) {
      failed_ = true;  // so that those which run end
      throw InputError("threads", static_cast<double>(wanted),
                       fmt::format("cannot be started ({}): give fewer", error.code().message()));
    }
    guarded();
  }
  if (worker_error_) {
    std::rethrow_exception(worker_error_);
  }
  if (error_) {
    throw EntryError(failed_entry_, error_);
  }
}

void for_each_entry(std::ptrdiff_t size, const Threads& threads, const std::function<bool()>& go_on,
                    const std::function<void(std::ptrdiff_t)>& body) {
  EntryThreads entries(size, 1, go_on);
  entries.run(threads, [&] {
    for (EntryRange one = entries.next(); one.begin < one.end; one = entries.next()) {
      entries.guard(one.begin, [&] { body(one.begin); });
    }
  });
}

}  // namespace stillpoint
