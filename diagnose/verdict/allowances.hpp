#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "diagnose/verdict/campaign_and_model.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "diagnose/verdict/model_alone.hpp"

namespace secular {

/// What records are allowed to have of their own.
struct Allowance {
  bool late = false;
  Eigen::VectorXd frequency_scatter = {};  ///< DiagnosisOptions::frequency_scatter
  /// When it is tried: what plainly comes at random before the plain equations, all else after them.
  enum Turn { at_random, plain, blows, at_last, both } turn = plain;
  double left = 0;               ///< beside the model as it is, mean square in variances
  bool blows_as_decays = false;  ///< nothing of what drives them
};

/// The model as it is beside what records are allowed to have; `common_late_s`: as of fit_alone().
using FitBeside = std::function<ModelAlone(const Allowance&, std::optional<double> common_late_s)>;

/// Allowances worth a diagnosis, the plain equations among them.
struct Allowances {
  std::vector<Allowance> all;
  Eigen::VectorXd scatter_alone;  ///< of frequencies about the model as it is; empty: there is none
};

/// What records may have of their own of a campaign of which the model as it is leaves more than noise, `plain`.
/// Natural frequencies or lateness of each record's own are tried first where they plainly come at random, in the
/// order of what the model as it is leaves beside them, and else after the plain equations: what a law that the
/// model lacks does follows the settings. Both at once take all that the resonant line of a dwell tells, and come
/// last. `decays`: DecayScatter::frequency_sd.
Allowances find_allowances(const CampaignAndModel& sides, const ModelAlone& plain, const Eigen::VectorXd& decays,
                           const FitBeside& fit_beside);

/// In the order in which they are tried.
std::vector<Allowance> in_turn(std::vector<Allowance> allowances);

/// Whether dwells are driven by one channel of excitation that the model knows: only then is it told how late their
/// responses are.
bool may_be_late(const CampaignAndModel& sides);

/// Whether the window takes a blow whose excitation acts in the model (`options.forces` are excitations, too).
bool has_blows(const CampaignAndModel& sides, const DiagnosisOptions& options);

}  // namespace secular
