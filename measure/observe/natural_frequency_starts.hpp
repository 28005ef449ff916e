#pragma once

#include <vector>

#include "measure/observe/dwell_resonance.hpp"

namespace secular {

/// Natural frequencies that a campaign's records tell, good enough to say which record excites which resonance and
/// where a mode rings.
struct NaturalFrequencyStarts {
  std::vector<double> frequency;  ///< by mode, rad/s, amid the dwells that show the mode; NaN: not determined
  std::vector<bool> moved;        ///< by mode: a nominal value was given and is not what the records show
};

/// Nominal values (rad/s, by mode; NaN: none) are right where every record is explained by them: a dwell by a case
/// within the resonance width that its response does not contradict, a decay by a mode at each of its lines; where
/// nothing decays, lines are those of driven records (docs/inference.md (51)). They take the place of those that no
/// line is near, and what makes a relation of a case exact at a dwell takes that of any, where that explains the
/// same records and more; the more, the better. Modes keep the order of their nominal frequencies, so that each
/// goes to the nearest line in order. Of several that explain as many, those count that more responses agree with,
/// then the nearest to the nominal values.
NaturalFrequencyStarts natural_frequency_starts(const Campaign& campaign, const RecordReader& read,
                                                const std::vector<double>& nominal,
                                                const std::vector<Resonance>& cases,
                                                const std::vector<DwellTones>& dwells, const Window& window);

}  // namespace secular
