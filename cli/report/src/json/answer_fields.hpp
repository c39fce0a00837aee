// SPDX-License-Identifier: MIT
#pragma once

// The report of a design or a region, the same of hits, pulses and records: what answer.cpp tells
// in a table of fields. What an answer does not have is empty.

#include "choices.hpp"
#include "json/head_fields.hpp"
#include "sections.hpp"

#include <stillpoint/core/interval.hpp>
#include <stillpoint/design/hits.hpp>
#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/works_for.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::report {

using IfReal = std::optional<double>;
using IfRange = std::optional<Interval>;
using Name = std::optional<std::string>;

/// What was asked for.
struct AskedTask {
  IfReal v0{};
  IfRange v0_range{};
  IfReal p{};
  IfRange p_range{};
  IfReal beta{};
  std::optional<design::Criterion> criterion{};
  std::optional<std::int64_t> arrivals{};
  IfReal residual{};
  double tolerance{0};
  IfRange tolerance_f{};
  IfRange tolerance_delta{};
  IfRange tolerance_width{};
  IfRange tolerance_period{};
  design::Limits limits{};
  IfReal jump_max{};
  std::optional<std::string_view> pulse{};
  IfReal k{};
  IfRange k_range{};
  IfReal lambda{};
  IfRange lambda_range{};
  IfRange f_range{};
  IfRange delta_range{};
  IfRange notch_width_range{};
  IfReal f{};
  IfReal delta{};
  IfReal hold{};
  IfReal notch_width{};
  std::optional<std::string_view> objective{};
  Name algorithm{};
  Name catalogue{};
  std::optional<std::int64_t> trade_off{};
};

/// The dampers that the answer is about: the sides of a box that are not exact.
struct ShownBox {
  IfRange f{};
  IfRange delta{};
  IfRange p{};
  IfRange period{};  ///< in tau
  IfRange width{};
  std::optional<std::int64_t> samples{};
  bool exact{true};
};

struct BoxedDamper : design::SuiteDamper {
  Name name{};
  IfReal tolerance{};
  IfRange tolerance_f{};
  IfRange tolerance_delta{};
  std::optional<std::int64_t> arrival{};
  ShownBox box{};
};

/// The damper of a box, and the motion, that have the worst of a figure.
struct WorstAt : design::SuiteDamper {
  Name motion{};
};
struct WorstOf {
  std::optional<WorstAt> peak{};
  std::optional<WorstAt> acceleration{};
  std::optional<WorstAt> residual{};
  std::optional<WorstAt> stop_time{};
  std::optional<WorstAt> jump{};
};
/// The figures of several motions, or of several dampers.
struct Worst {
  IfReal peak{};
  IfReal acceleration{};
  IfReal residual{};
  IfReal stop_time{};
  IfReal jump{};
};
struct WorstInBox : Worst {
  WorstOf of{};
};

/// A motion under a load.
struct ShownLoaded {
  std::string what;
  IfReal v0{};
  IfReal p{};
  IfReal k{};
  IfReal lambda{};
  IfReal scale{};
  IfReal pga{};
  std::optional<bool> from_inside{};
  ShownResponse response;
  std::optional<TwinsSi> physical{};
};

struct ShownLoad {
  std::string_view type;
  std::optional<std::size_t> records{};
};
struct ShownCase {
  Name name{};
  ShownLoad load;
  std::optional<design::Combine> combine{};
  std::optional<Worst> nominal{};
  std::optional<WorstInBox> worst{};
  std::vector<ShownLoaded> motions{};
};

struct ShownConstraint {
  Name of_case{};
  std::string_view name;
  std::string_view variable;
  std::string_view relation;
  IfReal value{};
  double limit{0};
  IfReal slack{};
  bool satisfied{false};
  Name motion{};

  /// Of a length, empty of anything else.
  [[nodiscard]] IfReal length(const IfReal& of) const;
};
struct ShownMend {
  Name of_case{};
  std::string_view input;
  double value{0};
};

struct ShownServed : design::WorksFor {
  bool of_pulse{false};
};

struct ShownPart {
  const design::RatedPart& rated;
  ShownTask task;
};

struct ShownNotch {
  IfReal friction{};
  bool changes_nothing{false};
  ShownLoaded motion;
  std::optional<ShownLoaded> from_start{};
  std::optional<ShownLoaded> farthest{};
  std::optional<ShownLoaded> peak{};
  std::optional<ShownLoaded> felt{};
};

struct Scan {
  std::int64_t points{0};
  std::int64_t feasible{0};
};
struct ShownSearch {
  std::string_view library;
  std::string version;
  std::string algorithm;
  std::string status;
  std::int64_t evaluations{0};
  double wall_time_s{0};
  Optimum optimum{};
  std::optional<Scan> scan{};
  bool interrupted{false};
};

struct ShownCheckMethod {
  std::string_view name;
  double tolerance{0};
  double relative_error{0};
  double wall_time_s{0};
  bool decided{true};
  bool passed{false};
  const design::MotionFigures* figures{nullptr};
  std::optional<std::vector<design::SuiteCheckRow>> motions{};
};
struct ShownCheck {
  bool passed{false};
  std::vector<ShownCheckMethod> methods{};
};

struct Nearest {
  design::SuiteDamper damper;
  std::optional<Worst> worst{};
};

struct ShownAnswer {
  const Physical& units;
  std::span<const design::Finding> findings{};
  std::string verdict{};
  AskedTask input{};
  std::optional<BoxedDamper> design{};
  std::vector<ShownCase> cases{};
  std::vector<ShownConstraint> constraints{};
  std::optional<bool> admissible{};
  IfReal delta1_published{};
  IfReal delta1_exact{};
  const design::RegionVerdict* region{nullptr};
  std::optional<std::vector<design::Strip>> strips{};
  IfReal largest_tolerance{};
  std::vector<ShownMend> mends{};
  std::optional<Nearest> nearest{};
  std::optional<ShownServed> works_for{};
  std::optional<std::vector<design::Hits>> hits{};
  std::optional<ShownPractice> practice{};
  std::optional<ShownPractice> practice_worst{};
  const design::PulseCheck* pulse{nullptr};
  std::optional<ShownNotch> built_notch{};
  std::optional<std::vector<ShownPart>> catalogue{};
  std::optional<std::vector<design::TradeOff>> trade_off{};
  std::optional<design::SuiteOutlook> outlook{};
  std::optional<ShownSearch> search{};
  std::optional<ShownCheck> cross_check{};
  std::optional<AnswerSi> physical{};
};
/// By the name of the schema.
struct DesignAnswer : ShownAnswer {};
struct RegionAnswer : ShownAnswer {};

/// Of a hit or a pulse; without its answer.
[[nodiscard]] AskedTask asked_task(const ShownTask& task);
[[nodiscard]] ShownLoad load_of(const ShownTask& task);
/// In which the damper keeps every requirement, as its corners prove, or a scan of a pulse's
/// ranges.
[[nodiscard]] BoxedDamper boxed_damper(const ShownTask& task, double f, double delta);
[[nodiscard]] std::vector<ShownConstraint> shown_constraints(
    std::span<const design::Constraint> constraints);
[[nodiscard]] std::vector<ShownMend> shown_mends(std::span<const design::Mend> mends);
[[nodiscard]] std::optional<TwinsSi> twins_of(const Physical& physical,
                                              const ShownResponse& response);
/// What the hit or pulse of a motion is.
[[nodiscard]] ShownLoaded loaded(const ShownTask& task, double v0,
                                 const std::optional<design::Pulse>& pulse, double p,
                                 const ShownResponse& response);
/// Over the box that was asked for, as far as it is known from the motion of the damper itself, or
/// from the `worst` of ranges.
void add_worst(ShownCase& now, const ShownTask& task, const BoxedDamper& damper,
               const std::optional<design::PulseWorst>& worst);
/// Of a hit or a pulse, the rest of a point's answer.
void add_point(ShownAnswer& answer, const ShownTask& task, const IfReal& f, const IfReal& delta,
               const std::optional<design::Practice>& practice, const Response* response);
void add_catalogue(ShownAnswer& answer, const std::optional<Catalogue>& catalogue,
                   const ShownTask& task);

[[nodiscard]] ShownAnswer shown(const DesignReport& report);
[[nodiscard]] ShownAnswer shown(const RegionReport& report);
[[nodiscard]] ShownAnswer shown(const RecordDesignReport& report);

/// The factors of one side of a tolerance box; empty if the box has the usual shape.
[[nodiscard]] IfRange side_of(const design::BoxShape& shape, double tolerance, double below,
                              double above);
/// The period of the spring alone, in tau.
[[nodiscard]] double turn(double p);

}  // namespace stillpoint::report
