#pragma once

#include <vector>

namespace secular {

/// How single ensembles of a dwell scatter about their mean at one line of one channel.
struct LineScatter {
  double frequency = 0;  ///< rad/s
  double sd = 0;         ///< of a real part of one ensemble
  double freedom = 0;    ///< of the sd
};

/// Scatter as a function of frequency: noise is coloured, and what a few ensembles of one line tell of it is
/// little.
class PooledScatter {
 public:
  explicit PooledScatter(std::vector<LineScatter> lines);

  /// Of a line: the root mean square over the lines that are nearest in frequency (as a ratio), as many as are
  /// needed to know it; zero where there are none. A line of more than four times the median of these is disturbed:
  /// it does not speak for the others, nor these for it, which has its own.
  double sd(const LineScatter& line) const;

 private:
  std::vector<LineScatter> lines_;  // by frequency
};

}  // namespace secular
