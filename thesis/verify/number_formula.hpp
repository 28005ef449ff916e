#pragma once

#include <Eigen/Dense>
#include <functional>
#include <span>
#include <stdexcept>

#include "perturb/expression.hpp"

namespace secular::verify {

/// What a formula of numbers makes: a matrix, of one row and one column for a number.
using Numbers = Eigen::MatrixXcd;

/// A value in double precision and what its rounding may be, entry by entry, in units of the precision and to first
/// order: that of every step is the size of its terms, carried on by the derivative of each later step (a running
/// error analysis). Infinite where double precision does not determine the value, as for the singular vectors of
/// equal singular values and the inverse of a singular matrix.
struct Computed {
  Numbers value;
  Eigen::MatrixXd rounding;
};
/// A value that nothing but its own rounding makes wrong.
Computed exact(Numbers value);

/// A sum, a product or an inverse of matrices whose sizes do not allow it.
struct SizeMismatch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// sqrt, exp, log, cos, sin, cosh, sinh, abs, real, imag, conj, square (entry by entry); transpose, inverse,
/// pseudoinverse, diagonal (of a row or column), left_singular, singular, right_singular; unit(n), powers(z, n)
/// (the column 1, z, ..., z^(n-1)), hankel(v, rows, columns), part(m, first row, last row, first column, last
/// column); f_quantile(probability, numerator, denominator degrees of freedom).
std::span<const FormulaFunction> number_functions();

/// The value of a formula of numbers and matrices in double precision: * is the product of matrices, or of a number
/// and a matrix; powers of matrices are integers. `value_of` is handed the node of a symbol. Throws SizeMismatch,
/// and InputError for division by zero and for what has no finite value.
Computed numbers_of(const Expression& expression, const FormulaSource& source,
                    const std::function<Computed(const Expression& symbol)>& value_of);

}  // namespace secular::verify
