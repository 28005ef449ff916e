// Fits whose slopes are taken by differences.
#include "diagnose/inference/refit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// u cos(7 x) + s max(x - g, 0) at even places between 0 and 1, each known to 0.01.
class Contact : public Evidence {
 public:
  explicit Contact(const VectorXd& truth) : measured_(values(truth)) {}

  Index size() const override { return places; }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const VectorXd& /*unknowns*/, double /*coarse*/) override {}
  void evaluate(const VectorXd& unknowns, Eigen::Ref<VectorXd> rows) const override {
    rows = (measured_ - values(unknowns)) / 0.01;
  }

 private:
  static constexpr Index places = 200;

  static VectorXd values(const VectorXd& unknowns) {
    return VectorXd::LinSpaced(places, 0, 1).unaryExpr([&](double x) {
      return unknowns(0) * std::cos(7 * x) + unknowns(1) * std::max(x - unknowns(2), 0.0);
    });
  }

  VectorXd measured_;
  std::vector<RowLabel> labels_ = std::vector<RowLabel>(places);
};

// Behind a clearance that is hardly reached, strengths are seen that no step could follow: by 4e-16 of the largest
// displacement it takes a stiffness of some 1e12 before a row moves by one standard deviation.
TEST(Refit, FindsAContactFromAClearanceThatIsHardlyReached) {
  const VectorXd truth = Eigen::Vector3d(0.5, 3, 0.4);
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<Contact>(truth));
  RefitOptions options;
  options.scale_guess = Eigen::Vector3d(0.01, 0.01, 0.01);
  const Refit fit = refit(discrepancy, Eigen::Vector3d(0, 3, 1 - 4e-16), {0, 1, 2}, options);
  EXPECT_EQ(fit.ending, SolverEnding::converged);
  EXPECT_LT((fit.unknowns - truth).cwiseAbs().maxCoeff(), 1e-3);
}

}  // namespace
}  // namespace secular
