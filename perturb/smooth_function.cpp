#include "perturb/smooth_function.hpp"

#include <algorithm>
#include <array>

#include "perturb/term_sum.hpp"

namespace secular {
namespace {

constexpr std::array<std::pair<std::string_view, SmoothKind>, 9> smooth_names = {
    {{"sin", SmoothKind::sine},
     {"cos", SmoothKind::cosine},
     {"tan", SmoothKind::tangent},
     {"exp", SmoothKind::exponential},
     {"sinh", SmoothKind::hyperbolic_sine},
     {"cosh", SmoothKind::hyperbolic_cosine},
     {"tanh", SmoothKind::hyperbolic_tangent},
     {"log", SmoothKind::logarithm},
     {"atan", SmoothKind::arc_tangent}}};

TermSum single(const SmoothFunction& function) {
  Factor factor{Factor::Kind::smooth, 0, 0, 1};
  factor.function = function;
  return TermSum::factor(factor);
}

}  // namespace

struct SmoothFunction::Argument {
  TermSum terms;
  std::string text;
};

std::string_view name_of(SmoothKind kind) {
  for (const auto& [name, named] : smooth_names)
    if (named == kind) return name;
  return "";
}

std::optional<SmoothKind> smooth_kind(std::string_view name) {
  for (const auto& [known, kind] : smooth_names)
    if (known == name) return kind;
  return std::nullopt;
}

SmoothFunction::SmoothFunction(SmoothKind kind, std::pair<long, long> exponent, TermSum argument, std::string text)
    : kind_(kind),
      exponent_(exponent),
      argument_(std::make_shared<const Argument>(Argument{std::move(argument), std::move(text)})) {}

const TermSum& SmoothFunction::argument() const {
  return argument_->terms;
}

std::string SmoothFunction::text() const {
  const auto [numerator, denominator] = exponent_;
  if (kind_ != SmoothKind::power) return std::string(name_of(kind_)) + "(" + argument_->text + ")";
  if (numerator == 1 && denominator == 2) return "sqrt(" + argument_->text + ")";
  return "(" + argument_->text + ")^(" + std::to_string(numerator) +
         (denominator == 1 ? "" : "/" + std::to_string(denominator)) + ")";
}

SmoothFunction SmoothFunction::with(SmoothKind kind, std::pair<long, long> exponent) const {
  SmoothFunction other = *this;
  other.kind_ = kind;
  other.exponent_ = exponent;
  return other;
}

TermSum SmoothFunction::slope() const {
  const auto inverse_square = [&](SmoothKind of) {
    const SmoothFunction inner = with(of, {1, 1});
    return single(SmoothFunction(SmoothKind::power, {-2, 1}, single(inner), inner.text()));
  };
  switch (kind_) {
    case SmoothKind::sine:
      return single(with(SmoothKind::cosine, exponent_));
    case SmoothKind::cosine:
      return single(with(SmoothKind::sine, exponent_)).scaled(-1);
    case SmoothKind::tangent:
      return inverse_square(SmoothKind::cosine);
    case SmoothKind::exponential:
      return single(*this);
    case SmoothKind::hyperbolic_sine:
      return single(with(SmoothKind::hyperbolic_cosine, exponent_));
    case SmoothKind::hyperbolic_cosine:
      return single(with(SmoothKind::hyperbolic_sine, exponent_));
    case SmoothKind::hyperbolic_tangent:
      return inverse_square(SmoothKind::hyperbolic_cosine);
    case SmoothKind::logarithm:
      return single(with(SmoothKind::power, {-1, 1}));
    case SmoothKind::arc_tangent: {
      TermSum sum = TermSum::constant(1);
      sum += argument() * argument();
      return single(SmoothFunction(SmoothKind::power, {-1, 1}, std::move(sum), "1 + (" + argument_->text + ")^2"));
    }
    case SmoothKind::power:
      break;
  }
  const auto [numerator, denominator] = exponent_;
  return single(with(SmoothKind::power, {numerator - denominator, denominator}))
      .scaled(GiNaC::numeric(numerator, denominator));
}

std::strong_ordering SmoothFunction::operator<=>(const SmoothFunction& other) const {
  if (exists() != other.exists()) return exists() <=> other.exists();
  if (!exists()) return std::strong_ordering::equal;
  if (const auto order = argument_->text <=> other.argument_->text; order != 0) return order;
  if (const auto order = kind_ <=> other.kind_; order != 0) return order;
  return exponent_ <=> other.exponent_;
}

}  // namespace secular
