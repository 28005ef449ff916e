#pragma once

#include <cstddef>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// Calls visit(i, other) for every observation i of `first` that `second` has as `other`: of the same record at the
/// same instant. Both are in the order of records and instants.
template <class Visit>
void for_common_observations(const ObservationSet& first, const ObservationSet& second, const Visit& visit) {
  std::size_t from = 0;
  for (std::size_t i = 0; i < first.observations.size(); ++i) {
    const Observation& o = first.observations[i];
    const auto before = [&](const Observation& other) {
      return other.record < o.record || (other.record == o.record && other.centre_s < o.centre_s);
    };
    while (from < second.observations.size() && before(second.observations[from])) ++from;
    if (from == second.observations.size()) return;
    const Observation& other = second.observations[from];
    if (other.record == o.record && other.centre_s == o.centre_s) visit(i, from);
  }
}

}  // namespace secular
