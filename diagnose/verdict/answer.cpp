#include "diagnose/verdict/answer.hpp"

#include <algorithm>
#include <vector>

#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

bool acts_on_damping(const Diagnosis& d, const EffectCatalogue& catalogue) {
  std::vector<std::string> names = d.set;
  names.insert(names.end(), d.together.begin(), d.together.end());
  names.insert(names.end(), d.second_or.begin(), d.second_or.end());
  return !names.empty() && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    const Effect* effect = catalogue.find(name);
    return effect != nullptr && effect->component == EffectComponent::dissipative;
  });
}

// Whether it names none that the other does not, of a set without drifts.
bool narrows(const Diagnosis& one, const Diagnosis& other, const EffectCatalogue& catalogue) {
  const auto is_named = [&](const std::string& name) {
    return std::find(other.set.begin(), other.set.end(), name) != other.set.end();
  };
  const bool drifts = std::any_of(other.set.begin(), other.set.end(), [&](const std::string& name) {
    const Effect* effect = catalogue.find(name);
    return effect != nullptr && effect->is_of_time();
  });
  return other.verdict == "set" && !drifts && !one.set.empty() && one.together == other.together &&
         std::all_of(one.set.begin(), one.set.end(), is_named);
}

}  // namespace

Accounted how_much(const Diagnosis& d) {
  if (!d.frequency_scatter.suffices || (d.verdict == "unknown" && !d.gap.detected)) return Accounted::doubtful;
  if (is_told(d)) return Accounted::all;
  return d.verdict == "approximate" ? Accounted::most : Accounted::nothing;
}

bool accounts_for_more(const Diagnosis& one, const Diagnosis& other) {
  const Accounted by_one = how_much(one), by_other = how_much(other);
  return by_one > by_other || (by_one == by_other && one.gap.after < other.gap.after);
}

bool outranks_segments(const Diagnosis& whole, const Diagnosis& segments, const EffectCatalogue& catalogue) {
  if (!whole.gap.detected || whole.gap.noise_misjudged || !doubt_of_own(whole).empty()) return false;
  if (!acts_on_damping(whole, catalogue) && !narrows(whole, segments, catalogue)) return false;
  if (segments.gap.detected) return how_much(whole) >= how_much(segments);
  return whole.verdict != "unknown" || whole.gap.closed >= diagnose_thresholds().least_closing;
}

std::string doubt_of_own(const Diagnosis& d) {
  if (d.frequency_scatter.follows_settings)
    return "natural frequencies of each record's own beside it follow the records' settings, as what a missing law "
           "does to them";
  if (d.late.records.empty() || d.late.comes_at_random()) return "";
  switch (d.late.following) {
    case Following::too_few:
      return "too few records to tell whether they are late beside it";
    case Following::settings:
      return "how late records are beside it follows their settings, as what a missing law does to phases";
    case Following::at_random:
      break;
  }
  return "records are not late by different times beside it";
}

}  // namespace secular
