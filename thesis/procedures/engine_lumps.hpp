#pragma once

#include <Eigen/Core>

#include "estimator/model/compiled_model.hpp"
#include "thesis/procedures/two_mode_regression.hpp"

namespace secular {

/// Table 6.2's lumps of any model of two modes at an additive combination resonance, read off its generated
/// modulation equations at exact resonance, in the thesis's names (6.25)-(6.27):
///   A1' = -mu11 A1 - (3/2) w1^2 mu13 A1^2 conj(A1)
///         + (i/w1) (Gamma_1 A1 + 4 Gamma_2 A1^2 conj(A1) + 4 Gamma_3 A1 A2 conj(A2) + Gamma_4 A1 F^2
///                   + (Gamma_5 + i Gamma_6) conj(A2) F),
/// and its sibling. `parameters` by CompiledModel::symbols. Throws std::invalid_argument for another number of
/// modes or excitations, or another relation.
Eigen::VectorXd two_mode_lumps(const CompiledModel& model, const CompiledCase& resonance,
                               const Eigen::Ref<const Eigen::VectorXd>& parameters);

/// Whether the case is Omega = w1 + w2 of a model with two modes and one excitation.
bool is_additive_combination(const CompiledModel& model, const CompiledCase& resonance);

}  // namespace secular
