#include "diagnose/verdict/foreign_search.hpp"

#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/gap_detection.hpp"

namespace secular {

// What is in the readings and no term of the equations makes is allowed for before anything is tried. What is large
// hides what is small, and where a line falls is known better beside a model that is fitted beside it.
bool holds_beside_foreign_content(ModelAlone left, const std::function<ModelAlone()>& fit, const Campaign& campaign,
                                  ForeignContent& foreign, DiagnosisOptions& options) {
  const ForeignContent in_records = foreign;
  for (std::size_t round = 0; round < diagnose_thresholds().foreign_searches &&
                              find_left_content(left.of_segments, left.of_records, campaign, foreign) > 0;
       ++round) {
    allow_for(foreign, campaign, options);
    left = fit();
    if (!is_more_than_noise(left.left)) return true;
  }
  foreign = in_records;
  allow_for(foreign, campaign, options);
  return false;
}

}  // namespace secular
