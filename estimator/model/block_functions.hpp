#pragma once

#include <cstddef>

#include "estimator/model/batch_arrays.hpp"
#include "estimator/model/complex_number.hpp"
#include "estimator/model/dual_number.hpp"
#include "estimator/model/pair_number.hpp"

/// Rows of a block, their slopes and its part of the modulation equations, from what is generated of it: `factors`,
/// which are functions of the frequencies, `row`, whose columns are linear in them, and of modulation equations
/// `slopes`, the derivatives of the sum of lumps times columns by the amplitudes and by their conjugates.
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

/// Factors of blocks that vary are made for so many observations at once, as a table [factor][observation].
inline constexpr std::size_t factors_at_once = 64;

struct BlockFunctions {
  std::size_t modes = 0, excitations = 0, columns_count = 0;
  /// columns[j][observation] of `data`; arrays overlap neither one another nor the data.
  void (*columns)(const BatchArrays& data, double* const* columns) = nullptr;
  /// Their derivatives by the natural frequency of a mode; none: they are zero.
  void (*column_slopes)(const BatchArrays& data, std::size_t mode, double* const* columns) = nullptr;
  /// rate = sum of lump[j] * column j at one point: real and imaginary part. Of modulation blocks.
  void (*rate)(const double* lump, const BatchArrays& point, double* rate) = nullptr;
  /// Its derivatives by Cartesian amplitudes, [2][2 * modes].
  void (*rate_by_amplitude)(const double* lump, const BatchArrays& point, double* slopes) = nullptr;
};

/// The functions of one block; `Model` holds what its blocks share: sizes, Frequencies, Signals.
template <class Model, class Block>
struct BlockCode {
  static constexpr std::size_t modes = Model::modes, excitations = Model::excitations;

  static void columns(const BatchArrays& data, double* const* columns) { fill(data, columns, factors); }

  static void column_slopes(const BatchArrays& data, std::size_t mode, double* const* columns) {
    fill(data, columns,
         [mode](const double* natural, const double* const* excitation, std::size_t count, double* factor) {
           factor_slopes(natural, excitation, count, mode, factor);
         });
  }

  // Columns with the factors that make(natural frequencies, excitation frequencies, count, factors) gives.
  template <class Make>
  static void fill(const BatchArrays& data, double* const* columns, const Make& make) {
    if constexpr (Block::varies) {
      double factor[Block::factors_count * factors_at_once];
      const double *amplitude[modes], *forcing[excitations], *excitation[excitations];
      double* column[Block::columns];
      for (std::size_t first = 0; first < data.count; first += factors_at_once) {
        const std::size_t rest = data.count - first, count = rest < factors_at_once ? rest : factors_at_once;
        for (std::size_t k = 0; k < modes; ++k) amplitude[k] = data.amplitude[k] + 2 * first;
        for (std::size_t j = 0; j < excitations; ++j) {
          if constexpr (Block::forced) forcing[j] = data.forcing[j] + 2 * first;
          excitation[j] = data.excitation_frequency[j] + first;
        }
        for (std::size_t j = 0; j < Block::columns; ++j) column[j] = columns[j] + 2 * first;
        make(data.natural_frequency, excitation, count, factor);
        multiply({count, data.natural_frequency, excitation, amplitude, forcing}, factor, column);
      }
    } else {
      double factor[Block::factors_count];
      make(data.natural_frequency, data.excitation_frequency, 1, factor);
      multiply(data, factor, columns);
    }
  }

  static void factors(const double* natural_frequency, const double* const* excitation_frequency,
                      [[maybe_unused]] std::size_t count, double* factor) {
    if constexpr (Block::varies) {
      PairNumber natural[modes], excitation[excitations];
      for (std::size_t k = 0; k < modes; ++k) natural[k] = natural_frequency[k];
      for (std::size_t i = 0; i < count; i += 2) {
        const std::size_t next = load_pairs(excitation_frequency, i, count, excitation);
        const auto list = Block::factors(typename Model::template Frequencies<PairNumber>(natural, excitation));
        for (std::size_t t = 0; t < Block::factors_count; ++t) store_pair(list.number[t], i, next, t, factor);
      }
    } else {
      const double excitation[excitations + 1] = {};
      const auto list = Block::factors(typename Model::template Frequencies<double>(natural_frequency, excitation));
      for (std::size_t t = 0; t < Block::factors_count; ++t) factor[t] = list.number[t];
    }
  }

  static void factor_slopes(const double* natural_frequency, const double* const* excitation_frequency,
                            std::size_t count, std::size_t mode, double* factor) {
    using Dual = DualNumber<PairNumber>;
    PairNumber pairs[excitations + 1];
    Dual natural[modes], excitation[excitations + 1];
    for (std::size_t k = 0; k < modes; ++k) natural[k] = natural_frequency[k];
    natural[mode].slope = 1.0;
    for (std::size_t i = 0; i < (Block::varies ? count : 1); i += 2) {
      std::size_t next = i;
      if constexpr (Block::varies) {
        next = load_pairs(excitation_frequency, i, count, pairs);
        for (std::size_t j = 0; j < excitations; ++j) excitation[j].value = pairs[j];
      }
      const auto list = Block::factors(typename Model::template Frequencies<Dual>(natural, excitation));
      for (std::size_t t = 0; t < Block::factors_count; ++t) store_pair(list.number[t].slope, i, next, t, factor);
    }
  }

  // Of observations i and the next, which it gives: i itself where it is the last one.
  static std::size_t load_pairs(const double* const* excitation_frequency, std::size_t i, std::size_t count,
                                PairNumber* excitation) {
    const std::size_t next = i + 1 < count ? i + 1 : i;
    for (std::size_t j = 0; j < excitations; ++j)
      excitation[j] = PairNumber(excitation_frequency[j][i], excitation_frequency[j][next]);
    return next;
  }
  static void store_pair(PairNumber value, std::size_t i, std::size_t next, std::size_t t, double* factor) {
    constexpr std::size_t width = Block::varies ? factors_at_once : 1;
    factor[t * width + i] = value[0];
    factor[t * width + next] = value[next - i];
  }

  [[gnu::noinline]] static void multiply(const BatchArrays& data, const double* factor, double* const* columns) {
    using Complex = ComplexNumber<Pair>;
    // Own copies: what is stored could else be taken for them.
    const double *amplitude[modes], *forcing[excitations + 1];
    double* column[Block::columns];
    Pair factors[Block::factors_count];
#pragma GCC unroll 8
    for (std::size_t k = 0; k < modes; ++k) amplitude[k] = data.amplitude[k];
#pragma GCC unroll 8
    for (std::size_t j = 0; j < excitations && Block::forced; ++j) forcing[j] = data.forcing[j];
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
    ComplexNumber<double> value[Block::columns], sum;
    const PointValues at(point);
    Block::row(at.signals, at.factor, value);
    for (std::size_t j = 0; j < Block::columns; ++j) sum = sum + lump[j] * value[j];
    result[0] = sum.real;
    result[1] = sum.imag;
  }

  // With a function f of B and conj(B): d/dRe(B) = df/dB + df/dconj(B), d/dIm(B) = i*(df/dB - df/dconj(B)).
  static void rate_by_amplitude(const double* lump, const BatchArrays& point, double* slopes) {
    ComplexNumber<double> by[modes], by_conjugate[modes];
    const PointValues at(point);
    Block::slopes(at.signals, at.factor, lump, by, by_conjugate);
    for (std::size_t k = 0; k < modes; ++k) {
      const ComplexNumber<double> sum = by[k] + by_conjugate[k], difference = by[k] - by_conjugate[k];
      slopes[2 * k] = sum.real;
      slopes[2 * k + 1] = -difference.imag;
      slopes[2 * modes + 2 * k] = sum.imag;
      slopes[2 * modes + 2 * k + 1] = difference.real;
    }
  }

  // Signals and factors at one point.
  struct PointValues {
    typename Model::template Signals<double> signals;
    double factor[Block::factors_count];

    explicit PointValues(const BatchArrays& point) : signals(signals_of(point)) {
      double excitation[excitations + 1];
      for (std::size_t j = 0; j < excitations; ++j) excitation[j] = point.excitation_frequency[j][0];
      const auto list =
          Block::factors(typename Model::template Frequencies<double>(point.natural_frequency, excitation));
      for (std::size_t t = 0; t < Block::factors_count; ++t) factor[t] = list.number[t];
    }
    static typename Model::template Signals<double> signals_of(const BatchArrays& point) {
      ComplexNumber<double> a[modes], f[excitations + 1];
      for (std::size_t k = 0; k < modes; ++k) a[k] = load_complex(point.amplitude[k], 0);
      if constexpr (Block::forced)
        for (std::size_t j = 0; j < excitations; ++j) f[j] = load_complex(point.forcing[j], 0);
      return {a, f};
    }
  };
};

/// A block of harmonics.
template <class Model, class Block>
constexpr BlockFunctions harmonic_functions() {
  using Code = BlockCode<Model, Block>;
  BlockFunctions functions{Model::modes, Model::excitations, Block::columns, Code::columns};
  if constexpr (Block::moves_with_modes) functions.column_slopes = Code::column_slopes;
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
