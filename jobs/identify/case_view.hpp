#pragma once

#include <string>
#include <vector>

#include "jobs/identify/identification.hpp"
#include "measure/observe/mode_frequencies.hpp"

namespace secular {

/// One case of an identification, for its figures. Refers to the identification.
struct CaseView {
  const CompiledModel* model;
  const CompiledCase* resonance;
  const Campaign& campaign;
  const ObservationSet &measured, &replayed;
  const Estimate& estimate;
  const std::string& coordinate_unit;
  const std::vector<std::string>& excitation_units;
  ModeFrequencies modes;

  /// Whether the full equations made every motion that was observed.
  bool is_replayed() const { return replayed.observations.size() == measured.observations.size(); }
};

CaseView view_of(const Identification& id, std::size_t c);

/// The first one that oscillates.
std::size_t first_mode(const CaseView& view);

/// Modes of a decay that ring in some of its windows.
std::vector<std::size_t> modes_seen(const CaseView& view);

}  // namespace secular
