#pragma once

#include <string>
#include <vector>

namespace secular::report {

/// Numbers that belong together, with their joint error.
struct JointValues {
  std::vector<std::string> names, units;
  std::vector<double> values, sd;
  std::vector<std::vector<double>> correlation;  ///< [value][value]
};

/// One <svg> element: below the diagonal every pair's ellipses of 68 % and 95 % of a joint normal distribution,
/// above it their correlation as a number, on it name and value. Axes run from three standard deviations below the
/// value to three above. Colours follow the page. Throws std::invalid_argument where sizes differ.
std::string pairs_plot(const JointValues& joint, const std::string& title);

}  // namespace secular::report
