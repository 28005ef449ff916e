#include "measure/formats/uff_frf.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "measure/formats/uff_units.hpp"
#include "measure/formats/unit.hpp"

namespace secular {
namespace {

constexpr int frequency_response_type = 4, transmissibility_type = 5, spectrum_type = 12;

bool rotates(const UffPoint& point) {
  return std::abs(static_cast<long long>(point.direction)) >= 4;
}

bool same_frequencies(const UffFunction& a, const UffFunction& b) {
  return a.even == b.even && a.count == b.count && a.start == b.start && a.rate == b.rate &&
         a.uneven_abscissa == b.uneven_abscissa && a.abscissa.unit == b.abscissa.unit;
}

DataVariable frequency_variable(std::string name, const UffFunction& function, bool read) {
  DataVariable frequency{std::move(name), {function.count}, "frequency", {}, {}};
  frequency.stated_unit = function.abscissa.unit.empty() ? "Hz" : function.abscissa.unit;
  if (!read) return frequency;
  frequency.values = function.uneven_abscissa;
  if (function.even)
    for (std::size_t i = 0; i < function.real.size(); ++i)
      frequency.values.push_back(function.start + static_cast<double>(i) / function.rate);
  return frequency;
}

}  // namespace

bool is_frequency_function(const UffFunction& function) {
  return is_complex(function.ordinate) && function.count > 0 &&
         (function.type == frequency_response_type || function.type == transmissibility_type ||
          function.type == spectrum_type);
}

void add_frequency_functions(const std::vector<UffFunction>& functions, const std::vector<std::string>& names,
                             const std::function<bool(const std::string&)>& wanted,
                             std::vector<DataVariable>& variables) {
  const auto first = std::find_if(functions.begin(), functions.end(), is_frequency_function);
  if (first == functions.end()) return;
  const bool shared = std::all_of(functions.begin(), functions.end(), [&](const UffFunction& function) {
    return !is_frequency_function(function) || same_frequencies(*first, function);
  });
  if (shared) variables.push_back(frequency_variable("f", *first, wanted("f")));
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const UffFunction& function = functions[i];
    if (!is_frequency_function(function)) continue;
    if (!shared) variables.push_back(frequency_variable(names[i] + ".f", function, wanted(names[i] + ".f")));
    const std::optional<UffMeaning> over = ordinate_meaning(function.numerator, rotates(function.response)),
                                    under = ordinate_meaning(function.denominator, rotates(function.reference));
    const double factor = (over ? over->si_factor : 1) / (under ? under->si_factor : 1);
    for (const bool imaginary : {false, true}) {
      DataVariable part{names[i] + (imaginary ? ".im" : ".re"),
                        {function.count},
                        std::string(function.type == spectrum_type ? "spectrum" : frequency_response) +
                            (is_double(function.ordinate) ? " double" : " single"),
                        {},
                        {}};
      part.stated_unit = function.numerator.unit;
      if (over) {
        part.quantity = over->quantity;
        part.unit = si_unit(over->quantity);
      }
      if (wanted(part.name)) {
        part.values = imaginary ? function.imaginary : function.real;
        for (double& value : part.values) value *= factor;
      }
      variables.push_back(std::move(part));
    }
  }
}

}  // namespace secular
