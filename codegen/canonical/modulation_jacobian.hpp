#pragma once

#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/canonical/variable_sum.hpp"

namespace secular {

/// The variables of the Cartesian form as a VariableSum counts them: of every mode x, y, r = sqrt(x^2 + y^2) and
/// its frame offset (observed minus natural frequency), then the excitations.
struct CartesianVariables {
  std::size_t modes = 0, excitations = 0;
  std::size_t x(std::size_t mode) const { return 4 * mode; }
  std::size_t y(std::size_t mode) const { return 4 * mode + 1; }
  std::size_t norm(std::size_t mode) const { return 4 * mode + 2; }
  std::size_t offset(std::size_t mode) const { return 4 * mode + 3; }
  std::size_t forcing(std::size_t excitation) const { return 4 * modes + excitation; }
  std::size_t count() const { return 4 * modes + excitations; }
};

/// Linearisation of the Cartesian form in the observed frame, the turning of the frame included: with z = (x_1,
/// y_1, x_2, y_2, ...) and dz/dt = f(z), entry[i][j] = df_i/dz_j.
struct ModulationJacobian {
  CartesianVariables variables;
  std::vector<VariableSum> right_side;          ///< f
  std::vector<std::vector<VariableSum>> entry;  ///< 2n rows of 2n
  bool regular_at_zero = true;                  ///< no odd power of a modulus r
  bool complete = true;                         ///< no term is left to quadrature
};

/// Of one case, of all modes; terms that are left to quadrature are not in it.
ModulationJacobian modulation_jacobian(const CanonicalModel& model, const CanonicalCase& resonance);

}  // namespace secular
