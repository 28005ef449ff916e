#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "estimator/identification/estimate_quality.hpp"
#include "estimator/model/compiled_model.hpp"

namespace secular {

/// What a campaign knows of one case: which of its lumps.
struct KnownLumps {
  const CompiledCase* resonance = nullptr;
  std::vector<bool> lumps;
};

/// What a campaign knows of a model.
struct CampaignKnowledge {
  const CompiledModel* model = nullptr;
  std::vector<KnownLumps> cases;
  std::vector<bool> parameters;  ///< by CompiledModel::symbols: natural frequencies that are seen, given values
};

/// Values of order one, different in every run of `which`, the same in every program: a generic point.
Eigen::VectorXd generic_point(Eigen::Index size, int which = 0);

/// d(known lumps and parameters)/d(parameters) at `point`.
Eigen::MatrixXd known_jacobian(const CampaignKnowledge& known, const Eigen::VectorXd& point);

/// Rank with columns scaled to unit norm.
Eigen::Index scaled_rank(const Eigen::MatrixXd& jacobian);

/// Parameters that the campaign determines, and for the others those of their null directions.
struct Identifiability {
  std::vector<bool> determined;
  std::vector<std::vector<int>> entangled_with;
};
Identifiability identifiability(const CampaignKnowledge& known);

/// The null space at generic points in readable form: reduced so that few parameters stand in each direction,
/// ratios as rational multiples of powers of natural frequencies where they are that at every point tried. For
/// every direction: the cases of the model that are not in the campaign, the harmonics that it did not use and the
/// zero-frequency components that would part it.
std::vector<NullDirection> null_directions(const CampaignKnowledge& known);

}  // namespace secular
