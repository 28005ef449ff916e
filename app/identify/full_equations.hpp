#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/shared/identification.hpp"
#include "diagnose/verdict/full_estimate.hpp"

namespace secular::app {

/// The equations that numbers come from.
enum class Equations {
  modulation,  ///< of each resonance case: dwells, free decays, tables of lines
  full         ///< of motion: records of any kind, in one likelihood
};

/// Of a campaign whose user does not say: the full ones where the window takes a sweep, a broadband record or an
/// impact that a channel drives.
Equations equations_for(const Campaign& campaign, const Window& window);

std::set<std::size_t> records_within(const Campaign& campaign, const Window& window);

/// Those of some records that the modulation equations say nothing of: sweeps and broadband records.
std::set<std::size_t> without_expansion(const Campaign& campaign, std::set<std::size_t> records);

/// What a run by the full equations found.
struct FullIdentification {
  Identification of;  ///< without cases, observations and lumps
  FullEstimate full;  ///< its estimate and disturbances are in `of`
};

/// Fits the model to all records of the window by its full equations of motion. Where dwells or free decays are
/// among them, the estimate by the modulation equations of these is the start; nominal values and natural
/// frequencies found in the records are where there is none, or where that leads nowhere. `progress`: see
/// estimate_by_full_equations(). Throws InputError.
FullIdentification identify_by_full_equations(const IdentificationRequest& request,
                                              const SearchProgress& progress = {});

/// "3 sweeps, 2 dwells": records by kind, in the order of their number.
std::string records_in_words(const Campaign& campaign, const std::set<std::size_t>& records);

}  // namespace secular::app
