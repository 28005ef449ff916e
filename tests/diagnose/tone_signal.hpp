#pragma once

#include <Eigen/Core>
#include <cmath>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/effects/candidate.hpp"
#include "diagnose/evidence/discrepancy.hpp"

namespace secular::testing_support {

inline constexpr Eigen::Index readings = 120;
inline constexpr double sd = 0.02;

inline constexpr double tones[] = {1.4, 0.7, 0.85, 1.15, 1.25, 1.55, 1.7, 1.85};  // rad/s

inline double time_of(Eigen::Index i) {
  return 0.1 * static_cast<double>(i + 1);
}

/// A signal cos(u_0 t) + sum of u_k cos(tones_k t), compared with one that was measured.
class Signal : public Evidence {
 public:
  explicit Signal(const Eigen::VectorXd& truth) : measured_(signal(truth)), labels_(readings) {
    std::mt19937 random(4);
    std::normal_distribution<double> noise(0, sd);
    for (double& y : measured_) y += noise(random);
  }

  Eigen::Index size() const override { return readings; }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  // Coarse errors are a multiple of the noise that is far beyond what any tone leaves.
  void freeze(const Eigen::VectorXd& /*unknowns*/, double coarse) override { widening_ = 1 + 1e6 * coarse; }
  void evaluate(const Eigen::VectorXd& unknowns, Eigen::Ref<Eigen::VectorXd> rows) const override {
    rows = (measured_ - signal(unknowns)) / (widening_ * sd);
  }

 private:
  static Eigen::VectorXd signal(const Eigen::VectorXd& unknowns) {
    Eigen::VectorXd y(readings);
    for (Eigen::Index i = 0; i < readings; ++i) {
      const double t = time_of(i);
      y(i) = std::cos(unknowns(0) * t);
      for (std::size_t k = 0; k < std::size(tones); ++k)
        y(i) += unknowns(static_cast<Eigen::Index>(k + 1)) * std::cos(tones[k] * t);
    }
    return y;
  }

  double widening_ = 1;
  Eigen::VectorXd measured_;
  std::vector<RowLabel> labels_;
};

/// One for each of the tones.
inline std::vector<Candidate> tone_candidates() {
  std::vector<Candidate> all(std::size(tones));
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].effect = "tone " + std::to_string(k);
    all[k].strengths = {k + 1};
    all[k].shape_starts = {Eigen::VectorXd()};
  }
  return all;
}

/// Numbers of a signal: its own frequency, and strengths of the tones that are named.
inline Eigen::VectorXd signal_of(double frequency,
                                 const std::vector<std::pair<Eigen::Index, double>>& strengths = {}) {
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(std::size(tones) + 1);
  unknowns(0) = frequency;
  for (const auto& [tone, strength] : strengths) unknowns(tone + 1) = strength;
  return unknowns;
}

inline Discrepancy measured_signal(const Eigen::VectorXd& truth) {
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<Signal>(truth));
  return discrepancy;
}

}  // namespace secular::testing_support
