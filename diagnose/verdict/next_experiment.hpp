#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/evidence/condition_rows.hpp"
#include "diagnose/inference/inference.hpp"

namespace secular {

/// An explanation that a further test should separate from others.
struct Hypothesis {
  const Explanation* explanation = nullptr;
  double probability = 0;  ///< before the test; those of all hypotheses need not add up to one
};

/// A dwell to run next.
struct ProposedDwell {
  std::size_t like = 0;      ///< record that it repeats at another level or frequency
  double level = 1;          ///< times that record's excitation
  double length = 1;         ///< times that record's number of ensembles
  std::string channel;       ///< of the excitation
  double excitation = 0;     ///< peak, in that channel's unit
  double frequency = 0;      ///< of the excitation, rad/s
  std::string resonance;     ///< "Omega near 2 omega1"
  double separation = 0;     ///< expected between the two hypotheses that lie closest, in standard deviations
  std::string watch;         ///< where most of that separation shows: mode or channel, and line
  double probability = 0;    ///< expected of the right hypothesis after the test
  double before = 0;         ///< the same without a test
  double typical = 0;        ///< the same after a test of that length taken at random from those compared
  double chance = 0;         ///< that it leaves the right hypothesis alone: no other at `told_apart` of its odds
  std::size_t compared = 0;  ///< tests that were compared
  double minutes = 0;        ///< of steady motion to be measured
};

struct ProposalOptions {
  double highest_level = 1.5;  ///< times the highest one measured at a resonance
  double dispersion = 1;       ///< variance of rows about the explanations, in that of repeatability
  unsigned threads = 1;
};

/// The dwell, among levels and frequencies around those measured, after which the right one of `hypotheses` is
/// expected to have the largest probability. Under each hypothesis in turn the dwell is predicted with its fitted
/// unknowns and judged by every other, whose unknowns may move as far as the campaign leaves them free: the
/// separation d^2 = r^T (1 + J P J^T)^-1 r of whitened rows r, Jacobian J and covariance P is the fall of
/// chi-squared that refitting cannot take back (a discrimination design; Box and Hill 1967, Atkinson and Fedorov
/// 1975), and exp(-d^2/2) the expected odds. What a dwell adds to the logarithm of the odds is normal with mean
/// d^2/2 and standard deviation d, which gives its chance. Levels stay within half the lowest and
/// `highest_level` times the highest used; where no dwell as long as those measured is as good as certain, one of
/// the next of `dwell_lengths` is looked for. Without a proposal (compared = 0) there is no dwell to start from.
ProposedDwell next_experiment(const ConditionModel& model, const std::vector<Condition>& conditions,
                              const std::vector<Hypothesis>& hypotheses, const ProposalOptions& options);

/// Times the number of ensembles of a measured dwell: each halves the errors of the one before.
inline constexpr double dwell_lengths[] = {1, 4, 16};

}  // namespace secular
