#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measure/formats/data_file.hpp"
#include "measure/formats/uff_function.hpp"

namespace secular {

/// What DataVariable::type of a frequency response function begins with.
inline constexpr const char* frequency_response = "frequency response";

/// Whether a function is complex numbers over frequency: a frequency response function, a transmissibility or a
/// spectrum of lines.
bool is_frequency_function(const UffFunction& function);

/// Their variables: NAME.re and NAME.im, over SI units where the file says the units of numerator and denominator,
/// and f in Hz (NAME.f where frequencies differ). `names`: by function; values of those that are wanted.
void add_frequency_functions(const std::vector<UffFunction>& functions, const std::vector<std::string>& names,
                             const std::function<bool(const std::string&)>& wanted,
                             std::vector<DataVariable>& variables);

}  // namespace secular
