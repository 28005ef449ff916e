#include "diagnose/anderson_mixing.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace secular {
namespace {

/// A step this many times longer than the last one says that the linear picture was wrong.
constexpr double growth = 2;

/// The plain step is shortened to no less than this share.
constexpr double least_share = 0.05;

/// Differences that are this close to depending on each other are not told apart.
constexpr double rank_tolerance = 1e-8;

}  // namespace

Eigen::VectorXd AndersonMixing::next(const Eigen::VectorXd& x, const Eigen::VectorXd& f) {
  if (last_f_.size() > 0) {
    if (f.norm() > growth * last_f_.norm()) {
      changes_.clear();
      step_changes_.clear();
      share_ = std::max(least_share, 0.5 * share_);
    } else {
      if (changes_.size() == memory_) {
        changes_.erase(changes_.begin());
        step_changes_.erase(step_changes_.begin());
      }
      changes_.push_back(x - last_x_);
      step_changes_.push_back(f - last_f_);
    }
  }
  last_x_ = x;
  last_f_ = f;
  Eigen::VectorXd next = x + share_ * f;
  if (changes_.empty()) return next;
  Eigen::MatrixXd step_changes(f.size(), static_cast<Eigen::Index>(changes_.size()));
  for (std::size_t i = 0; i < changes_.size(); ++i)
    step_changes.col(static_cast<Eigen::Index>(i)) = step_changes_[i];
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(step_changes);
  qr.setThreshold(rank_tolerance);
  const Eigen::VectorXd weight = qr.solve(f);
  for (std::size_t i = 0; i < changes_.size(); ++i)
    next -= weight(static_cast<Eigen::Index>(i)) * (changes_[i] + share_ * step_changes_[i]);
  return next;
}

}  // namespace secular
