#include "diagnose/verdict/held_out_gap.hpp"

namespace secular {

using Eigen::VectorXd;

HeldOutGap::HeldOutGap(const Discrepancy& discrepancy, const std::vector<RowLabel>& labels,
                       const std::optional<VectorXd>& given, const Explanation& null, double floor)
    : discrepancy_(discrepancy), labels_(labels), floor_(floor), before_(given ? *given : rows(null)) {}

ClosedShare HeldOutGap::closed_by(const Explanation& explanation) {
  return closed_share(before_, rows(explanation), labels_, floor_, span_);
}

bool HeldOutGap::repeats_step(const Explanation& limit, const Explanation& explanation) {
  return repeats(rows(limit), rows(explanation), labels_);
}

const VectorXd& HeldOutGap::rows(const Explanation& explanation) {
  const auto [place, fresh] = predicted_.try_emplace(&explanation);
  if (fresh) place->second = predict_held_out(discrepancy_, explanation.fit, labels_).rows;
  return place->second;
}

}  // namespace secular
