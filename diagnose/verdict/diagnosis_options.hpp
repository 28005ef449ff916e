#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnose/evidence/segment.hpp"
#include "diagnose/inference/inference.hpp"
#include "diagnose/verdict/given_numbers.hpp"
#include "diagnose/verdict/test_outcome.hpp"
#include "effects/catalogue.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/balance/state_force.hpp"

namespace secular {

/// Samples of decays, sweeps and broadband records that a diagnosis compares, in all: what tells effects apart. Of
/// a campaign of one record twice as many.
inline constexpr Eigen::Index usual_samples = 6000;

struct DiagnosisOptions {
  EffectCatalogue catalogue = effect_catalogue();
  Window window;
  GivenNumbers given;                   ///< the gap of these is diagnosed
  std::map<std::string, double> start;  ///< by symbol: where fits begin; nobody claims these numbers
  Eigen::Index most_samples = usual_samples;
  /// By mode, rad/s: where the records are, whatever the model's nominal values say; NaN or missing: not known.
  std::vector<double> natural_frequency;
  std::vector<StateForce> forces;  ///< scales are set from the data
  bool keeps_scales = false;       ///< of `forces`, as they are
  std::set<std::string> left_out;  ///< effects that are not to be considered
  bool late = false;               ///< responses of every dwell may be late by a time of its own
  /// By mode, relative: standard deviation with which natural frequencies differ from record to record, at first.
  /// Each record has its own then. Empty: all have the same.
  Eigen::VectorXd frequency_scatter;
  bool knows_without_scatter = false;  ///< where frequencies turn out to be all the same, nothing is told
  bool blows_as_decays = false;        ///< see SegmentCut
  bool skips_blows = false;            ///< see SegmentCut
  bool whole_decays = false;           ///< see SegmentCut
  WanderingZeros wandering;            ///< of responses: no offset of theirs lasts
  ForeignTones tones;                  ///< of records that are compared sample by sample
  ColouredNoises coloured;
  std::optional<Window> check;  ///< part of the records on which the explanation is tried, whatever was fitted
  bool fit_check = false;       ///< and once more with the numbers that fit that part best
  double highest_level =
      usual_highest_level;  ///< that may be proposed, times the highest one measured at a resonance
  unsigned threads = 1;
  SearchProgress progress = {};
  std::function<void()> after_own_fit = {};  ///< see InferenceOptions
};

}  // namespace secular
