#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace secular {

/// How far what several records tell of one number differs from record to record, beyond what each of them leaves
/// open: a standard deviation with its 95 % interval.
struct ScatterBetweenRecords {
  std::size_t mode = 0;  ///< whose natural frequency it is
  double sd = 0, low = 0, high = 0;
  double p_value = 1;                ///< of records that do not differ
  std::vector<std::size_t> records;  ///< indices into Campaign::records
  std::vector<double> shifts;        ///< by record: its likeliest distance from the mean of all
  Eigen::MatrixXd covariance;        ///< of `shifts`, where records scatter at random by `sd`
};

}  // namespace secular
