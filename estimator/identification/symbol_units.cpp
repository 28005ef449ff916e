#include "estimator/identification/symbol_units.hpp"

#include "estimator/identification/unit_text.hpp"
#include "measure/observe/modal_projection.hpp"

namespace secular {

SymbolUnits::SymbolUnits(const Campaign& campaign, const CompiledModel& model)
    : model_(model), coordinates_(model.modes(), modal_projection(campaign, model).unit) {
  for (const Channel& channel : campaign.channels)
    if (channel.role == ChannelRole::excitation) excitations_.push_back(channel.unit);
}

SymbolUnits::SymbolUnits(const CompiledModel& model)
    : model_(model), coordinates_(model.modes(), "kg^(1/2) m"), excitations_(model.excitations.size(), "m/s^2") {}

std::string SymbolUnits::of(std::size_t symbol) const {
  return symbol < model_.symbols.size() ? of(model_.symbols[symbol].dimension) : std::string();
}

std::string SymbolUnits::of(std::span<const Ratio> dimension) const {
  std::vector<std::string> excitations = excitations_;
  excitations.resize(model_.excitations.size());
  for (std::size_t e = excitations_.size(); e < excitations.size() && !dimension.empty(); ++e)
    if (dimension[coordinates_.size() + e].numerator != 0) return {};
  return unit_text(dimension, coordinates_, excitations);
}

}  // namespace secular
