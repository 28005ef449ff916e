#include "perturb/polynomial.hpp"

#include <cln/integer.h>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace secular {
namespace {

// The top bit of every packed power: free in all valid ones, set where a power left its range.
constexpr std::uint64_t top_bits = 0x8000800080008000ULL;
// More copies at once are merged by halves.
constexpr std::size_t merged_at_once = 6;

// a - b of two monomials, word by word: negative, zero or positive as a stands after, with or before b.
int compared(const std::uint64_t* a, const std::uint64_t* b, std::size_t width) {
  for (std::size_t w = 0; w < width; ++w)
    if (a[w] != b[w]) return a[w] < b[w] ? -1 : 1;
  return 0;
}

void add(const std::uint64_t* a, const std::uint64_t* b, std::size_t width, std::uint64_t* sum) {
  std::uint64_t left = 0;
  for (std::size_t w = 0; w < width; ++w) left |= sum[w] = a[w] + b[w];
  if ((left & top_bits) != 0) throw PolynomialTooLarge(fmt::format("a power beyond {}", Polynomial::highest_power));
}

// a/b of monomials; false where b has a higher power.
bool subtract(const std::uint64_t* a, const std::uint64_t* b, std::size_t width, std::uint64_t* difference) {
  for (std::size_t w = 0; w < width; ++w) {
    const std::uint64_t guarded = (a[w] | top_bits) - b[w];
    if ((guarded & top_bits) != top_bits) return false;
    difference[w] = guarded & ~top_bits;
  }
  return true;
}

}  // namespace

Polynomial::Polynomial(std::size_t symbols, const std::vector<Term>& terms) : Polynomial(symbols) {
  std::vector<std::uint64_t> packed(terms.size() * width_, 0);
  for (std::size_t t = 0; t < terms.size(); ++t)
    for (std::size_t s = 0; s < symbols; ++s) {
      const int power = terms[t].powers[s];
      if (power < 0 || power > highest_power)
        throw PolynomialTooLarge(fmt::format("a power beyond {}", Polynomial::highest_power));
      packed[t * width_ + s / 4] |= static_cast<std::uint64_t>(power) << shift(s);
    }
  std::vector<std::size_t> sorted(terms.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
    return compared(&packed[a * width_], &packed[b * width_], width_) > 0;
  });
  for (std::size_t i = 0; i < sorted.size();) {
    const std::uint64_t* here = packed.data() + sorted[i] * width_;
    cln::cl_I sum = 0;
    for (; i < sorted.size() && compared(packed.data() + sorted[i] * width_, here, width_) == 0; ++i)
      sum = sum + terms[sorted[i]].coefficient;
    append(here, std::move(sum));
  }
}

void Polynomial::append(const std::uint64_t* monomial, cln::cl_I coefficient) {
  if (cln::zerop(coefficient)) return;
  if (size() == most_terms) throw PolynomialTooLarge(fmt::format("more than {} terms", most_terms));
  powers_.insert(powers_.end(), monomial, monomial + width_);
  coefficients_.push_back(std::move(coefficient));
}

bool Polynomial::is_one() const {
  return size() == 1 && coefficients_.front() == 1 &&
         std::all_of(powers_.begin(), powers_.end(), [](std::uint64_t word) { return word == 0; });
}

std::vector<int> Polynomial::powers(std::size_t term) const {
  std::vector<int> result(symbols_);
  for (std::size_t s = 0; s < symbols_; ++s) result[s] = power(term, s);
  return result;
}

cln::cl_I Polynomial::make_primitive() {
  if (is_zero()) return 1;
  cln::cl_I content = 0;
  for (const cln::cl_I& coefficient : coefficients_) {
    content = cln::gcd(content, coefficient);
    if (content == 1) break;
  }
  if (cln::minusp(coefficients_.front())) content = -content;
  if (content != 1)
    for (cln::cl_I& coefficient : coefficients_) coefficient = cln::exquo(coefficient, content);
  return content;
}

std::vector<int> Polynomial::take_out_monomial() {
  std::vector<int> least = is_zero() ? std::vector<int>(symbols_, 0) : powers(0);
  for (std::size_t t = 1; t < size(); ++t)
    for (std::size_t s = 0; s < symbols_; ++s) least[s] = std::min(least[s], power(t, s));
  std::vector<std::uint64_t> packed(width_, 0);
  for (std::size_t s = 0; s < symbols_; ++s) packed[s / 4] |= static_cast<std::uint64_t>(least[s]) << shift(s);
  for (std::size_t i = 0; i < powers_.size(); ++i) powers_[i] -= packed[i % width_];
  return least;
}

Polynomial Polynomial::renumbered(const std::vector<std::size_t>& place, std::size_t symbols) const {
  Polynomial result(symbols);
  result.coefficients_ = coefficients_;
  result.powers_.assign(size() * result.width_, 0);
  for (std::size_t t = 0; t < size(); ++t)
    for (std::size_t s = 0; s < symbols_; ++s)
      result.powers_[t * result.width_ + place[s] / 4] |= static_cast<std::uint64_t>(power(t, s))
                                                          << shift(place[s]);
  return result;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial sum(a.symbols_);
  sum.powers_.reserve(a.powers_.size() + b.powers_.size());
  sum.coefficients_.reserve(a.size() + b.size());
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const int order = i == a.size() ? -1 : j == b.size() ? 1 : compared(a.monomial(i), b.monomial(j), a.width_);
    if (order > 0) {
      sum.append(a.monomial(i), a.coefficients_[i]);
      ++i;
    } else if (order < 0) {
      sum.append(b.monomial(j), b.coefficients_[j]);
      ++j;
    } else {
      sum.append(a.monomial(i), a.coefficients_[i] + b.coefficients_[j]);
      ++i;
      ++j;
    }
  }
  return sum;
}

// Times the terms of b from begin to end: copies of a, each in order by itself, are merged.
Polynomial Polynomial::product(const Polynomial& a, const Polynomial& b, std::size_t begin, std::size_t end) {
  const std::size_t copies = end - begin, width = a.width_;
  if (copies > merged_at_once) {
    const std::size_t half = begin + copies / 2;
    return product(a, b, begin, half) + product(a, b, half, end);
  }
  Polynomial result(a.symbols_);
  if (a.is_zero()) return result;
  result.powers_.reserve(2 * a.powers_.size());
  result.coefficients_.reserve(2 * a.size());
  std::vector<std::size_t> next(copies, 0);
  std::vector<std::uint64_t> heads(copies * width), here(width);
  for (std::size_t c = 0; c < copies; ++c)
    secular::add(a.monomial(0), b.monomial(begin + c), width, heads.data() + c * width);
  while (true) {
    const std::uint64_t* largest = nullptr;
    for (std::size_t c = 0; c < copies; ++c)
      if (next[c] < a.size() && (!largest || compared(heads.data() + c * width, largest, width) > 0))
        largest = heads.data() + c * width;
    if (!largest) return result;
    std::copy_n(largest, width, here.begin());
    cln::cl_I sum = 0;
    for (std::size_t c = 0; c < copies; ++c) {
      std::uint64_t* head = heads.data() + c * width;
      if (next[c] == a.size() || compared(head, here.data(), width) != 0) continue;
      sum = sum + a.coefficients_[next[c]] * b.coefficients_[begin + c];
      if (++next[c] < a.size()) secular::add(a.monomial(next[c]), b.monomial(begin + c), width, head);
    }
    result.append(here.data(), std::move(sum));
  }
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.size() < b.size()) return b * a;
  if (b.is_zero()) return b;
  if (b.is_one()) return a;
  return Polynomial::product(a, b, 0, b.size());
}

// Long division: what is left of a is never stored, but for the next term of each of its parts: a, and for every
// further term of b the quotient so far times that term.
std::optional<Polynomial> divided(const Polynomial& a, const Polynomial& b) {
  const std::size_t parts = b.size(), width = a.width_;
  Polynomial quotient(a.symbols_);
  if (b.is_zero()) return std::nullopt;
  std::size_t taken = 0;                    // of a
  std::vector<std::size_t> next(parts, 0);  // of the quotient, for every term of b; the first is not used
  std::vector<std::uint64_t> heads(parts * width), here(width), monomial(width);
  const auto waiting = [&](std::size_t p) { return next[p] < quotient.size(); };
  while (true) {
    const std::uint64_t* largest = taken < a.size() ? a.monomial(taken) : nullptr;
    for (std::size_t p = 1; p < parts; ++p)
      if (waiting(p)) {
        add(quotient.monomial(next[p]), b.monomial(p), width, heads.data() + p * width);
        if (!largest || compared(heads.data() + p * width, largest, width) > 0) largest = heads.data() + p * width;
      }
    if (!largest) return quotient;
    std::copy_n(largest, width, here.begin());
    cln::cl_I left = 0;
    if (taken < a.size() && compared(a.monomial(taken), here.data(), width) == 0) left = a.coefficients_[taken++];
    for (std::size_t p = 1; p < parts; ++p)
      if (waiting(p) && compared(heads.data() + p * width, here.data(), width) == 0)
        left = left - b.coefficients_[p] * quotient.coefficients_[next[p]++];
    if (cln::zerop(left)) continue;
    if (!subtract(here.data(), b.monomial(0), width, monomial.data())) return std::nullopt;
    const cln::cl_I_div_t share = cln::truncate2(left, b.coefficients_[0]);
    if (!cln::zerop(share.remainder)) return std::nullopt;
    quotient.append(monomial.data(), share.quotient);
  }
}

bool Polynomial::operator==(const Polynomial& other) const {
  return symbols_ == other.symbols_ && powers_ == other.powers_ &&
         std::equal(coefficients_.begin(), coefficients_.end(), other.coefficients_.begin(),
                    other.coefficients_.end());
}

}  // namespace secular
