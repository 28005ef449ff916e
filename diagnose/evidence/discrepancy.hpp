#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "diagnose/evidence/record_directions.hpp"
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

/// Where what a record has of its own is looked for: anywhere, or where it was, by unknowns that have moved little.
enum class Lookout { anywhere, close_by };

/// Records of blows, and the relative standard deviation of what is between the samples of their excitations, at a
/// natural frequency (rad/s).
struct BetweenSamples {
  std::set<std::size_t> records;
  double share = 0, frequency = 0;
};

/// Evidence of one kind: rows of unit variance that vanish where the unknowns explain what was measured. Where
/// unknowns have no frequencies (has_frequencies) rows are infinite, so that no fit goes there.
class Evidence {
 public:
  virtual ~Evidence() = default;
  /// How many rows there are.
  virtual Eigen::Index size() const = 0;
  /// Rows that are independent of each other.
  virtual Eigen::Index freedom() const { return size(); }
  virtual const std::vector<RowLabel>& labels() const = 0;
  /// Takes errors and starting points at these unknowns. `coarse`: the equations of motion count as known to this
  /// share of the inertia only, for unknowns that are still far off.
  virtual void freeze(const Eigen::VectorXd& unknowns, double coarse) = 0;
  /// Whether freeze() measures errors by what the unknowns leave, unless it is coarse: among true errors they may
  /// leave less then than among wide ones.
  virtual bool measures_errors() const { return false; }
  /// Independent rows whose noise is measured by third differences of what is left of them (docs/inference.md
  /// (50)).
  virtual Eigen::Index measured_rows() const { return 0; }
  /// Motions are looked for from those at these unknowns on; errors stay.
  virtual void approach(const Eigen::VectorXd& /*unknowns*/) {}
  /// `rows`: size() of them, at the errors that freeze() took.
  virtual void evaluate(const Eigen::VectorXd& unknowns, Eigen::Ref<Eigen::VectorXd> rows) const = 0;
  /// Columns of d rows / d (unknown / scale) for some of the unknowns, by central differences of half a scale; zero
  /// where the rows are not finite.
  virtual Eigen::MatrixXd slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                                 const Eigen::VectorXd& scale, unsigned threads) const;
  /// Natural frequencies of a record are those of the unknowns times 1 + offset, by record and mode; of a record
  /// that is not named they are those of the unknowns. Until the next call.
  virtual void set_frequency_offsets(const std::map<std::size_t, Eigen::VectorXd>& /*offsets*/) {}
  /// Counts these records' responses (period of the excitation in s, by record) as late as is likeliest at these
  /// unknowns, and notes it (s). Until the next call.
  virtual void put_in_step(const Eigen::VectorXd& /*unknowns*/, double /*coarse*/, Lookout /*lookout*/,
                           const std::map<std::size_t, double>& /*periods*/,
                           std::map<std::size_t, double>& /*late_s*/) {}
  /// Columns by which rows move with one standard deviation of what is between the samples of blows; none where
  /// nothing is.
  virtual Eigen::MatrixXd between_samples(const Eigen::VectorXd& /*unknowns*/,
                                          const BetweenSamples& /*of_blows*/) const {
    return {};
  }
  /// Rows before they were made independent of each other, where that mixed them.
  virtual Eigen::VectorXd unmixed(const Eigen::VectorXd& rows) const { return rows; }
  /// Rows with what balances of the equations of motion tell apart from the rest, where that is spread over
  /// readings.
  virtual Eigen::VectorXd by_balance(const Eigen::VectorXd& rows) const { return rows; }
};

/// What differs from record to record and explains nothing (docs/inference.md (24), (26), (42)).
struct RecordNuisances {
  /// Unknown that delays the excitation; by record the standard deviation of its responses' lateness in s, where it
  /// is not known at all that of a whole period, period/sqrt(12).
  std::size_t delay = 0;
  std::map<std::size_t, double> delay_sd;
  /// By mode: standard deviation of the records' natural frequencies, relative. Empty: all are the same.
  Eigen::VectorXd frequency_sd;
  BetweenSamples of_blows;  ///< no fit puts it anywhere

  /// Whether records have anything that is looked for.
  bool any() const { return !delay_sd.empty() || frequency_sd.size() > 0; }
};

/// How late the responses of one record are.
struct OwnLateness {
  std::size_t record = 0;
  double late_s = 0, variance = 0;  ///< s, s^2: by the record's rows alone
  double period_s = 0;              ///< of the excitation, any number of which may come on top
  double level = 0, frequency = 0;  ///< of the excitation, as RowLabel
};

/// A natural frequency of one record, relative to that of all.
struct OwnFrequency {
  std::size_t record = 0, mode = 0;
  double offset = 0, variance = 0;  ///< by the record's rows alone
};

/// Of a standard deviation: a row that moves by less is not seen to.
inline constexpr double negligible_step = 0.1;

/// All evidence of a campaign as one vector of rows of unit variance, with what differs from record to record
/// allowed for.
class Discrepancy {
 public:
  /// Its rows stand behind those that are there.
  void add(std::unique_ptr<Evidence> evidence);
  /// From the next freeze() on.
  void admit(RecordNuisances nuisances);
  bool admits_own() const { return nuisances_.any(); }
  /// Whether any of the evidence does.
  bool measures_errors() const;
  // Sums, or one behind the other, of the evidence's own.
  Eigen::Index size() const;
  Eigen::Index freedom() const;
  Eigen::Index measured_rows() const;
  std::vector<RowLabel> labels() const;
  /// As Evidence::freeze(). Each record's own natural frequencies and lateness are put where they are likeliest at
  /// these unknowns, so that what is left of them is small.
  void freeze(const Eigen::VectorXd& unknowns, double coarse = 0, Lookout lookout = Lookout::anywhere);
  void approach(const Eigen::VectorXd& unknowns);
  /// The rows, of unit variance with what records have of their own (RecordDirections).
  Eigen::VectorXd operator()(const Eigen::VectorXd& unknowns) const;
  /// Of these rows, as Evidence::slopes(): rows x which.
  Eigen::MatrixXd slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                         const Eigen::VectorXd& scale, unsigned threads) const;
  // Of the evidence, one behind the other.
  Eigen::VectorXd unmixed(const Eigen::VectorXd& rows) const { return part_by_part(rows, &Evidence::unmixed); }
  Eigen::VectorXd by_balance(const Eigen::VectorXd& rows) const {
    return part_by_part(rows, &Evidence::by_balance);
  }
  /// Share of the variance of what this column of rows tells that is the records' own: how their frequencies
  /// scatter (docs/inference.md (32)).
  double share_of_records(Eigen::VectorXd column) const;
  /// By mode, relative, as put in; empty: the record has the frequencies of all.
  Eigen::VectorXd frequency_offset(std::size_t record) const {
    const auto own = frequency_offsets_.find(record);
    return own == frequency_offsets_.end() ? Eigen::VectorXd() : own->second;
  }
  /// Of the late records that tell it, at the unknowns of the last freeze(), within half a period of their mean.
  std::vector<OwnLateness> own_lateness() const;
  /// Of the records that tell them, at these unknowns.
  std::vector<OwnFrequency> own_frequencies(const Eigen::VectorXd& unknowns) const;

 private:
  using RowsOfPart = Eigen::VectorXd (Evidence::*)(const Eigen::VectorXd&) const;
  Eigen::VectorXd part_by_part(const Eigen::VectorXd& rows, RowsOfPart of_part) const;
  Eigen::VectorXd raw_rows(const Eigen::VectorXd& unknowns) const;
  Eigen::MatrixXd raw_slopes(const Eigen::VectorXd& unknowns, const std::vector<std::size_t>& which,
                             const Eigen::VectorXd& scale, unsigned threads) const;
  void take_directions(const Eigen::VectorXd& unknowns);
  bool put_in_own(const Eigen::VectorXd& unknowns);
  Eigen::Index modes() const { return nuisances_.frequency_sd.size(); }

  std::vector<std::unique_ptr<Evidence>> parts_;
  RecordNuisances nuisances_;
  std::map<std::size_t, Eigen::VectorXd>
      frequency_offsets_;                         // of natural frequencies, by record and mode, as put in
  std::map<std::size_t, double> record_periods_;  // of late records, s
  std::map<std::size_t, double> record_late_s_;   // as put in, s
  // Records are late from where they are on when numbers are first fitted: half a period more or less goes with the
  // other sign of the force.
  bool in_reach_ = false;
  std::map<std::size_t, RecordDirections> directions_;  // by record, as frozen
};

}  // namespace secular
