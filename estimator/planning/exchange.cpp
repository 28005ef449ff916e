#include "estimator/planning/exchange.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Prior information, in units of what all items together give: keeps the first choices comparable.
constexpr double prior = 1e-9;

/// Smallest gain of an exchange, in the logarithm of the criterion.
constexpr double smallest_gain = 1e-6;

class Search {
 public:
  explicit Search(const DesignProblem& problem) : problem_(problem) {
    if (problem.items.empty()) throw std::invalid_argument("a design needs items to choose from");
    const Index size = problem.items.front().information.rows();
    MatrixXd all = MatrixXd::Zero(size, size);
    for (const DesignItem& item : problem.items) {
      if (item.information.rows() != size || item.information.cols() != size || !(item.cost > 0))
        throw std::invalid_argument("design items need equal sizes and positive costs");
      all += item.information;
    }
    if (problem.wanted.empty() || problem.scale.size() != size)
      throw std::invalid_argument("a design needs wanted unknowns and their scales");
    unit_ = all.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    for (const DesignItem& item : problem.items)
      scaled_.push_back(unit_.asDiagonal() * item.information * unit_.asDiagonal());
    sum_ = MatrixXd::Zero(size, size);
  }

  Design run() {
    fill();
    for (int round = 0; round < 200; ++round) {
      const bool exchanged = exchange();
      const bool removed = !exchanged && remove_for_better();
      if (!exchanged && !removed) break;
      fill();
    }
    Design design;
    design.chosen.assign(chosen_.begin(), chosen_.end());
    design.cost = cost_;
    design.feasible = chosen_.size() >= problem_.least;
    MatrixXd information = MatrixXd::Zero(sum_.rows(), sum_.cols());
    for (const std::size_t i : chosen_) information += problem_.items[i].information;
    design.sd = standard_deviations(information);
    design.value = value_of(sum_);
    return design;
  }

 private:
  double value_of(const MatrixXd& scaled) const {
    const Index size = scaled.rows();
    const Eigen::LLT<MatrixXd> cholesky(MatrixXd(scaled + prior * MatrixXd::Identity(size, size)));
    if (cholesky.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
    const auto wanted = static_cast<Index>(problem_.wanted.size());
    MatrixXd selector = MatrixXd::Zero(size, wanted);
    for (Index w = 0; w < wanted; ++w) selector(problem_.wanted[static_cast<std::size_t>(w)], w) = 1;
    const MatrixXd half = cholesky.matrixL().solve(selector);
    const MatrixXd covariance = half.transpose() * half;  // of the wanted ones, scaled
    switch (problem_.criterion) {
      case DesignCriterion::d:
        return -2 * MatrixXd(covariance.llt().matrixL()).diagonal().array().log().sum();
      case DesignCriterion::a:
      case DesignCriterion::c: {
        double trace = 0;
        for (Index w = 0; w < wanted; ++w) {
          const Index u = problem_.wanted[static_cast<std::size_t>(w)];
          trace += covariance(w, w) * std::pow(unit_(u) / problem_.scale(u), 2);
        }
        return -std::log(trace);
      }
    }
    return 0;
  }

  bool is_free(std::size_t item, std::size_t except = std::numeric_limits<std::size_t>::max()) const {
    for (const std::size_t c : chosen_)
      if (c != except && problem_.items[c].group == problem_.items[item].group) return false;
    return true;
  }

  void choose(std::size_t item) {
    chosen_.insert(item);
    cost_ += problem_.items[item].cost;
    sum_ += scaled_[item];
  }
  void drop(std::size_t item) {
    chosen_.erase(item);
    cost_ -= problem_.items[item].cost;
    sum_ -= scaled_[item];
  }

  // Adds the item with the largest gain over its cost while the budget lasts; until `least` are chosen, only what
  // leaves room for the cheapest others.
  void fill() {
    double cheapest = std::numeric_limits<double>::infinity();
    for (const DesignItem& item : problem_.items) cheapest = std::min(cheapest, item.cost);
    for (;;) {
      if (problem_.pulse) problem_.pulse();
      const double value = value_of(sum_);
      const double missing =
          chosen_.size() + 1 < problem_.least ? static_cast<double>(problem_.least - chosen_.size() - 1) : 0.0;
      std::size_t best = problem_.items.size();
      double best_rate = 0;
      for (std::size_t i = 0; i < problem_.items.size(); ++i) {
        if (cost_ + problem_.items[i].cost + missing * cheapest > problem_.budget || !is_free(i)) continue;
        const double rate = (value_of(sum_ + scaled_[i]) - value) / problem_.items[i].cost;
        if (rate > best_rate) {
          best_rate = rate;
          best = i;
        }
      }
      if (best == problem_.items.size()) return;
      choose(best);
    }
  }

  bool exchange() {
    const double value = value_of(sum_);
    double best_gain = smallest_gain;
    std::size_t out = 0, in = problem_.items.size();
    for (const std::size_t c : chosen_) {
      if (problem_.pulse) problem_.pulse();
      const MatrixXd without = sum_ - scaled_[c];
      for (std::size_t i = 0; i < problem_.items.size(); ++i) {
        if (chosen_.count(i) == 1 || cost_ - problem_.items[c].cost + problem_.items[i].cost > problem_.budget ||
            !is_free(i, c))
          continue;
        const double gain = value_of(without + scaled_[i]) - value;
        if (gain > best_gain) {
          best_gain = gain;
          out = c;
          in = i;
        }
      }
    }
    if (in == problem_.items.size()) return false;
    drop(out);
    choose(in);
    return true;
  }

  // One item out, then filled up again: kept only if that is better.
  bool remove_for_better() {
    const double value = value_of(sum_);
    const std::set<std::size_t> before = chosen_;
    const MatrixXd sum_before = sum_;
    const double cost_before = cost_;
    for (const std::size_t c : before) {
      drop(c);
      fill();
      if (value_of(sum_) > value + smallest_gain && chosen_.size() >= std::min(before.size(), problem_.least))
        return true;
      chosen_ = before;
      sum_ = sum_before;
      cost_ = cost_before;
    }
    return false;
  }

  const DesignProblem& problem_;
  VectorXd unit_;
  std::vector<MatrixXd> scaled_;
  std::set<std::size_t> chosen_;
  MatrixXd sum_;
  double cost_ = 0;
};

}  // namespace

VectorXd standard_deviations(const Eigen::Ref<const MatrixXd>& information) {
  const Index size = information.rows();
  const VectorXd unit = information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
      MatrixXd(unit.asDiagonal() * information * unit.asDiagonal()));
  const double smallest = 1e-10 * std::max(1e-300, eigen.eigenvalues().maxCoeff());
  VectorXd variance = VectorXd::Zero(size);
  for (Index e = 0; e < size; ++e) {
    const VectorXd direction = eigen.eigenvectors().col(e);
    for (Index u = 0; u < size; ++u) {
      const double share = direction(u) * direction(u);
      if (eigen.eigenvalues()(e) > smallest)
        variance(u) += share / eigen.eigenvalues()(e);
      else if (share > 1e-9)
        variance(u) = std::numeric_limits<double>::infinity();
    }
  }
  return unit.cwiseProduct(variance.cwiseSqrt());
}

Design optimal_design(const DesignProblem& problem) {
  return Search(problem).run();
}

}  // namespace secular
