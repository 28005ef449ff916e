#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/identification/estimate.hpp"

namespace secular {

/// Lumps of all cases, one after the other as Estimate::lumps, of parameters by CompiledModel::symbols.
Eigen::VectorXd lumps_of(const std::vector<const CompiledCase*>& cases, const Eigen::VectorXd& parameters);

/// Parameters that reproduce what an estimate tells: of those that no lump can tell, where all lumps together are
/// most plausible (Estimate::null_coordinate).
Eigen::VectorXd representative_parameters(const Estimate& estimate);

/// Cases of an estimate whose modulation equations hold no lump that it does not tell: whatever has its lumps has
/// its steady motions.
std::vector<const CompiledCase*> identified_cases(const Estimate& estimate);

/// The lumps that an estimate tells, in units of their error bars.
class IdentifiedLumps {
 public:
  IdentifiedLumps() = default;
  explicit IdentifiedLumps(const Estimate& estimate);

  /// By Estimate::lumps, of parameters by CompiledModel::symbols; 0 where there is no estimate.
  Eigen::VectorXd at(const Eigen::VectorXd& parameters) const;

  /// From `parameters` to where the lumps are those of `like`, by what belongs to the `directions` (symbols x
  /// directions, of which Estimate::null_space are tangents that products of parameters leave), and by the least of
  /// that.
  Eigen::VectorXd returned(Eigen::VectorXd parameters, const Eigen::VectorXd& like,
                           const Eigen::MatrixXd& directions) const;

 private:
  Eigen::MatrixXd slope(const Eigen::VectorXd& parameters) const;

  std::vector<const CompiledCase*> cases_;
  Eigen::VectorXd weight_;
};

}  // namespace secular
