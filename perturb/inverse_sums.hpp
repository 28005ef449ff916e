#pragma once

#include <map>

#include "perturb/field.hpp"
#include "perturb/prime_field.hpp"

namespace secular {

/// Inverses of frequencies while an expansion runs. A symbol stands for the inverse of a sum: GiNaC goes through
/// the sum at every evaluation of a product with it, a third of all time. What such symbols hide is found at a
/// random point and written out at the end.
class InverseSums {
 public:
  /// 1/frequency: number * power for a single factor, number * symbol for a sum.
  GiNaC::ex inverse(const GiNaC::ex& frequency);
  /// The coefficient expanded; 0 if it is identically zero behind different denominators.
  GiNaC::ex cleaned(const GiNaC::ex& coefficient);
  /// The same for a field: terms that are identically zero are gone.
  Field cleaned(const Field& field);
  /// The field with sums put back for their symbols.
  Field written_out(const Field& field) const;

 private:
  RandomPoint point_;
  std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> symbol_of_;  // power -1 of a sum to its symbol
  GiNaC::exmap sum_behind_;                                      // and back
};

}  // namespace secular
