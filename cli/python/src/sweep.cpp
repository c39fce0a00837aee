// SPDX-License-Identifier: MIT
// The command sweep, with its rows in memory: what a file of the format npy holds, as an array. Or
// without rows.

#include "arguments.hpp"
#include "input/request.hpp"
#include "interruptible.hpp"
#include "output.hpp"
#include "parts.hpp"
#include "result.hpp"

#include <stillpoint/report/reduction.hpp>
#include <stillpoint/report/sweep.hpp>
#include <stillpoint/sweep/open_rows.hpp>

#include <new>

namespace stillpoint::python {

namespace py = pybind11;
using cli::Command;
using cli::Settings;
using sweep::SweepSpec;

namespace {

/// What sweep found, with its rows if they are in memory.
struct Sweep final : Result {
  using Result::Result;
};

/// The records of a .npy file.
py::dtype dtype_of(const SweepSpec& spec) {
  py::list columns;
  for (const sweep::Quantity column : spec.columns) {
    const sweep::Form form = sweep::form(column);
    const char* const type = form == sweep::Form::number  ? "f8"
                             : form == sweep::Form::truth ? "?"
                                                          : "u1";
    columns.append(py::make_tuple(std::string(name(column, spec.units)), type));
  }
  return py::dtype::from_args(columns);
}

/// The bytes of a file without its header.
class RowsInMemory final : public sweep::RowSink {
 public:
  /// `size` is that of all rows, if known.
  explicit RowsInMemory(std::size_t size) {
    try {
      bytes_.reserve(size);
    } catch (const std::bad_alloc&) {
      throw cli::UsageError(
          fmt::format("the table takes {:.3g} GB of memory: give output, a file, or reduce",
                      1e-9 * static_cast<double>(size)));
    }
  }

  void write(std::string_view bytes) override {
    if (after_header_) {
      bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }
    after_header_ = true;
  }

  /// The rows as an array that owns them.
  [[nodiscard]] py::array take(const py::dtype& type) {
    auto bytes = std::make_unique<std::vector<char>>(std::move(bytes_));
    const auto count = static_cast<py::ssize_t>(bytes->size()) / type.itemsize();
    const void* const data = bytes->data();
    return {type, count, data, kept(std::move(bytes))};
  }

 private:
  bool after_header_{false};  ///< which comes first, alone
  std::vector<char> bytes_;
};

/// Only a sweep over f and delta has a map.
std::optional<sweep::SweepMap> map_of(const SweepSpec& spec) {
  try {
    return sweep::SweepMap(spec);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::unique_ptr<Sweep> found_by(const Settings& given, bool in_memory) {
  report::SweepReport found{.spec = cli::sweep_request(given), .record = given.text("record")};
  const SweepSpec& spec = found.spec;
  const bool with_rows = !spec.reduction;
  found.map = with_rows ? map_of(spec) : std::nullopt;
  const py::dtype type = dtype_of(spec);
  in_memory = in_memory && with_rows;
  RowsInMemory memory(in_memory
                          ? static_cast<std::size_t>(sweep::own_entries(spec).count.value_or(0)) *
                                static_cast<std::size_t>(type.itemsize())
                          : 0);
  found.summary = interruptible([&](const std::stop_token& stop) {
    const std::unique_ptr<sweep::RowSink> file = in_memory ? nullptr : sweep::open_rows(spec);
    return sweep::run(spec, file ? *file : memory, {stop, {}, found.map ? &*found.map : nullptr});
  });
  if (with_rows) {
    py::object table = py::none();
    if (in_memory) {
      table = memory.take(type);
    }
    return std::make_unique<Sweep>(answers::answer_of(std::move(found)), std::move(table));
  }
  report::ReductionReport reduced = report::reduction_report(spec, found.summary);
  if (!sweep::keeps_rows(spec)) {
    cli::Output output;
    cli::print_report(reduced, given, output, false);
    output.commit();
  }
  return std::make_unique<Sweep>(answers::answer_of(std::move(reduced)), py::none());
}

std::unique_ptr<Sweep> run_sweep(const py::object& scene, const py::kwargs& options) {
  Settings given = settings(Command::sweep, scene, options);
  const bool in_memory = !given.has("output");
  if (in_memory && !given.flag("reduce")) {
    given.set("format", std::string("npy"));
  }
  std::unique_ptr<Sweep> found = with_places(given, [&] {
    cli::resolve_part(given);
    cli::require_files_apart(Command::sweep, given, std::nullopt);
    return found_by(given, in_memory);
  });
  warn_of_doubts(given, Command::sweep);
  return found;
}

}  // namespace

void add_sweep(py::module_& module) {
  py::list names;
  for (std::size_t i = 0; i < sweep::sweep_outcome_count; ++i) {
    names.append(py::str(std::string(sweep::sweep_outcome_name(i))));
  }
  module.attr("outcomes") = py::tuple(names);
  result_class<Sweep, Result>(
      module, "Sweep", "What sweep found: the fields of its report as attributes, and table.")
      .def_property_readonly("table", &Result::rows,
                             "a structured array with a field for each column; None if the rows "
                             "went to a file, and with reduce");
  module.def(
      "sweep", &run_sweep, py::arg("scene") = py::none(), py::pos_only(),
      documentation(Command::sweep,
                    "Many motions, or with beta many designs, over a grid or a list. An axis "
                    "is a number, an array, or a string: \"first:last:count\", with \":log\", or "
                    "\"a,b,c\". A list is a file, or arrays: {\"f\": f, \"delta\": delta}. The "
                    "result has a table, a structured array with a field for each "
                    "column; outcome is an index in stillpoint.outcomes. With output the rows "
                    "go to that file instead. With reduce there are no rows, but counts, extremes "
                    "and histograms.")
          .c_str());
}

}  // namespace stillpoint::python
