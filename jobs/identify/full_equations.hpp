#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "jobs/identify/identification.hpp"

namespace secular {

/// Of a campaign whose user does not say: the full ones where the window takes a sweep, a broadband record or an
/// impact that a channel drives.
Equations equations_for(const Campaign& campaign, const Window& window);

/// Whether the window takes a dwell or a free decay, of which the modulation equations tell numbers.
bool holds_dwells_or_decays(const Campaign& campaign, const Window& window);

/// Those of some records that the modulation equations say nothing of: sweeps and broadband records.
std::set<std::size_t> without_expansion(const Campaign& campaign, std::set<std::size_t> records);

/// What the modulation equations make of the dwells and free decays of the window, by name: a start for fits by the
/// full equations. Nothing where they make nothing of them, and then `why`, or where there are none.
std::map<std::string, double> start_by_modulation(const IdentificationRequest& request, const Campaign& campaign,
                                                  std::string& why);

/// A fit by the full equations, and what reading the records and beginning it had to say.
struct FullFit {
  FullEstimate of;
  std::vector<std::string> warnings;
  std::size_t looked_at = 0;  ///< records
};

/// Fits `id.model` to all records of the window in `id.campaign`. `begins`: as `starts` of
/// estimate_by_full_equations(). Throws InputError.
FullFit fit_full_equations(const IdentificationRequest& request, const Identification& id,
                           const ModelSource& source, const std::vector<std::map<std::string, double>>& begins);

/// Fits the model to all records of the window by its full equations of motion. Where dwells or free decays are
/// among them, the estimate by the modulation equations of these is the start; nominal values and natural
/// frequencies found in the records are where there is none, or where that leads nowhere. Throws InputError.
Identification identify_by_full_equations(const IdentificationRequest& request, const Campaign& campaign);

/// "3 sweeps, 2 dwells": records by kind, in the order of their number.
std::string records_in_words(const Campaign& campaign, const std::set<std::size_t>& records);

}  // namespace secular
