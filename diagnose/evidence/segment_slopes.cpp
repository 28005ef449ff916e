#include "diagnose/evidence/segment_slopes.hpp"

#include <algorithm>
#include <utility>

#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// By the offset of a response channel, per `scale`.
VectorXd offset_slopes(const SegmentRows& rows, std::size_t channel, double scale) {
  const std::vector<Index> begins = rows.begins();
  VectorXd column(begins.back());
  for (std::size_t i = 0; i < rows.segments.size(); ++i) {
    const Segment& s = rows.segments[i].segment;
    const Index samples = s.response.cols(), c = static_cast<Index>(channel);
    VectorXd error = VectorXd::Zero(s.response.rows() * samples);
    error.segment(c * samples, samples).setConstant(-scale / s.noise_sd(c));
    rows.fill(i, rows.segments[i].seen(std::move(error)), column.segment(begins[i], rows.count(i)));
  }
  return column;
}

// Central, of half a scale.
MatrixXd differences(const SegmentRows& rows, const VectorXd& unknowns, const std::vector<std::size_t>& which,
                     const VectorXd& scale, unsigned threads) {
  constexpr std::size_t together = Lanes::count / 2;  // either side of each
  const std::vector<Index> begins = rows.begins();
  MatrixXd columns(begins.back(), static_cast<Index>(which.size()));
  const auto moved = [&](std::size_t w, double side) {
    VectorXd end = unknowns;
    end(static_cast<Index>(which[w])) += side * scale(static_cast<Index>(w));
    return end;
  };
  std::vector<VectorXd> ends;
  for (std::size_t w = 0; w < which.size(); ++w)
    for (const double side : {0.5, -0.5}) ends.push_back(moved(w, side));
  // Columns of all segments one after the other.
  const std::size_t count = rows.segments.size() * which.size();
  in_parallel((count + together - 1) / together, threads, [&](std::size_t task) {
    const std::size_t begin = task * together, end = std::min(begin + together, count);
    std::vector<const FrozenSegment*> of;
    std::vector<SegmentTrial> trials;
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t side = 0; side < 2; ++side) {
        of.push_back(&rows.segments[i / which.size()]);
        trials.push_back(of.back()->trial(ends[2 * (i % which.size()) + side]));
      }
    std::vector<VectorXd> errors = seen_errors(rows.model, of, std::move(trials));
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t segment = i / which.size(), up = 2 * (i - begin);
      VectorXd above(rows.count(segment)), below(rows.count(segment));
      rows.fill(segment, std::move(errors[up]), above);
      rows.fill(segment, std::move(errors[up + 1]), below);
      columns.col(static_cast<Index>(i % which.size())).segment(begins[segment], above.size()) = above - below;
    }
  });
  const std::size_t modes = rows.model.modes();
  for (std::size_t w = 0; w < which.size(); ++w) {
    auto column = columns.col(static_cast<Index>(w));
    const bool there = has_frequencies(ends[2 * w], modes) && has_frequencies(ends[2 * w + 1], modes);
    if (!there || !column.allFinite()) column.setZero();
  }
  return columns;
}

}  // namespace

MatrixXd segment_slopes(const SegmentRows& rows, const VectorXd& unknowns, const std::vector<std::size_t>& which,
                        const VectorXd& scale, unsigned threads) {
  const std::size_t channels = rows.model.sensors().responses.size();
  MatrixXd columns(rows.begins().back(), static_cast<Index>(which.size()));
  std::vector<std::size_t> others;
  std::vector<Index> places;
  for (std::size_t w = 0; w < which.size(); ++w) {
    std::size_t channel = 0;
    while (channel < channels && which[w] != rows.model.offset(channel)) ++channel;
    const auto place = static_cast<Index>(w);
    if (channel < channels) {
      columns.col(place) = offset_slopes(rows, channel, scale(place));
    } else {
      others.push_back(which[w]);
      places.push_back(place);
    }
  }
  columns(Eigen::all, places) = differences(rows, unknowns, others, scale(places), threads);
  return columns;
}

}  // namespace secular
