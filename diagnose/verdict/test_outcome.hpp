#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/inference/inference.hpp"

namespace secular {

/// An explanation that a further test should separate from others.
struct Hypothesis {
  const Explanation* explanation = nullptr;
  double probability = 0;  ///< before the test; those of all hypotheses need not add up to one
};

/// A test to run next: a measured record at another level, a dwell also at another frequency.
struct ProposedTest {
  std::size_t like = 0;      ///< record that it repeats
  double level = 1;          ///< times that record's excitation; of a decay, times the state that it begins with
  double length = 1;         ///< times that record's number of ensembles, or as many such records
  std::string channel;       ///< of the excitation; empty: there is none
  double excitation = 0;     ///< of a dwell: peak, in that channel's unit
  double frequency = 0;      ///< of a dwell's excitation, rad/s
  std::string resonance;     ///< of a dwell: "Omega near 2 omega1"
  double separation = 0;     ///< expected between the two hypotheses that lie closest, in standard deviations
  std::string watch;         ///< where most of that separation shows: mode or channel, and line
  double probability = 0;    ///< expected of the right hypothesis after the test
  double before = 0;         ///< the same without a test
  double typical = 0;        ///< the same after a test of that length taken at random from those compared
  double chance = 0;         ///< that it leaves the right hypothesis alone: no other at `told_apart` of its odds
  std::size_t compared = 0;  ///< tests that were compared
  double minutes = 0;        ///< to be measured
};

/// Times the highest level measured: half again.
inline constexpr double usual_highest_level = 1.5;

struct ProposalOptions {
  double highest_level = usual_highest_level;  ///< times the highest one measured
  double dispersion = 1;  ///< variance of rows about the explanations, in that of repeatability
  unsigned threads = 1;
};

/// Levels that are compared, times a measured one; none below this share of the lowest one measured.
inline constexpr double test_levels[] = {0.5, 0.7, 1.0, 1.5, 2.0}, lowest_test_level = 0.5;

/// Times the length of a measured record: each halves the errors of the one before.
inline constexpr double test_lengths[] = {1, 4, 16};

/// A test that may be run next.
struct PossibleTest {
  ProposedTest proposed;  ///< what it is; what is expected of it is not yet in it
  /// Rows, not yet frozen, of the test if it goes as the hypothesis of that index predicts, for another one's
  /// unknowns, with the errors of as many such tests as `length`. Empty: not every hypothesis predicts it.
  std::function<Discrepancy(std::size_t truth, const Eigen::VectorXd& unknowns, double length)> rows;
};

/// The test after which the right hypothesis is expected to have the largest probability; between certain ones the
/// larger separation is the safer test. A test that goes as one hypothesis predicts is judged by every other, whose
/// unknowns may move as far as the campaign leaves them free: d^2 = r^T (1 + J P J^T)^-1 r of whitened rows r,
/// Jacobian J and covariance P is the fall of chi-squared that refitting cannot take back, and exp(-d^2/2) the
/// expected odds. What a test adds to the logarithm of the odds is normal with mean d^2/2 and standard deviation d,
/// which gives its chance. Of the shortest of test_lengths at which a test is as good as certain, else of the
/// longest. Without a proposal (compared = 0) none is possible.
ProposedTest best_test(const std::vector<PossibleTest>& tests, const std::vector<Hypothesis>& hypotheses,
                       const ProposalOptions& options);

}  // namespace secular
