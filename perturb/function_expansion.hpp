#pragma once

#include <map>
#include <stdexcept>
#include <utility>

#include "perturb/term_sum.hpp"

namespace secular {

/// An expansion with more terms than a case can be derived from.
struct ExpansionTooLong : std::length_error {
  using std::length_error::length_error;
};

/// Power of coordinates and velocities of a product without smooth functions.
int degree_in_coordinates(const FactorProduct& product);

/// Taylor series of smooth functions about rest, up to some degree in coordinates and velocities: exact, with
/// rational numbers and the symbols of the equations. Remembers what it has made.
class FunctionExpansions {
 public:
  explicit FunctionExpansions(int highest_degree) : highest_(highest_degree) {}

  /// Sums of products of coordinates and velocities, in ascending degree. Throws ExpansionTooLong.
  const TermSum& of(const SmoothFunction& function);
  /// The same of a sum or product of polynomial factors and smooth functions.
  TermSum of(const TermSum& sum);
  TermSum of(const FactorProduct& product, const GiNaC::ex& coefficient);

 private:
  TermSum times(const TermSum& a, const TermSum& b);

  int highest_;
  std::size_t products_ = 0;  // of terms, so far
  std::map<SmoothFunction, TermSum> known_;
};

/// Of f about `rest`: the n-th derivative over n!, n = 0 ... highest.
GiNaC::exvector taylor_coefficients(SmoothKind kind, std::pair<long, long> exponent, const GiNaC::ex& rest,
                                    int highest);

}  // namespace secular
