// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/html_page.hpp>
#include <stillpoint/report/document.hpp>
#include <stillpoint/report/report.hpp>

#include <nlohmann/json.hpp>

#include <memory>
#include <utility>

namespace stillpoint::answers {

/// What a command found, for users other than the program. Its report is made when it is read.
class Answer {
 public:
  Answer() = default;
  Answer(const Answer&) = delete;
  Answer& operator=(const Answer&) = delete;
  virtual ~Answer() = default;

  [[nodiscard]] virtual nlohmann::ordered_json json() const = 0;
  [[nodiscard]] virtual report::Document document() const = 0;
  [[nodiscard]] virtual figures::HtmlPage page() const = 0;
};

/// For a report that has json() and document().
template <class Report>
class AnswerOf : public Answer {
 public:
  explicit AnswerOf(Report report) : report_(std::move(report)) {}

  [[nodiscard]] nlohmann::ordered_json json() const override {
    using report::json;
    return json(report_);
  }
  [[nodiscard]] report::Document document() const override {
    using report::document;
    return document(report_, report::Verbosity::normal);
  }
  [[nodiscard]] figures::HtmlPage page() const override {
    using report::page;
    return page(report_);
  }

  [[nodiscard]] const Report& made() const { return report_; }

 private:
  Report report_;
};

template <class Report>
[[nodiscard]] std::unique_ptr<Answer> answer_of(Report report) {
  return std::make_unique<AnswerOf<Report>>(std::move(report));
}

}  // namespace stillpoint::answers
