#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "codegen/runtime/expansion_sizes.hpp"
#include "motion/correction/expansion_remainder.hpp"

namespace secular {

/// Where a case's expansion says something. An asymptotic series is worth taking to its smallest term, and what it
/// leaves out is of the size of the term after its last one. So a state is outside
///  - where the last order of the displacement exceeds every order before (ExpansionSizes::outside), or
///  - where what the full equations add to dA/dt (ExpansionRemainder) exceeds every order of dA/dt, or no motion of
///    theirs is found: the terms after the last one are larger than any before.
/// Compared is what is not linear in amplitudes and excitation: a damping or a detuning taken to few orders leaves
/// as much at any amplitude. That part of the remainder is R(a) - lim R(s*a)/s for s -> 0, with a the amplitudes
/// and the excitation. A constant force moves the rest position, and with it the stiffness, which is linear in what
/// is left: there the linear part itself may not exceed every order of dA/dt either.
class ExpansionRange {
 public:
  ExpansionRange(const CompiledModel& model, const CompiledCase& resonance, ExpansionSizes sizes)
      : model_(model), resonance_(resonance), sizes_(std::move(sizes)), remainder_(model, resonance) {}

  /// As ExpansionRemainder::at takes them. From any thread.
  bool excludes(const Eigen::VectorXd& parameters, const std::vector<std::complex<double>>& amplitude) const;

  /// By how much constant forces shift a mode's rate beyond the expansion, in the limit of small motion, 1/s: of
  /// what the full equations add to dA/dt of A the most that is added with them and not without them, by mode.
  /// Nothing where none act, no balance is found, or the expansion lacks more without them.
  std::optional<double> rest_shift(const Eigen::VectorXd& parameters,
                                   const std::vector<std::complex<double>>& amplitude) const;

 private:
  std::optional<std::vector<std::complex<double>>> linear_remainder(
      const Eigen::VectorXd& parameters, const std::vector<std::complex<double>>& amplitude) const;
  bool remainder_exceeds(const Eigen::VectorXd& parameters, const std::vector<std::complex<double>>& amplitude,
                         const ExpansionSizes::State& state) const;

  std::vector<std::complex<double>> forcing(const Eigen::VectorXd& parameters) const;
  double rest_size(const Eigen::VectorXd& parameters, const std::vector<std::complex<double>>& amplitude) const;
  Eigen::VectorXd without_loads(const Eigen::VectorXd& parameters,
                                const std::vector<std::complex<double>>& amplitude) const;

  const CompiledModel& model_;
  const CompiledCase& resonance_;
  ExpansionSizes sizes_;
  ExpansionRemainder remainder_;
};

}  // namespace secular
