#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "blind/effect.hpp"
#include "blind/specimen.hpp"

namespace secular::blind {

/// Harmonic amplitudes of every dwell and channel of a reality, as one vector: real and imaginary parts of the
/// harmonics of the response's fundamental in the first ensemble (in all of them where an effect changes with
/// time), each divided by its standard deviation under the noise.
class Signatures {
 public:
  /// `noise_sd` by channel.
  Signatures(const Specimen& specimen, std::vector<double> noise_sd);

  /// How a reality's harmonic amplitudes differ from the model's own. `all_ensembles` costs more.
  Eigen::VectorXd change(const Reality& reality, bool all_ensembles) const;
  /// Changes by small steps of the model's own natural frequencies and coefficients: columns of unit length.
  const Eigen::MatrixXd& own_parameters(bool all_ensembles) const;
  /// What is left of `change` when the model's own parameters are fitted to it (Gauss and Newton, the linearisation
  /// at the nominal values).
  Eigen::VectorXd remainder(const Eigen::VectorXd& change, bool all_ensembles) const;
  /// The same to convergence: slopes follow the fit, which a large change may lead far. Costs many times as much.
  Eigen::VectorXd refitted_remainder(const Eigen::VectorXd& change, bool all_ensembles) const;
  /// The same after the first step alone.
  Eigen::VectorXd linear_remainder(const Eigen::VectorXd& change, bool all_ensembles) const;

  /// Norm of a change over one ensemble of one dwell, root mean square over the dwells: in standard deviations.
  double strength(const Eigen::VectorXd& change, bool all_ensembles) const;
  /// The same relative to the amplitudes themselves, all channels together.
  double relative(const Eigen::VectorXd& change, bool all_ensembles) const;

 private:
  Eigen::VectorXd amplitudes(const Reality& reality, bool all_ensembles) const;
  /// The change that the model's own parameters make where they move by `moved`, in steps of unit columns.
  Eigen::VectorXd change_of_own(const Eigen::VectorXd& moved, bool all_ensembles) const;

  const Specimen& specimen_;
  std::vector<double> noise_sd_;
  std::size_t harmonics_;
  const Eigen::VectorXd& nominal(bool all_ensembles) const;

  mutable std::map<bool, Eigen::VectorXd> nominal_;
  mutable std::map<bool, Eigen::MatrixXd> own_;
  mutable std::map<bool, std::vector<double>> steps_;  // of each own parameter for a column of unit length
};

inline constexpr std::size_t ensembles_per_dwell = 6;

/// Root mean square of every channel over the campaign's median dwell, and its largest absolute value.
struct Levels {
  std::vector<double> median_rms, peak;
};
Levels levels_of(const Specimen& specimen, const Reality& reality);

/// Drive of dwell `d` in a reality.
Drive drive_of(const Dwell& dwell, const Reality& reality);

}  // namespace secular::blind
