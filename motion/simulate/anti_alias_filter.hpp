#pragma once

#include <cstddef>
#include <vector>

namespace secular {

/// Low-pass filter between a sensor and its converter, of an even number of poles, with unit gain at zero
/// frequency.
struct AntiAliasFilter {
  enum class Kind {
    butterworth,  ///< -3.01 dB at the cut-off
    elliptic,     ///< ripple of 0.1 dB up to the cut-off, 80 dB of attenuation in its stop band: with 8 poles from
                  ///< 1.41 times the cut-off on
  };
  Kind kind = Kind::butterworth;
  std::size_t poles = 8;
  double cut_off_hz = 0;
  std::size_t oversampling = 8;  ///< the motion is sampled this many times faster, filtered, and decimated
};

/// The filter as second-order sections at a sampling rate (bilinear transform, exact at the cut-off). One object
/// filters one channel.
class FilterCascade {
 public:
  FilterCascade(const AntiAliasFilter& filter, double sample_rate_hz);
  /// First-order high-pass: what an AC-coupled amplifier does.
  static FilterCascade high_pass(double corner_hz, double sample_rate_hz);

  /// State in which `input` has stood for ever.
  void settle(double input);
  double operator()(double input);

 private:
  struct Section {
    double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
    double z1 = 0, z2 = 0;  ///< transposed direct form II
  };
  FilterCascade() = default;

  std::vector<Section> sections_;
};

}  // namespace secular
