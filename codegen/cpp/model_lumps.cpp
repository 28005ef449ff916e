#include "codegen/cpp/model_lumps.hpp"

#include <algorithm>
#include <set>

#include "codegen/expression/cpp_expression.hpp"

namespace secular {

ModelLumps::ModelLumps(const CanonicalModel& model) {
  std::set<std::string> taken;
  for (const std::string& symbol : model.order) taken.insert(safe_identifier(symbol));
  for (const CanonicalCase& c : model.cases) {
    numbers_.emplace_back();
    for (const CanonicalLump& lump : c.lumps) {
      const auto known = std::find_if(lumps_.begin(), lumps_.end(), [&](const Lump& other) {
        return other.lump->name == lump.name && other.lump->definition == lump.definition &&
               other.lump->dimension == lump.dimension;
      });
      numbers_.back().push_back(static_cast<int>(known - lumps_.begin()));
      if (known != lumps_.end()) continue;
      std::string function = "lump_" + lump.name;
      if (taken.contains(function)) function += "_of_" + c.name;
      while (!taken.insert(function).second) function += "_also";
      lumps_.push_back({&lump, function});
    }
  }
}

}  // namespace secular
