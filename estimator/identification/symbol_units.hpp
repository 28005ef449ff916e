#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "measure/data/campaign.hpp"

namespace secular {

/// Units of a model's coordinates, excitations, symbols and lumps.
class SymbolUnits {
 public:
  /// From those of the campaign's channels. Throws InputError where channels and coordinates do not fit together.
  SymbolUnits(const Campaign& campaign, const CompiledModel& model);
  /// Coordinates are modal ones, excitations accelerations.
  explicit SymbolUnits(const CompiledModel& model);

  const std::string& coordinate() const { return coordinates_.front(); }
  /// "1" for none, empty where the equations do not fix it, or where it is no symbol of the model.
  std::string of(std::size_t symbol) const;
  /// The same of a lump's powers of units, as those of a symbol.
  std::string of(std::span<const Ratio> dimension) const;

 private:
  const CompiledModel& model_;
  std::vector<std::string> coordinates_, excitations_;
};

}  // namespace secular
