// SPDX-License-Identifier: MIT
// The commands that answer with a report: settings from keyword arguments, then what the program
// does.

#include "arguments.hpp"
#include "input/request.hpp"
#include "interruptible.hpp"
#include "parts.hpp"
#include "result.hpp"
#include "values.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/report/report.hpp>

#include <array>
#include <functional>
#include <memory>
#include <utility>

namespace stillpoint::python {

namespace py = pybind11;
using cli::Command;

namespace {

/// The region for only v0, p and beta, which is available at once; the rest of the report is made
/// when it is read.
class Bounds final : public Result {
 public:
  explicit Bounds(const design::Problem& problem)
      : Result(nullptr), request_{problem}, region_(admissible_region(problem)) {}

  [[nodiscard]] const py::object& region() {
    if (!fields_) {
      fields_ = to_python(report::region_fields(region_.feasible ? design::RegionVerdict{region_}
                                                                 : design::answer(request_)));
    }
    return fields_;
  }

 private:
  [[nodiscard]] const answers::Answer& answer() const override {
    if (!whole_) {
      whole_ = answers::answer_of(report::RegionReport{request_, design::answer(request_), {}, {}});
    }
    return *whole_;
  }

  design::RegionRequest request_;
  design::Region region_;
  py::object fields_;
  mutable std::unique_ptr<answers::Answer> whole_;
};

/// With a trajectory, if samples or an end were asked for.
class Motion final : public Result {
 public:
  using Result::Result;

  /// The memory is that of the result.
  [[nodiscard]] static py::object trajectory(const py::object& self) {
    const auto& motion = static_cast<const answers::AnswerOf<report::MotionReport>&>(
        self.cast<const Motion&>().answer());
    const std::vector<State>& states = motion.made().answer.trajectory;
    if (states.empty()) {
      return py::none();
    }
    py::array rows(py::dtype::of<State>(), states.size(), states.data(), self);
    rows.attr("flags").attr("writeable") = false;
    return rows;
  }
};

using Given = cli::Settings;
using GoOn = std::function<bool()>;
using Found = std::unique_ptr<answers::Answer>;

Found found_design(const Given& given, const GoOn& go_on) {
  if (!cli::designs_under_records(given)) {
    return answers::answer_of(answers::answer(cli::design_input(given)));
  }
  const report::RecordDesignInput input = cli::record_design_input(given);
  return answers::answer_of(report::record_design_report(
      design::design(input.request, [&](const auto& /*progress*/) { return go_on(); }),
      input.physical));
}

Found found_region(const Given& given, const GoOn& /*go_on*/) {
  return answers::answer_of(answers::answer(cli::region_input(given)));
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
    Row{Command::design, found_design,
        "Designs a damper: the admissible region, the search in it, its motion and its check; with "
        "record, for a suite of acceleration records."},
    Row{Command::region, found_region,
        "The admissible region of f and delta, without a search; with f and delta, where this "
        "damper stands in it. With v0, p and beta alone, as floats, it takes less than a "
        "microsecond."},
    Row{Command::simulate, found_motion,
        "One motion, free or forced: metrics and half-cycles. With samples, or t_end of a free "
        "motion, the result has a trajectory: an array of (tau, x, v)."},
    Row{Command::spectrum, found_spectrum,
        "Peak, residual and transmitted acceleration of one damper under records over the period, "
        "an axis as of sweep, beside the same damper without its notch."},
};

/// v0, p and beta, if nothing else is given and these are floats.
std::unique_ptr<Bounds> bounds(PyObject* const* values, Py_ssize_t count, PyObject* names) {
  static const std::array<PyObject*, 3> keys{PyUnicode_InternFromString("v0"),
                                             PyUnicode_InternFromString("p"),
                                             PyUnicode_InternFromString("beta")};
  if (count != 0 || names == nullptr || PyTuple_GET_SIZE(names) != std::ssize(keys)) {
    return nullptr;
  }
  std::array<double, keys.size()> numbers{};
  unsigned found = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (Py_ssize_t j = 0; j < std::ssize(keys); ++j) {
      if (PyTuple_GET_ITEM(names, j) == keys[i] && PyFloat_CheckExact(values[j])) {
        numbers[i] = PyFloat_AS_DOUBLE(values[j]);
        ++found;
      }
    }
  }
  if (found != keys.size()) {
    return nullptr;
  }
  design::Problem problem;
  problem.v0 = numbers[0];
  problem.p = numbers[1];
  problem.beta = numbers[2];
  return std::make_unique<Bounds>(problem);
}

PyObject* general_region = nullptr;

/// region(v0=, p=, beta=) without settings; anything else, and what is wrong, goes to the general
/// function.
PyObject* fast_region(PyObject* /*module*/, PyObject* const* values, Py_ssize_t count,
                      PyObject* names) {
  try {
    if (auto found = bounds(values, count, names)) {
      return py::cast(std::move(found)).release().ptr();
    }
  } catch (const InputError&) {
    // which the general function throws again
  }
  return PyObject_Vectorcall(general_region, values, static_cast<std::size_t>(count), names);
}

std::unique_ptr<Result> run(const Row& row, const py::object& scene, const py::dict& options) {
  const cli::Settings given = settings(row.command, scene, options);
  std::unique_ptr<answers::Answer> found = interruptible([&](const std::stop_token& stop) {
    return with_places(given,
                       [&] { return row.answer(given, [&] { return !stop.stop_requested(); }); });
  });
  warn_of_doubts(row.command == Command::simulate ? cli::traced(given) : given, row.command);
  if (row.command == Command::simulate) {
    return std::make_unique<Motion>(std::move(found));
  }
  return std::make_unique<Result>(std::move(found));
}

}  // namespace

void add_commands(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(State, tau, x, v);
  py::class_<Motion, Result>(
      module, "Motion",
      "What simulate found: the fields of its report as attributes, and trajectory.")
      .def_property_readonly("trajectory", &Motion::trajectory,
                             "a structured array of tau, x and v, read-only; None if neither "
                             "samples nor the end of a free motion was given");
  py::class_<Bounds, Result>(module, "Bounds", "What region found of v0, p and beta alone.")
      .def_property_readonly("region", &Bounds::region);
  for (const Row& row : rows) {
    module.def(
        std::string(name(row.command)).c_str(),
        [&row](const py::object& scene, const py::kwargs& given) { return run(row, scene, given); },
        py::arg("scene") = py::none(), py::pos_only(),
        documentation(row.command, row.about).c_str());
  }
  module.def("options", &options, py::arg("command"),
             "options(command)\n--\n\n(keyword, type, help) of each option of a command.");
  general_region = py::object(module.attr("region")).release().ptr();
  static const std::string doc = documentation(Command::region, rows[1].about);
  static std::array<PyMethodDef, 2> methods{
      {{"region", as_method(&fast_region), METH_FASTCALL | METH_KEYWORDS, doc.c_str()}, {}}};
  PyModule_AddFunctions(module.ptr(), methods.data());
}

}  // namespace stillpoint::python
