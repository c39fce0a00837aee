// SPDX-License-Identifier: MIT
#include "batch_work.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <utility>

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

void run_batch(const BatchEntries& entries, std::ptrdiff_t block, int threads,
               const std::function<void(EntryThreads&)>& worker) {
  const std::function<bool()> always;
  EntryThreads work(entries.size, block, always);
  try {
    work.run(threads, [&] { worker(work); });
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

}  // namespace stillpoint
