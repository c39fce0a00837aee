// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/cancellation.hpp>

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <stop_token>

namespace stillpoint::python {

/// work(stop) without the interpreter's lock. It runs on a thread of its own, because only the
/// caller's thread can see an interrupt: that requests a stop, and is thrown once the work has
/// ended.
template <class Work>
auto interruptible(const Work& work) {
  namespace py = pybind11;
  constexpr std::chrono::milliseconds between_looks{20};
  std::stop_source source;
  bool interrupted = false;
  std::future<decltype(work(source.get_token()))> answer;
  {
    const py::gil_scoped_release released;
    answer = std::async(std::launch::async, [&work, stop = source.get_token()] {
      const Cancellable cancellable([&stop] { return !stop.stop_requested(); });
      return work(stop);
    });
    while (answer.wait_for(between_looks) != std::future_status::ready) {
      const py::gil_scoped_acquire acquired;
      if (!interrupted && PyErr_CheckSignals() != 0) {
        interrupted = true;
        source.request_stop();
      }
    }
  }
  if (interrupted) {
    throw py::error_already_set();
  }
  return answer.get();
}

}  // namespace stillpoint::python
