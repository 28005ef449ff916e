#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "estimator/model/locked_excitations.hpp"
#include "motion/response/vector_field.hpp"

namespace secular {

/// Half peak amplitudes B of every mode of the model, and how much faster each oscillates than its observed
/// frequency (CompiledCase::observed_frequency), rad/s.
struct ModeAmplitudes {
  std::vector<std::complex<double>> amplitude;
  std::vector<double> frequency_shift;
};

/// The modulation equations of a resonance case as a real vector field. Its parameters are the model's symbols, the
/// excitation frequencies (rad/s) and the excitation amplitudes (peak, at phase zero), in this order. Of
/// frequencies that follow others (LockedExcitations) the entries are not read.
///
/// Phases that no resonance relation ties to the excitation are free: B_k -> B_k exp(i n_k theta) turns solutions
/// into solutions wherever sum_k r_k n_k = 0 for the relations' weights r_k. Such a symmetry turns fixed points
/// into circles, along which solutions may turn with a frequency of their own (a combination resonance responds at
/// w_1 + nu and w_2 - nu). It is divided out: the mode with the largest |n| of a symmetry is `pinned`, its B = r
/// real in a frame that turns with it, nu = Im(f/r)/n. With one symmetry the other modes that it moves are B_j = r
/// w_j, so that
///   r' = r Re(f_pinned/r),   w_j' = f_j/r - w_j f_pinned/r (each in the turning frame):
/// smooth at r = 0, where w is a direction in which the trivial solution decays or grows.
class ResponseField {
 public:
  /// Throws std::invalid_argument if every mode is at rest.
  ResponseField(const CompiledModel& model, const CompiledCase& resonance);

  /// Of the field's parameters, in their order.
  static std::vector<std::string> parameter_names(const CompiledModel& model);

  const CompiledModel& model() const { return *model_; }
  const CompiledCase& resonance() const { return *case_; }
  const LockedExcitations& locked() const { return locked_; }
  /// Modes not at rest.
  const std::vector<std::size_t>& active() const { return active_; }
  /// Rows n, [active mode]; empty where all phases are tied.
  const Eigen::MatrixXd& symmetries() const { return symmetries_; }
  bool is_reduced() const { return symmetries_.rows() > 0; }
  /// Whether the trivial solution is blown up: r = 0 with amplitude ratios w.
  bool is_blown_up() const { return !ratio_.empty(); }
  /// What was done about the symmetries, for the reader.
  std::string description() const;

  /// dB/dt of the active modes as derived. amplitude, [active mode].
  Eigen::VectorXcd modulation(const Eigen::Ref<const Eigen::VectorXd>& parameters,
                              const Eigen::Ref<const Eigen::VectorXcd>& amplitude) const;

  /// Re B, Im B of every active mode; symmetries stay in.
  VectorField full(double amplitude_scale, const Eigen::Ref<const Eigen::VectorXd>& parameters) const;
  /// Without symmetries the same as full().
  VectorField reduced(double amplitude_scale, const Eigen::Ref<const Eigen::VectorXd>& parameters) const;
  /// Half widths of a box for the states of reduced(): amplitudes |Re B|, |Im B| up to `largest`.
  Eigen::VectorXd box(double largest) const;

  /// What a state of reduced() means.
  ModeAmplitudes amplitudes(const Eigen::Ref<const Eigen::VectorXd>& parameters,
                            const Eigen::Ref<const Eigen::VectorXd>& state) const;
  /// The pinned amplitudes of a state of reduced(); nothing without symmetries.
  Eigen::VectorXd pinned(const Eigen::Ref<const Eigen::VectorXd>& state) const;

 private:
  struct Frame {
    Eigen::VectorXcd amplitude, rate;  // [active mode]; rate in the turning frame
    Eigen::VectorXd shift;             // [active mode], rad/s
    double scale = 1;                  // rate is per this amplitude in ratio modes and the pinned one
  };
  // Of every active mode: `amplitude(k)`, and `put(k, dB_k/dt)`.
  template <class Amplitude, class Put>
  void modulate(const Eigen::Ref<const Eigen::VectorXd>& parameters, const Amplitude& amplitude,
                const Put& put) const;
  Frame frame_at(const Eigen::Ref<const Eigen::VectorXd>& parameters,
                 const Eigen::Ref<const Eigen::VectorXd>& state) const;
  bool is_equivariant(const Eigen::Ref<const Eigen::VectorXd>& direction) const;
  VectorField field(bool reduced, double amplitude_scale,
                    const Eigen::Ref<const Eigen::VectorXd>& parameters) const;

  const CompiledModel* model_;
  const CompiledCase* case_;
  LockedExcitations locked_;
  std::vector<std::size_t> active_;
  Eigen::MatrixXd symmetries_;
  std::vector<Eigen::Index> pinned_;  // active modes, one a symmetry
  std::vector<Eigen::Index> ratio_;   // active modes given as r w, with one symmetry
  std::vector<Eigen::Index> plain_;   // active modes given as they are
};

/// Amplitude |B| at which the nonlinear terms become as large as the linear ones and the direct excitation
/// together, with `parameter` at several places of [lower, upper]; where nothing is nonlinear, that of the linear
/// response (1 without excitation).
double amplitude_scale(const ResponseField& field, const Eigen::Ref<const Eigen::VectorXd>& parameters,
                       Eigen::Index parameter, double lower, double upper);

}  // namespace secular
