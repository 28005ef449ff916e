#pragma once

#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// Lumps of a model as generated code has them: each definition once under its name, whatever cases have it.
class ModelLumps {
 public:
  struct Lump {
    const CanonicalLump* lump = nullptr;
    std::string function;  ///< "lump_alpha_e", of a later definition of that name "lump_alpha_e_of_CASE"
  };

  explicit ModelLumps(const CanonicalModel& model);

  const std::vector<Lump>& all() const { return lumps_; }
  /// Numbers of those of a case, in its order.
  const std::vector<int>& of_case(std::size_t resonance) const { return numbers_[resonance]; }

 private:
  std::vector<Lump> lumps_;
  std::vector<std::vector<int>> numbers_;
};

}  // namespace secular
