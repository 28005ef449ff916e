#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/inference/parts_of_rows.hpp"
#include "diagnose/verdict/comparison.hpp"
#include "diagnose/verdict/unseen_laws.hpp"
#include "estimator/identification/lack_of_fit.hpp"

namespace secular {

/// Whether parts of free decays, each fitted in one piece, tell the same numbers (docs/inference.md (65), (66)): by
/// tenths of each decay, which see what changes along it, and by decay, or halves of a single one, which see what
/// differs between few parts.
struct PartsOfDecays {
  PartsAgreement folds, large;
  UnseenLaws laws = {};     ///< of a model of one mode
  bool of_records = false;  ///< whether the large parts are records

  const PartsAgreement& worse() const { return large.p_value < folds.p_value ? large : folds; }
  /// Variance along the numbers, in units of the noise beside the motion's frequencies.
  double dispersion() const { return std::max(folds.dispersion(), large.dispersion()); }
  /// Two looks, and the laws, allowed for.
  double p_value() const;
  bool differ() const;
  /// Whether it is records that differ, each of which holds by itself: they scatter, and no law is missing.
  bool only_records_differ() const;
};

/// Of a fit to decays in one piece each; none where there is anything but decays, or where it sees nothing.
std::optional<PartsOfDecays> parts_of_decays(const Comparison& comparison, const Refit& fit,
                                             const Campaign& campaign, std::size_t modes);

/// As one equation.
LackOfFit lack_of_parts(const PartsOfDecays& parts, std::size_t decays);

/// Of parts that differ.
std::string warning_of(const PartsOfDecays& parts);

}  // namespace secular
