#pragma once

#include <Eigen/Core>
#include <atomic>
#include <vector>

#include "diagnose/inference/fitter.hpp"
#include "diagnose/inference/inference.hpp"

namespace secular {

/// What the stages of infer() work on: the model as it is, the explanations that were found so far, and at which
/// errors. Stages are functions of it: null_fit.hpp, single_fits.hpp, pair_fits.hpp, fits_afresh.hpp, weighing.hpp.
struct ExplanationSearch {
  ExplanationSearch(Discrepancy& discrepancy, const std::vector<Candidate>& all_candidates,
                    const std::vector<std::size_t>& all_of_own, const InferenceOptions& all_options,
                    Eigen::Index unknowns);

  const std::vector<Candidate>& candidates;
  const std::vector<std::size_t>& all_own;
  const InferenceOptions& options;
  Fitter fitter;
  double price;                  ///< of one unknown more, in log evidence
  std::vector<std::size_t> own;  ///< of all_own, that are fitted at present
  std::size_t level = 0;         ///< index into coarse_levels that the errors are frozen at
  bool null_holds = false;       ///< the model as it is leaves no more than noise among its own true errors
  std::vector<Screening> singles;
  std::vector<Explanation> found;       ///< best first
  std::atomic<std::size_t> fitted = 0;  ///< explanations so far
  std::size_t expected = 0;             ///< when those at hand are done
  Inference result;                     ///< the null, and what is known of it

  void freeze_at_level(const Eigen::VectorXd& at) { fitter.freeze(at, coarse_levels[level]); }

  // At the errors as they are.
  bool misses(const Refit& fit) const { return is_missed(fit.chi_squared, fitter.rows()); }
  double freedom_about_null() const { return fitter.rows() - static_cast<double>(result.null.fit.rank); }
  bool leaves_more_than_noise(const Explanation& e) const {
    return !is_within_noise(e.fit.chi_squared, freedom_about_null());
  }
  double dispersion_of(const Explanation& e) const;

  std::vector<std::size_t> free_of(const std::vector<std::size_t>& members) const {
    return free_beside(own, members, candidates);
  }
  /// Fits candidates together from a start; several at a time.
  Explanation explain(const std::vector<std::size_t>& members, const Eigen::VectorXd& start);
  /// All that were found, from where they are.
  void refit_found();
  void take_gains(const std::vector<Screening>& screened);
};

}  // namespace secular
