#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "thesis/verify/demodulation.hpp"
#include "thesis/verify/printed_formula.hpp"

namespace secular::verify {

/// One integrated and demodulated record of every mode: parameters of order eps^n as the case orders them, at the
/// middle of the record.
struct Measurement {
  GiNaC::exmap
      values;  ///< parameters, amplitudes, their rates, slow waves: a number for every symbol of the chapter
  std::vector<Demodulation> mode;
};

/// Makes measurements of a case from the full equations of motion alone. Parameters are fixed numbers of order one
/// with nothing special about them, times their powers of eps.
class Laboratory {
 public:
  Laboratory(const Derivation& derivation, const PrintedFormula& formula)
      : derivation_(derivation), formula_(formula) {}

  /// `without`: parameters that are zero. Repeated calls return the same measurement.
  const Measurement& measure(double eps, const std::set<std::string>& without);

  const Derivation& derivation() const { return derivation_; }
  const PrintedFormula& formula() const { return formula_; }

 private:
  const Derivation& derivation_;
  const PrintedFormula& formula_;
  std::map<std::pair<double, std::set<std::string>>, Measurement> done_;
};

}  // namespace secular::verify
