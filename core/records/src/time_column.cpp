// SPDX-License-Identifier: MIT
#include "time_column.hpp"

#include <stillpoint/records/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stillpoint::records {

void TimeColumn::add(double time, const RecordReader& reader) {
  const RecordClock& clock = reader.options().clock;
  per_tau_ = clock.per_tau;
  first_ = times_.empty() ? time : first_;
  if (!clock.reaches(std::abs(time)) || !clock.reaches(time - start())) {
    reader.refuse(
        fmt::format("time {} {}: must be at most {:.3g}", time, clock.unit, clock.latest()));
  }
  if (!times_.empty()) {
    const double before = times_.back();
    if (!(time > before)) {
      reader.refuse(fmt::format("time {}: must be more than the previous time, {}{}", time, before,
                                comma_note(reader.line())));
    }
    if (!clock.tells_apart(before - start(), time - start())) {
      reader.refuse(fmt::format("time {} {}: is too close to the previous time, {}", time,
                                clock.unit, before));
    }
  }
  times_.push_back(time);
}

bool TimeColumn::is_uniform(double step) const {
  constexpr double tolerance = 0x1p-51;  // the step and its multiple are rounded
  double i = 0;
  return std::ranges::all_of(times_, [&](double time) {
    const double off = std::abs(time - start() - step * i);
    i += 1;
    return off <= tolerance * (std::abs(time) + std::abs(start()));
  });
}

void TimeColumn::move_to(Record& record) {
  const double last = static_cast<double>(times_.size()) - 1;
  const double step = last < 1 ? 0 : start() < 0 ? (times_.back() - start()) / last : times_[1];
  if (step > 0 && is_uniform(step)) {
    record.step = step / per_tau_;
    return;
  }
  for (double& time : times_) {
    time = (time - start()) / per_tau_;
  }
  record.times = std::move(times_);
}

std::string TimeColumn::note() const {
  return start() < 0 ? fmt::format("; the times are counted from the first, {:.6g}", start()) : "";
}

}  // namespace stillpoint::records
