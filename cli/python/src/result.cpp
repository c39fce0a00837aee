// SPDX-License-Identifier: MIT
#include "result.hpp"

#include "values.hpp"

#include <fmt/format.h>

namespace stillpoint::python {

namespace py = pybind11;

const py::dict& Result::report() {
  if (!report_) {
    report_ = to_python(answer().json());
  }
  return report_;
}

py::object Result::field(const std::string& name) {
  const py::str key(name);
  if (!report().contains(key)) {
    throw py::attribute_error(fmt::format("the report has no field '{}'", name));
  }
  return report()[key];
}

std::string Result::text() const {
  return report::text(answer().document());
}

std::string Result::one_line() const {
  const report::Document said = answer().document();
  return said.verdict.empty() ? said.title : fmt::format("{}: {}", said.title, said.verdict);
}

std::string Result::html() const {
  const figures::HtmlPage shown = answer().page();
  std::string text = fmt::format("<div><p><b>{}</b>: {}</p>\n", figures::escaped(shown.title),
                                 figures::escaped(shown.verdict));
  for (const figures::Figure& figure : shown.figures) {
    text += "<div style=\"display:inline-block;width:450px;max-width:100%;vertical-align:top\">" +
            svg(figure, figures::Frame::alone) + "</div>\n";
  }
  return text + "</div>";
}

void add_result(py::module_& module) {
  py::class_<Result>(module, "Result",
                     "What a command found: the fields of its report as attributes.")
      .def_property_readonly("report", &Result::report, "the JSON report as a dict")
      .def("__getattr__", &Result::field)
      .def("__repr__", [](const Result& result) { return "<" + result.one_line() + ">"; })
      .def("__str__", &Result::text, "the report as the program prints it")
      .def("_repr_html_", &Result::html)
      .def("__dir__", [](const py::object& self) {
        const auto own = py::module_::import("builtins").attr("object").attr("__dir__")(self);
        return own + py::list(self.attr("report"));
      });
}

}  // namespace stillpoint::python
