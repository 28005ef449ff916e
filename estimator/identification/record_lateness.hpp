#pragma once

#include <span>
#include <string>
#include <vector>

#include "estimator/identification/estimate.hpp"

namespace secular {

/// How much later than its excitation a record's responses are, as far as the model's equations tell.
struct RecordLateness {
  std::size_t record = 0;  ///< index into Campaign::records
  double late_s = 0;       ///< within half a period of the (first) excitation
  double period_s = 0;
};

/// What records of one case say of it.
struct CaseLateness {
  std::string resonance;
  std::vector<RecordLateness> records;
  double f =
      0;  ///< what phases of their own explain of the misfit by phase, over what they leave by degree of freedom
  double p_value = 1;  ///< that records without lateness look like this
  /// Half a period more or less turns the sign of the coefficients of the excitation: whether phases are near
  /// enough to those that were measured to tell it. If not, the excitation acts in its positive direction.
  bool sign_told = true;
};

/// The same in a sentence for a user.
std::string text_of(const CaseLateness& lateness);

/// Sets whose equations are freed of phases that do not hold, and what was found.
struct UnknownPhases {
  std::vector<ObservationSet> sets;
  std::vector<CaseLateness> cases;  ///< none: phases hold everywhere
};

/// Equations that rest on the phase between excitation and response are satisfied by nothing (no damping, no force)
/// where that phase is off at random, and nothing shrinks its own noise: an estimate that looks sharp and is wrong.
/// Every case of dwells whose equations did not hold in `estimate` is therefore fitted once more with the phase of
/// each record unknown. Where this explains the misfit (F test of nested models on the records' means, 0.1 %), the
/// set's excitations are turned by what was found and its phases marked as unknown.
///
/// docs/inference.md (16) to (18).
UnknownPhases find_unknown_phases(std::span<const ObservationSet> sets, const MeasuredUnits& units,
                                  const EstimateOptions& options, const Estimate& estimate);

}  // namespace secular
