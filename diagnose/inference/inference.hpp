#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnose/inference/explanation.hpp"

namespace secular {

/// What the candidates explain.
struct Inference {
  Explanation null;                       ///< own parameters alone
  std::vector<Explanation> explanations;  ///< singles and pairs that were fitted, likeliest first; null is not here
  double dispersion = 1;                  ///< variance of the rows about the best explanation
  double degrees_of_freedom = 0;          ///< of the rows about the null
  double price = 0;                       ///< of one unknown more, in log evidence
  std::vector<double> linear_gain;        ///< by candidate: fall of chi-squared to first order at the null
  std::vector<double> gain_of_records;    ///< by candidate: share of that gain's variance that is the records' own
};

/// How many explanations have been fitted, of about how many; the last call names the same number twice. Calls may
/// come from several threads.
using SearchProgress = std::function<void(std::size_t done, std::size_t expected)>;

struct InferenceOptions {
  SearchProgress progress = {};
  std::function<void()> after_own_fit = {};  ///< of the model as it is, at errors that were taken for it
  unsigned threads = 1;
  /// Unknowns whose start is trusted more than a model that is far from the data: held until one explanation is
  /// near.
  std::vector<std::size_t> anchors;
  double prior_second = 1e-3;    ///< prior odds of a second effect beside a first
  double prior_open_law = 1e-3;  ///< of a single law outside of the catalogue instead of one in it
  /// Of other rows of the same records, with the same candidates: its explanations are where fits begin as well.
  const Inference* near = nullptr;
};

/// Fits every candidate that shows at first order, with all `own` unknowns free beside it, and pairs of the best
/// with the rest. Evidence: Schwarz's approximation with rows of the dispersion that the best explanation leaves,
/// and equal prior odds for every candidate of the catalogue. Open laws compete alone only: a single law that the
/// catalogue lacks looks like two that it holds.
Inference infer(Discrepancy& discrepancy, const std::vector<Candidate>& candidates, const Eigen::VectorXd& start,
                const std::vector<std::size_t>& own, const InferenceOptions& options);

}  // namespace secular
