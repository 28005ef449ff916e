#pragma once

#include <functional>
#include <optional>
#include <string>

namespace secular {

/// What the numbers of a table mean. Where a file states a unit itself that is the one.
struct TableConvention {
  enum class Amplitude { peak, rms, peak_to_peak };

  Amplitude amplitude = Amplitude::peak;  ///< of a level, too
  std::optional<bool> degrees;            ///< of phases; nothing: not known
  bool lags = false;             ///< a positive phase is one of a response that comes later: cos(Omega t - phase)
  double phase_offset_rad = 0;   ///< comes on top of the phases of responses
  bool per_excitation = false;   ///< responses are frequency response functions: over the excitation's amplitude
  std::optional<double> level;   ///< of the excitation in all rows, in its SI unit, where no column holds it
  std::string frequency_unit{};  ///< Hz, kHz, rad/s or 1/min
};

/// The same as a person says it; an empty text says nothing.
struct ConventionWords {
  std::string amplitudes{}, phases{}, phase_sign{}, frequency_unit{};
  double phase_offset_deg = 0;
  bool per_excitation = false;
};
/// Ends with an error of its own: which word ("phase_sign"), what it is, what is wrong with it, what was expected.
using RefuseWord = std::function<void(const std::string& word, const std::string& is, const std::string& wrong,
                                      const std::string& expected)>;
/// Without a level.
TableConvention convention_of(const ConventionWords& words, const RefuseWord& refuse);

inline constexpr const char* frequency_unit_list = "Hz, kHz, rad/s or 1/min";
/// Hz in a unit of frequency; nothing for another unit.
std::optional<double> hertz_in(const std::string& unit);

/// Peak value over what a table has for the size of a harmonic motion.
double peak_of(TableConvention::Amplitude amplitude);

}  // namespace secular
