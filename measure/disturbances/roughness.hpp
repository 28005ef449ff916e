#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace secular {

/// How far every sample is off the cubic through two neighbours on either side. What is smooth on the scale of five
/// samples leaves little; a sample that is wrong by h leaves h there, and h times `spike_shares` around it.
struct Roughness {
  std::vector<double> off;       ///< signed, in the channel's unit; the first two and the last two are zero
  std::vector<double> scales;    ///< zero where nothing is off
  std::vector<double> relative;  ///< modulus over the scale; zero where that is
  double blur = 0;               ///< how far rounding may change a relative one, in either direction
};

/// What a wrong sample leaves at its neighbours from two before it to two after it.
inline constexpr std::array spike_shares = {1.0 / 6, -2.0 / 3, 1.0, -2.0 / 3, 1.0 / 6};

/// Scale is the median over 64 samples around a sample, or beside them where that is larger: motion begins and dies
/// away. Rounding to a lattice of that step (0: none) changes a value by 4/3 of a step at most; no scale is
/// smaller.
Roughness roughness(std::span<const double> samples, double step);

/// Samples whose relative value is not below those of two neighbours on either side, rising.
std::vector<std::size_t> peaks(const Roughness& rough);

/// What is left of the five values around a sample behind the shares of a spike that fits them best, as a norm in
/// units of the sample's scale. Of a corner of the motion 0.27 of its own relative value is left, of a jump more.
double beside_spike(const Roughness& rough, std::size_t sample);

/// The same behind a corner of the motion, at the sample or between it and one of its neighbours.
double beside_corner(const Roughness& rough, std::size_t sample);

}  // namespace secular
