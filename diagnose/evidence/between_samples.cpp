#include "diagnose/evidence/between_samples.hpp"

#include <array>
#include <utility>
#include <vector>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Two thirds of what a signal does are of halfway between its samples (Simpson's rule).
constexpr double part_between = 2.0 / 3;

}  // namespace

Segment stronger_between_samples(Segment s, double share) {
  for (Index i = 1; i < s.excitation.cols(); i += 2) s.excitation.col(i) *= 1 + share / part_between;
  return s;
}

Segment later_between_samples(Segment s, double late_s) {
  for (Index i = 1; i + 1 < s.excitation.cols(); i += 2)
    s.excitation.col(i) -= late_s / part_between / s.sample_s * (s.excitation.col(i + 1) - s.excitation.col(i - 1));
  return s;
}

MatrixXd between_samples_columns(const SegmentRows& rows, const VectorXd& unknowns,
                                 const BetweenSamples& of_blows) {
  if (of_blows.records.empty()) return {};
  const std::vector<Index> begins = rows.begins();
  MatrixXd columns = MatrixXd::Zero(begins.back(), 2);
  for (std::size_t i = 0; i < rows.segments.size(); ++i) {
    const FrozenSegment& f = rows.segments[i];
    if (!of_blows.records.contains(f.segment.record)) continue;
    constexpr double step = 1e-3;  // of a standard deviation
    const std::array<Segment, 2> moved{
        stronger_between_samples(f.segment, step * of_blows.share),
        later_between_samples(f.segment, step * of_blows.share / of_blows.frequency)};
    std::vector<SegmentTrial> trials{f.trial(unknowns)};
    for (const Segment& s : moved) trials.push_back({s, s.response.cols(), unknowns, f.state});
    const std::vector<VectorXd> errors = seen_errors(rows.model, {&f, &f, &f}, trials);
    for (Index side : {0, 1}) {
      VectorXd own(rows.count(i));
      rows.fill(i, (errors[static_cast<std::size_t>(side + 1)] - errors[0]) / step, own);
      columns.col(side).segment(begins[i], own.size()) = own;
    }
  }
  return columns;
}

}  // namespace secular
