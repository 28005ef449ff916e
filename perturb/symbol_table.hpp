#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

namespace secular {

/// The one place where a name becomes a GiNaC symbol: two symbols of the same name would be different unknowns.
/// Filled while a model is read, constant afterwards and passed on. All symbols are real; natural frequencies,
/// excitation frequencies and amplitudes are positive.
class SymbolTable {
 public:
  const GiNaC::ex& add_real(const std::string& name);
  const GiNaC::ex& add_positive(const std::string& name);
  bool contains(const std::string& name) const { return symbols_.count(name) != 0; }
  /// Throws std::out_of_range for an undeclared name (a programming error: readers check names before).
  const GiNaC::ex& at(const std::string& name) const { return symbols_.at(name); }
  /// In order of declaration: the order of everything that is printed.
  const std::vector<std::string>& names() const { return names_; }
  /// All symbols in that order, then Pi: what expressions of a model are rational in.
  GiNaC::exvector with_pi() const;

 private:
  // As ex: a copy as GiNaC::symbol would forget that the symbol is real.
  std::map<std::string, GiNaC::ex> symbols_;
  std::vector<std::string> names_;
};

/// An exact rational from digits as written: "0.25" is 1/4, "1e-3" is 1/1000.
GiNaC::numeric exact_number(const std::string& digits);

}  // namespace secular
