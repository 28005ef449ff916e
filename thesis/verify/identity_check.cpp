#include "thesis/verify/identity_check.hpp"

#include <algorithm>
#include <complex>
#include <limits>
#include <map>

#include "perturb/prime_field.hpp"
#include "thesis/verify/number_formula.hpp"

namespace secular::verify {
namespace {

// Draws go in pairs of opposite signs. Whether signs agree with one another is random in every pair, so that what
// holds for one sign of a product alone is seen but once in 2^16.
constexpr int draws = 32;
// Rounding of double precision, with room for the steps and entries that a bound of first order does not count.
constexpr double equal = 64 * std::numeric_limits<double>::epsilon();
constexpr double smallest_drawn = 0.25;

/// "left = right" as two formulas whose places stay those of the file.
std::pair<FormulaSource, FormulaSource> sides(const FormulaSource& text) {
  const std::size_t at = text.text.find('=');
  if (at == std::string::npos) fail_at(text, {text.first_line, 1}, "has no equals sign", "left = right");
  std::string right = text.text;
  for (std::size_t i = 0; i <= at; ++i)
    if (right[i] != '\n') right[i] = ' ';
  return {{text.text.substr(0, at), text.file, text.first_line}, {right, text.file, text.first_line}};
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_reserved(const std::string& name) {
  const auto functions = number_functions();
  return name == "i" || name == "Pi" ||
         std::any_of(functions.begin(), functions.end(), [&](const FormulaFunction& f) { return f.name == name; });
}

std::vector<std::string> names_in(const FormulaSource& formula) {
  return identifiers(parse_expression(formula, number_functions()));
}

/// Every name of `define`, `sizes` and `complex` has one meaning and occurs.
void require_names_that_occur(const PrintedIdentity& identity) {
  std::vector<std::string> used;
  const auto use = [&](const FormulaSource& formula) {
    for (const std::string& name : names_in(formula)) used.push_back(name);
  };
  for (const auto* text : {&identity.printed, identity.corrected ? &*identity.corrected : nullptr})
    if (text != nullptr) {
      const auto [left, right] = sides(*text);
      use(left);
      use(right);
    }
  std::vector<std::string> defined;  // from the last definition to the first
  for (auto one = identity.define.rbegin(); one != identity.define.rend(); ++one) {
    const std::string& name = one->first;
    if (is_reserved(name))
      identity.place.fail("define", "'" + name + "' has a meaning already", "choose another name");
    if (contains(defined, name)) identity.place.fail("define", "has '" + name + "' twice", "every name once");
    if (!contains(used, name))
      identity.place.fail("define", "'" + name + "' does not occur after its definition",
                          "a name of `printed`, `corrected` or a later definition");
    defined.push_back(name);
    const std::vector<std::string> names = names_in(one->second);
    for (const std::string& after : defined)
      if (contains(names, after))
        identity.place.fail("define", "'" + name + "' is made from '" + after + "', which is not defined before it",
                            "definitions in the order of their use");
    used.insert(used.end(), names.begin(), names.end());
  }
  const auto require_drawn = [&](const char* key, const std::string& name) {
    if (is_reserved(name) || contains(defined, name))
      identity.place.fail(key, "'" + name + "' has a value already",
                          "a symbol that is neither defined nor reserved");
    if (!contains(used, name))
      identity.place.fail(key, "'" + name + "' does not occur in the identity",
                          "a symbol of `printed`, `corrected` or `define`");
  };
  for (const auto& [name, size] : identity.sizes) require_drawn("sizes", name);
  for (const std::string& name : identity.complex) require_drawn("complex", name);
}

/// The values of one draw: symbols on demand, definitions in their order.
class Draw {
 public:
  Draw(const PrintedIdentity& identity, int number) : identity_(identity), number_(number) {
    for (const auto& [name, formula] : identity.define) values_[name] = value(formula);
  }

  Computed value(const FormulaSource& formula) {
    return numbers_of(parse_expression(formula, number_functions()), formula,
                      [this](const Expression& e) { return of(e.text); });
  }

 private:
  Computed of(const std::string& name) {
    if (name == "i") return exact(Numbers::Constant(1, 1, std::complex<double>(0, 1)));
    const auto [entry, fresh] = values_.try_emplace(name);
    if (!fresh) return entry->second;
    const auto size = identity_.sizes.find(name);
    const bool is_complex = contains(identity_.complex, name);
    Numbers drawn(size == identity_.sizes.end() ? 1 : size->second.first,
                  size == identity_.sizes.end() ? 1 : size->second.second);
    const auto part = [&](const char* which, Eigen::Index entry_number) {
      const std::string key = name + which + std::to_string(entry_number) + "_";
      const double magnitude = random_value(key + std::to_string(number_), 51).fraction();
      const bool negative = random_value(key + "pair" + std::to_string(number_ / 2), 51).fraction() < 0.5;
      return (negative == (number_ % 2 == 0) ? 1 : -1) * (smallest_drawn + (1 - smallest_drawn) * magnitude);
    };
    for (Eigen::Index n = 0; n < drawn.size(); ++n)
      drawn(n) = {part("_real_", n), is_complex ? part("_imag_", n) : 0.0};
    return entry->second = exact(drawn);
  }

  const PrintedIdentity& identity_;
  int number_;
  std::map<std::string, Computed> values_;
};

}  // namespace

IdentityCheck check_identity(const PrintedIdentity& identity, const FormulaSource& text) {
  require_names_that_occur(identity);
  const auto [left_text, right_text] = sides(text);
  IdentityCheck check;
  for (int n = 0; n < draws; ++n) {
    try {
      Draw draw(identity, n);
      const Computed left = draw.value(left_text), right = draw.value(right_text);
      if (left.value.rows() != right.value.rows() || left.value.cols() != right.value.cols())
        throw SizeMismatch("an equation between matrices of different sizes");
      const Eigen::ArrayXXd terms = left.rounding.array() + right.rounding.array();
      if (!terms.isFinite().all()) throw SizeMismatch("nothing that double precision determines");
      const Eigen::ArrayXXd apart = (left.value - right.value).array().abs();
      check.largest = std::max(check.largest, (apart == 0).select(0, apart / terms).maxCoeff());
    } catch (const SizeMismatch& mismatch) {
      check.why = std::string("is ") + mismatch.what();
      return check;
    }
  }
  check.holds = check.largest < equal;
  return check;
}

}  // namespace secular::verify
