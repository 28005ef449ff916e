#pragma once

#include <cstddef>

#include "estimator/model/batch_arrays.hpp"
#include "estimator/model/complex_number.hpp"
#include "estimator/model/dual_number.hpp"
#include "estimator/model/pair_number.hpp"

/// Rows of a block, their slopes and its part of the modulation equations, from what is generated of it: `factors`,
/// which are functions of the frequencies, and `row`, whose columns are linear in them.
namespace secular {

/// What a block may depend on: its factors on natural frequencies and on those of excitations, its rows on
/// excitations.
enum BlockUses : unsigned { follows_modes = 1, follows_excitation = 2, is_forced = 4 };

/// Sizes of a block, and what it depends on.
template <std::size_t column_count, std::size_t factor_count, unsigned uses>
struct BlockShape {
  static constexpr std::size_t columns = column_count, factors_count = factor_count;
  static constexpr bool moves_with_modes = uses & follows_modes, varies = uses & follows_excitation,
                        forced = uses & is_forced;
};

/// A list of numbers as a value.
template <class Number, std::size_t count>
struct NumberList {
  Number number[count];
};

/// Factors of varying blocks are made for so many observations at once, as a table [factor][observation].
inline constexpr std::size_t factors_at_once = 64;

struct BlockFunctions {
  std::size_t modes = 0, excitations = 0, columns = 0, factors_count = 0;
  bool varies = false;
  /// Factors of the first `count` observations from their excitation frequencies: [factor], of a block that varies
  /// the table.
  void (*factors)(const double* natural_frequency, const double* const* excitation_frequency, std::size_t count,
                  double* factor) = nullptr;
  /// Their derivatives by the natural frequency of a mode; none: they are zero.
  void (*factor_slopes)(const double* natural_frequency, const double* const* excitation_frequency,
                        std::size_t count, std::size_t mode, double* factor) = nullptr;
  /// columns[j][observation] of `data` with these factors; arrays overlap neither one another nor the data.
  void (*multiply)(const BatchArrays& data, const double* factor, double* const* columns) = nullptr;
  /// rate = sum of lump[j] * column j at one point: real and imaginary part. Of modulation blocks.
  void (*rate)(const double* lump, const BatchArrays& point, double* rate) = nullptr;
  /// Its derivatives by Cartesian amplitudes, [2][2 * modes].
  void (*rate_by_amplitude)(const double* lump, const BatchArrays& point, double* slopes) = nullptr;
};

/// The functions of one block; `Model` holds what its blocks share: sizes, Frequencies, Signals.
template <class Model, class Block>
struct BlockCode {
  static constexpr std::size_t modes = Model::modes, excitations = Model::excitations;

  static void factors(const double* natural_frequency, const double* const* excitation_frequency,
                      [[maybe_unused]] std::size_t count, double* factor) {
    if constexpr (Block::varies) {
      PairNumber natural[modes], excitation[excitations];
      for (std::size_t k = 0; k < modes; ++k) natural[k] = natural_frequency[k];
      for (std::size_t i = 0; i < count; i += 2) {
        const std::size_t next = i + 1 < count ? i + 1 : i;
        for (std::size_t j = 0; j < excitations; ++j)
          excitation[j] = PairNumber(excitation_frequency[j][i], excitation_frequency[j][next]);
        const auto list = Block::factors(typename Model::template Frequencies<PairNumber>(natural, excitation));
        for (std::size_t t = 0; t < Block::factors_count; ++t) {
          factor[t * factors_at_once + i] = list.number[t][0];
          factor[t * factors_at_once + next] = list.number[t][next - i];
        }
      }
    } else {
      const double excitation[excitations + 1] = {};
      const auto list = Block::factors(typename Model::template Frequencies<double>(natural_frequency, excitation));
      for (std::size_t t = 0; t < Block::factors_count; ++t) factor[t] = list.number[t];
    }
  }

  static void factor_slopes(const double* natural_frequency, const double* const* excitation_frequency,
                            std::size_t count, std::size_t mode, double* factor) {
    using Dual = DualNumber<1>;
    Dual natural[modes], excitation[excitations + 1];
    for (std::size_t k = 0; k < modes; ++k) natural[k] = natural_frequency[k];
    natural[mode].slope[0] = 1;
    for (std::size_t i = 0; i < (Block::varies ? count : 1); ++i) {
      for (std::size_t j = 0; j < excitations && Block::varies; ++j) excitation[j] = excitation_frequency[j][i];
      const auto list = Block::factors(typename Model::template Frequencies<Dual>(natural, excitation));
      for (std::size_t t = 0; t < Block::factors_count; ++t)
        factor[Block::varies ? t * factors_at_once + i : t] = list.number[t].slope[0];
    }
  }

  static void multiply(const BatchArrays& data, const double* factor, double* const* columns) {
    using Complex = ComplexNumber<Pair>;
    // Own copies: what is stored could else be taken for them.
    const double *amplitude[modes], *forcing[excitations + 1];
    double* column[Block::columns];
    Pair factors[Block::factors_count];
#pragma GCC unroll 8
    for (std::size_t k = 0; k < modes; ++k) amplitude[k] = data.amplitude[k];
#pragma GCC unroll 8
    for (std::size_t j = 0; j < excitations; ++j) forcing[j] = data.forcing[j];
#pragma GCC unroll 64
    for (std::size_t j = 0; j < Block::columns; ++j) column[j] = columns[j];
#pragma GCC unroll 64
    for (std::size_t t = 0; t < Block::factors_count; ++t) factors[t] = Pair{factor[t], factor[t]};
    for (std::size_t i = 0; i < data.count; i += 2) {
      const std::size_t next = i + 1 < data.count ? i + 1 : i;
      Complex a[modes], f[excitations + 1], value[Block::columns];
#pragma GCC unroll 8
      for (std::size_t k = 0; k < modes; ++k) a[k] = Complex::load(amplitude[k], i, next);
      if constexpr (Block::forced) {
#pragma GCC unroll 8
        for (std::size_t j = 0; j < excitations; ++j) f[j] = Complex::load(forcing[j], i, next);
      }
      if constexpr (Block::varies) {
#pragma GCC unroll 64
        for (std::size_t t = 0; t < Block::factors_count; ++t)
          factors[t] = Pair{factor[t * factors_at_once + i], factor[t * factors_at_once + next]};
      }
      Block::row(typename Model::template Signals<Pair>(a, f), factors, value);
#pragma GCC unroll 64
      for (std::size_t j = 0; j < Block::columns; ++j) value[j].store(column[j], i, next);
    }
  }

  static void rate(const double* lump, const BatchArrays& point, double* result) {
    ComplexNumber<double> a[modes];
    for (std::size_t k = 0; k < modes; ++k) a[k] = load_complex(point.amplitude[k], 0);
    const ComplexNumber<double> sum = weighted(lump, point, a);
    result[0] = sum.real;
    result[1] = sum.imag;
  }

  static void rate_by_amplitude(const double* lump, const BatchArrays& point, double* slopes) {
    using Dual = DualNumber<2 * modes>;
    ComplexNumber<Dual> a[modes];
    for (std::size_t k = 0; k < modes; ++k)
      a[k] = ComplexNumber<Dual>(Dual::variable(point.amplitude[k][0], 2 * k),
                                 Dual::variable(point.amplitude[k][1], 2 * k + 1));
    const ComplexNumber<Dual> sum = weighted(lump, point, a);
    for (std::size_t z = 0; z < 2 * modes; ++z) {
      slopes[z] = sum.real.slope[z];
      slopes[2 * modes + z] = sum.imag.slope[z];
    }
  }

  // Sum of lump * column at one point with these amplitudes.
  template <class Number>
  static ComplexNumber<Number> weighted(const double* lump, const BatchArrays& point,
                                        const ComplexNumber<Number>* a) {
    using Complex = ComplexNumber<Number>;
    Complex f[excitations + 1], value[Block::columns], sum;
    if constexpr (Block::forced)
      for (std::size_t j = 0; j < excitations; ++j) f[j] = Complex(point.forcing[j][0], point.forcing[j][1]);
    double table[Block::factors_count * factors_at_once], factor[Block::factors_count];
    factors(point.natural_frequency, point.excitation_frequency, 1, table);
    for (std::size_t t = 0; t < Block::factors_count; ++t)
      factor[t] = table[Block::varies ? t * factors_at_once : t];
    Block::row(typename Model::template Signals<Number>(a, f), factor, value);
    for (std::size_t j = 0; j < Block::columns; ++j) sum = sum + lump[j] * value[j];
    return sum;
  }
};

/// A block of harmonics.
template <class Model, class Block>
constexpr BlockFunctions harmonic_functions() {
  using Code = BlockCode<Model, Block>;
  BlockFunctions functions{Model::modes,         Model::excitations, Block::columns,
                           Block::factors_count, Block::varies,      Code::factors};
  if constexpr (Block::moves_with_modes) functions.factor_slopes = Code::factor_slopes;
  functions.multiply = Code::multiply;
  return functions;
}

/// A block of modulation equations.
template <class Model, class Block>
constexpr BlockFunctions modulation_functions() {
  BlockFunctions functions = harmonic_functions<Model, Block>();
  functions.rate = BlockCode<Model, Block>::rate;
  functions.rate_by_amplitude = BlockCode<Model, Block>::rate_by_amplitude;
  return functions;
}

}  // namespace secular
