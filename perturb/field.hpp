#pragma once

#include <ginac/ginac.h>

#include <map>
#include <vector>

#include "perturb/model.hpp"
#include "perturb/resonance.hpp"

namespace secular {

/// Where each integer of a FieldKey stands. One flat vector, so that a product of terms is a sum of keys:
/// phase over all frequencies | slow phase over relations | A_k | conj A_k | |A_k| | F_j.
struct FieldLayout {
  std::size_t modes = 0, excitations = 0, relations = 0;

  std::size_t frequencies() const { return modes + excitations; }
  std::size_t slow(std::size_t relation) const { return frequencies() + relation; }
  std::size_t amplitude(std::size_t mode) const { return frequencies() + relations + mode; }
  std::size_t conjugate(std::size_t mode) const { return amplitude(modes) + mode; }
  std::size_t modulus(std::size_t mode) const { return conjugate(modes) + mode; }
  std::size_t forcing(std::size_t excitation) const { return modulus(modes) + excitation; }
  std::size_t size() const { return forcing(excitations); }
};

using FieldKey = std::vector<int>;

/// A real quantity on the fast and slow scales: sum of coefficient * A, conj A, |A|, F powers *
/// exp(i*(phase.f)*T0) * exp(i*slow phase). Terms and their conjugates are both stored. Coefficients are expanded.
class Field {
 public:
  Field() = default;

  /// Adds one term; `coefficient` expanded. A term whose coefficient becomes zero is taken out.
  void add(const FieldKey& key, const GiNaC::ex& coefficient);
  const std::map<FieldKey, GiNaC::ex>& terms() const { return terms_; }
  bool empty() const { return terms_.empty(); }

  Field& operator+=(const Field& other);
  Field scaled(const GiNaC::ex& scale) const;
  friend Field operator*(const Field& left, const Field& right);
  /// The complex conjugate: phases turned back, A and conj A exchanged.
  Field conjugated(const FieldLayout& layout) const;
  /// The same with |A|^2 = A conj(A) used one way: pairs A conj(A) beside an odd power of |A| go into |A|.
  Field with_moduli_joined(const FieldLayout& layout) const;
  /// The same with values put in for symbols of the coefficients.
  Field with_symbols(const GiNaC::exmap& values) const;

 private:
  std::map<FieldKey, GiNaC::ex> terms_;
};

/// A field by powers of eps.
using FieldSeries = std::vector<Field>;

/// Products of terms that a derivation makes. A guard: at 2 to 5 microseconds each, of seconds of work.
class ProductCount {
 public:
  static constexpr std::size_t most = 1'000'000;
  explicit ProductCount(std::size_t limit = most) : limit_(limit) {}
  /// Throws std::length_error beyond the limit.
  void add(std::size_t products);

 private:
  std::size_t limit_, count_ = 0;
};

/// The coefficient of eps^order in a product of series; entries beyond a series' end are zero.
Field product_at_order(const std::vector<const FieldSeries*>& factors, int order, ProductCount& count);

}  // namespace secular
