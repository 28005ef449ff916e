#include "diagnose/verdict/answer.hpp"

namespace secular {

Accounted how_much(const Diagnosis& d) {
  if (!d.frequency_scatter.suffices || (d.verdict == "unknown" && !d.gap.detected)) return Accounted::doubtful;
  if (is_told(d)) return Accounted::all;
  return d.verdict == "approximate" ? Accounted::most : Accounted::nothing;
}

bool accounts_for_more(const Diagnosis& one, const Diagnosis& other) {
  const Accounted by_one = how_much(one), by_other = how_much(other);
  return by_one > by_other || (by_one == by_other && one.gap.after < other.gap.after);
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
