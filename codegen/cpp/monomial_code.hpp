#pragma once

#include <set>
#include <string>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/cpp/code_text.hpp"

namespace secular {

/// C++ of products of powers of amplitudes, their conjugates and moduli, and of the excitation, in ComplexNumbers:
/// what Monomial (codegen/runtime) computes. |A|^2 in pairs, A/|A| as a direction that is zero at A = 0: safe at
/// zero amplitude.
class MonomialCode {
 public:
  explicit MonomialCode(const CanonicalModel& model) : model_(model) {}

  /// "norm_A_v * A_v"; notes which local values it needs. `real`: it is a real number.
  std::string product(const CanonicalPowers& powers, bool& real);
  /// Products of two numbers written so far.
  int products() const { return products_; }

  /// The amplitude itself is needed, whatever products use.
  void use_amplitude(std::size_t mode) { amplitude_.insert(mode); }
  bool uses_amplitude(std::size_t mode) const;
  bool uses_forcing(std::size_t excitation) const;
  /// Declares the local values from arrays of (real, imaginary) pairs: "load_complex(ARRAY, INDEX)", where the
  /// amplitude of mode k is at `index` of `amplitude[k]`, or at index k of `amplitude` where `index` is empty.
  void declare(CodeText& code, const std::string& index) const;

 private:
  const CanonicalModel& model_;
  int products_ = 0;
  std::set<std::size_t> amplitude_, conjugate_, norm_, modulus_, inverse_modulus_, direction_;
  std::set<std::size_t> forcing_, forcing_conjugate_, forcing_norm_;
};

}  // namespace secular
