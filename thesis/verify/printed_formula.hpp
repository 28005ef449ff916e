#pragma once

#include <ginac/ginac.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "perturb/derivation.hpp"
#include "thesis/verify/printed_source.hpp"

namespace secular::verify {

/// Reads a chapter's formulas into expressions, and the engine's fields into the same symbols, so that both can be
/// subtracted. Harmonics are powers of symbols: X_k = exp(i omega_k t), S_r = exp(i sigma_r t), B_k = exp(i
/// beta_k); an excitation frequency is its resonant value plus its detuning.
class PrintedFormula {
 public:
  PrintedFormula(const PrintedChapter& chapter, const Derivation& derivation);

  /// Throws InputError at the place of what is not understood.
  GiNaC::ex read(const FormulaSource& source) const;
  /// left - right of an equation, or the formula itself.
  GiNaC::ex difference(const FormulaSource& source) const;

  /// A field in these symbols, amplitudes as A_k.
  GiNaC::ex field(const Field& field) const;
  GiNaC::ex conjugated(const GiNaC::ex& expression) const;
  /// A_k = a_k exp(i beta_k)/2 and what belongs to it.
  GiNaC::ex in_polar_form(const GiNaC::ex& expression) const;
  /// Integers of a combination of slow phases (each named by its detuning) and of beta. Throws InputError.
  struct PhaseCombination {
    std::vector<int> slow, phases;
  };
  PhaseCombination phase_combination(const FormulaSource& source) const;
  /// Excitation frequencies at their resonant values.
  GiNaC::ex at_resonance(const GiNaC::ex& expression) const;

  /// Replaces the value of a definition, to see what a printed one does.
  void set_definition(const std::string& name, const GiNaC::ex& value) { names_[name] = value; }

  /// One-sided Fourier coefficient of a mode at the frequency with these multiples of the natural frequencies: c of
  /// Re(c exp(i f t)). Without a source of one's own, the lowest order of the response that has that frequency.
  using Lines = std::function<GiNaC::ex(std::size_t mode, const std::vector<int>& multiples)>;
  void set_lines(Lines lines) { lines_ = std::move(lines); }

  const GiNaC::ex& amplitude(std::size_t mode) const { return amplitude_[mode]; }
  const GiNaC::ex& conjugate_amplitude(std::size_t mode) const { return conjugate_[mode]; }
  const GiNaC::ex& modulus(std::size_t mode) const { return modulus_[mode]; }
  const GiNaC::ex& wave(std::size_t mode) const { return wave_[mode]; }
  const GiNaC::ex& slow_wave(std::size_t relation) const { return slow_[relation]; }
  const GiNaC::ex& phase_factor(std::size_t mode) const { return phase_factor_[mode]; }
  const GiNaC::ex& polar_amplitude(std::size_t mode) const { return polar_[mode]; }
  const GiNaC::ex& amplitude_rate(std::size_t mode) const { return polar_rate_[mode]; }  ///< da
  const GiNaC::ex& phase_rate(std::size_t mode) const { return phase_rate_[mode]; }      ///< dbeta
  const GiNaC::ex& gamma_rate() const { return gamma_rate_; }                            ///< dgamma
  /// D_n A_k as a symbol, and its conjugate.
  const GiNaC::ex& slow_derivative(std::size_t mode, int n) const {
    return slow_derivative_[mode][static_cast<std::size_t>(n)];
  }
  const GiNaC::ex& slow_derivative_conjugate(std::size_t mode, int n) const {
    return slow_derivative_conjugate_[mode][static_cast<std::size_t>(n)];
  }
  /// A name of the model or of the language that stands for itself: no definition.
  bool is_symbol(const std::string& name) const {
    const auto found = names_.find(name);
    return found != names_.end() && GiNaC::is_a<GiNaC::symbol>(found->second);
  }
  const GiNaC::ex& symbol(const std::string& name) const { return names_.at(name); }
  /// gamma = sum_r slow_r * (slow phase r) + sum_k beta_k * multiple.
  const std::vector<int>& gamma_slow() const { return gamma_slow_; }
  const std::vector<int>& gamma_phases() const { return gamma_phases_; }

  /// D0^a D1^b D2^c v_{mode, order} as one unknown.
  GiNaC::ex unknown(std::size_t mode, std::size_t order, const std::vector<int>& derivatives) const;
  GiNaC::ex absolute(const GiNaC::ex& inside) const;
  /// F cos(Omega T0), differentiated `derivative` times by T0.
  GiNaC::ex excitation(std::size_t index, int derivative) const;
  GiNaC::ex clock(std::size_t index, int multiple, bool cosine) const;

 private:
  void read_gamma();
  GiNaC::ex value(const Expression& e, const FormulaSource& source) const;
  GiNaC::ex call(const Expression& e, const FormulaSource& source) const;
  GiNaC::ex line(const Expression& e, const FormulaSource& source) const;
  GiNaC::ex response_line(std::size_t mode, const std::vector<int>& multiples) const;
  GiNaC::ex slow_scale_derivative(const GiNaC::ex& expression, std::size_t scale) const;
  /// exp(i angle) for an angle linear in frequencies (times t where `timed`), detunings, phases and gamma.
  GiNaC::ex exponential(const Expression& angle, const FormulaSource& source, bool timed) const;
  GiNaC::ex excitation_wave(std::size_t index, int multiple) const;

  const PrintedChapter& chapter_;
  const Derivation& derivation_;
  std::map<std::string, GiNaC::ex> names_;
  std::vector<GiNaC::ex> amplitude_, conjugate_, modulus_, wave_, slow_, phase_factor_, polar_, polar_rate_,
      phase_rate_;
  std::vector<std::vector<GiNaC::ex>> slow_derivative_, slow_derivative_conjugate_;
  std::vector<GiNaC::ex> detuning_;
  std::vector<int> gamma_slow_, gamma_phases_;
  GiNaC::ex gamma_rate_;
  Lines lines_;
  struct Jet {
    std::size_t mode, order;
    std::vector<int> derivatives;
  };
  mutable std::map<std::string, std::pair<GiNaC::ex, Jet>> jets_;
  mutable std::map<std::string, GiNaC::ex> absolutes_;
};

}  // namespace secular::verify
