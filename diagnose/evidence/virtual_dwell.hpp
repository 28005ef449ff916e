#pragma once

#include <Eigen/Core>
#include <optional>

#include "diagnose/evidence/condition_rows.hpp"

namespace secular {

/// The dwell that `unknowns` predict at `level` times the excitation and `frequency` times the frequency of a
/// measured one: its lines as the channels would show them, with the errors of the measured one. Amplitudes are
/// followed from the measured ones in steps, Newton's method at each, so that the motion stays on the measured
/// branch. Nothing where that branch ends before (a saddle-node: the Jacobian of the balance changes sign) or where
/// no motion is found. Dwells of one base phase only.
std::optional<Condition> virtual_dwell(const ConditionModel& model, const Condition& measured,
                                       const Eigen::VectorXd& unknowns, double level, double frequency);

}  // namespace secular
