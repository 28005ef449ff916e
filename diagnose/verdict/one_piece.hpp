#pragma once

#include <optional>
#include <string>

#include "diagnose/verdict/decay_parts.hpp"
#include "diagnose/verdict/model_alone.hpp"

namespace secular {

/// Why free decays are not compared in one piece each; empty: nothing speaks against it. Mains and zeros keep their
/// course over a segment only, and beside noise with a colour a law that is missing hardly shows.
std::string against_one_piece(const DiagnosisOptions& options);

bool compares_decays(const Comparison& comparison, const Campaign& campaign);

/// The model as it is beside free decays in one piece each (docs/inference.md, decays in one piece).
struct InOnePiece {
  FittedAlone fitted;
  RowsLeft left;
  std::optional<PartsOfDecays> parts;  ///< where the fit has converged, see parts_of_decays()

  bool has_converged() const { return fitted.inference.null.fit.ending == SolverEnding::converged; }
  /// Whether all rows, or what parts of the decays tell, are more than noise, and not since one decay differs from the
  /// next: the model does not hold along them.
  bool misses() const {
    if (parts && parts->only_records_differ()) return false;
    return is_more_than_noise(left) || (parts && parts->differ());
  }
};

/// Fits `fitted`, whose rows are those of decays in one piece, until it comes to rest; errors are taken anew.
RowsLeft bring_to_rest(FittedAlone& fitted, const DiagnosisOptions& options);

/// From a fit in which segments of decays have states of their own. `options.whole_decays` is set.
InOnePiece model_in_one_piece(const CampaignAndModel& sides, const DiagnosisOptions& options, Inference segments,
                              bool late);

}  // namespace secular
