#pragma once

#include <span>
#include <vector>

#include "measure/observe/observation_set.hpp"
#include "motion/correction/equal_poles.hpp"

namespace secular {

/// What a measuring chain may do to a motion, with one unknown.
enum class ChainFault {
  low_pass,   ///< equal poles
  high_pass,  ///< equal poles
  even_law,   ///< it reads s + k*s^2 of what there is to be read
  cubic_law,  ///< s + k*s^3
};

/// Whether it is equal poles.
constexpr bool is_filter(ChainFault kind) {
  return kind == ChainFault::low_pass || kind == ChainFault::high_pass;
}

/// A fault of some size, docs/inference.md (61).
struct SizedFault {
  ChainFault kind = ChainFault::low_pass;
  int poles = 1;
  /// low_pass: n (w tau)^2 of n poles, about twice the share that is lost of an amplitude. high_pass: n/(w tau),
  /// about the angle by which a line is early. Laws: share of the second or third harmonic that they make in the
  /// largest motion.
  double size = 0;
  double frequency = 0;  ///< w, rad/s
  double largest = 0;    ///< half amplitude of the largest motion, as the channels show it
  int derivatives = 0;   ///< ModalProjection::derivatives
  /// even_law: its mean is seen, too. False: the chain passes nothing at zero frequency.
  bool shows_mean = false;
  /// even_law: time constant of an AC coupling behind it, s. 0: it shows none.
  double coupling_s = 0;

  EqualPoles filter() const;  ///< of a low-pass or a high-pass
};

/// The observations without what the fault does, docs/inference.md (61): amplitudes, harmonics up to the third and
/// means. Laws take off dwells, too; poles only decays, and dwells whose phases are unknown.
std::vector<ObservationSet> without_fault(std::span<const ObservationSet> sets, const SizedFault& fault);

/// Over a decay's window, the mean square of half the amplitude of its first mode, as the channels show it
/// (`derivatives` of it): what the mean of an even law grows with.
double mean_square(const Observation& window, int derivatives);

/// How many times the own frequency of the one mode that takes part the line of a harmonic turns; 0: at zero
/// frequency, or several modes take part.
int multiple_of(const RegressorBlock& block);

}  // namespace secular
