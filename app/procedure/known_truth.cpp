#include "app/procedure/known_truth.hpp"

#include <filesystem>
#include <map>
#include <vector>

#include "estimator/model/by_name.hpp"
#include "input/input_error.hpp"
#include "jobs/shared/parameter_file.hpp"
#include "jobs/shared/shipped_models.hpp"
#include "motion/simulate/experiment.hpp"

namespace secular::app {

using Eigen::Index;

KnownTruth::KnownTruth(const std::string& source, const CompiledModel& model, const CompiledCase& resonance)
    : model_(&model), resonance_(&resonance) {
  if (source.empty()) return;
  const bool experiment =
      std::filesystem::path(source).extension() == ".toml" || source.rfind("experiments/", 0) == 0;
  if (experiment) {
    parameters_ = read_experiment(resolve_model(source), model).parameters;
    return;
  }
  const std::map<std::string, double> given = read_parameter_file(source).values;
  parameters_ = Eigen::VectorXd::Zero(static_cast<Index>(model.symbols.size()));
  for (std::size_t s = 0; s < model.symbols.size(); ++s) {
    const auto found = given.find(std::string(model.symbols[s].name));
    if (found == given.end())
      throw InputError(source, "", "gives no value for " + std::string(model.symbols[s].name),
                       "the numbers that the campaign was simulated with, all of them");
    parameters_(static_cast<Index>(s)) = found->second;
  }
}

std::optional<double> KnownTruth::symbol(std::string_view name) const {
  if (!known()) return {};
  if (const auto place = place_of(model_->symbols, name)) return parameters_(static_cast<Index>(*place));
  return {};
}

std::optional<double> KnownTruth::lump(std::string_view name) const {
  if (!known()) return {};
  std::vector<double> values(resonance_->lumps.size());
  resonance_->evaluate_lumps(parameters_.data(), values.data());
  if (const auto place = place_of(resonance_->lumps, name)) return values[*place];
  return symbol(name);
}

}  // namespace secular::app
