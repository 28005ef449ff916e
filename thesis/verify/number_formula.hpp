#pragma once

#include <Eigen/Dense>
#include <functional>
#include <span>
#include <stdexcept>

#include "perturb/expression.hpp"

namespace secular::verify {

/// What a formula of numbers makes: a matrix, of one row and one column for a number.
using Numbers = Eigen::MatrixXcd;

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
Numbers numbers_of(const Expression& expression, const FormulaSource& source,
                   const std::function<Numbers(const Expression& symbol)>& value_of);

}  // namespace secular::verify
