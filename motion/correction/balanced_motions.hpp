#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <optional>
#include <span>

#include "estimator/model/compiled_model.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/balance/motion_balance.hpp"
#include "motion/correction/base_phases.hpp"

namespace secular {

/// Motions of a case whose modes have observed amplitudes, in balance by the full equations of motion on every
/// other line (MotionBalance). Everything that the observation does not change is made once. From any thread.
/// `model` must outlive it.
class BalancedMotions {
 public:
  BalancedMotions(const CompiledModel& model, const CompiledCase& resonance);

  struct Balanced {
    MotionSetting setting;  ///< its masters are the modes that are not at rest, in their order
    Motion motion;
  };

  /// Whether there is anything to balance: not in a case of more than two independent frequencies.
  bool known() const { return base_.has_value(); }
  /// Nothing where it is not known(), or the motion is too strong for its lines to be found. Of the observation its
  /// excitation, amplitudes and rates are read. `start`: as MotionBalance::solve takes it.
  std::optional<Balanced> in_balance(const Eigen::VectorXd& parameters, const Observation& observation,
                                     const Motion* start = nullptr) const;
  /// in_balance() under all lines of the excitation that were measured, `Observation::forcing_harmonic` too.
  std::optional<Balanced> under_all_lines(const Eigen::VectorXd& parameters, const Observation& observation,
                                          const Motion* start = nullptr) const;
  /// Nothing also where what the lines make is quite another motion than the observed one.
  std::optional<Balanced> at(const Eigen::VectorXd& parameters, const Observation& observation,
                             const Motion* start = nullptr) const;

  /// Growth + i*frequency of the amplitude A of a mode; nothing of a mode at rest. Inertia at the rate s takes s^2
  /// A: what is left on the mode's line (force minus inertia) over 2 s A is what the observed rate lacks of
  /// balance. That leaves out how forces depend on so slow a change: shares of it of the order of the damping ratio
  /// and of the squared nonlinearity.
  std::optional<std::complex<double>> rate_of(std::size_t mode, const Balanced& balanced) const;
  /// Amplitude, half of the peak, of a mode at the phase of natural frequencies and excitations (as RegressorBlock
  /// has it); nothing beyond the highest line.
  std::optional<std::complex<double>> amplitude_of(std::size_t mode, std::span<const int> phase,
                                                   const Balanced& balanced) const;
  /// Gives `seen` the rates of the modes and every harmonic of the case that has a line.
  void show(const Balanced& balanced, Observation& seen) const;

 private:
  /// rate_of less the observed rate; zero of a mode at rest.
  std::complex<double> excess_rate(std::size_t mode, const Balanced& balanced) const;
  bool is_near_what_was_measured(const Balanced& balanced, const Observation& o) const;
  const MasterLine* master(std::size_t mode, const Balanced& balanced) const;

  /// A line of either sign: the torus holds one of each pair.
  struct SignedLine {
    Eigen::Index line = 0;
    bool conjugate = false;

    std::complex<double> of(std::complex<double> amplitude) const {
      return conjugate ? std::conj(amplitude) : amplitude;
    }
  };
  std::optional<SignedLine> find(const LinePhase& phase) const;
  std::optional<SignedLine> line_of(std::span<const int> phase) const;
  MotionSetting setting_of(const Observation& observation) const;
  std::optional<Balanced> balance(const Eigen::VectorXd& parameters, const Observation& observation,
                                  MotionSetting setting, const Motion* start) const;

  const CompiledModel& model_;
  const CompiledCase& resonance_;
  std::optional<BasePhases> base_;
  std::shared_ptr<const Torus> torus_;
};

}  // namespace secular
