#pragma once

#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/canonical/variable_sum.hpp"

namespace secular {

/// real + i*imaginary, both sums over powers of the excitations.
struct ComplexSum {
  VariableSum real, imaginary;
  bool empty() const { return real.empty() && imaginary.empty(); }
};

/// The solution B = 0 of the modulation equations and its linearisation in the observed frame:
///   dB_k/dt = -i offset_k B_k + sum_j (direct[k][j] B_j + conjugate[k][j] conj(B_j)).
/// Where it is the sum of single modes and pairs, the condition for an eigenvalue on the imaginary axis is closed.
struct ZeroSolution {
  enum class Kind {
    none,                ///< a term is free of all amplitudes
    not_differentiable,  ///< a term is linear in a modulus or of lower degree
    undecided,           ///< terms are left to quadrature
    linear,
  };
  Kind kind = Kind::linear;
  std::vector<std::vector<ComplexSum>> direct, conjugate;  ///< [mode][mode]; offsets of the frame not included
  std::vector<std::vector<CanonicalRatio>> offset;         ///< [mode][frequency]

  struct Group {
    enum class Kind {
      single,      ///< dB/dt = p B
      parametric,  ///< dB/dt = p B + q conj(B): real determinant |p|^2 - |q|^2, trace 2 Re p
      additive,    ///< dB1/dt = p1 B1 + q12 conj(B2), dB2/dt = p2 B2 + q21 conj(B1)
      difference,  ///< dB1/dt = p1 B1 + p12 B2, dB2/dt = p2 B2 + p21 B1
      several,     ///< no closed form
    };
    Kind kind = Kind::single;
    std::vector<std::size_t> modes;
  };
  std::vector<Group> groups;  ///< modes at rest left out

  /// Of a pair with p_k = -c_k + i d_k the numbers in its characteristic equation
  ///   (s + c1 - i d1)(s + c2 -+ i d2) = K,
  /// + additive with K = q12 conj(q21), - difference with K = p12 p21. An eigenvalue is imaginary where
  ///   Re K = c1 c2 (1 + detuning^2/(c1 + c2)^2) - Im K (Im K + detuning (c2 - c1))/(c1 + c2)^2,
  /// detuning = d1 + d2 additive, d1 - d2 difference; both decay where c1 + c2 > 0 and Re K is smaller.
  struct Pair {
    VariableSum first_decay, second_decay;  ///< c1, c2
    VariableSum detuning;                   ///< without the frame
    std::vector<CanonicalRatio> turning;    ///< the frame's part of the detuning
    ComplexSum exchange;                    ///< K
  };
  Pair pair(const Group& group) const;
};

/// Of one case, of all modes.
ZeroSolution zero_solution(const CanonicalModel& model, const CanonicalCase& resonance);

}  // namespace secular
