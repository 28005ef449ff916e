#pragma once

#include "diagnose/discrepancy.hpp"

namespace secular {

/// Numbers that were given with error bars, as rows (unknown - value)/sd.
class PriorEvidence : public Evidence {
 public:
  struct Entry {
    std::size_t unknown = 0;
    double value = 0, sd = 1;
    std::string name;
  };
  explicit PriorEvidence(std::vector<Entry> entries);

  Eigen::Index size() const override { return static_cast<Eigen::Index>(entries_.size()); }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const Eigen::VectorXd&, double) override {}
  void evaluate(const Eigen::VectorXd& unknowns, Eigen::Ref<Eigen::VectorXd> rows) const override;

 private:
  std::vector<Entry> entries_;
  std::vector<RowLabel> labels_;
};

}  // namespace secular
