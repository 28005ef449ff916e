#pragma once

#include "diagnose/evidence/condition_rows.hpp"
#include "diagnose/evidence/discrepancy.hpp"

namespace secular {

/// Evidence of dwells: their rows, whitened one after the other, balances first. A row that the rows before it
/// determine (the line from which an amplitude was taken) drops out. Motions have as many lines as the rows need.
class LineEvidence : public Evidence {
 public:
  /// `threads`: of freeze().
  LineEvidence(ConditionModel model, std::vector<Condition> conditions, const Eigen::VectorXd& unknowns,
               unsigned threads = 1);

  Eigen::Index size() const override { return static_cast<Eigen::Index>(labels_.size()); }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const Eigen::VectorXd& unknowns, double coarse) override;
  void approach(const Eigen::VectorXd& unknowns) override;
  void evaluate(const Eigen::VectorXd& unknowns, Eigen::Ref<Eigen::VectorXd> rows) const override;
  Eigen::MatrixXd slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                         const Eigen::VectorXd& scale, unsigned threads) const override;
  void set_frequency_offsets(const std::map<std::size_t, Eigen::VectorXd>& offsets) override;
  void put_in_step(const Eigen::VectorXd& unknowns, double coarse, Lookout lookout,
                   const std::map<std::size_t, double>& periods, std::map<std::size_t, double>& late_s) override;
  Eigen::VectorXd unmixed(const Eigen::VectorXd& rows) const override;

 private:
  struct Whitening {
    std::vector<Eigen::Index> kept;
    Eigen::MatrixXd inverse_root;  // kept x kept, lower triangle
    Motion motion;
    bool is_of_before = false;  // the errors at these unknowns are not finite
  };
  /// Returns the rows as they are, not yet whitened.
  ConditionRows whiten(const Condition& condition, const Eigen::VectorXd& unknowns, double coarse,
                       Whitening& whitening) const;
  /// Whether a motion of twice as many lines moves a row of `few`, which whiten() has found with those that it has,
  /// by more than a tenth of its standard deviation; it has them from then on (docs/inference.md, Lines of a
  /// motion).
  bool took_more_lines(std::size_t condition, const Eigen::VectorXd& unknowns, const ConditionRows& few,
                       Whitening& whitening);
  static Eigen::VectorXd whitened(const ConditionRows& rows, const Whitening& whitening);
  double deviance_if_late(const std::vector<std::size_t>& conditions, const Eigen::VectorXd& unknowns,
                          double coarse, double seconds) const;

  ConditionModel model_;
  std::vector<Condition> conditions_;
  unsigned threads_;
  std::vector<Whitening> whitening_;
  std::vector<RowLabel> labels_;
};

}  // namespace secular
