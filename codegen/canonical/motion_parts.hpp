#pragma once

#include <optional>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// Some terms of the equations of motion.
struct MotionPart {
  /// Parameter that multiplies all of them: where it is zero there is nothing to compute. None: the model's own.
  std::optional<std::size_t> strength;
  std::vector<std::vector<CanonicalMotionTerm>> motion;  ///< [mode]

  bool has_inertia() const;  ///< terms with an acceleration
};

/// The equations of motion as a sum: the model's own part, then that of every added effect that has a term.
std::vector<MotionPart> motion_parts(const CanonicalModel& model);

}  // namespace secular
