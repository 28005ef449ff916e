#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "measure/disturbances/searched_record.hpp"

namespace secular {

/// A converter's steps that the noise before it does not blur: rounding then adds lines that repeat from turn to
/// turn of the motion.
struct ConverterLattice {
  double step = 0, origin = 0;  ///< values are origin + k step
  double noise = 0;             ///< sd before the converter

  /// Peak amplitude of the largest line that rounding can make: step/pi exp(-2 pi^2 noise^2/step^2).
  double repeated_line() const;
};

/// Whether values lie on a lattice (binomial law at `level`).
bool is_lattice(const ValueGrid& grid, double level);

/// Nothing where values lie on no lattice or where the lines that it makes stay below the
/// standard deviation of a line over the samples.
std::optional<ConverterLattice> repeating_lattice(const SearchedChannel& channel, double level);

/// What rounding to the lattice adds to a value x in the mean, with Gaussian noise of that sd before it
/// (docs/inference.md (28)). Exact for an sd of a tenth of a step or more.
class MeanRounding {
 public:
  static constexpr int terms = 8;
  MeanRounding(const ConverterLattice& lattice, double sd);
  double at(double x) const;

 private:
  ConverterLattice lattice_;
  std::array<double, terms> term_{};
};

/// Takes what rounding adds in the mean out of `samples`: (28) at the motion that tones at `frequencies_hz` and a
/// straight line make in each block of `block` samples, again and again until motion and rounding agree. A block in
/// which they do not stays as it is. The first of the frequencies count, as many as have four samples for each
/// unknown. `skip`: samples, rising, that no converter has rounded.
void take_out_rounding(std::span<double> samples, double rate_hz, const std::vector<double>& frequencies_hz,
                       const ConverterLattice& lattice, std::size_t block, const std::vector<std::size_t>& skip);

}  // namespace secular
