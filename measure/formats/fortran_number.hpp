#pragma once

#include <optional>
#include <string_view>

namespace secular {

/// A number as Fortran writes it: exponents with D, exponents without a letter ("1.0-100"). A field of asterisks
/// (a number too wide for its field) and what C libraries print for NaN are NaN. Nothing for any other text.
std::optional<double> fortran_number(std::string_view text);

/// A whole number with blanks around it.
std::optional<long long> whole_number(std::string_view text);

/// Text without blanks, tabulators and line breaks at its ends.
std::string_view stripped(std::string_view text);

/// The sampling rate whose interval was printed as `text` with the value `step`. A printed interval is rounded:
/// 2.44141E-04 is that of 4096 Hz. Of the rates with fewer digits than the interval the shortest is meant.
double meant_rate(std::string_view text, double step);

/// The number of so many significant digits that is next to `value`.
double of_digits(double value, int digits);

}  // namespace secular
