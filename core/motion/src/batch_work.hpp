// SPDX-License-Identifier: MIT
#pragma once

// What the free and the forced batch share: the checks of the arrays, and threads whose errors name
// the array and the first entry at fault.

#include "entry_threads.hpp"

#include <stillpoint/core/batch.hpp>

namespace stillpoint {

/// All of them with one v0 and one p, which must outlive the result.
BatchEntries entries_of(const double& v0, const double& p, const BatchValues& f,
                        const BatchValues& delta);

/// Throws InputError if the arrays have different lengths.
BatchEntries entries_of(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                        const BatchValues& delta);

/// Calls worker(EntryThreads&) on several threads; it draws its entries and runs each in a guard.
/// Then throws the first error, with the entry in it.
void run_batch(const BatchEntries& entries, std::ptrdiff_t block, int threads,
               const std::function<void(EntryThreads&)>& worker);

}  // namespace stillpoint
