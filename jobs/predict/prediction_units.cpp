#include "jobs/predict/prediction_units.hpp"

#include "estimator/identification/symbol_units.hpp"

namespace secular {
namespace {

// Names behind the symbols: frequencies of excitations, then their amplitudes.
void take_campaign(const Campaign& campaign, Prediction& prediction) {
  const CompiledModel& model = *prediction.model;
  const SymbolUnits units(campaign, model);
  for (std::size_t s = 0; s < model.symbols.size(); ++s)
    if (prediction.units[s].empty()) prediction.units[s] = units.of(s);
  std::size_t amplitude = model.symbols.size() + model.excitation_frequencies.size();
  for (const Channel& channel : campaign.channels)
    if (channel.role == ChannelRole::excitation && amplitude < prediction.units.size())
      prediction.units[amplitude++] = channel.unit;
  if (prediction.coordinate_unit.empty()) prediction.coordinate_unit = units.coordinate();
}

}  // namespace

void find_units(const PredictionRequest& request, const GivenParameters& given, Prediction& prediction) {
  const CompiledModel& model = *prediction.model;
  prediction.units.assign(prediction.names.size(), "");
  prediction.coordinate_unit = given.coordinate_unit;
  for (std::size_t p = 0; p < prediction.names.size(); ++p) {
    const auto known = given.units.find(prediction.names[p]);
    const bool frequency =
        p >= model.symbols.size() && p < model.symbols.size() + model.excitation_frequencies.size();
    if (p < model.modes() || frequency)
      prediction.units[p] = "rad/s";
    else if (known != given.units.end())
      prediction.units[p] = known->second;
  }
  if (!request.measured.empty())
    take_campaign(request.campaign ? *request.campaign : read_campaign(request.measured), prediction);
}

}  // namespace secular
