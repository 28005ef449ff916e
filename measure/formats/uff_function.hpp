#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace secular {

/// One axis of a universal file's data set 58: its specific data type (8 displacement, 11 velocity, 12
/// acceleration, 13 excitation force, 17 time, ...), the exponents of its units, and its labels.
struct UffAxis {
  int data_type = 0;
  int length_exponent = 0, force_exponent = 0, temperature_exponent = 0;
  std::string label, unit;
};

/// Where a function was measured: 1, 2, 3 along x, y, z and 4, 5, 6 about them, negative against them, 0 scalar.
struct UffPoint {
  std::string entity;
  long long node = 0;
  int direction = 0;
};

enum class UffOrdinate { real_single = 2, real_double = 4, complex_single = 5, complex_double = 6 };

inline bool is_complex(UffOrdinate type) {
  return type == UffOrdinate::complex_single || type == UffOrdinate::complex_double;
}

inline bool is_double(UffOrdinate type) {
  return type == UffOrdinate::real_double || type == UffOrdinate::complex_double;
}

/// A data set 58, "function at nodal degree of freedom" (SDRC): one channel of a record.
struct UffFunction {
  std::array<std::string, 5> id_lines;
  int type = 1;  ///< 1 time response, 4 frequency response function, ...
  long long identification = 0, version = 0, load_case = 0;
  UffPoint response, reference;
  UffOrdinate ordinate = UffOrdinate::real_single;
  bool even = true;
  double start = 0;  ///< of an even abscissa
  double rate = 1;   ///< values for each unit of an even abscissa: meant_rate of the printed interval
  double z_value = 0;
  UffAxis abscissa, numerator, denominator, z;
  std::size_t count = 0;  ///< of values in the file it was read from
  std::vector<double> uneven_abscissa;
  std::vector<double> real, imaginary;  ///< `imaginary` of complex functions only
};

}  // namespace secular
