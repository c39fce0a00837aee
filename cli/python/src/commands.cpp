// SPDX-License-Identifier: MIT
// The commands that answer with a report: settings from keyword arguments, then what the program
// does.

#include "arguments.hpp"
#include "input/request.hpp"
#include "interruptible.hpp"
#include "parts.hpp"
#include "result.hpp"

namespace stillpoint::python {

namespace py = pybind11;
using cli::Command;

namespace {

/// With a trajectory, if samples or an end were asked for.
struct Motion final : Result {
  using Result::Result;
};

/// In metres and seconds as well if the input is; else in the memory of the answer.
py::object trajectory(const std::shared_ptr<const answers::Answer>& answer) {
  const report::MotionReport& found =
      static_cast<const answers::AnswerOf<report::MotionReport>&>(*answer).made();
  const std::vector<TracedState>& states = found.answer.trajectory;
  if (states.empty()) {
    return py::none();
  }
  py::list columns;
  for (const std::string_view name : report::trajectory_columns(found.physical)) {
    columns.append(py::make_tuple(std::string(name), "f8"));
  }
  const py::dtype type = py::dtype::from_args(columns);
  py::array rows =
      found.physical
          ? py::array(to_array(report::trajectory_rows(states, found.physical)).attr("view")(type))
          : py::array(type, static_cast<py::ssize_t>(states.size()), states.data(),
                      kept(std::make_unique<std::shared_ptr<const answers::Answer>>(answer)));
  rows.attr("flags").attr("writeable") = false;
  return rows;
}

using Given = cli::Settings;
using GoOn = std::function<bool()>;
using Found = std::unique_ptr<answers::Answer>;

template <Command command>
Found found_dampers(const Given& given, const GoOn& go_on) {
  const auto searched = [&](const report::RecordDesignInput& input) {
    return report::RecordDesignReport{
        design::design(input.request, [&](const auto& /*progress*/) { return go_on(); }), input};
  };
  return cli::answer_dampers(given, command, searched,
                             [](auto report) { return answers::answer_of(std::move(report)); });
}

Found found_motion(const Given& given, const GoOn& go_on) {
  return answers::answer_of(cli::motion_report(given, go_on));
}

Found found_spectrum(const Given& given, const GoOn& go_on) {
  report::SpectrumReport found = cli::spectrum_input(given);
  found.result = design::spectrum(found.result.request, [&](double /*done*/) { return go_on(); });
  return answers::answer_of(std::move(found));
}

/// A new command that answers with a report is a row. What is called now and then may end a run.
struct Row {
  Command command;
  Found (*answer)(const Given& given, const GoOn& go_on);
  std::string_view about;
};
constexpr std::array rows{
    Row{Command::design, found_dampers<Command::design>,
        "Designs a damper: the admissible region, the search in it, its motion and its check; with "
        "record, for a suite of acceleration records."},
    Row{Command::region, found_dampers<Command::region>,
        "The admissible region of f and delta, without a search; with f and delta, where this "
        "damper stands in it."},
    Row{Command::simulate, found_motion,
        "One motion, free or forced: metrics and half-cycles. With samples, or t_end of a free "
        "motion, the result has a trajectory: an array of (tau, x, v, w, absolute_acceleration, "
        "friction)."},
    Row{Command::spectrum, found_spectrum,
        "Peak, residual and transmitted acceleration of one damper under records over the period, "
        "an axis as of sweep, beside the same damper without its notch."},
};

std::unique_ptr<Result> run(const Row& row, const py::object& scene, const py::dict& options) {
  const cli::Settings given = settings(row.command, scene, options);
  const std::shared_ptr<const answers::Answer> found =
      interruptible([&](const std::stop_token& stop) {
        return with_places(
            given, [&] { return row.answer(given, [&] { return !stop.stop_requested(); }); });
      });
  warn_of_doubts(row.command == Command::simulate ? cli::traced(given) : given, row.command);
  if (row.command == Command::simulate) {
    return std::make_unique<Motion>(found, trajectory(found));
  }
  return std::make_unique<Result>(found);
}

}  // namespace

void add_commands(py::module_& module) {
  result_class<Motion, Result>(
      module, "Motion",
      "What simulate found: the fields of its report as attributes, and trajectory.")
      .def_property_readonly("trajectory", &Result::rows,
                             "a structured array of tau, x, v, w, absolute_acceleration and "
                             "friction, with physical input also of t_s, x_m and so on, read-only; "
                             "None if neither samples nor the end of "
                             "a free motion was given");
  for (const Row& row : rows) {
    module.def(
        std::string(name(row.command)).c_str(),
        [&row](const py::object& scene, const py::kwargs& given) { return run(row, scene, given); },
        py::arg("scene") = py::none(), py::pos_only(),
        documentation(row.command, row.about).c_str());
  }
  module.def("options", &options, py::arg("command"),
             "options(command)\n--\n\n(keyword, type, help) of each option of a command.");
}

}  // namespace stillpoint::python
