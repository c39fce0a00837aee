// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"
#include "specified.hpp"

#include <stillpoint/records/text.hpp>
#include <stillpoint/report/findings.hpp>
#include <stillpoint/texts/embedded.hpp>

#include <initializer_list>

namespace stillpoint::report {

namespace {

using design::Duty;

/// Per mass without one.
Unit stiffness_unit(const Physical& physical) {
  if (!physical) {
    return {};
  }
  const design::Scales& scales = physical->scales;
  const double per_mass = scales.gravity_m_per_s2 / scales.length_m;
  if (!has_mass(physical)) {
    return {per_mass, "1/s²"};
  }
  const double stiffness = *scales.mass_kg * per_mass;
  const Unit read = physical->inches ? read_in(physical, "N/m", stiffness) : Unit{1e-3, "kN/m"};
  return {stiffness * read, read.name};
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
    table.rows.push_back({{now.name.value_or("")}});
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
  specify_cases(sheet, of, "Stroke, speed and path", {{"case", "farthest under"}, {}},
                {{"stroke", units.length, duty(&Duty::stroke)},
                 {"worst stroke", units.length, duty(&Duty::stroke_worst)},
                 {"allowed", units.length, &SheetCase::allowed},
                 {"worst residual", units.length, worst(&Worst::residual)},
                 {"worst transmitted", {1, "g"}, worst(&Worst::acceleration)},
                 {"peak velocity", units.velocity, duty(&Duty::peak_velocity)},
                 {"slip path", units.length, duty(&Duty::most, &Energies::slip_path)}});
  specify_cases(
      sheet, of, "Energy and stiffness", {{"case"}, {}},
      {{"friction heat", units.energy, duty(&Duty::most, &Energies::friction)},
       {"notch", units.energy, duty(&Duty::most, &Energies::notch)},
       {"damping", units.energy,
        [](const SheetCase& now) {
          const double taken = now.duty->most.damping;
          return taken > 0 ? std::optional(taken) : std::nullopt;
        }},
       {"secant stiffness", stiffness_unit(of.physical), cycle(&FullCycle::secant_stiffness)},
       {"equivalent damping", {100, "%"}, cycle(&FullCycle::equivalent_damping)},
       {"taken by a cycle", units.energy, cycle(&FullCycle::energy)}});
}

void specify_limits(Document& sheet, const Specified& of) {
  Document limits;
  add_constraints(limits, of.answer.constraints, of.physical, of.of_constraints);
  if (limits.sections.empty()) {
    return;
  }
  Section& section = sheet.sections.emplace_back(limits.sections.front());
  section.heading = "Limits";
  for (const SheetCase& now : of.cases) {
    section.row(of.cases.size() == 1 ? "governs" : *now.name + " governed by", now.governs);
  }
}

void specify_practice(Document& sheet, const Specified& of) {
  Section& section = sheet.section("In practice");
  add_works_for(section, of.answer.works_for, of.physical);
  const design::Judged* const judged = of.answer.judged;
  if (judged == nullptr || !judged->practice) {
    return;
  }
  const design::Practice& now = judged->practice_worst.value_or(*judged->practice);
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
    return of_mass ? si_words(of.physical, *of_mass, "N s", few)
                   : units.velocity.words(speed) + " per mass";
  };
  if (now.impulse_at_stop && now.impulse_largest) {
    section.row("impulse", format("{} at the stop, at most {}", impulse(*now.impulse_at_stop),
                                  impulse(*now.impulse_largest)));
  }
}

void specify_checks(Document& sheet, const Specified& of) {
  Section& section = sheet.section("Checks");
  if (of.answer.cross_check != nullptr) {
    add_check(section, *of.answer.cross_check);
  }
  Document told;
  add_findings(told, of.answer.findings, of.physical);
  for (auto& part : told.answer.parts) {
    section.parts.push_back(std::move(part));
  }
}

/// What data/words/sheet.txt says of such a damper and such loads, under its headings.
void specify_rest(Document& sheet, const Specified& of) {
  const Oscillator& mass = of.cases.front().motion.oscillator;
  const auto forced = [](const SheetCase& now) { return is_forced(now.motion); };
  std::vector<design::FindingValue> holding;
  for (const auto& [name, holds] : std::initializer_list<std::pair<std::string_view, bool>>{
           {"undamped", mass.zeta == 0},
           {"damped", mass.zeta > 0},
           {"even", mass.breakaway == 1},
           {"notch", of.damper.delta > 0},
           {"hit", !std::ranges::all_of(of.cases, forced)},
           {"load", std::ranges::any_of(of.cases, forced)}}) {
    if (holds) {
      holding.push_back({name, std::string()});
    }
  }
  for (const std::string_view line : records::split(texts::embedded("words/sheet.txt"), '\n')) {
    if (line.starts_with("# ")) {
      sheet.section(std::string(line.substr(2)));
    } else {
      sheet.sections.back().line(filled(line, holding, of.physical));
    }
  }
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
      figure.title += alone ? "" : ": " + *now.name;
      constexpr double low = 190;
      figure.height = low;
      text += format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                     svg(figure, figures::Frame::in_page), figures::prose(figure.caption()));
    }
  }
  return text.empty() ? "" : "<div class=\"plates\">\n" + text + "</div>\n";
}

}  // namespace

std::string body(const Specified& of, const SheetFrame& frame) {
  constexpr std::size_t longest = 400;
  Document front;
  front.answer.line(of.answer.verdict, Tone::heading);
  specify_damper(front, of);
  specify_duties(front, of);
  specify_limits(front, of);
  Document back;
  specify_practice(back, of);
  specify_checks(back, of);
  specify_rest(back, of);
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

}  // namespace stillpoint::report
