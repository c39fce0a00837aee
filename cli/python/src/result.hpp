// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/answers/answer.hpp>
#include <stillpoint/figures/html_page.hpp>
#include <stillpoint/report/document.hpp>

#include <pybind11/numpy.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <utility>

namespace stillpoint::python {

/// What a command found. Its report is made when it is read.
class Result {
 public:
  Result() = default;
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;
  Result(Result&&) = delete;
  Result& operator=(Result&&) = delete;
  virtual ~Result() = default;

  [[nodiscard]] virtual nlohmann::ordered_json json() const = 0;
  [[nodiscard]] virtual report::Document document() const = 0;
  [[nodiscard]] virtual figures::HtmlPage page() const = 0;

  /// The JSON as a dict, always the same one.
  [[nodiscard]] const pybind11::dict& report();
  [[nodiscard]] pybind11::object field(const std::string& name);
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string one_line() const;
  [[nodiscard]] std::string html() const;

 protected:
  /// The verdict alone.
  [[nodiscard]] figures::HtmlPage page_without_figures() const;

 private:
  pybind11::dict report_{pybind11::reinterpret_steal<pybind11::dict>(nullptr)};
};

/// What the program answers.
class Answered : public Result {
 public:
  explicit Answered(std::unique_ptr<answers::Answer> answer) : answer_(std::move(answer)) {}

  [[nodiscard]] nlohmann::ordered_json json() const override { return answer_->json(); }
  [[nodiscard]] report::Document document() const override { return answer_->document(); }
  [[nodiscard]] figures::HtmlPage page() const override { return answer_->page(); }

 protected:
  [[nodiscard]] const answers::Answer& answer() const { return *answer_; }

 private:
  std::unique_ptr<answers::Answer> answer_;
};

void add_result(pybind11::module_& module);

}  // namespace stillpoint::python
