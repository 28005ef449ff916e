#pragma once

#include <set>
#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/cpp/code_text.hpp"

namespace secular {

/// C++ of products of powers of amplitudes, their conjugates and moduli, and of the excitation, in ComplexNumbers:
/// what Monomial (codegen/runtime) computes. |A|^2 in pairs, A/|A| as a direction that is zero at A = 0: safe at
/// zero amplitude.
class MonomialCode {
 public:
  explicit MonomialCode(const CanonicalModel& model) : model_(model) {}

  /// "norm_A_v * A_v"; notes which signals it needs. `real`: it is a real number.
  std::string product(const CanonicalPowers& powers, bool& real);
  bool uses_excitation() const {
    return !forcing_.empty() || !forcing_norm_.empty() || !forcing_conjugate_.empty();
  }
  bool uses_any() const;

  /// Names of the signals that products so far need and are made of, dependencies first.
  std::vector<std::string> names() const;
  /// Their declarations as members made of arrays `amplitude` and `forcing`.
  void declare(CodeText& code) const;

 private:
  struct Signal {
    std::string type, name, value;
  };
  std::vector<Signal> signals() const;
  bool uses_amplitude(std::size_t mode) const;
  bool uses_forcing(std::size_t excitation) const;

  const CanonicalModel& model_;
  std::set<std::size_t> amplitude_, conjugate_, norm_, modulus_, inverse_modulus_, direction_;
  std::set<std::size_t> forcing_, forcing_conjugate_, forcing_norm_;
};

}  // namespace secular
