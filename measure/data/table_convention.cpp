#include "measure/data/table_convention.hpp"

#include <numbers>

#include "input/nearest_word.hpp"
#include "numerics/hertz.hpp"

namespace secular {

TableConvention convention_of(const ConventionWords& words, const RefuseWord& refuse) {
  TableConvention convention;
  const auto is_one = [&](const char* word, const std::string& is, const std::string& first,
                          const std::string& second) {
    if (!is.empty() && is != first && is != second)
      refuse(word, is, "is no convention",
             remedy_for_word(first + " or " + second + " was expected", is, {first, second}));
    return is == second;
  };
  if (words.amplitudes == "rms")
    convention.amplitude = TableConvention::Amplitude::rms;
  else if (words.amplitudes == "peak_to_peak")
    convention.amplitude = TableConvention::Amplitude::peak_to_peak;
  else if (!words.amplitudes.empty() && words.amplitudes != "peak")
    refuse("amplitudes", words.amplitudes, "is no convention",
           remedy_for_word("peak, rms or peak_to_peak was expected", words.amplitudes,
                           {"peak", "rms", "peak_to_peak"}));
  const bool degrees = is_one("phases", words.phases, "rad", "deg");
  if (!words.phases.empty()) convention.degrees = degrees;
  convention.lags = is_one("phase_sign", words.phase_sign, "lead", "lag");
  convention.phase_offset_rad = words.phase_offset_deg * std::numbers::pi / 180;
  convention.per_excitation = words.per_excitation;
  convention.frequency_unit = words.frequency_unit;
  if (!words.frequency_unit.empty() && !hertz_in(words.frequency_unit))
    refuse("frequency_unit", words.frequency_unit, "is no unit of frequency",
           remedy_for_word(std::string(frequency_unit_list) + " was expected", words.frequency_unit,
                           {"Hz", "kHz", "rad/s", "1/min"}));
  return convention;
}

std::optional<double> hertz_in(const std::string& unit) {
  if (unit == "Hz" || unit == "hz" || unit == "1/s") return 1;
  if (unit == "kHz") return 1e3;
  if (unit == "rad/s") return 1 / two_pi;
  if (unit == "1/min" || unit == "rpm") return 1.0 / 60;
  return std::nullopt;
}

double peak_of(TableConvention::Amplitude amplitude) {
  switch (amplitude) {
    case TableConvention::Amplitude::rms:
      return std::numbers::sqrt2;
    case TableConvention::Amplitude::peak_to_peak:
      return 0.5;
    default:
      return 1;
  }
}

}  // namespace secular
