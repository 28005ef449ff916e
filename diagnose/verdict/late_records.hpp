#pragma once

#include <vector>

#include "diagnose/evidence/discrepancy.hpp"
#include "estimator/identification/setting_functions.hpp"

namespace secular {

/// How late the responses of dwells are against their excitation (docs/inference.md (24)).
struct LateRecords {
  std::vector<OwnLateness> records;
  /// Level, frequency and order of the records (F law, 5 %), as what a missing law does to phases does.
  Following following = Following::at_random;
  bool differ = false;  ///< from record to record, beyond what each leaves open
  bool plain = false;   ///< a law that made six tenths of it would be seen

  bool comes_at_random() const { return differ && following == Following::at_random; }
  bool is_plain() const { return comes_at_random() && plain; }
};

/// Beside the unknowns that a discrepancy was last frozen at.
LateRecords lateness_about(const Discrepancy& discrepancy);

}  // namespace secular
