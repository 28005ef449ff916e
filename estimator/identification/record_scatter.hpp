#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "estimator/identification/case_regression.hpp"

namespace secular {

/// How many records a set's observations are of.
std::size_t count_of_records(const ObservationSet& set);

/// What the rows of each record show of one natural frequency, of mean square length 1 in its column x: sums x_r'e
/// of residuals, their covariance by what stretches scatter, and what a shift of each record's frequency makes of
/// them.
struct RecordSums {
  double unit = 1;                  ///< by which |x_r|^2 were divided
  std::vector<std::size_t> record;  ///< index into Campaign::records
  Eigen::VectorXd sums;             ///< by record
  Eigen::MatrixXd noise, shown;     ///< record x record
  Eigen::VectorXd own_noise;        ///< by record: variance of its own frequency
  Eigen::VectorXd freedom;          ///< by record: degrees of freedom of that
  Eigen::MatrixXd seen;             ///< rank x record: the column's rows in coordinates of the fit
};

/// By their moments (docs/inference.md (23)). Nothing where nothing scatters at all.
std::optional<ScatterBetweenRecords> scatter_of(const RecordSums& sums);

/// docs/inference.md (52): of what scatter_of() gives, what records that do not differ show no more than once in
/// 1/`probability`; 0 where they do as much.
double told_scatter(const RecordSums& sums, double probability);

/// Stretches of one decay share the structure as it was that day: what scatters from record to record, as natural
/// frequencies do with temperature and clamping, is no scatter of conditions (docs/inference.md (23)).
struct RecordScatter {
  std::vector<ScatterBetweenRecords> frequencies;  ///< of modes that several records tell
  std::vector<double> told;                        ///< of each, told_scatter() at the level of a lack of fit
  /// Coefficients x (records and modes): what one standard deviation of a record's natural frequency does to them.
  /// No columns where records do not differ by more than their stretches explain, and none of dwells, each of which
  /// is a condition.
  Eigen::MatrixXd moves;
};

/// Of a case that several records tell. What dwells show may be what the model lacks.
RecordScatter record_scatter(const CaseFit& fit);

}  // namespace secular
