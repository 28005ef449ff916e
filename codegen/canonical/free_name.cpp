#include "codegen/canonical/free_name.hpp"

#include <algorithm>
#include <initializer_list>

namespace secular {
namespace {

bool is_taken(const CanonicalModel& model, const std::string& name) {
  for (const std::vector<std::string>* names :
       {&model.order, &model.coordinates, &model.excitations, &model.excitation_frequencies,
        &model.natural_frequencies, &model.parameters})
    if (std::find(names->begin(), names->end(), name) != names->end()) return true;
  for (const CanonicalCase& c : model.cases) {
    for (const CanonicalLump& lump : c.lumps)
      if (lump.name == name) return true;
    for (const CanonicalRelation& relation : c.relations)
      if (relation.detuning == name) return true;
  }
  for (const std::string& coordinate : model.coordinates)
    for (const char* quantity : {"A_", "B_", "a_", "beta_", "x_", "y_"})
      if (quantity + coordinate == name) return true;
  return false;
}

}  // namespace

std::string free_name(const CanonicalModel& model, std::string wanted) {
  while (is_taken(model, wanted)) wanted += '_';
  return wanted;
}

std::string observed_frequency_name(const CanonicalModel& model, std::size_t mode) {
  return free_name(model, model.coordinates.size() == 1 ? "omega_obs" : "omega_obs_" + model.coordinates[mode]);
}

}  // namespace secular
