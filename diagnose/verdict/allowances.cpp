#include "diagnose/verdict/allowances.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/blows_alone.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

// What decays tell of a mode outranks what the model as it is leaves of it.
void take_decays(FrequencyScatter& scatter, const Eigen::VectorXd& decays) {
  for (Eigen::Index k = 0; k < std::min(decays.size(), scatter.sd.size()); ++k)
    if (decays(k) > 0) scatter.sd(k) = decays(k);
}

// Laws that follow settings would leave more of it than an approximate explanation may.
bool scatters_at_random(const FrequencyScatter& scatter) {
  return scatter.any() &&
         (!scatter.follows_settings || scatter.at_random > 1 - diagnose_thresholds().most_of_the_gap);
}

std::ptrdiff_t excitation_count(const Campaign& campaign) {
  return std::count_if(campaign.channels.begin(), campaign.channels.end(),
                       [](const Channel& channel) { return channel.role == ChannelRole::excitation; });
}

// Not where one time of all does as well, which is a cause, channel_skew, and no disturbance.
bool are_late(const ModelAlone& late, const ModelAlone& plain, const FitBeside& fit_beside) {
  if (late.late.records.size() < 2 || !lateness_takes_more_than_chance(plain, late)) return false;
  std::vector<double> late_s;
  for (const OwnLateness& record : late.late.records) late_s.push_back(record.late_s);
  return lateness_takes_more_than_chance(fit_beside({}, upper_median(std::move(late_s))), late);
}

}  // namespace

Allowances find_allowances(const CampaignAndModel& sides, const ModelAlone& plain, const Eigen::VectorXd& decays,
                           const FitBeside& fit_beside) {
  const Eigen::VectorXd first = first_frequency_scatter(sides.model.modes());
  Allowances found{{{}}, {}};
  std::vector<Allowance>& all = found.all;
  ModelAlone scatter = fit_beside({false, first}, {});
  take_decays(scatter.scatter, decays);
  const bool at_random = scatters_at_random(scatter.scatter);
  if (at_random) all.push_back({false, admitted(scatter.scatter), Allowance::at_random, scatter.dispersion()});
  if (scatter.scatter.any()) found.scatter_alone = admitted(scatter.scatter);
  const auto of_records_in_step = [&] {
    if (scatter.scatter.any() && !at_random)
      all.push_back({false, admitted(scatter.scatter), Allowance::at_last, scatter.dispersion()});
    return found;
  };
  if (!may_be_late(sides)) return of_records_in_step();
  const ModelAlone late = fit_beside({true, {}}, {});
  if (!are_late(late, plain, fit_beside)) return of_records_in_step();
  if (late.late.comes_at_random() || late.late.following == Following::too_few)
    all.push_back({true, {}, late.late.is_plain() ? Allowance::at_random : Allowance::at_last, late.dispersion()});
  // Frequencies of late records follow the settings as their phases do, until they are in step.
  ModelAlone both = fit_beside({true, first}, {});
  take_decays(both.scatter, decays);
  if (scatters_at_random(both.scatter) && both.late.comes_at_random() &&
      lateness_takes_more_than_chance(scatter, both))
    all.push_back({true, admitted(both.scatter), Allowance::both, both.dispersion()});
  return found;
}

std::vector<Allowance> in_turn(std::vector<Allowance> allowances) {
  std::stable_sort(allowances.begin(), allowances.end(), [](const Allowance& a, const Allowance& b) {
    return std::tie(a.turn, a.left) < std::tie(b.turn, b.left);
  });
  return allowances;
}

bool may_be_late(const CampaignAndModel& sides) {
  const std::vector<RecordEntry>& records = sides.campaign.records;
  const bool dwells =
      std::any_of(records.begin(), records.end(), [](const RecordEntry& record) { return is_steady(record.kind); });
  return !sides.model.excitations.empty() && excitation_count(sides.campaign) == 1 && dwells;
}

bool has_blows(const CampaignAndModel& sides, const DiagnosisOptions& options) {
  const std::vector<bool> impacts = chosen_impacts(sides.campaign, options.window);
  return sides.model.excitations.size() > options.forces.size() && excitation_count(sides.campaign) > 0 &&
         std::find(impacts.begin(), impacts.end(), true) != impacts.end();
}

}  // namespace secular
