#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "effects/catalogue.hpp"

namespace secular {

/// What one whitened row of a discrepancy speaks of.
struct RowLabel {
  std::size_t record = 0;  ///< index into Campaign::records
  int fold = 0;            ///< rows of one fold are left out together
  std::string place;       ///< of what it is a row: mode or channel
  bool balance = false;    ///< of an equation of motion (else of a channel)
  std::size_t mode = 0;    ///< balance rows
  EffectComponent component = EffectComponent::measurement;
  std::string harmonic;  ///< "omega0", "2 Omega", ...
  double amplitude = 0;  ///< of the mode (or of the channel's strongest line), half of the peak
  double time_s = 0;
  double level = 0;      ///< of a dwell: amplitude of the excitation's fundamental, half of the peak
  double frequency = 0;  ///< of a dwell: of the excitation, rad/s
};

/// Whether unknowns can be those of a structure: the first `modes` are natural frequencies, all positive.
bool has_frequencies(const Eigen::VectorXd& unknowns, std::size_t modes);

/// Evidence of one kind: rows of unit variance that vanish where the unknowns explain what was measured. Where
/// unknowns have no frequencies (has_frequencies) rows are infinite, so that no fit goes there.
class Evidence {
 public:
  virtual ~Evidence() = default;
  virtual Eigen::Index size() const = 0;
  /// Rows that are independent of each other.
  virtual Eigen::Index freedom() const { return size(); }
  virtual const std::vector<RowLabel>& labels() const = 0;
  /// Takes errors and starting points at these unknowns. `coarse`: the equations of motion count as known to this
  /// share of the inertia only, for unknowns that are still far off.
  virtual void freeze(const Eigen::VectorXd& unknowns, double coarse) = 0;
  /// Motions are looked for from those at these unknowns on; errors stay.
  virtual void approach(const Eigen::VectorXd& /*unknowns*/) {}
  virtual void evaluate(const Eigen::VectorXd& unknowns, Eigen::Ref<Eigen::VectorXd> rows) const = 0;
  /// Columns of d rows / d (unknown / scale) for some of the unknowns, by central differences of half a scale; zero
  /// where the rows are not finite.
  virtual Eigen::MatrixXd slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                                 const Eigen::VectorXd& scale, unsigned threads) const;
  /// Rows before they were made independent of each other, where that mixed them.
  virtual Eigen::VectorXd unmixed(const Eigen::VectorXd& rows) const { return rows; }
};

/// All evidence of a campaign as one vector of rows. Lateness of a record's responses that is not known gives its
/// rows the covariance I + u u' instead of I, u by one standard deviation of it, and they are multiplied by its
/// inverse root (docs/inference.md (24)).
class Discrepancy {
 public:
  void add(std::unique_ptr<Evidence> evidence);
  /// Responses of a record that are late against its excitation by an unknown time: `delay` is the unknown that
  /// delays the excitation, `sd` by record its standard deviation in s, where it is not known at all that of a
  /// whole period, period/sqrt(12). From the next freeze() on.
  void admit_lateness(std::size_t delay, std::map<std::size_t, double> sd);
  Eigen::Index size() const;
  Eigen::Index freedom() const;
  std::vector<RowLabel> labels() const;
  void freeze(const Eigen::VectorXd& unknowns, double coarse = 0);
  void approach(const Eigen::VectorXd& unknowns);
  Eigen::VectorXd operator()(const Eigen::VectorXd& unknowns) const;
  Eigen::MatrixXd slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                         const Eigen::VectorXd& scale, unsigned threads) const;
  Eigen::VectorXd unmixed(const Eigen::VectorXd& rows) const;

 private:
  /// What of a record's rows is kept along its direction of lateness, a unit vector.
  struct LateRecord {
    std::vector<Eigen::Index> rows;
    Eigen::VectorXd direction;
    double kept = 1;
  };
  Eigen::MatrixXd raw_slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                             const Eigen::VectorXd& scale, unsigned threads) const;
  void allow_for_lateness(Eigen::Ref<Eigen::MatrixXd> columns) const;

  std::vector<std::unique_ptr<Evidence>> parts_;
  std::size_t delay_ = 0;
  std::map<std::size_t, double> delay_sd_;  // by record
  std::vector<LateRecord> late_;            // as frozen
};

}  // namespace secular
