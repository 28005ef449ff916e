#include "jobs/identify/case_view.hpp"

#include <algorithm>

namespace secular {

CaseView view_of(const Identification& id, std::size_t c) {
  return {id.model.get(),     id.measured[c].resonance, id.campaign,
          id.measured[c],     id.replayed[c],           id.estimate,
          id.coordinate_unit, id.excitation_units,      mode_frequencies(*id.model, *id.measured[c].resonance)};
}

std::size_t first_mode(const CaseView& view) {
  for (std::size_t k = 0; k < view.model->modes(); ++k)
    if (view.modes.oscillates[k]) return k;
  return 0;
}

std::vector<std::size_t> modes_seen(const CaseView& view) {
  std::vector<std::size_t> seen;
  for (std::size_t k = 0; k < view.model->modes(); ++k)
    if (view.modes.oscillates[k] &&
        std::any_of(view.measured.observations.begin(), view.measured.observations.end(),
                    [&](const Observation& o) { return o.growth_sd[k] >= 0; }))
      seen.push_back(k);
  return seen;
}

}  // namespace secular
