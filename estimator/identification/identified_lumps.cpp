#include "estimator/identification/identified_lumps.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Parameters are on their lumps within this part of a standard deviation; steps towards there.
constexpr double on_lumps = 1e-3;
constexpr int most_steps = 6;
/// Effects that differ by this share are the same.
constexpr double same_effect = 1e-6;

}  // namespace

VectorXd lumps_of(const std::vector<const CompiledCase*>& cases, const VectorXd& parameters) {
  std::size_t count = 0;
  for (const CompiledCase* resonance : cases) count += resonance->lumps.size();
  VectorXd lumps(static_cast<Index>(count));
  double* first = lumps.data();
  for (const CompiledCase* resonance : cases) {
    if (resonance->lumps.empty()) continue;
    resonance->evaluate_lumps(parameters.data(), first);
    first += resonance->lumps.size();
  }
  return lumps;
}

IdentifiedLumps::IdentifiedLumps(const Estimate& estimate) : cases_(estimate.cases) {
  weight_ = VectorXd::Zero(static_cast<Index>(estimate.lumps.size()));
  for (std::size_t l = 0; l < estimate.lumps.size(); ++l)
    if (const EstimatedValue& v = estimate.lumps[l]; v.value && v.sd > 0) weight_(static_cast<Index>(l)) = 1 / v.sd;
}

VectorXd IdentifiedLumps::at(const VectorXd& parameters) const {
  return weight_.cwiseProduct(lumps_of(cases_, parameters));
}

MatrixXd IdentifiedLumps::slope(const VectorXd& parameters) const {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> slope(weight_.size(), parameters.size());
  Index first = 0;
  for (const CompiledCase* resonance : cases_) {
    if (resonance->lumps.empty()) continue;
    resonance->evaluate_lumps_jacobian(parameters.data(), slope.row(first).data());
    first += static_cast<Index>(resonance->lumps.size());
  }
  return weight_.asDiagonal() * slope;
}

VectorXd IdentifiedLumps::returned(VectorXd parameters, const VectorXd& like, const MatrixXd& directions) const {
  const VectorXd scale = directions.rowwise().norm(), wanted = at(like);
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(same_effect);
  VectorXd left = at(parameters) - wanted;
  for (int step = 0; step < most_steps && left.norm() > on_lumps; ++step) {
    solver.compute(slope(parameters) * scale.asDiagonal());
    const VectorXd nearer = parameters - scale.cwiseProduct(solver.solve(left));
    const VectorXd still = at(nearer) - wanted;
    if (!(still.norm() < left.norm())) break;
    parameters = nearer;
    left = still;
  }
  return parameters;
}

VectorXd representative_parameters(const Estimate& estimate) {
  const VectorXd& values = estimate.parameter_values;
  if (estimate.null_space.cols() == 0 || estimate.null_coordinate.size() != estimate.null_space.cols())
    return values;
  return IdentifiedLumps(estimate).returned(values + estimate.null_space * estimate.null_coordinate, values,
                                            estimate.null_space);
}

std::vector<const CompiledCase*> identified_cases(const Estimate& estimate) {
  std::vector<const CompiledCase*> told;
  std::size_t first = 0;
  for (const CompiledCase* resonance : estimate.cases) {
    const bool known =
        std::all_of(resonance->blocks.begin(), resonance->blocks.end(), [&](const RegressorBlock& b) {
          return b.kind != BlockKind::modulation || std::all_of(b.lumps.begin(), b.lumps.end(), [&](int lump) {
                   return estimate.lumps[first + static_cast<std::size_t>(lump)].identifiable;
                 });
        });
    if (known) told.push_back(resonance);
    first += resonance->lumps.size();
  }
  return told;
}

}  // namespace secular
