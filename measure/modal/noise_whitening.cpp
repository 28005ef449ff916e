#include "measure/modal/noise_whitening.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Filter of the prediction error, [0] = 1, from the columns of one channel: Burg's recursion, whose reflections are
// below one, as long as Schwarz's criterion gains by it.
VectorXd prediction_error_filter(const MatrixXd& columns, Index longest) {
  MatrixXd forward = columns, backward = columns;
  VectorXd filter = VectorXd::Ones(1), best = filter;
  double power = columns.squaredNorm() / static_cast<double>(columns.size()), least = 0;
  const auto count = static_cast<double>(columns.size());
  double criterion = 0;  // against order zero
  for (Index order = 1; order <= longest; ++order) {
    const Index rows = forward.rows() - 1;
    const MatrixXd ahead = forward.bottomRows(rows), behind = backward.topRows(rows);
    const double energy = ahead.squaredNorm() + behind.squaredNorm();
    if (!(energy > 0)) break;
    const double reflection = -2 * ahead.cwiseProduct(behind).sum() / energy;
    const double gain = 1 - reflection * reflection;
    if (!(gain > 0)) break;
    VectorXd longer = VectorXd::Zero(order + 1);
    longer.head(order) = filter;
    longer.tail(order) += reflection * filter.reverse();
    filter = longer;
    forward = ahead + reflection * behind;
    backward = behind + reflection * ahead;
    power *= gain;
    criterion += count * std::log(gain) + std::log(count);
    if (criterion < least) {
      least = criterion;
      best = filter;
    }
  }
  return best;
}

}  // namespace

NoiseWhitening::NoiseWhitening(const Eigen::Ref<const MatrixXd>& left, Index channels, Index unknowns,
                               double floor) {
  if (channels < 1 || left.cols() % channels != 0) throw std::invalid_argument("NoiseWhitening: no whole records");
  // Most coefficients of a predictor: a tenth of the rows determines them; beyond 40 the bands that a filter tells
  // apart are as narrow as modes.
  const Index records = left.cols() / channels, longest = std::min<Index>(40, left.rows() / 10);
  if (left.rows() <= unknowns + longest + channels)
    throw std::invalid_argument("NoiseWhitening: too few rows for the fit that was made");
  for (Index c = 0; c < channels; ++c) {
    MatrixXd of_channel(left.rows(), records);
    for (Index r = 0; r < records; ++r) of_channel.col(r) = left.col(r * channels + c);
    filters_.push_back(prediction_error_filter(of_channel, longest));
    order_ = std::max(order_, filters_.back().size() - 1);
  }
  const MatrixXd noise = filtered(left);
  for (Index r = 0; r < records; ++r) {
    const MatrixXd of_record = noise.middleCols(r * channels, channels);
    MatrixXd covariance = of_record.transpose() * of_record / static_cast<double>(noise.rows() - unknowns);
    covariance.diagonal().array() += floor * floor;
    const MatrixXd lower = covariance.llt().matrixL();
    mixing_.push_back(
        lower.triangularView<Eigen::Lower>().solve(MatrixXd(MatrixXd::Identity(channels, channels))).transpose());
  }
}

MatrixXd NoiseWhitening::filtered(const Eigen::Ref<const MatrixXd>& samples) const {
  const Index rows = samples.rows() - order_, channels = static_cast<Index>(filters_.size());
  MatrixXd result = MatrixXd::Zero(rows, samples.cols());
  for (Index s = 0; s < samples.cols(); ++s) {
    const VectorXd& filter = filters_[static_cast<std::size_t>(s % channels)];
    for (Index k = 0; k < filter.size(); ++k) result.col(s) += filter(k) * samples.col(s).segment(order_ - k, rows);
  }
  return result;
}

MatrixXd NoiseWhitening::operator()(const Eigen::Ref<const MatrixXd>& samples) const {
  MatrixXd result = filtered(samples);
  const auto channels = static_cast<Index>(filters_.size());
  for (std::size_t r = 0; r < mixing_.size(); ++r) {
    auto of_record = result.middleCols(static_cast<Index>(r) * channels, channels);
    of_record = (of_record * mixing_[r]).eval();
  }
  return result;
}

}  // namespace secular
