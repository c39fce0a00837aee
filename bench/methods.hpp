// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/reference.hpp>

#include <functional>
#include <string>
#include <vector>

namespace stillpoint::bench {

/// A method, and its description for readers.
struct Method {
  std::string name;              ///< "RK4"
  std::string what;              ///< one sentence: what it is and how it was used
  std::string knob;              ///< the name of its setting; empty if it has none
  bool rival{false};             ///< the speed ratio is taken against it
  std::vector<double> settings;  ///< for this scene, the coarsest first
  std::function<peers::Result(const peers::Scene&, double setting)> run;
};

/// GSL's rk8pd (Prince and Dormand), adaptive, with `tolerance` absolute and relative. It has no
/// dense output: events are sign changes over a step, then Newton's method within the
/// bracket on shorter steps from its start.
[[nodiscard]] peers::Result gsl_rk8pd(const peers::Scene& scene, double tolerance);

/// SUNDIALS CVODE 6, where it is installed: Adams with fixed-point iteration, as its manual advises
/// for problems that are not stiff. CVodeRootInit finds events in the given directions; CVodeReInit
/// after each; stop times at kinks.
[[nodiscard]] peers::Result cvode_adams(const peers::Scene& scene, double tolerance);

/// Every method with its settings for a scene, this project's kernel first.
[[nodiscard]] std::vector<Method> methods(const peers::ReferenceScene& scene);

}  // namespace stillpoint::bench
