#pragma once

#include <string>
#include <vector>

#include "perturb/model.hpp"

namespace secular::verify {

/// Helmholtz's conditions: equations E_i(q, q', q'') = 0 are Lagrange's equations of some Lagrangian exactly if
///   dE_i/dq_j'' = dE_j/dq_i'',
///   dE_i/dq_j' + dE_j/dq_i' = d/dt (dE_i/dq_j'' + dE_j/dq_i''),
///   dE_i/dq_j - dE_j/dq_i = 1/2 d/dt (dE_i/dq_j' - dE_j/dq_i').
/// The equations are the model's with the parameters `without` (damping, excitation) zero. Returns what fails, as
/// text; empty if all hold.
std::vector<std::string> broken_lagrangian_symmetries(const Model& model, const std::vector<std::string>& without);

}  // namespace secular::verify
