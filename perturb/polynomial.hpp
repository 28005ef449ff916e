#pragma once

#include <cln/integer.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

namespace secular {

/// A polynomial that would not fit: beyond `most_terms`, or with a power beyond `highest_power`.
struct PolynomialTooLarge : std::length_error {
  using std::length_error::length_error;
};

/// A polynomial with integer coefficients in numbered symbols, as plain data: terms in descending lexicographic
/// order of their powers, which are packed, four to a word, so that monomials multiply and compare word by word.
/// Sums of many small divisors have thousands of terms: as GiNaC expressions each costs a hundred times as much.
class Polynomial {
 public:
  /// Zero, in so many symbols.
  explicit Polynomial(std::size_t symbols = 0) : symbols_(symbols), width_(symbols / 4 + 1) {}
  /// From terms in any order; equal monomials are summed. Powers are not negative. Throws PolynomialTooLarge, as
  /// sums and products do.
  struct Term {
    std::vector<int> powers;
    cln::cl_I coefficient;
  };
  Polynomial(std::size_t symbols, const std::vector<Term>& terms);

  static constexpr int highest_power = 0x7fff;
  static constexpr std::size_t most_terms = 1'000'000;  ///< a guard: some 100 MB

  std::size_t symbols() const { return symbols_; }
  std::size_t size() const { return coefficients_.size(); }  ///< number of terms
  bool is_zero() const { return coefficients_.empty(); }
  bool is_one() const;
  int power(std::size_t term, std::size_t symbol) const {
    return static_cast<int>(powers_[term * width_ + symbol / 4] >> shift(symbol) & 0xffff);
  }
  std::vector<int> powers(std::size_t term) const;
  const cln::cl_I& coefficient(std::size_t term) const { return coefficients_[term]; }

  /// Divided by the greatest common divisor of its coefficients, which is returned with the sign of the first one;
  /// zero stays, with content 1.
  cln::cl_I make_primitive();
  /// Divided by its largest monomial, whose powers are returned.
  std::vector<int> take_out_monomial();
  /// The same in other symbols: symbol i becomes symbol place[i] of `symbols`; places in ascending order.
  Polynomial renumbered(const std::vector<std::size_t>& place, std::size_t symbols) const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  /// Sum of shifted copies of a, one for each term of b: quick where b is short.
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  /// a/b where b divides a with integer coefficients; by Gauss's lemma a primitive b that divides it at all does.
  friend std::optional<Polynomial> divided(const Polynomial& a, const Polynomial& b);
  bool operator==(const Polynomial& other) const;

 private:
  static unsigned shift(std::size_t symbol) { return 48U - 16U * static_cast<unsigned>(symbol % 4); }
  const std::uint64_t* monomial(std::size_t term) const { return powers_.data() + term * width_; }
  static Polynomial product(const Polynomial& a, const Polynomial& b, std::size_t begin, std::size_t end);
  void append(const std::uint64_t* monomial, cln::cl_I coefficient);

  std::size_t symbols_, width_;  // words to a monomial
  std::vector<std::uint64_t> powers_;
  std::vector<cln::cl_I> coefficients_;
};

Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator*(const Polynomial& a, const Polynomial& b);
std::optional<Polynomial> divided(const Polynomial& a, const Polynomial& b);

}  // namespace secular
