#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/identification/case_regression.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// design * values = response, in rows of one variance.
struct Equations {
  Eigen::MatrixXd design;
  Eigen::VectorXd response;
};

/// Adds equations of the same rows to their sum, which begins empty.
void add_to(Equations& sum, double share, const Equations& part);

/// One below the other.
Equations stacked(const std::vector<const Equations*>& parts);

struct Solution {
  Eigen::VectorXd values;     ///< of minimal norm in columns of length one where not determined
  double sum_of_squares = 0;  ///< sum of squares
  Eigen::Index rank = 0;
};

/// Columns of length one that depend on others to 1e-9 count as dependent.
Solution least_squares(const Equations& equations);

/// Observations of one record that have the same equations.
struct RecordMembers {
  std::size_t record = 0;
  std::vector<std::size_t> observations;
};

/// A case whose records have phases of their own between excitation and responses, see docs/inference.md (17).
struct PhaseProblem {
  PhaseProblem(const ObservationSet& observed, std::vector<std::size_t> regressed, const CaseKnowledge& given,
               unsigned with_threads);

  const ObservationSet& set;
  std::vector<std::size_t> blocks;  ///< of the regression
  const CaseKnowledge& known;
  unsigned threads;
  std::vector<RecordMembers> records;
};

/// Puts the excitation of each record ahead by an angle (of the first excitation, others by as much time).
void turn(ObservationSet& set, const std::vector<RecordMembers>& records, const std::vector<double>& ahead);

/// The set with the excitation of each record `ahead` as turn() does.
ObservationSet turned(const PhaseProblem& problem, const std::vector<double>& ahead);

/// Whether phases of all records agree within `enough`, periods apart or not.
bool agree(const std::vector<double>& a, const std::vector<double>& b, double enough);

/// The same, `enough` by record.
bool agree(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& enough);

}  // namespace secular
