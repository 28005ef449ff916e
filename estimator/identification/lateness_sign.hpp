#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace secular {

/// How late a case's records are, in seconds, if one of the minima of docs/inference.md (17) holds; angles beyond
/// half a period off their common direction are brought near to it by whole periods. So many whole periods more of
/// each as make one delay of them, if they scatter the less (34).
struct LatenessOfRecords {
  std::vector<double> late_s;
  double period_s = 0;  ///< of the excitation, mean of the records
};

/// `ahead`: by record what the excitation has to be put ahead by; `frequency` in rad/s.
LatenessOfRecords lateness_of_records(const std::vector<double>& ahead, const std::vector<double>& frequency);

/// Which of several minima that differ in the sign of the excitation, half a period apart, is the right one, from
/// the records' lateness alone (docs/inference.md (20), (21), (34)). Nothing where it does not tell.
std::optional<std::size_t> told_by_own_lateness(const std::vector<LatenessOfRecords>& minima);

/// The same from the lateness of records of other cases of the campaign, which one recorder took (22). Nothing
/// where it does not tell.
std::optional<std::size_t> told_by_other_lateness(const std::vector<LatenessOfRecords>& minima,
                                                  const std::vector<double>& others_s);

}  // namespace secular
