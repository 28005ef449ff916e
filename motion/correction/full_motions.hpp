#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "measure/observe/observation_set.hpp"
#include "motion/correction/balanced_set.hpp"

namespace secular {

/// What the full equations do at some parameters where a set was measured: observe_replay.
using ReplaySet = std::function<ObservationSet(const ObservationSet& measured, const Eigen::VectorXd& parameters)>;

/// Motions of the full equations where sets were measured, at one vector of parameters after the other, with few
/// replays: a replay takes each motion through all its periods, its balance a small share of that. What a balance
/// leaves out (lines beyond its highest, what so slow a change does to forces, the length of a decay's windows)
/// changes little from parameters to parameters, so that
///   motion(p) = balance(p) + replay(p0) - balance(p0 at the amplitudes of the replay),
/// with p0 the parameters of the latest replay; before the first one it is the balance alone. Dwells are so at the
/// amplitudes that were measured, from which replays with other parameters drift away, decays at those of the
/// replay, which are free of noise. Sets that have no balance are replayed each time.
class FullMotions {
 public:
  FullMotions(std::span<const ObservationSet> measured, const ReplaySet& replay, unsigned threads);

  /// Nothing where a motion that was in balance before is not. Throws NumericalFailure where one that never was,
  /// and is replayed, grows beyond bounds.
  std::optional<std::vector<ObservationSet>> at(const Eigen::VectorXd& parameters);

  /// Counts from here on. Throws NumericalFailure where a motion grows beyond bounds, and forgets nothing then.
  void replay(const Eigen::VectorXd& parameters);

  /// The latest replays, one of every set; empty before.
  std::vector<ObservationSet> replays() const;

 private:
  struct Reference {
    Reference(ObservationSet replay, const Eigen::VectorXd& at, unsigned threads)
        : parameters(at), replayed(std::move(replay)), balance(replayed, threads), balanced(balance.at(at)) {}
    Eigen::VectorXd parameters;
    ObservationSet replayed;
    BalancedSet balance;                     ///< of the replayed motions
    std::optional<ObservationSet> balanced;  ///< at the same parameters
  };
  std::optional<ObservationSet> balanced(std::size_t s, const Eigen::VectorXd& parameters);

  std::span<const ObservationSet> measured_;
  const ReplaySet& replay_;
  unsigned threads_;
  std::vector<bool> was_balanced_;  // by set, as the others
  std::vector<std::unique_ptr<BalancedSet>> of_measured_;
  std::vector<std::unique_ptr<Reference>> reference_;
};

}  // namespace secular
