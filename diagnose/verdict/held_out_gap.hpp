#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "diagnose/inference/held_out.hpp"
#include "diagnose/inference/inference.hpp"

namespace secular {

/// A gap on conditions that were held out: what explanations leave of it there. Predicting that takes long, and of
/// some explanations it is asked more than once: it is done once for each.
class HeldOutGap {
 public:
  /// Of rows that nothing was fitted to (`given`), or else of those that the model as it is (`null`) predicts.
  /// `floor`: as closed_share() takes it. What is referred to, and all explanations, have to outlive this.
  HeldOutGap(const Discrepancy& discrepancy, const std::vector<RowLabel>& labels,
             const std::optional<Eigen::VectorXd>& given, const Explanation& null, double floor);

  /// Shares are those of what lies in these directions from here on; before, of all.
  void measure_in(GapSpan span) { span_ = std::move(span); }
  const GapSpan& span() const { return span_; }

  ClosedShare closed_by(const Explanation& explanation);
  /// Of the gap as it is: none.
  ClosedShare unclosed() const { return closed_share(before_, before_, labels_, floor_); }
  /// Whether conditions repeat it that `explanation` leaves less than `limit` (as repeats() takes it).
  bool repeats_step(const Explanation& limit, const Explanation& explanation);

 private:
  const Eigen::VectorXd& rows(const Explanation& explanation);

  const Discrepancy& discrepancy_;
  const std::vector<RowLabel>& labels_;
  double floor_;
  GapSpan span_;
  std::map<const Explanation*, Eigen::VectorXd> predicted_;
  Eigen::VectorXd before_;
};

}  // namespace secular
