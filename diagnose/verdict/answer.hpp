#pragma once

#include <string>

#include "diagnose/verdict/diagnosis.hpp"
#include "effects/catalogue.hpp"

namespace secular {

/// How much of the gap a diagnosis accounts for, from little to all.
enum class Accounted {
  doubtful,  ///< the gap is gone, and that is doubtful
  nothing,
  most,  ///< an approximate explanation
  all    ///< there is no gap beside it, or it is explained
};

Accounted how_much(const Diagnosis& diagnosis);

/// Whether one diagnosis accounts for more of the gap than another one does, or for as much of it and leaves less.
bool accounts_for_more(const Diagnosis& one, const Diagnosis& other);

/// Whether the diagnosis of decays in one piece is a better answer than the one by their segments: it explains as
/// much, or a gap that segments do not see, and what it names acts on the damping. What a frequency does that drifts
/// along a decay, which rows of one piece are not tried with, a law of the stiffness does as well: of such laws it can
/// but rule out some that segments named.
bool outranks_segments(const Diagnosis& whole, const Diagnosis& segments, const EffectCatalogue& catalogue);

/// Why what records have of their own beside an explanation is doubtful; empty: it is not.
std::string doubt_of_own(const Diagnosis& diagnosis);

}  // namespace secular
