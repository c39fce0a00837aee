// SPDX-License-Identifier: MIT
#include "result.hpp"

#include <fmt/format.h>

namespace stillpoint::python {

namespace py = pybind11;

Result::Result(std::shared_ptr<const answers::Answer> answer, py::object rows)
    : answer_(std::move(answer)), rows_(std::move(rows)) {}

Result::Result(const py::tuple& state)
    : told_(Told{state[1], state[2], state[3]}), rows_(state[4]), report_(state[0]) {}

py::tuple Result::state() {
  return py::make_tuple(report(), text(), one_line(), html(), rows_);
}

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

py::str Result::text() const {
  return told_ ? told_->text : to_str(report::text(answer().document()));
}

py::str Result::one_line() const {
  if (told_) {
    return told_->one_line;
  }
  const report::Document said = answer().document();
  return to_str(said.verdict.empty() ? said.title
                                     : fmt::format("{}: {}", said.title, said.verdict));
}

py::str Result::html() const {
  if (told_) {
    return told_->html;
  }
  const figures::HtmlPage shown = answer().page();
  std::string text = fmt::format("<div><p><b>{}</b>: {}</p>\n", figures::escaped(shown.title),
                                 figures::escaped(shown.verdict));
  for (const figures::Figure& figure : shown.figures) {
    text += "<div style=\"display:inline-block;width:450px;max-width:100%;vertical-align:top\">" +
            svg(figure, figures::Frame::alone) + "</div>\n";
  }
  return to_str(text + "</div>");
}

void add_result(py::module_& module) {
  result_class<Result>(module, "Result",
                       "What a command found: the fields of its report as attributes.")
      .def_property_readonly("report", &Result::report, "the JSON report as a dict")
      .def("__getattr__", &Result::field)
      .def("__repr__",
           [](const Result& result) { return py::str("<{}>").format(result.one_line()); })
      .def("__str__", &Result::text, "the report as the program prints it")
      .def("_repr_html_", &Result::html)
      .def("__dir__", [](const py::object& self) {
        const auto own = py::module_::import("builtins").attr("object").attr("__dir__")(self);
        return own + py::list(self.attr("report"));
      });
}

}  // namespace stillpoint::python
