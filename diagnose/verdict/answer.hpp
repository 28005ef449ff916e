#pragma once

#include <string>

#include "diagnose/verdict/diagnosis.hpp"

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

/// Why what records have of their own beside an explanation is doubtful; empty: it is not.
std::string doubt_of_own(const Diagnosis& diagnosis);

}  // namespace secular
