// SPDX-License-Identifier: MIT
#include "batch_work.hpp"

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

namespace stillpoint {

namespace {

EntryValues each(const BatchValues& values) {
  return {values.data(), 1};
}

void require_size(const char* field, const BatchValues& values, std::ptrdiff_t size) {
  if (values.size() != size) {
    throw InputError(field, fmt::format("an array of {}", values.size()),
                     fmt::format("must have as many entries as f, {}", size));
  }
}

/// `error` in entry i; a value that stands for all is none of that entry alone.
InputError in_entry(const InputError& error, std::ptrdiff_t i, const BatchEntries& entries) {
  for (const auto& [field, values] :
       {std::pair("v0", &entries.v0), std::pair("p", &entries.p), std::pair("f", &entries.f),
        std::pair("delta", &entries.delta)}) {
    if (error.field() == field && values->stride != 0) {
      return error.in_entry(i);
    }
  }
  return error;
}

}  // namespace

BatchEntries entries_of(const double& v0, const double& p, const BatchValues& f,
                        const BatchValues& delta) {
  require_size("delta", delta, f.size());
  return {{&v0, 0}, {&p, 0}, each(f), each(delta), f.size()};
}

BatchEntries entries_of(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                        const BatchValues& delta) {
  require_size("v0", v0, f.size());
  require_size("p", p, f.size());
  require_size("delta", delta, f.size());
  return {each(v0), each(p), each(f), each(delta), f.size()};
}

EntryRange BatchWork::next() {
  const std::ptrdiff_t size = entries_.size;
  const std::ptrdiff_t begin = failed_ ? size : std::min(size, next_.fetch_add(block_));
  return {begin, std::min(size, begin + block_)};
}

void BatchWork::guard(std::ptrdiff_t i, const std::function<void()>& entry) {
  try {
    entry();
  } catch (const InputError& error) {
    fail(i, std::make_exception_ptr(in_entry(error, i, entries_)));
  } catch (const TooManyHalfCycles& error) {
    fail(i, std::make_exception_ptr(error.in_entry(i)));
  } catch (...) {
    fail(i, std::current_exception());
  }
}

void BatchWork::fail(std::ptrdiff_t i, const std::exception_ptr& error) {
  const std::scoped_lock lock(mutex_);
  if (!error_ || i < failed_entry_) {
    failed_entry_ = i;
    error_ = error;
  }
  failed_ = true;
}

void BatchWork::in_threads(int threads, const std::function<void()>& run) {
  if (threads < 0) {
    throw InputError("threads", threads, "must be 0 or more");
  }
  const std::ptrdiff_t at_once = std::thread::hardware_concurrency();
  const std::ptrdiff_t wanted = threads > 0 ? threads : at_once;
  const std::ptrdiff_t blocks = (entries_.size + block_ - 1) / block_;
  {
    std::vector<std::jthread> others;
    for (std::ptrdiff_t i = 1; i < std::min(wanted, blocks); ++i) {
      others.emplace_back(run);
    }
    run();
  }
  if (error_) {
    std::rethrow_exception(error_);
  }
}

}  // namespace stillpoint
