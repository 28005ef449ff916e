#include "codegen/canonical/variable_sum.hpp"

#include <algorithm>
#include <utility>

#include "codegen/canonical/polar_form.hpp"

namespace secular {

void VariableSum::add(const Powers& powers, const RationalFunction& coefficient) {
  if (coefficient.is_zero()) return;
  std::vector<RationalFunction>& parts = terms_[powers];
  const auto like = std::find_if(parts.begin(), parts.end(), [&](const RationalFunction& part) {
    return have_like_denominators(part, coefficient);
  });
  if (like == parts.end()) {
    parts.push_back(coefficient);
    return;
  }
  *like = sum(*like, coefficient);
  if (like->is_zero()) parts.erase(like);
  if (parts.empty()) terms_.erase(powers);
}

void VariableSum::add(const VariableSum& other, long numerator, long denominator) {
  for (const auto& [powers, parts] : other.terms_)
    for (const RationalFunction& part : parts) add(powers, scaled(part, numerator, denominator));
}

bool VariableSum::is_zero() const {
  return std::all_of(terms_.begin(), terms_.end(), [](const auto& term) {
    RationalFunction total = term.second.front();
    for (std::size_t i = 1; i < term.second.size(); ++i) total = sum(total, term.second[i]);
    return vanishes(total);
  });
}

bool VariableSum::depends_on_symbol(std::size_t symbol) const {
  return std::any_of(terms_.begin(), terms_.end(), [&](const auto& term) {
    return std::any_of(term.second.begin(), term.second.end(),
                       [&](const RationalFunction& part) { return depends_on(part, symbol); });
  });
}

bool VariableSum::depends_on_variable(std::size_t variable) const {
  return std::any_of(terms_.begin(), terms_.end(), [&](const auto& term) { return term.first[variable] != 0; });
}

int VariableSum::lowest_power(std::size_t variable) const {
  int lowest = terms_.empty() ? 0 : terms_.begin()->first[variable];
  for (const auto& [powers, parts] : terms_) lowest = std::min(lowest, powers[variable]);
  return lowest;
}

VariableSum VariableSum::derivative(std::size_t variable) const {
  VariableSum result;
  for (const auto& [powers, parts] : terms_) {
    if (powers[variable] == 0) continue;
    Powers lowered = powers;
    --lowered[variable];
    for (const RationalFunction& part : parts) result.add(lowered, scaled(part, powers[variable], 1));
  }
  return result;
}

VariableSum VariableSum::times_power(std::size_t variable, int power) const {
  VariableSum result;
  for (const auto& [powers, parts] : terms_) {
    Powers raised = powers;
    raised[variable] += power;
    result.terms_[raised] = parts;
  }
  return result;
}

VariableSum operator*(const VariableSum& a, const VariableSum& b) {
  VariableSum result;
  for (const auto& [left, left_parts] : a.terms_)
    for (const auto& [right, right_parts] : b.terms_) {
      VariableSum::Powers powers = left;
      for (std::size_t i = 0; i < powers.size(); ++i) powers[i] += right[i];
      for (const RationalFunction& x : left_parts)
        for (const RationalFunction& y : right_parts) result.add(powers, product(x, y));
    }
  return result;
}

VariableSum operator+(VariableSum a, const VariableSum& b) {
  a.add(b);
  return a;
}

VariableSum operator-(VariableSum a, const VariableSum& b) {
  a.add(b, -1);
  return a;
}

}  // namespace secular
