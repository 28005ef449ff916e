#pragma once

#include <Eigen/Core>
#include <complex>
#include <map>
#include <vector>

#include "estimator/identification/case_regression.hpp"
#include "measure/observe/mode_frequencies.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// exp(-i*phase) that turns a block's equation into the frame of the observed motion: the modulation equation of
/// mode k by arg A_k, a harmonic by what its phase makes of the arguments of the amplitudes and forces. There
/// repeats of one condition are equal but for noise, whatever the instants at which they were taken, and of a
/// modulation equation the real part is the balance of energy (dissipative), the imaginary part that of frequency
/// (conservative).
std::complex<double> motion_frame(const RegressorBlock& block, const Observation& observation);

/// What turns one of an observation's excitations ahead by the time that the first one takes for `angle`.
std::complex<double> put_ahead(const Observation& observation, std::size_t excitation, double angle);

/// docs/inference.md (1) to (3): columns of the generated equations at every observation, and how they change where
/// a measured quantity is off by one standard deviation.
class EquationData {
 public:
  enum class Errors { of_measurement, none };

  /// `blocks`: indices into CompiledCase::blocks. `set` must outlive this. Without errors, no quantity is varied.
  EquationData(const ObservationSet& set, const std::vector<std::size_t>& blocks,
               Errors errors = Errors::of_measurement);

  /// Columns at ObservationSet::column_frequency, without it at the natural frequencies `found` (by mode); nothing
  /// is done while they move by less than 1e-11.
  void evaluate(const std::vector<double>& found);

  /// Real rows that one observation has.
  Eigen::Index row_count(std::size_t observation) const;

  /// Equations of one observation as real rows in the frame of its motion: two a block, one at zero frequency.
  struct Rows {
    Eigen::MatrixXd design;        ///< rows x columns
    Eigen::VectorXd response;      ///< known lumps subtracted
    Eigen::MatrixXd variants;      ///< rows x varied quantities: change of left minus right side by one sd
    Eigen::VectorXd own_variance;  ///< rows: noise of the row's own measured harmonic, and a floor
    /// Rows: change of left minus right side by an excitation that is a radian ahead (further ones as much time).
    /// Empty where the phase is known (ObservationSet::phase_unknown).
    Eigen::VectorXd phase;
    std::vector<std::size_t> block;
    std::vector<EquationPart> part;
  };
  /// `point`: current values, also of what is given. Unknown natural frequencies are counted from
  /// `reference_frequency`: where something else acts like a change of frequency, both then stay small.
  Rows rows(std::size_t observation, const std::vector<CaseColumn>& columns, const EquationPoint& point,
            const std::vector<double>& reference_frequency) const;

  /// Number of varied quantities.
  Eigen::Index quantities() const { return static_cast<Eigen::Index>(quantities_.size()); }

  /// Those of them that follow from the motion: amplitudes, and frequencies that the resonance leaves free.
  std::vector<Eigen::Index> motion_quantities() const;

  /// Quantities x quantities: their correlations in a window of a decay and, by column, in the later one of `pair`.
  Eigen::MatrixXd correlation(const WindowPair& pair) const;

  /// Takes `deviations` standard deviations (by varied quantity) off an observation.
  void move(Observation& observation, const Eigen::VectorXd& deviations) const;

  /// Change of the design of one observation where a quantity is off by one standard deviation, for those that
  /// change it.
  struct ColumnError {
    Eigen::Index quantity;
    Eigen::MatrixXd design;
  };
  std::vector<ColumnError> column_errors(std::size_t observation, const std::vector<CaseColumn>& columns) const;

  /// Size of a block's equation at an observation, before its noise is known.
  double first_scale(std::size_t observation, std::size_t block) const;

 private:
  enum class Kind { amplitude, growth, frequency, own_frequency, free_frequency, forcing, excitation_frequency };
  struct Quantity {
    Kind kind;
    std::size_t index;
    bool imaginary;
  };
  double sd(const Quantity& q, const Observation& o) const;
  static bool is_slope_of(const Quantity& amplitude, const Quantity& slope);
  std::complex<double> step(const Quantity& q, const Observation& o, double size) const;
  bool present(std::size_t block, const Observation& o) const;
  std::complex<double> modulation_change(const Quantity& quantity, std::complex<double> step, const Observation& o,
                                         std::size_t mode, double natural_frequency) const;

  const ObservationSet& set_;
  const CompiledCase& case_;
  ModeFrequencies modes_;
  std::map<std::size_t, double> repeats_;  ///< by record
  std::vector<std::size_t> blocks_;
  std::vector<Quantity> quantities_;
  std::vector<int> column_variant_;  ///< by quantity: which copy of the columns, 0 where they do not depend on it
  int phase_variant_ = 0;            ///< the copy with excitations ahead; 0: none
  std::size_t copies_ = 1;
  std::vector<std::complex<double>> frame_;  ///< [observation][block in blocks_]: motion_frame
  /// [observation][quantity]: its standard deviation, and that as the change of what is measured.
  std::vector<double> deviation_;
  std::vector<std::complex<double>> step_;
  std::vector<double> evaluated_at_;
  /// [block in blocks_][lump of the block]: values at copy*observations + observation.
  std::vector<std::vector<Eigen::VectorXcd>> columns_;
};

}  // namespace secular
