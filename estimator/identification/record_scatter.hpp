#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "estimator/identification/case_regression.hpp"

namespace secular {

/// How many records a set's observations are of.
std::size_t count_of_records(const ObservationSet& set);

/// Stretches of one decay share the structure as it was that day: what scatters from record to record, as natural
/// frequencies do with temperature and clamping, is no scatter of conditions. Columns x (records and modes): what
/// one standard deviation of a record's natural frequency does to the coefficients, as far as records of the decays
/// differ by more than their stretches explain (docs/inference.md (23)). No columns where they do not, or there is
/// one record.
Eigen::MatrixXd record_scatter(const CaseFit& fit);

}  // namespace secular
