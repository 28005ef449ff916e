#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "blind/specimen.hpp"

namespace secular::blind {

/// What is withheld from the model: an effect, where it acts, how strong it is.
struct Withheld {
  std::string effect;
  std::size_t mode = 0;     ///< of the structure
  std::size_t channel = 0;  ///< of the measurement, for its faults
  double coefficient = 0;   ///< in SI; see `switch_on`
  double detail = 0;        ///< gap, slip or level over the typical amplitude; speed of falling friction over the
                            ///< typical one; exponent of a power; third over second shaker harmonic; frequency of
                            ///< an extra mode over the excited one; 0 without meaning
  bool smooth = false;      ///< hysteresis of Bouc and Wen instead of Jenkins
};

/// A structure, its excitation and its sensors with effects switched on.
struct Reality {
  Structure structure;
  Measurement measurement;
  double second = 0, third = 0;   ///< shaker harmonics over the fundamental
  std::vector<State> begun = {};  ///< by stretch, added to the state that it begins with; empty: nothing
};

/// With nothing switched on: what the model holds as well.
Reality reality_of(const Specimen& specimen);

/// Coefficients of terms: see ModeTerms. extra_mode: its excitation; shaker_harmonics: second harmonic over the
/// first; sensor_gain: relative error; sensor_offset: channel unit; sensor_cross_axis: of the excitation;
/// channel_skew: s; clipping: 1/(1 + coefficient) of `peak` is the range; mode_shape_error: what leaks into `mode`
/// from the other.
void switch_on(const Withheld& withheld, const Specimen& specimen, const std::vector<double>& peak,
               Reality& reality);

/// Names of docs/simulating.md that records of a family can show, and effects that no catalogue lists.
std::vector<std::string> effects_shown(const std::string& family, Programme programme);
std::vector<std::string> uncatalogued_effects(Programme programme);
/// Whether it is of sensors or shapes, not of the structure or its excitation.
bool is_measurement_fault(const std::string& effect);

/// Effects that could be the same thing to the data, by physics; whether they are is decided case by case from
/// their signatures. See docs/blind_check.md.
std::vector<std::string> look_alikes(const std::string& effect, const std::string& family, Programme programme);

/// Draws where an effect acts, its sign and its details; `coefficient` is a first guess of the strength.
Withheld draw_withheld(const std::string& effect, const Specimen& specimen, Random& random);

}  // namespace secular::blind
