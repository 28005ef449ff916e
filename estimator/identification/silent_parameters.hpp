#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// By CompiledModel::symbols: the size with which a parameter alone would do as much to some mode's motion as all
/// forces do there but the linear spring's, by the full equations of motion at the largest amplitudes of the `sets`
/// (root mean square over the modes' phases, without excitation); of all modes the smallest. 0 where it acts on
/// none that moves.
Eigen::VectorXd sizes_by_force(const CompiledModel& model, std::span<const ObservationSet* const> sets,
                               const Eigen::VectorXd& parameters);

}  // namespace secular
