#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "blind/disturbances.hpp"
#include "blind/effect.hpp"
#include "blind/specimen.hpp"
#include "blind/stretch_spectra.hpp"

namespace secular::blind {

/// Harmonic amplitudes of every dwell and channel of a reality, as one vector: real and imaginary parts of the
/// harmonics of the response's fundamental in the first ensemble (in all of them where an effect changes with
/// time), each divided by its standard deviation under the noise. The excitation is known as well as its channel
/// tells it and no better: what an error of its amplitude or phase would do to the responses counts as noise, and
/// so does what a record that is late or a natural frequency that scatters from record to record does to them.
///
/// Where a specimen has no dwells they are the spectra of its stretches (`stretch_spectra`), all of them, whatever
/// `all_ensembles` is; how decays begin is then among the model's own parameters.
class Signatures {
 public:
  /// `noise_sd` by channel.
  Signatures(const Specimen& specimen, std::vector<double> noise_sd, Disturbances disturbances = {});

  /// How a reality's harmonic amplitudes differ from the model's own, in standard deviations (rotated so that these
  /// are independent of each other). `all_ensembles` costs more.
  Eigen::VectorXd change(const Reality& reality, bool all_ensembles) const;
  /// Changes by small steps of the model's own natural frequencies and coefficients, and of the offset of every
  /// response channel, which nobody knows either: columns of unit length.
  const Eigen::MatrixXd& own_parameters(bool all_ensembles) const;
  /// What is left of `change` when the model's own parameters are fitted to it (Gauss and Newton, the linearisation
  /// at the nominal values).
  Eigen::VectorXd unexplained(const Eigen::VectorXd& change, bool all_ensembles) const;
  /// The same to convergence: slopes follow the fit, which a large change may lead far. Costs many times as much.
  Eigen::VectorXd refitted_unexplained(const Eigen::VectorXd& change, bool all_ensembles) const;
  /// The same with the coefficient of a rival fitted beside them, from `coefficient` on: `rival` is the specimen's
  /// reality with it switched on.
  Eigen::VectorXd refitted_unexplained(const Eigen::VectorXd& change, bool all_ensembles,
                                       const std::function<Reality(double coefficient)>& rival,
                                       double coefficient) const;
  /// The same after the first step alone.
  Eigen::VectorXd linear_unexplained(const Eigen::VectorXd& change, bool all_ensembles) const;

  /// Norm of a change over one ensemble of one dwell, root mean square over the dwells: in standard deviations. Of
  /// stretches: over as many samples as an ensemble has, root mean square over all.
  double strength(const Eigen::VectorXd& change, bool all_ensembles) const;
  /// How many ensembles were recorded for each that is compared.
  double recorded_alike(bool all_ensembles) const;
  /// Norm of a reality's change relative to the amplitudes themselves, all channels together.
  double relative(const Reality& reality, bool all_ensembles) const;

 private:
  Eigen::VectorXd amplitudes(const Reality& reality, bool all_ensembles, double of_drive = 1) const;
  Eigen::VectorXd lines_of_dwells(const Reality& reality, bool all_ensembles, double of_drive) const;
  bool has_dwells() const { return !specimen_.dwells.empty(); }
  Eigen::Index components() const { return static_cast<Eigen::Index>(2 * harmonics_ + 1); }
  /// Of one channel's noise alone: each divided by its own standard deviation.
  Eigen::VectorXd difference(const Reality& reality, bool all_ensembles) const;
  /// What errors of the excitation's amplitude and phase of one standard deviation do to the responses. Throws
  /// NumericalFailure where a dwell of the model alone grows beyond bounds.
  Eigen::MatrixX2d excitation_noise(bool all_ensembles) const;
  /// The same of all that counts as noise of a whole record, a column each.
  const Eigen::MatrixXd& noise_of_records(bool all_ensembles) const;
  /// Rows that one lot of it is common to.
  std::vector<RowsOfStretch> rows_of_records(Eigen::Index all) const;
  /// The change where `reality`'s own parameters move by the first of `moved`, in steps of unit columns.
  Eigen::VectorXd change_with_own(Reality reality, const Eigen::VectorXd& moved, bool all_ensembles) const;

  const Specimen& specimen_;
  ChannelNoise noise_;
  std::size_t harmonics_;
  const Eigen::VectorXd& nominal(bool all_ensembles) const;

  mutable std::map<bool, Eigen::VectorXd> nominal_;
  mutable std::map<bool, Eigen::MatrixXd> noise_of_records_;
  mutable std::map<bool, Eigen::MatrixXd> own_;
  mutable std::map<bool, std::vector<double>> steps_;  // of each own parameter for a column of unit length
};

inline constexpr std::size_t ensembles_per_dwell = 6;

/// Root mean square of every channel over the campaign's median dwell, and its largest absolute value.
struct Levels {
  std::vector<double> median_rms, peak;
};
/// By channel, in its unit, without noise; for a reality whose dwells stay bounded.
Levels levels_of(const Specimen& specimen, const Reality& reality);

/// Drive of dwell `d` in a reality.
Drive drive_of(const Dwell& dwell, const Reality& reality);

}  // namespace secular::blind
