#pragma once

#include <span>
#include <vector>

namespace secular {

/// A line in what a model leaves of a channel.
struct LeftLine {
  double frequency_hz = 0;
  double amplitude = 0;  ///< peak, at the begin
  double rate = 0;       ///< 1/s, by which it falls; 0: it is steady
};

/// Lines in what a model leaves of a record, `left`, beside what it moves itself, `motion` (as many samples), that
/// no missing term of its equations makes: steady ones over the whole, and ones that are in the first half, fourth,
/// ... alone, a mode outside of the model that rings (find_lines, at half of the false alarm each). What a term
/// makes lies at multiples of the motion's own line, as it is in the same samples, is no sharper than that, and
/// falls as the motion does (outlasts_products).
std::vector<LeftLine> find_left_lines(std::span<const double> left, std::span<const double> motion, double rate_hz,
                                      double false_alarm);

}  // namespace secular
