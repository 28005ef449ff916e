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

/// All evidence of a campaign as one vector of rows. What differs from record to record by chance, natural
/// frequencies and the lateness of responses, gives the rows of a record the covariance I + U U' instead of I, U by
/// one standard deviation of each, and they are multiplied by its inverse root (docs/inference.md (24)).
class Discrepancy {
 public:
  void add(std::unique_ptr<Evidence> evidence);
  /// `relative_sd`: s, of the first `modes` unknowns. From the next freeze() on; 0: they are the same everywhere.
  void admit_scatter(double relative_sd, std::size_t modes);
  /// Responses of a record that are late against its excitation by an unknown time: `delay` is the unknown that
  /// delays the excitation, `sd` by record its standard deviation in s, where it is not known at all that of a
  /// whole period, period/sqrt(12). From the next freeze() on.
  void admit_lateness(std::size_t delay, std::map<std::size_t, double> sd);
  /// Rows x modes by a relative change of each of the first `modes` unknowns.
  Eigen::MatrixXd frequency_changes(const Eigen::VectorXd& unknowns, std::size_t modes) const;
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
  /// What differs from record to record and explains nothing.
  struct Nuisances {
    double relative_sd = 0;  // of natural frequencies
    std::size_t modes = 0;
    std::size_t delay = 0;
    std::map<std::size_t, double> delay_sd;  // by record
    bool any() const { return relative_sd > 0 || !delay_sd.empty(); }
    /// By record: its rows, and orthonormal directions among them with what is kept along each.
    struct OfRecord {
      std::vector<Eigen::Index> rows;
      Eigen::MatrixXd directions;
      Eigen::VectorXd kept;
    };
    std::vector<OfRecord> records;
  };
  /// Rows x nuisances of their record, by one standard deviation of each.
  Eigen::MatrixXd changes_by_nuisances(const Eigen::VectorXd& unknowns,
                                       const std::map<std::size_t, std::vector<Eigen::Index>>& rows_of) const;
  Eigen::MatrixXd raw_slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                             const Eigen::VectorXd& scale, unsigned threads) const;
  void allow_for_nuisances(Eigen::Ref<Eigen::MatrixXd> columns) const;

  std::vector<std::unique_ptr<Evidence>> parts_;
  Nuisances nuisances_;
};

}  // namespace secular
