#include "codegen/document/symbol_name.hpp"

#include <array>

namespace secular {
namespace {

constexpr std::array greek_letters = std::to_array<GreekLetter>({
    {"alpha", "alpha", "\u03B1"},     {"beta", "beta", "\u03B2"},       {"gamma", "gamma", "\u03B3"},
    {"delta", "delta", "\u03B4"},     {"eps", "varepsilon", "\u03B5"},  {"epsilon", "varepsilon", "\u03B5"},
    {"zeta", "zeta", "\u03B6"},       {"eta", "eta", "\u03B7"},         {"theta", "theta", "\u03B8"},
    {"iota", "iota", "\u03B9"},       {"kappa", "kappa", "\u03BA"},     {"lambda", "lambda", "\u03BB"},
    {"mu", "mu", "\u03BC"},           {"nu", "nu", "\u03BD"},           {"xi", "xi", "\u03BE"},
    {"pi", "pi", "\u03C0"},           {"rho", "rho", "\u03C1"},         {"sigma", "sigma", "\u03C3"},
    {"tau", "tau", "\u03C4"},         {"upsilon", "upsilon", "\u03C5"}, {"phi", "varphi", "\u03C6"},
    {"chi", "chi", "\u03C7"},         {"psi", "psi", "\u03C8"},         {"omega", "omega", "\u03C9"},
    {"Gamma", "Gamma", "\u0393"},     {"Delta", "Delta", "\u0394"},     {"Theta", "Theta", "\u0398"},
    {"Lambda", "Lambda", "\u039B"},   {"Xi", "Xi", "\u039E"},           {"Pi", "Pi", "\u03A0"},
    {"Sigma", "Sigma", "\u03A3"},     {"Phi", "Phi", "\u03A6"},         {"Psi", "Psi", "\u03A8"},
    {"Upsilon", "Upsilon", "\u03A5"}, {"Omega", "Omega", "\u03A9"},
});

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

NamePart part(std::string_view text) {
  if (is_digit(text.front())) return {NamePart::Kind::number, std::string(text)};
  if (greek_letter(text) != nullptr) return {NamePart::Kind::greek, std::string(text)};
  return {text.size() == 1 ? NamePart::Kind::letter : NamePart::Kind::word, std::string(text)};
}

// "mu12" -> mu with subscript 12; "5" -> 5.
SymbolName without_underscores(std::string_view text) {
  std::size_t letters = 0;
  while (letters < text.size() && !is_digit(text[letters])) ++letters;
  if (letters == 0 || letters == text.size()) return {part(text), {}};
  return {part(text.substr(0, letters)), {{part(text.substr(letters)), {}}}};
}

}  // namespace

const GreekLetter* greek_letter(std::string_view word) {
  for (const GreekLetter& letter : greek_letters)
    if (letter.word == word) return &letter;
  return nullptr;
}

SymbolName verbatim_name(std::string_view identifier) {
  return {{NamePart::Kind::verbatim, std::string(identifier)}, {}};
}

SymbolName symbol_name(std::string_view identifier) {
  SymbolName name;
  bool first = true;
  while (!identifier.empty()) {
    const std::size_t end = identifier.find('_');
    const std::string_view piece = identifier.substr(0, end);
    identifier = end == std::string_view::npos ? std::string_view() : identifier.substr(end + 1);
    if (piece.empty()) continue;
    if (first)
      name = without_underscores(piece);
    else
      name.subscripts.push_back(without_underscores(piece));
    first = false;
  }
  return name;
}

}  // namespace secular
