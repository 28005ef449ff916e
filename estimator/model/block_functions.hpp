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

/// Columns of two observations at a time.
template <class Model, class Block>
class ColumnPairs {
 public:
  __attribute__((always_inline)) ColumnPairs(const BatchArrays& data, const ComplexParts* columns) {
    // Own copies: what is stored could else be taken for them.
#pragma GCC unroll 8
    for (std::size_t k = 0; k < Model::modes; ++k) amplitude_[k] = data.amplitude[k];
#pragma GCC unroll 8
    for (std::size_t j = 0; j < Model::excitations && Block::forced; ++j) forcing_[j] = data.forcing[j];
#pragma GCC unroll 64
    for (std::size_t j = 0; j < Block::columns; ++j) column_[j] = columns[j];
  }
  __attribute__((always_inline)) void make(std::size_t i, std::size_t next, const Pair* factor) const {
    using Complex = ComplexNumber<Pair>;
    Complex a[Model::modes], f[Model::excitations + 1], value[Block::columns];
#pragma GCC unroll 8
    for (std::size_t k = 0; k < Model::modes; ++k) a[k] = Complex::load(amplitude_[k], i, next);
    if constexpr (Block::forced) {
#pragma GCC unroll 8
      for (std::size_t j = 0; j < Model::excitations; ++j) f[j] = Complex::load(forcing_[j], i, next);
    }
    Block::row(typename Model::template Signals<Pair>(a, f), factor, value);
#pragma GCC unroll 64
    for (std::size_t j = 0; j < Block::columns; ++j) value[j].store(column_[j], i, next);
  }

 private:
  const double *amplitude_[Model::modes], *forcing_[Model::excitations + 1];
  double* column_[Block::columns];
};

struct BlockFunctions {
  std::size_t columns_count = 0;
  /// columns[j][2 * observation] of `data`; arrays overlap neither one another nor the data.
  void (*columns)(const BatchArrays& data, const ComplexParts* columns) = nullptr;
  /// Their derivatives by the natural frequency of a mode; none: they are zero.
  void (*column_slopes)(const BatchArrays& data, std::size_t mode, const ComplexParts* columns) = nullptr;
  /// rate = sum of lump[j] * column j at one point: real and imaginary part. Of modulation blocks.
  void (*rate)(const double* lump, const BatchArrays& point, double* rate) = nullptr;
  /// Its derivatives by Cartesian amplitudes, [2][2 * modes].
  void (*rate_by_amplitude)(const double* lump, const BatchArrays& point, double* slopes) = nullptr;
};

/// Natural frequencies as numbers that carry no derivative, or that by one of them.
template <class Number, std::size_t modes>
struct FrequencyValues {
  using Frequency = Number;
  Number natural[modes];
  explicit FrequencyValues(const double* natural_frequency) {
    for (std::size_t k = 0; k < modes; ++k) natural[k] = natural_frequency[k];
  }
  static Number constant(Number value) { return value; }
  static Number result(Number value) { return value; }
};
template <class Number, std::size_t modes>
struct FrequencySlopes {
  using Frequency = DualNumber<Number>;
  Frequency natural[modes];
  FrequencySlopes(const double* natural_frequency, std::size_t mode) {
    for (std::size_t k = 0; k < modes; ++k) natural[k] = natural_frequency[k];
    natural[mode].slope = 1.0;
  }
  static Frequency constant(Number value) { return {value, 0.0}; }
  static Number result(const Frequency& value) { return value.slope; }
};

/// The functions of one block; `Model` holds what its blocks share: sizes, Frequencies, Signals.
template <class Model, class Block>
struct BlockCode {
  static constexpr std::size_t modes = Model::modes, excitations = Model::excitations;

  static void columns(const BatchArrays& data, const ComplexParts* columns) {
    if constexpr (Block::varies)
      fill(data, FrequencyValues<PairNumber, modes>(data.natural_frequency), columns);
    else
      repeat(data, FrequencyValues<double, modes>(data.natural_frequency), columns);
  }
  static void column_slopes(const BatchArrays& data, std::size_t mode, const ComplexParts* columns) {
    if constexpr (Block::varies)
      fill(data, FrequencySlopes<PairNumber, modes>(data.natural_frequency, mode), columns);
    else
      repeat(data, FrequencySlopes<double, modes>(data.natural_frequency, mode), columns);
  }

  // Where factors are the same for all observations.
  template <class Natural>
  static void repeat(const BatchArrays& data, const Natural& at, const ComplexParts* columns) {
    const typename Natural::Frequency excitation[excitations + 1] = {};
    const auto list =
        Block::factors(typename Model::template Frequencies<typename Natural::Frequency>(at.natural, excitation));
    Pair factor[Block::factors_count];
    for (std::size_t t = 0; t < Block::factors_count; ++t) {
      const double value = Natural::result(list.number[t]);
      factor[t] = Pair{value, value};
    }
    multiply(data, factor, columns);
  }
  [[gnu::noinline]] static void multiply(const BatchArrays& data, const Pair* factor, const ComplexParts* columns) {
    const ColumnPairs<Model, Block> rows(data, columns);
    Pair own[Block::factors_count];
#pragma GCC unroll 64
    for (std::size_t t = 0; t < Block::factors_count; ++t) own[t] = factor[t];
    for (std::size_t i = 0; i < data.count; i += 2) rows.make(i, i + 1 < data.count ? i + 1 : i, own);
  }

  // Where they differ.
  template <class Natural>
  static void fill(const BatchArrays& data, const Natural& at, const ComplexParts* columns) {
    const ColumnPairs<Model, Block> rows(data, columns);
    const double* frequency[excitations];
    for (std::size_t j = 0; j < excitations; ++j) frequency[j] = data.excitation_frequency[j];
    for (std::size_t i = 0; i < data.count; i += 2) {
      const std::size_t next = i + 1 < data.count ? i + 1 : i;
      typename Natural::Frequency excitation[excitations];
      for (std::size_t j = 0; j < excitations; ++j)
        excitation[j] = Natural::constant(PairNumber(frequency[j][i], frequency[j][next]));
      const auto list =
          Block::factors(typename Model::template Frequencies<typename Natural::Frequency>(at.natural, excitation));
      Pair factor[Block::factors_count];
#pragma GCC unroll 64
      for (std::size_t t = 0; t < Block::factors_count; ++t) factor[t] = Natural::result(list.number[t]).pair();
      rows.make(i, next, factor);
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
  BlockFunctions functions{Block::columns, Code::columns};
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
