#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "estimator/identification/case_regression.hpp"
#include "estimator/identification/estimate_quality.hpp"

namespace secular {

/// Name of a column: the lump's, the natural frequency's, or "offset of <mode>".
std::string column_name(const CaseFit& fit, std::size_t column);

/// By block of equations that was regressed, by condition, and of ensembles that weigh less than one.
std::vector<BlockQuality> block_quality(const CaseFit& fit);
std::vector<ConditionQuality> condition_quality(const CaseFit& fit);
std::vector<OutlyingEnsemble> outlying_ensembles(const CaseFit& fit);

/// By column; only identifiable lumps are tested.
std::vector<std::optional<PartialF>> partial_f(const CaseFit& fit);

/// By column: names of the lumps that it is hard to tell from.
std::vector<std::vector<std::string>> nearly_entangled(const CaseFit& fit);

/// Every selection of the dissipative terms of each mode (those whose column is a real multiple of the amplitude),
/// judged by what it predicts of conditions that are left out, one after the other. Modes with fewer than two such
/// terms are not listed.
std::vector<DampingComparison> compare_damping(const CaseFit& fit);

/// Coefficients of all columns with conditions drawn with replacement: columns x resamples. Draws that lose rank
/// are drawn again. The same seed gives the same numbers everywhere.
Eigen::MatrixXd bootstrap_coefficients(const CaseFit& fit, int resamples, std::uint64_t seed);

}  // namespace secular
