#pragma once

#include <vector>

#include "diagnose/evidence/segment_model.hpp"

namespace secular {

/// A search for the state that a segment begins at.
struct StateSearch {
  const Segment& segment;
  Eigen::VectorXd state;              ///< from which on, then which was found; of find_states() it may be empty
  Eigen::Index samples;               ///< that count: the first ones
  std::vector<Eigen::Index> without;  ///< of which these do not
  double squared_error = 0;           ///< that was found
};

/// Gauss-Newton of every search. Motions of all are integrated side by side; each goes as it would alone.
void improve_states(const SegmentModel& model, const Eigen::VectorXd& unknowns, std::vector<StateSearch>& searches);

/// The states that segments begin at which fit best what counts of them: from the state of each search, where it
/// has one, and from a new one.
void find_states(const SegmentModel& model, const Eigen::VectorXd& unknowns, std::vector<StateSearch>& searches);

}  // namespace secular
