#include "perturb/expression.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "input/input_error.hpp"
#include "perturb/expression_size.hpp"

namespace secular {

void fail_at(const FormulaSource& source, const SourcePlace& place, const std::string& wrong,
             const std::string& right) {
  throw InputError(source.file, "line " + std::to_string(place.line) + ", column " + std::to_string(place.column),
                   wrong, right);
}

namespace {

constexpr int deepest_nesting =
    200;  // two levels a parenthesis: far more than a formula needs, far less than the stack
constexpr std::array<FormulaFunction, 16> functions_of_equations = {{{"D", 1},
                                                                     {"D2", 1},
                                                                     {"abs", 1},
                                                                     {"sgn", 1},
                                                                     {"cos", 1},
                                                                     {"sin", 1},
                                                                     {"max", 2},
                                                                     {"min", 2},
                                                                     {"tan", 1},
                                                                     {"exp", 1},
                                                                     {"sinh", 1},
                                                                     {"cosh", 1},
                                                                     {"tanh", 1},
                                                                     {"log", 1},
                                                                     {"atan", 1},
                                                                     {"sqrt", 1}}};

bool starts_identifier(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

class Parser {
 public:
  Parser(const FormulaSource& source, std::span<const FormulaFunction> functions)
      : source_(source), functions_(functions), line_(source.first_line) {
    skip_blanks();
  }

  Expression sum() {
    const Nesting guard(*this);
    std::vector<Expression> terms;
    const SourcePlace start = place();
    terms.push_back(product());
    while (next() == '+' || next() == '-') {
      const bool minus = next() == '-';
      const SourcePlace at = place();
      advance();
      Expression term = product();
      if (minus) term = Expression{Expression::Kind::negation, at, "-", {std::move(term)}};
      terms.push_back(std::move(term));
    }
    if (terms.size() == 1) return std::move(terms.front());
    return Expression{Expression::Kind::sum, start, "+", std::move(terms)};
  }

  bool take(char c) {
    if (next() != c) return false;
    advance();
    return true;
  }

  void expect_end() {
    if (next() == '\0' && position_ >= source_.text.size()) return;
    if (next() == ')') fail_at(source_, place(), "')' without its '('", "remove it or open the parenthesis");
    if (next() == '=') fail_at(source_, place(), "a second '='", "one equation has one '='");
    fail_at(source_, place(), "unexpected " + shown(), "an operator + - * / ^ or the end was expected");
  }

  void expect_more(const char* what) {
    if (position_ >= source_.text.size()) fail_at(source_, place(), "the formula ends too early", what);
  }

 private:
  // Limits recursion: a formula nested a million deep is an error, not a stack overflow.
  class Nesting {
   public:
    explicit Nesting(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > deepest_nesting)
        fail_at(parser_.source_, parser_.place(),
                "nested deeper than " + std::to_string(deepest_nesting) + " levels",
                "write the formula with fewer parentheses");
    }
    ~Nesting() { --parser_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    Parser& parser_;
  };

  Expression product() {
    const SourcePlace start = place();
    std::vector<Expression> factors;
    factors.push_back(signed_power());
    while (next() == '*' || next() == '/') {
      const bool divides = next() == '/';
      const SourcePlace at = place();
      advance();
      Expression factor = signed_power();
      if (!divides) {
        factors.push_back(std::move(factor));
        continue;
      }
      Expression numerator = collapse(std::move(factors), start);
      factors.clear();
      factors.push_back(Expression{Expression::Kind::quotient, at, "/", {std::move(numerator), std::move(factor)}});
      if (++quotients_ > deepest_nesting)
        fail_at(source_, at, "more than " + std::to_string(deepest_nesting) + " divisions in one formula",
                "collect them into one denominator");
    }
    return collapse(std::move(factors), start);
  }

  static Expression collapse(std::vector<Expression> factors, SourcePlace start) {
    if (factors.size() == 1) return std::move(factors.front());
    return Expression{Expression::Kind::product, start, "*", std::move(factors)};
  }

  Expression signed_power() {
    const Nesting guard(*this);
    const SourcePlace at = place();
    if (take('-')) return Expression{Expression::Kind::negation, at, "-", {signed_power()}};
    if (take('+')) return signed_power();
    Expression base = primary();
    const SourcePlace power_at = place();
    if (!take('^')) return base;
    return Expression{Expression::Kind::power, power_at, "^", {std::move(base), signed_power()}};
  }

  Expression primary() {
    expect_more("a number, a symbol or '(' was expected");
    const SourcePlace at = place();
    if (take('(')) {
      Expression inside = sum();
      if (!take(')')) fail_at(source_, at, "'(' is never closed", "add the missing ')'");
      return inside;
    }
    if (is_digit(next()) || next() == '.') return Expression{Expression::Kind::number, at, number_text(), {}};
    if (starts_identifier(next())) {
      std::string name = identifier_text();
      const FormulaFunction* function = find_function(name);
      if (next() != '(') {
        if (function)
          fail_at(source_, at, "function " + name + " without argument",
                  "write " + name + "(...); a symbol cannot have the name of a function");
        return Expression{Expression::Kind::symbol, at, std::move(name), {}};
      }
      advance();
      if (!function) refuse_function(name, at);
      std::vector<Expression> arguments;
      arguments.push_back(sum());
      while (take(',')) arguments.push_back(sum());
      if (!take(')'))
        fail_at(source_, place(), "the argument of " + name + " is not closed", "')' was expected here");
      if (arguments.size() != function->arguments)
        fail_at(source_, at, name + " with " + std::to_string(arguments.size()) + " arguments",
                name + " takes " + std::to_string(function->arguments));
      return Expression{Expression::Kind::call, at, std::move(name), std::move(arguments)};
    }
    fail_at(source_, at, "unexpected " + shown(), "a number, a symbol, a function or '(' was expected");
  }

  const FormulaFunction* find_function(const std::string& name) const {
    const auto found = std::find_if(functions_.begin(), functions_.end(),
                                    [&](const FormulaFunction& function) { return function.name == name; });
    return found == functions_.end() ? nullptr : &*found;
  }

  std::string function_list() const {
    std::string list;
    for (const FormulaFunction& function : functions_)
      list += (list.empty() ? "" : ", ") + std::string(function.name);
    return list;
  }

  std::string number_text() {
    const SourcePlace at = place();
    const std::size_t begin = position_;
    const auto digits = [&] {
      while (is_digit(raw())) ++position_;
    };
    digits();
    if (raw() == '.') {
      ++position_;
      digits();
    }
    if (position_ - begin == 1 && source_.text[begin] == '.')
      fail_at(source_, at, "'.' is not a number", "write digits, for example 0.25");
    if (raw() == 'e' || raw() == 'E') {
      std::size_t probe = position_ + 1;
      if (probe < source_.text.size() && (source_.text[probe] == '+' || source_.text[probe] == '-')) ++probe;
      if (probe >= source_.text.size() || !is_digit(source_.text[probe]))
        fail_at(source_, at, "a number with an empty exponent", "write for example 1.5e-3");
      position_ = probe;
      digits();
    }
    std::string text = source_.text.substr(begin, position_ - begin);
    if (text.size() > 400) fail_at(source_, at, "a number of more than 400 characters", "shorten it");
    if (starts_identifier(raw()))
      fail_at(source_, place(), "a symbol directly after the number " + text, "write '*' between them");
    skip_blanks();
    return text;
  }

  // Behind the parenthesis of a function that is none.
  [[noreturn]] void refuse_function(const std::string& name, SourcePlace at) {
    static const std::map<std::string, std::string> others = {{"ln", "log(...), the natural one"},
                                                              {"arctan", "atan(...)"},
                                                              {"sign", "sgn(...)"},
                                                              {"signum", "sgn(...)"},
                                                              {"fabs", "abs(...)"},
                                                              {"pow", "a power with ^, as x^3"}};
    if (const auto other = others.find(name); other != others.end())
      fail_at(source_, at, "unknown function " + name, "write " + other->second);
    if (starts_identifier(next()) && identifier_text() == "t")
      fail_at(source_, at, "unknown function " + name + " of the time",
              "coordinates are written alone, as they are now; a short delay of one is its series, " + name +
                  " - tau*D(" + name + ")");
    fail_at(source_, at, "unknown function " + name, "known are " + function_list());
  }

  std::string identifier_text() {
    const SourcePlace at = place();
    const std::size_t begin = position_;
    while (starts_identifier(raw()) || is_digit(raw())) ++position_;
    std::string text = source_.text.substr(begin, position_ - begin);
    if (text.size() > 64) fail_at(source_, at, "a symbol of more than 64 characters", "choose a shorter name");
    skip_blanks();
    return text;
  }

  char raw() const { return position_ < source_.text.size() ? source_.text[position_] : '\0'; }
  char next() const { return raw(); }
  void advance() {
    ++position_;
    skip_blanks();
  }
  void skip_blanks() {
    for (; position_ < source_.text.size(); ++position_) {
      const char c = source_.text[position_];
      if (c == '\n') {
        ++line_;
        line_begin_ = position_ + 1;
      } else if (c != ' ' && c != '\t' && c != '\r') {
        break;
      }
    }
  }
  SourcePlace place() const { return {line_, static_cast<std::uint32_t>(position_ - line_begin_ + 1)}; }
  std::string shown() const {
    const auto c = static_cast<unsigned char>(raw());
    if (position_ >= source_.text.size()) return "end of the formula";
    if (c < 0x20 || c >= 0x7f) return "character with code " + std::to_string(static_cast<int>(c));
    return "'" + std::string(1, static_cast<char>(c)) + "'";
  }

  const FormulaSource& source_;
  std::span<const FormulaFunction> functions_;
  std::size_t position_ = 0;
  std::size_t line_begin_ = 0;
  std::uint32_t line_ = 1;
  int depth_ = 0;
  int quotients_ = 0;
};

void collect_identifiers(const Expression& expression, std::vector<std::string>& names) {
  if (expression.kind == Expression::Kind::symbol &&
      std::find(names.begin(), names.end(), expression.text) == names.end())
    names.push_back(expression.text);
  for (const Expression& operand : expression.operands) collect_identifiers(operand, names);
}

}  // namespace

std::span<const FormulaFunction> equation_functions() {
  return functions_of_equations;
}

Expression parse_expression(const FormulaSource& source, std::span<const FormulaFunction> functions) {
  Parser parser(source, functions);
  Expression expression = parser.sum();
  parser.expect_end();
  refuse_out_of_proportion(expression, source);
  return expression;
}

Equation parse_equation(const FormulaSource& source) {
  Parser parser(source, equation_functions());
  Equation equation{parser.sum(), {}};
  if (!parser.take('=')) {
    parser.expect_end();
    fail_at(source, {source.first_line, 1}, "is not an equation", "write left = right");
  }
  equation.right.push_back(parser.sum());
  parser.expect_end();
  refuse_out_of_proportion(equation.left, source);
  refuse_out_of_proportion(equation.right.front(), source);
  return equation;
}

std::vector<std::string> identifiers(const Expression& expression) {
  std::vector<std::string> names;
  collect_identifiers(expression, names);
  return names;
}

}  // namespace secular
