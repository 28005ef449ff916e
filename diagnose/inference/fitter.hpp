#pragma once

#include <Eigen/Core>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "diagnose/inference/refit.hpp"
#include "diagnose/inference/screening.hpp"

namespace secular {

/// Shares of the inertia to which the equations of motion count as known, one after the other.
inline constexpr double coarse_levels[] = {1e-2, 1e-3, 1e-4, 0};
inline constexpr std::size_t finest_level = std::size(coarse_levels) - 1;

/// The most that chi-squared of a model comes to with these degrees of freedom where it leaves no more than noise.
double most_of_noise(double freedom);
bool is_within_noise(double chi_squared, double freedom);

/// Whether so many rows are missed by so much that they are no place to look for what a model lacks: its numbers
/// are bent by then.
bool is_missed(double chi_squared, double rows);

/// A fit among errors of one level, and how many rows count there.
struct LevelFit {
  Refit fit;
  double rows = 0;

  bool misses() const { return is_missed(fit.chi_squared, rows); }
};

/// Fits to the rows of a discrepancy at errors that are taken where a search says, and what fits tell each other:
/// the scales of unknowns.
class Fitter {
 public:
  /// `after_own_fit`: see InferenceOptions.
  Fitter(Discrepancy& discrepancy, Eigen::Index unknowns, unsigned threads,
         std::function<void()> after_own_fit = {})
      : discrepancy_(discrepancy), threads_(threads), scales_(unknowns), after_own_fit_(std::move(after_own_fit)) {}

  /// Takes errors and starting points of the rows at these unknowns.
  void freeze(const Eigen::VectorXd& at, double coarse = 0, Lookout lookout = Lookout::anywhere);
  /// Whether they are those of the measurement.
  bool at_true_errors() const { return frozen_.coarse == 0; }
  /// Rows that are independent.
  double rows() const { return static_cast<double>(discrepancy_.freedom()); }
  /// Chi-squared of these unknowns among the errors as they are.
  double left_by(const Eigen::VectorXd& unknowns) const { return discrepancy_(unknowns).squaredNorm(); }
  std::vector<RowLabel> labels() const { return discrepancy_.labels(); }
  /// Whether anything is allowed for that records have of their own.
  bool admits_own() const { return discrepancy_.admits_own(); }

  /// On one thread: one of several fits side by side.
  Refit fit_beside(const Eigen::VectorXd& from, const std::vector<std::size_t>& free) const {
    return refit(discrepancy_, from, free, options());
  }
  Refit fit_beside(const Eigen::VectorXd& from, const std::vector<std::size_t>& free,
                   const RefitOptions& options) const {
    return refit(discrepancy_, from, free, options);
  }
  /// On all threads.
  Refit fit_alone(const Eigen::VectorXd& from, const std::vector<std::size_t>& free) const {
    return refit(discrepancy_, from, free, options(threads_));
  }
  /// The same; what it learns of scales is used from then on.
  Refit fit_own(const Eigen::VectorXd& from, const std::vector<std::size_t>& free, double damping = 0);
  RefitOptions options(unsigned threads = 1) const;

  /// A fit among errors of one level, which are taken anew at where it ends until it comes to rest.
  LevelFit at_level(Eigen::VectorXd unknowns, const std::vector<std::size_t>& free, double coarse);

  /// Errors of the rows depend on the unknowns, and a start far off has none that mean anything: one fit for each
  /// of coarse_levels, every one from where the last ended. Among wider errors a fit leaves less: none that is
  /// finer follows one that leaves more than `most`.
  std::vector<LevelFit> from_coarse_to_fine(const Eigen::VectorXd& start, const std::vector<std::size_t>& free,
                                            double most = std::numeric_limits<double>::infinity());

  /// Of every candidate beside a fit.
  std::vector<Screening> screen(const Refit& base, const std::vector<Candidate>& candidates) {
    return screen_all(discrepancy_, base, candidates, scales_, threads_);
  }

  /// To come back to.
  struct Place {
    Eigen::VectorXd at;
    double coarse = 0;
    KnownScales scales;
  };
  Place place() const { return {frozen_.at, frozen_.coarse, scales_}; }
  void return_to(const Place& place);

 private:
  struct Frozen {
    Eigen::VectorXd at;
    double coarse = 0;
  };

  Discrepancy& discrepancy_;
  unsigned threads_;
  KnownScales scales_;
  std::function<void()> after_own_fit_;
  Frozen frozen_;
};

}  // namespace secular
