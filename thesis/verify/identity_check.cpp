#include "thesis/verify/identity_check.hpp"

#include <algorithm>
#include <complex>
#include <map>

#include "perturb/prime_field.hpp"
#include "thesis/verify/number_formula.hpp"

namespace secular::verify {
namespace {

constexpr int draws = 3;
constexpr double equal = 1e-9;  // rounding of double precision, with room for what inverses lose

/// "left = right" as two formulas whose places stay those of the file.
std::pair<FormulaSource, FormulaSource> sides(const FormulaSource& text) {
  const std::size_t at = text.text.find('=');
  if (at == std::string::npos) fail_at(text, {text.first_line, 1}, "has no equals sign", "left = right");
  std::string right = text.text;
  for (std::size_t i = 0; i <= at; ++i)
    if (right[i] != '\n') right[i] = ' ';
  return {{text.text.substr(0, at), text.file, text.first_line}, {right, text.file, text.first_line}};
}

/// The values of one draw: symbols on demand, definitions in their order.
class Draw {
 public:
  Draw(const PrintedIdentity& identity, int number) : identity_(identity), number_(number) {
    for (const auto& [name, formula] : identity.define) values_[name] = value(formula);
  }

  Numbers value(const FormulaSource& formula) {
    return numbers_of(parse_expression(formula, number_functions()), formula,
                      [this](const Expression& e) { return of(e.text); });
  }

 private:
  Numbers of(const std::string& name) {
    const auto [entry, fresh] = values_.try_emplace(name);
    if (!fresh) return entry->second;
    if (name == "i") return entry->second = Numbers::Constant(1, 1, std::complex<double>(0, 1));
    const auto size = identity_.sizes.find(name);
    const bool is_complex =
        std::find(identity_.complex.begin(), identity_.complex.end(), name) != identity_.complex.end();
    Numbers drawn(size == identity_.sizes.end() ? 1 : size->second.first,
                  size == identity_.sizes.end() ? 1 : size->second.second);
    const auto part = [&](const char* which, Eigen::Index entry_number) {
      const std::string key = name + which + std::to_string(entry_number) + "_" + std::to_string(number_);
      return 2 * random_value(key, 51).fraction() - 1;
    };
    for (Eigen::Index n = 0; n < drawn.size(); ++n)
      drawn(n) = {part("_real_", n), is_complex ? part("_imag_", n) : 0.0};
    return entry->second = drawn;
  }

  const PrintedIdentity& identity_;
  int number_;
  std::map<std::string, Numbers> values_;
};

}  // namespace

IdentityCheck check_identity(const PrintedIdentity& identity, const FormulaSource& text) {
  const auto [left_text, right_text] = sides(text);
  IdentityCheck check;
  for (int n = 0; n < draws; ++n) {
    Draw draw(identity, n);
    try {
      const Numbers left = draw.value(left_text), right = draw.value(right_text);
      if (left.rows() != right.rows() || left.cols() != right.cols())
        throw SizeMismatch("an equation between matrices of different sizes");
      const Eigen::ArrayXXd scale = 1 + left.array().abs() + right.array().abs();
      check.largest = std::max(check.largest, ((left - right).array().abs() / scale).maxCoeff());
    } catch (const SizeMismatch& mismatch) {
      check.why = mismatch.what();
      return check;
    }
  }
  check.holds = check.largest < equal;
  return check;
}

}  // namespace secular::verify
