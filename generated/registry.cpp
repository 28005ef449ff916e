// Models compiled into this program: generated code, never edited by hand.
#include "registry.hpp"

namespace secular::generated {

namespace duffing {
extern const CompiledModel model;
}
namespace internal_resonance {
extern const CompiledModel model;
}
namespace mathieu_duffing {
extern const CompiledModel model;
}
namespace parametric_pair {
extern const CompiledModel model;
}
namespace pendulum {
extern const CompiledModel model;
}
namespace three_modes {
extern const CompiledModel model;
}
namespace two_mass {
extern const CompiledModel model;
}
namespace two_mass_frame {
extern const CompiledModel model;
}
namespace two_mass_lumps {
extern const CompiledModel model;
}
namespace two_mass_mode1 {
extern const CompiledModel model;
}
namespace van_der_pol {
extern const CompiledModel model;
}

std::span<const CompiledModel* const> compiled_models() {
  static const CompiledModel* const models[] = {
    &duffing::model,
    &internal_resonance::model,
    &mathieu_duffing::model,
    &parametric_pair::model,
    &pendulum::model,
    &three_modes::model,
    &two_mass::model,
    &two_mass_frame::model,
    &two_mass_lumps::model,
    &two_mass_mode1::model,
    &van_der_pol::model,
  };
  return models;
}

const CompiledModel* find_compiled_model(std::string_view name) {
  for (const CompiledModel* model : compiled_models())
    if (model->name == name) return model;
  return nullptr;
}

}  // namespace secular::generated
