#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace secular {

/// A number as a truncated power series in eps: coefficients of eps^0 ... eps^N.
template <class Number>
using EpsSeries = std::vector<Number>;

/// value*eps^order, truncated to `size` powers of eps.
template <class Number>
EpsSeries<Number> eps_power(const Number& value, std::size_t order, std::size_t size) {
  EpsSeries<Number> result(size);
  if (order < size) result[order] = value;
  return result;
}

template <class Number>
EpsSeries<Number> product(const EpsSeries<Number>& a, const EpsSeries<Number>& b) {
  EpsSeries<Number> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; i + j < a.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

/// 1/a for a series with an invertible leading coefficient. `inverse` inverts a number.
template <class Number, class Inverse>
EpsSeries<Number> reciprocal(const EpsSeries<Number>& a, const Inverse& inverse) {
  EpsSeries<Number> result(a.size());
  const Number lead = inverse(a[0]);
  result[0] = lead;
  for (std::size_t n = 1; n < a.size(); ++n) {
    Number sum{};
    for (std::size_t j = 1; j <= n; ++j) sum += a[j] * result[n - j];
    result[n] = -(sum * lead);
  }
  return result;
}

/// A Laurent polynomial in some variables, truncated in eps: for every power of eps a sum of number * product of
/// variables to integer powers. Terms that cancel stay, as zeros.
template <class Number>
class GradedPolynomial {
 public:
  using Powers = std::vector<int>;
  using Terms = std::map<Powers, Number>;

  GradedPolynomial() = default;
  explicit GradedPolynomial(int highest_order) : orders_(static_cast<std::size_t>(highest_order) + 1) {}

  /// A constant, `variables` of them in all.
  static GradedPolynomial constant(const EpsSeries<Number>& value, std::size_t variables) {
    GradedPolynomial result(static_cast<int>(value.size()) - 1);
    for (std::size_t n = 0; n < value.size(); ++n)
      if (value[n] != Number{}) result.orders_[n][Powers(variables, 0)] = value[n];
    return result;
  }

  const std::vector<Terms>& orders() const { return orders_; }
  void add(std::size_t order, const Powers& powers, const Number& value) {
    if (order < orders_.size()) orders_[order][powers] += value;
  }
  GradedPolynomial& operator+=(const GradedPolynomial& other) {
    for (std::size_t n = 0; n < orders_.size(); ++n)
      for (const auto& [powers, value] : other.orders_[n]) orders_[n][powers] += value;
    return *this;
  }
  GradedPolynomial negated() const {
    GradedPolynomial result = *this;
    for (Terms& terms : result.orders_)
      for (auto& [powers, value] : terms) value = -value;
    return result;
  }
  friend GradedPolynomial operator*(const GradedPolynomial& a, const GradedPolynomial& b) {
    GradedPolynomial result;
    result.orders_.resize(a.orders_.size());
    Powers sum;
    for (std::size_t i = 0; i < a.orders_.size(); ++i)
      for (std::size_t j = 0; i + j < a.orders_.size(); ++j)
        for (const auto& [left, x] : a.orders_[i])
          for (const auto& [right, y] : b.orders_[j]) {
            sum = left;
            for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += right[v];
            result.orders_[i + j][sum] += x * y;
          }
    return result;
  }

 private:
  std::vector<Terms> orders_;
};

}  // namespace secular
