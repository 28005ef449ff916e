#include "perturb/field.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace secular {

void Field::add(const FieldKey& key, const GiNaC::ex& coefficient) {
  const auto [position, added] = terms_.try_emplace(key, coefficient);
  if (!added) position->second += coefficient;
  if (position->second.is_zero()) terms_.erase(position);
}

Field& Field::operator+=(const Field& other) {
  for (const auto& [key, coefficient] : other.terms_) add(key, coefficient);
  return *this;
}

Field Field::scaled(const GiNaC::ex& scale) const {
  Field result;
  if (scale.is_zero()) return result;
  for (const auto& [key, coefficient] : terms_) result.add(key, (coefficient * scale).expand());
  return result;
}

Field operator*(const Field& left, const Field& right) {
  Field sums;
  FieldKey key;
  for (const auto& [left_key, left_coefficient] : left.terms_)
    for (const auto& [right_key, right_coefficient] : right.terms_) {
      key = left_key;
      for (std::size_t i = 0; i < key.size(); ++i) key[i] += right_key[i];
      sums.add(key, left_coefficient * right_coefficient);
    }
  Field result;
  for (const auto& [sum_key, coefficient] : sums.terms_) result.add(sum_key, coefficient.expand());
  return result;
}

Field Field::conjugated(const FieldLayout& layout) const {
  Field result;
  for (const auto& [key, coefficient] : terms_) {
    FieldKey mirrored = key;
    for (std::size_t i = 0; i < layout.amplitude(0); ++i) mirrored[i] = -key[i];
    for (std::size_t mode = 0; mode < layout.modes; ++mode)
      std::swap(mirrored[layout.amplitude(mode)], mirrored[layout.conjugate(mode)]);
    result.add(mirrored, coefficient.conjugate().expand());
  }
  return result;
}

Field Field::with_moduli_joined(const FieldLayout& layout) const {
  Field result;
  for (const auto& [key, coefficient] : terms_) {
    FieldKey joined = key;
    for (std::size_t mode = 0; mode < layout.modes; ++mode) {
      int& modulus = joined[layout.modulus(mode)];
      int &forward = joined[layout.amplitude(mode)], &backward = joined[layout.conjugate(mode)];
      if (modulus % 2 != 0) {
        const int pairs = std::max(0, std::min(forward, backward));
        modulus += 2 * pairs;
        forward -= pairs;
        backward -= pairs;
      } else if (modulus > 0) {
        forward += modulus / 2;
        backward += modulus / 2;
        modulus = 0;
      }
    }
    result.add(joined, coefficient);
  }
  return result;
}

Field Field::with_symbols(const GiNaC::exmap& values) const {
  Field result;
  for (const auto& [key, coefficient] : terms_)
    result.add(key, coefficient.subs(values, GiNaC::subs_options::no_pattern));
  return result;
}

namespace {

void accumulate(const std::vector<const FieldSeries*>& factors, std::size_t first, int order, const Field* partial,
                Field& result, ProductCount& count) {
  const FieldSeries& series = *factors[first];
  const bool last = first + 1 == factors.size();
  for (int n = last ? order : 0; n <= order; ++n) {
    if (static_cast<std::size_t>(n) >= series.size() || series[static_cast<std::size_t>(n)].empty()) continue;
    const Field& here = series[static_cast<std::size_t>(n)];
    if (partial) count.add(partial->terms().size() * here.terms().size());
    const Field product = partial ? *partial * here : here;
    if (last)
      result += product;
    else
      accumulate(factors, first + 1, order - n, &product, result, count);
  }
}

}  // namespace

void ProductCount::add(std::size_t products) {
  if ((count_ += products) > limit_)
    throw std::length_error("has more than " + std::to_string(limit_) + " products of terms in its expansion");
}

Field product_at_order(const std::vector<const FieldSeries*>& factors, int order, ProductCount& count) {
  Field result;
  if (factors.empty() || order < 0) return result;
  accumulate(factors, 0, order, nullptr, result, count);
  return result;
}

}  // namespace secular
