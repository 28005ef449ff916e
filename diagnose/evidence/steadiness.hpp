#pragma once

#include <string>
#include <vector>

#include "diagnose/evidence/condition.hpp"
#include "diagnose/evidence/nonstationarity.hpp"
#include "measure/data/campaign.hpp"

namespace secular {

/// Settled motions that vary within dwells by more than noise though the excitation is steady: a force that no
/// channel records, or a structure that changes from minute to minute. No effect of the catalogue does that.
struct Unsteadiness {
  bool detected = false;
  double p_value = 1;
  double ratio = 1;    ///< variation of resonant lines over that of the noise beside them
  std::string record;  ///< where it is largest
};

/// One test of all dwells (test_nonstationarity) at `diagnose_thresholds().unsteady_alarm`. `campaign`: the one
/// that `record` of each dwell is an index into. Of no dwell nothing is detected.
Unsteadiness judge_steadiness(const std::vector<Nonstationarity>& nonstationarity, const Campaign& campaign);

/// Takes out the conditions whose motion is not steady, and their nonstationarity, as long as most are: a few
/// dwells that vary have no mean motion to compare; where most do, the mean is all there is. Returns the files they
/// came from.
std::vector<std::string> leave_out_unsteady(std::vector<Condition>& conditions,
                                            std::vector<Nonstationarity>& nonstationarity,
                                            const Campaign& campaign);

}  // namespace secular
