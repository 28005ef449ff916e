#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "estimator/identification/estimate.hpp"

namespace secular {

/// How much later than its excitation a record's responses are, as far as the model's equations tell.
struct RecordLateness {
  std::size_t record = 0;  ///< index into Campaign::records
  double late_s = 0;       ///< by whole periods of the (first) excitation near that of the other records
  double period_s = 0;
};

/// What phases that are free numbers show of a case whose equations do not hold.
enum class PhaseFinding {
  late,          ///< records out of step: the phases are unknowns of the case
  in_part,       ///< the equations hold better then, but do not hold
  nothing_told,  ///< records out of step, but the conditions tell nothing without phases
  like_a_law     ///< phases that follow the amplitude, as a law that the model lacks makes them
};

/// As in estimate.json.
std::string_view name_of(PhaseFinding finding);

/// What records of one case say of it.
struct CaseLateness {
  std::string resonance;
  PhaseFinding finding = PhaseFinding::late;
  std::vector<RecordLateness> records;  ///< where they are late
  double f = 0;                         ///< docs/inference.md (18)
  double p_value = 1;                   ///< that records in step, of a model that holds, look like this
  /// Half a period more or less turns the sign of the coefficients of the excitation. Where lateness does not tell
  /// it (docs/inference.md (20) to (22)): the coefficient that is taken as positive.
  std::string assumed_positive;
};

/// The same in a sentence for a user.
std::string text_of(const CaseLateness& lateness);

/// Sets whose equations are freed of phases that do not hold, and what was found.
struct UnknownPhases {
  std::vector<ObservationSet> sets;  ///< freed where records are late or phases follow the amplitude
  std::vector<CaseLateness> cases;   ///< none: phases hold everywhere
  /// Where a sign was assumed: in place of which of `sets` another one would be as good.
  struct Rival {
    std::size_t place = 0;
    ObservationSet set;
  };
  std::vector<Rival> rivals;
};

/// Equations that rest on the phase between excitation and response are satisfied by nothing (no damping, no force)
/// where that phase is off at random, and nothing shrinks its own noise: an estimate that looks sharp and is wrong.
/// Every case of dwells with one excitation whose equations did not hold in `estimate`, or could not be judged, is
/// therefore fitted once more with the phase of each record unknown. Where this explains the lack of fit (F test of
/// nested models on the records' means, 0.1 %), and phases do not follow the amplitude as those of a missing
/// stiffness do, records are out of step. The set's excitations are turned by what was found and its phases marked
/// as unknown, also where phases follow the amplitude: to see which numbers that moves.
///
/// docs/inference.md (16) to (22).
UnknownPhases find_unknown_phases(std::span<const ObservationSet> sets, const MeasuredUnits& units,
                                  const EstimateOptions& options, const Estimate& estimate);

/// Phases once more, at equations that truncation has been taken out of, `corrected`: those of truncated equations
/// are off by more than their errors, and the square of that is no longer nothing (docs/inference.md (16)). Turns
/// the excitations of `unknown.sets` and moves the lateness of their records; false where nothing moves by more
/// than a tenth of its standard deviation, or where nothing could be corrected (no sets).
bool refine_phases(UnknownPhases& unknown, std::span<const ObservationSet> corrected, const MeasuredUnits& units,
                   const EstimateOptions& options, const Estimate& estimate);

}  // namespace secular
