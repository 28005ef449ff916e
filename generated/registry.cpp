// Models compiled into this program: generated code, never edited by hand.
#include "generated/registry.hpp"

namespace secular::generated {

namespace pendulum {
extern const CompiledModel model;
}
namespace two_mass_lumps {
extern const CompiledModel model;
}
namespace two_mass_mode1 {
extern const CompiledModel model;
}

std::span<const CompiledModel* const> compiled_models() {
  static const CompiledModel* const models[] = {
    &pendulum::model,
    &two_mass_lumps::model,
    &two_mass_mode1::model,
  };
  return models;
}

const CompiledModel* find_compiled_model(std::string_view name) {
  for (const CompiledModel* model : compiled_models())
    if (model->name == name) return model;
  return nullptr;
}

}  // namespace secular::generated
