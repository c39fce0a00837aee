// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"
#include "sections.hpp"

#include <stillpoint/design/duty.hpp>
#include <stillpoint/records/decimal.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/report/findings.hpp>
#include <stillpoint/report/sheet.hpp>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <numbers>

namespace stillpoint::report {

namespace {

using design::Constraint;
using design::Duty;
using records::decimal;
using records::Rounding;

/// A case as it stands on the sheet.
struct SheetCase {
  std::string name;
  std::string under;  ///< the motion that moves the mass farthest
  Duty duty;
  std::optional<double> allowed;              ///< of the stroke
  std::optional<design::SuiteFigures> worst;  ///< of records and of several cases
  std::string governs;
  SimulationRequest motion;
};

/// A damper with all that is said of it.
struct Specified {
  const Physical& physical;
  std::string verdict;
  std::span<const design::Finding> findings;
  std::span<const Constraint> constraints;
  std::string_view of_constraints;
  const design::CrossCheck* check;
  const std::optional<design::WorksFor>& works_for;
  const design::Practice* practice;  ///< of ranges the worst
  design::SuiteDamper damper;
  Interval f, delta, width, p;  ///< of the tolerance
  std::string tolerance;
  std::vector<SheetCase> cases;
};

/// A value and its range, in a unit, with the digits that its tolerance deserves.
struct Column {
  std::string head;
  double value;
  Interval range;

  [[nodiscard]] bool exact() const { return !(range.low < range.high); }
  [[nodiscard]] int shown() const {
    constexpr int usual = 4;
    return exact() ? usual + 2 : interval_places(range.low, range.high);
  }
};

/// "0.260", "1250": all digits that an end deserves, of which the last may be zeros.
std::string padded(double rounded, int digits) {
  int places = digits - 1;
  for (double left = rounded; left >= 10; left /= 10) {
    --places;
  }
  for (double left = rounded; left > 0 && left < 1 && places < digits_of_double; left *= 10) {
    ++places;
  }
  return places < digits_of_double ? format("{:.{}f}", rounded, std::max(places, 0))
                                   : format("{:.{}g}", rounded, digits);
}

Column column(std::string_view name, const Unit& unit, double value, const Interval& range) {
  return {in(name, unit), value * unit, {range.low * unit, range.high * unit}};
}

bool has_mass(const Physical& physical) {
  return physical && physical->scales.mass_kg;
}

/// Friction over the weight has a force only with a mass; else it is one per mass.
Unit friction_unit(const Physical& physical) {
  return !physical            ? Unit{}
         : has_mass(physical) ? units_of(physical).force
                              : Unit{physical->scales.gravity_m_per_s2, "m/s²"};
}

/// Per mass without one.
Unit stiffness_unit(const Physical& physical) {
  if (!physical) {
    return {};
  }
  const design::Scales& scales = physical->scales;
  const double per_mass = scales.gravity_m_per_s2 / scales.length_m;
  return has_mass(physical) ? Unit{1e-3 * *scales.mass_kg * per_mass, "kN/m"}
                            : Unit{per_mass, "1/s²"};
}

Table damper_table(const Specified& of) {
  const FigureUnits units = units_of(of.physical);
  std::vector<Column> all{column(has_mass(of.physical) ? "friction force"
                                 : of.physical         ? "friction per mass"
                                                       : "friction f",
                                 friction_unit(of.physical), of.damper.f, of.f),
                          column(of.physical ? "notch energy" : "notch energy Δ", units.energy,
                                 of.damper.delta, of.delta)};
  if (of.p.low < of.p.high) {
    constexpr double turn = 2 * std::numbers::pi;
    all.push_back(column(of.physical ? "period" : "period τ", units.time, turn / of.damper.p,
                         {turn / of.p.high, turn / of.p.low}));
  }
  if (of.damper.width > 0) {
    all.push_back(column("notch width", units.length, of.damper.width, of.width));
  }
  Table table{{""}, {{{"nominal"}}}};
  if (!std::ranges::all_of(all, &Column::exact)) {
    table.rows = {{{"least"}}, {{"nominal"}}, {{"most"}}};
  }
  for (const Column& now : all) {
    table.head.push_back(now.head);
    for (TableRow& row : table.rows) {
      const std::string& which = row.cells.front();
      constexpr double conversion = 1e-12;  // the rounding of 25 mm to dimensionless and back
      const auto& [low, high] = now.range;
      const int shown = now.shown();
      row.cells.push_back(
          now.exact()
              ? format("{:.{}g}", now.value, shown)
              : padded(which == "least"  ? decimal(low * (1 - conversion), shown, Rounding::up)
                       : which == "most" ? decimal(high * (1 + conversion), shown, Rounding::down)
                                         : decimal(now.value, shown),
                       shown));
    }
  }
  return table;
}

void specify_damper(Document& sheet, const Specified& of) {
  Section& section = sheet.section("Damper", {damper_table(of)});
  const Oscillator& mass = of.cases.front().motion.oscillator;
  section.row("tolerance", of.tolerance);
  section.row("notch", of.damper.delta == 0 ? "none"
                       : of.damper.width > 0
                           ? "resists evenly within its width, by its energy over it"
                       : mass.hold ? format("at x = 0; lets go at {} above the friction",
                                            acceleration_shown(*mass.hold))
                                   : "at x = 0, where it holds the mass under any load");
  section.row("in the program", format("f = {:.6g}, delta = {}", of.damper.f,
                                       length_shown(of.physical, of.damper.delta)));
  section.row("spring", spring_words(of.physical, of.damper.p));
  if (const auto kg = of.physical ? of.physical->scales.mass_kg : std::nullopt) {
    constexpr double tonne = 1e3;
    section.row("mass", *kg < tonne ? format("{:.6g} kg", *kg) : format("{:.6g} t", *kg / tonne));
  }
  add_damping(section, mass);
}

/// A figure of each case.
struct CaseColumn {
  std::string_view name;
  Unit unit;
  std::function<std::optional<double>(const SheetCase&)> figure;
};

void specify_cases(Document& sheet, const Specified& of, std::string heading, Table table,
                   const std::vector<CaseColumn>& columns) {
  for (const SheetCase& now : of.cases) {
    table.rows.push_back({{now.name}});
    if (table.head.size() > 1) {
      table.rows.back().cells.push_back(now.under);
    }
  }
  for (const auto& [name, unit, figure] : columns) {
    table.head.push_back(in(name, unit));
    for (std::size_t i = 0; i < of.cases.size(); ++i) {
      const auto value = figure(of.cases[i]);
      table.rows[i].cells.push_back(value ? few_digits(*value * unit) : "");
    }
  }
  sheet.section(std::move(heading), {without_empty_columns(std::move(table))});
}

void specify_duties(Document& sheet, const Specified& of) {
  const FigureUnits units = units_of(of.physical);
  const auto duty = [](auto... part) { return stillpoint::in(&SheetCase::duty, part...); };
  const auto cycle = [&](auto part) { return duty(&Duty::cycle, part); };
  const auto worst = [](auto part) { return stillpoint::in(&SheetCase::worst, part); };
  using design::FullCycle;
  using design::SuiteFigures;
  specify_cases(sheet, of, "Stroke, speed and path", {{"case", "farthest under"}, {}},
                {{"stroke", units.length, duty(&Duty::stroke)},
                 {"worst stroke", units.length, duty(&Duty::stroke_worst)},
                 {"allowed", units.length, &SheetCase::allowed},
                 {"worst residual", units.length, worst(&SuiteFigures::residual)},
                 {"worst transmitted", {1, "g"}, worst(&SuiteFigures::acceleration)},
                 {"peak velocity", units.velocity, duty(&Duty::peak_velocity)},
                 {"slip path", units.length, duty(&Duty::most, &Energies::slip_path)}});
  specify_cases(
      sheet, of, "Energy and stiffness", {{"case"}, {}},
      {{"friction heat", units.energy, duty(&Duty::most, &Energies::friction)},
       {"notch", units.energy, duty(&Duty::most, &Energies::notch)},
       {"damping", units.energy,
        [](const SheetCase& now) {
          const double taken = now.duty.most.damping;
          return taken > 0 ? std::optional(taken) : std::nullopt;
        }},
       {"secant stiffness", stiffness_unit(of.physical), cycle(&FullCycle::secant_stiffness)},
       {"equivalent damping", {100, "%"}, cycle(&FullCycle::equivalent_damping)},
       {"taken by a cycle", units.energy, cycle(&FullCycle::energy)}});
}

void specify_limits(Document& sheet, const Specified& of) {
  Document limits;
  add_constraints(limits, of.constraints, of.physical, of.of_constraints);
  if (limits.sections.empty()) {
    return;
  }
  Section& section = sheet.sections.emplace_back(limits.sections.front());
  section.heading = "Limits";
  for (const SheetCase& now : of.cases) {
    section.row(of.cases.size() == 1 ? "governs" : now.name + " governed by", now.governs);
  }
}

void specify_practice(Document& sheet, const Specified& of) {
  Section& section = sheet.section("In practice");
  add_works_for(section, of.works_for, of.physical);
  if (of.practice == nullptr) {
    return;
  }
  const design::Practice& now = *of.practice;
  const FigureUnits units = units_of(of.physical);
  section.row("base shear", units.force.words(now.base_shear) +
                                (units.force.name.empty() ? " of the weight" : ""));
  if (now.energy_ratio && now.residual_ratio) {
    section.row("re-centring", format("energy ratio {:.4g} (EN 15129), residual ratio {:.4g} (EN "
                                      "1998-2)",
                                      *now.energy_ratio, *now.residual_ratio));
  }
  const auto impulse = [&](double speed) {
    const auto of_mass = of.physical ? of.physical->scales.impulse_n_s(speed) : std::nullopt;
    constexpr int few = 4;
    return of_mass ? with_unit(*of_mass, "N s", few) : units.velocity.words(speed) + " per mass";
  };
  if (now.impulse_at_stop && now.impulse_largest) {
    section.row("impulse", format("{} at the stop, at most {}", impulse(*now.impulse_at_stop),
                                  impulse(*now.impulse_largest)));
  }
}

void specify_checks(Document& sheet, const Specified& of) {
  Section& section = sheet.section("Checks");
  if (of.check != nullptr) {
    add_check(section, *of.check);
  }
  Document told;
  add_findings(told, of.findings, of.physical);
  for (auto& part : told.answer.parts) {
    section.parts.push_back(std::move(part));
  }
}

/// Those that hold.
using Sentences = std::initializer_list<std::pair<bool, std::string_view>>;
void specify(Document& sheet, std::string heading, const Sentences& all) {
  Section& section = sheet.section(std::move(heading));
  for (const auto& [holds, text] : all) {
    if (holds) {
      section.line(std::string(text));
    }
  }
}

void specify_assumptions(Document& sheet, const Specified& of) {
  const Oscillator& mass = of.cases.front().motion.oscillator;
  const auto forced =
      std::ranges::count_if(of.cases, [](const SheetCase& now) { return is_forced(now.motion); });
  specify(sheet, "Assumptions",
          {{true, "One rigid mass moves in one direction on a linear spring."},
           {mass.zeta == 0, "There is no viscous damping."},
           {true,
            "The constant friction is the same whatever the speed, the pressure and the "
            "temperature. Their effect belongs to the tolerance."},
           {mass.breakaway == 1, "It is the same at rest and in motion."},
           {of.damper.delta > 0, "The notch takes the same energy at every passage through x = 0."},
           {static_cast<std::size_t>(forced) < of.cases.size(),
            "A hit is a velocity at x = 0, where the mass has left the notch. That is valid for "
            "pulses much shorter than the natural period."},
           {forced > 0, "Under a pulse or a record the mass starts at rest at x = 0."},
           {true, "Nothing stops the mass at the stroke limit: farther out the motion goes on."},
           {true, "Each later load starts where the mass came to rest after the one before."}});
}

void specify_meanings(Document& sheet, const Specified& of) {
  specify(sheet, "What the figures mean",
          {{true,
            "Friction acts wherever the mass slides; each passage through x = 0 costs the notch "
            "energy besides. Least and most are the ends of the tolerance, rounded inwards."},
           {true,
            "The stroke is of the nominal damper, the worst stroke of any damper within the "
            "tolerance. Velocity, path and energies are of the nominal damper up to its rest, of "
            "several motions each the largest. Friction heat is friction times the slip path."},
           {true,
            "The secant stiffness is the force of spring and friction at the stroke over the "
            "stroke. The equivalent damping is what one full cycle between plus and minus the "
            "stroke takes, over 2 pi times secant stiffness times stroke squared: four strokes "
            "of friction and two passages of the notch. The motion here is no such cycle: use it "
            "to compare devices."},
           {of.cases.front().motion.oscillator.zeta > 0,
            "Viscous damping in it is at the frequency of the secant stiffness."}});
}

/// Where it does not fit, the page is longer.
std::string task_html(const SheetFrame& frame) {
  return format(
      "<section><h2>Task</h2>\n<p>Saved as <code>scene.json</code>, <code>stillpoint {} "
      "scene.json</code> gives these numbers.</p>\n<pre>{}</pre></section>\n",
      frame.command, figures::escaped(frame.scene));
}

std::string plates(const Specified& of) {
  constexpr std::size_t most = 4;
  const FigureUnits units = units_of(of.physical);
  const bool alone = of.cases.size() == 1;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, of.cases.size()); ++i) {
    const SheetCase& now = of.cases[i];
    DrawnMotion motion(design::shown_motion(now.motion));
    if (!motion.moves()) {
      continue;
    }
    std::vector<Figure> all{loop_figure(now.motion.excitation, motion, units)};
    if (alone) {
      motion.beta = now.allowed;
      all.push_back(motion_figure(motion, units));
    }
    for (Figure& figure : all) {
      figure.id = format("sheet-{}-{}", figure.id, i + 1);
      figure.title += alone ? "" : ": " + now.name;
      constexpr double low = 190;
      figure.height = low;
      text += format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                     svg(figure, figures::Frame::in_page), figures::prose(figure.caption()));
    }
  }
  return text.empty() ? "" : "<div class=\"plates\">\n" + text + "</div>\n";
}

std::string body(const Specified& of, const SheetFrame& frame) {
  constexpr std::size_t longest = 400;
  Document front;
  front.answer.line(of.verdict, Tone::heading);
  specify_damper(front, of);
  specify_duties(front, of);
  specify_limits(front, of);
  Document back;
  specify_practice(back, of);
  specify_checks(back, of);
  specify_assumptions(back, of);
  specify_meanings(back, of);
  const std::string title =
      frame.title.empty() ? "Friction damper" : records::printable(frame.title, longest);
  return format(
             "<h1>{}</h1>\n<p class=\"stamp\"><span>Damper specification</span> <span>Revision "
             "{}</span> <span>{}</span> <span>Checked <i></i></span></p>\n",
             figures::prose(title),
             frame.revision.empty() ? "<i></i>"
                                    : figures::escaped(records::printable(frame.revision, longest)),
             frame.date) +
         html(front.answer) + html(front) + plates(of) + "<div class=\"notes\">\n" + html(back) +
         "</div>\n" + task_html(frame) + format("<footer>{}</footer>\n", version_line());
}

/// "12 % of the limit is left"
std::string governing_words(const Constraint* limit, const Physical& physical) {
  if (limit == nullptr) {
    return "nothing";
  }
  const auto& motion = limit->motion;
  return format("{}{}, {} left{}", requirement(*limit, units_of(physical)),
                limit->variable == "f" ? force_beside(physical, limit->limit) : "",
                part_words(part_left(*limit)),
                motion ? " under " + scaled_name(motion->file, motion->scale) : "");
}

/// Of hits and pulses.
std::string specified(const design::ShownDamper& shown, const Physical& physical,
                      std::string verdict, std::span<const design::Finding> findings,
                      const design::CrossCheck* check, const ShownTask& task,
                      const SheetFrame& frame) {
  const design::DesignPoint& point = shown.point;
  const design::DesignPoint granted = design::granted(point, shown.limits);
  const design::DamperBox box = box_about(granted, shown.limits.shape);
  const double width = shown.built != nullptr ? shown.built->shape.width.value_or(0) : 0;
  const bool asked = shown.limits.tolerance > 0;
  const design::Judged& judged = shown.judged;
  const auto& practice = judged.practice_worst ? judged.practice_worst : judged.practice;
  return body(
      {.physical = physical,
       .verdict = std::move(verdict),
       .findings = findings,
       .constraints = judged.constraints,
       .of_constraints = of_first_swing(task),
       .check = check,
       .works_for = judged.works_for,
       .practice = practice ? &*practice : nullptr,
       .damper = {shown.p(), point.f, point.delta, width},
       .f = box.f,
       .delta = box.delta,
       .width = {width, width},
       .p = {},
       .tolerance = format("{}: {}", tolerance_words(shown.limits, granted.tolerance, point.delta),
                           asked ? "what was asked for" : "the largest that keeps every limit"),
       .cases = {{{},
                  shown_motion(shown, physical),
                  duty_of(shown),
                  shown.problem.beta,
                  {},
                  governing_words(design::governing(judged.constraints), physical),
                  motion_of(shown)}}},
      frame);
}

}  // namespace

std::string sheet_date() {
  namespace chrono = std::chrono;
  auto now = chrono::floor<chrono::seconds>(chrono::system_clock::now()).time_since_epoch();
  if (const char* const fixed = std::getenv("SOURCE_DATE_EPOCH"); fixed != nullptr) {
    now = chrono::seconds(records::parse_integer("SOURCE_DATE_EPOCH", fixed));
  }
  const chrono::year_month_day date(chrono::sys_days(chrono::floor<chrono::days>(now)));
  return format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

std::optional<std::string> sheet(const DesignReport& report, const SheetFrame& frame) {
  const auto& found = report.result.finding;
  return found ? std::optional(specified(shown_damper(report.result, report.built_notch),
                                         report.physical, verdict(report), report.findings,
                                         &found->cross_check, task_of(report), frame))
               : std::nullopt;
}

std::optional<std::string> sheet(const RegionReport& report, const SheetFrame& frame) {
  const design::RegionAnswer& answer = report.answer;
  return answer.admissible.value_or(false) && answer.response
             ? std::optional(specified(shown_damper(report.request, answer), report.physical,
                                       verdict(report), report.findings, nullptr, task_of(report),
                                       frame))
             : std::nullopt;
}

std::optional<std::string> sheet(const RecordDesignReport& report, const SheetFrame& frame) {
  const design::RecordDesign& result = report.result;
  const auto& finding = result.finding;
  if (!finding || !finding->admissible) {
    return std::nullopt;
  }
  const design::RecordDesignRequest& task = result.request;
  const design::SuiteBox& box = finding->box;
  const std::vector<Duty> duties = duties_of(result);
  std::vector<SheetCase> cases;
  for (std::size_t c = 0; c < task.cases.size(); ++c) {
    const design::LoadCase& load_case = task.cases[c];
    const design::CaseMotion motion = motions_of(load_case)[duties[c].index];
    const auto limit = governing(result, c);
    cases.push_back({load_case.name, scaled_name(motion.name, motion.scale), duties[c],
                     load_case.limits.peak, box.worst[c],
                     governing_words(limit ? &limit->constraint : nullptr, report.physical),
                     motion_of(task, finding->point.damper, motion)});
  }
  return body(
      {.physical = report.physical,
       .verdict = verdict(report),
       .findings = result.findings,
       .constraints = result.constraints,
       .of_constraints = task.tolerance.exact() ? "" : "Each is the worst within the tolerance.",
       .check = &finding->cross_check,
       .works_for = finding->works_for,
       .practice = nullptr,
       .damper = finding->point.damper,
       .f = box.f,
       .delta = box.delta,
       .width = box.width,
       .p = box.p,
       .tolerance = box.samples > 1 ? box_words(box, true)
                    : result.largest_tolerance
                        ? format("none was asked for; the largest that was found is {}",
                                 percent_digits(*result.largest_tolerance))
                        : "none was asked for",
       .cases = std::move(cases)},
      frame);
}

}  // namespace stillpoint::report
