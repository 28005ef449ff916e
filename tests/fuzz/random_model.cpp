#include "tests/fuzz/random_model.hpp"

namespace secular::fuzz {
namespace {

std::string coordinate(std::size_t mode) {
  return mode == 0 ? "v" : "u";
}

std::string frequency(std::size_t index, std::size_t modes) {
  return index == modes ? "Omega" : "w" + std::to_string(index + 1);
}

RandomTerm random_term(Choices& choices, std::size_t modes, int expand_to, const std::string& coefficient) {
  RandomTerm term;
  term.coefficient = coefficient;
  term.number = choices.below(2) == 0 ? -1 : choices.below(3) + 1;
  term.denominator = choices.below(4) + 1;
  term.powers.resize(modes);
  term.order = choices.below(expand_to) + 1;
  if (choices.below(3) == 1) {
    term.multiple = choices.below(3) + 1;
    term.sine = choices.below(2) == 1;
  }
  const int degree = choices.below(4) + (term.multiple == 0 ? 1 : 0);
  for (int factor = 0; factor < degree; ++factor) {
    const auto mode = static_cast<std::size_t>(choices.below(static_cast<int>(modes)));
    ++term.powers[mode][static_cast<std::size_t>(choices.below(3))];
  }
  return term;
}

std::string text_of(const RandomTerm& term) {
  std::string text = term.number < 0 ? " - " : " + ";
  text += std::to_string(term.number < 0 ? -term.number : term.number);
  if (term.denominator > 1) text += "/" + std::to_string(term.denominator);
  text += "*" + term.coefficient;
  const char* const begins[] = {"", "D(", "D2("};
  for (std::size_t mode = 0; mode < term.powers.size(); ++mode)
    for (std::size_t derivative = 0; derivative < 3; ++derivative)
      if (const int power = term.powers[mode][derivative]; power > 0)
        text += std::string("*") + begins[derivative] + coordinate(mode) + (derivative > 0 ? ")" : "") +
                (power > 1 ? "^" + std::to_string(power) : "");
  if (term.multiple > 0) {
    text += term.is_forced() ? "*F*cos(" : term.sine ? "*sin(" : "*cos(";
    text += (term.multiple > 1 ? std::to_string(term.multiple) + "*" : "") + "Omega*t)";
  }
  return text;
}

RandomRelation relation(std::vector<int> multiples, int order, std::size_t modes) {
  RandomRelation r;
  r.multiples = std::move(multiples);
  r.order = order;
  r.detuning = "sigma" + std::to_string(r.multiples[modes] != 0 ? 1 : 2);
  // The last frequency with a multiple is on the left, all others on the right.
  std::size_t left = modes;
  while (r.multiples[left] == 0) --left;
  r.text = std::to_string(r.multiples[left]) + "*" + frequency(left, modes) + " = ";
  for (std::size_t j = 0; j < left; ++j)
    if (r.multiples[j] != 0) r.text += std::to_string(-r.multiples[j]) + "*" + frequency(j, modes) + " + ";
  r.text += "eps" + (order > 1 ? "^" + std::to_string(order) : "") + "*" + r.detuning;
  return r;
}

void choose_relations(Choices& choices, RandomModel& model) {
  const std::size_t modes = model.modes;
  const auto order = [&] { return choices.below(model.expand_to) + 1; };
  bool excited = false;
  for (const auto& equation : model.equations)
    for (const RandomTerm& term : equation) excited = excited || term.multiple > 0;
  if (excited) {
    std::vector<int> multiples(modes + 1, 0);
    multiples[modes] = choices.below(2) == 0 ? 1 : choices.below(3) + 1;
    switch (choices.below(4)) {
      case 0:
        break;
      case 1:
        multiples[0] = -(choices.below(3) + 1);
        break;
      case 2:
        multiples[modes - 1] = -(choices.below(3) + 1);
        break;
      default:
        for (std::size_t k = 0; k < modes; ++k) multiples[k] = -1;
    }
    // Without common divisors, as a relation is written.
    if (multiples[0] % 2 == 0 && multiples[modes - 1] % 2 == 0 && multiples[modes] % 2 == 0)
      for (int& m : multiples) m /= 2;
    if (multiples[0] % 3 == 0 && multiples[modes - 1] % 3 == 0 && multiples[modes] % 3 == 0)
      for (int& m : multiples) m /= 3;
    if (multiples[0] != 0 || multiples[modes - 1] != 0)
      model.relations.push_back(relation(multiples, order(), modes));
  }
  if (modes == 2 && choices.below(2) == 1)
    model.relations.push_back(relation({-(choices.below(3) + 1), 1, 0}, order(), modes));
}

}  // namespace

RandomModel random_model(Choices choices) {
  RandomModel model;
  model.modes = static_cast<std::size_t>(choices.below(2)) + 1;
  model.expand_to = choices.below(3) + 1;
  model.equations.resize(model.modes);
  int coefficients = 0;
  for (auto& equation : model.equations)
    for (int term = choices.below(3) + 1; term > 0; --term)
      equation.push_back(random_term(choices, model.modes, model.expand_to, "c" + std::to_string(++coefficients)));
  choose_relations(choices, model);
  return model;
}

std::string RandomModel::text() const {
  std::string text = "schema = 1\nname = \"random\"\n", order;
  for (std::size_t k = 0; k < modes; ++k) {
    const std::string v = coordinate(k), w = frequency(k, modes);
    text += "[[mode]]\ncoordinate = \"" + v + "\"\nfrequency = \"" + w + "\"\nequation = \"D2(" + v + ") + " + w +
            "^2*" + v + " = ";
    for (const RandomTerm& term : equations[k]) {
      text += text_of(term);
      order += (order.empty() ? "" : ", ") + term.coefficient + " = " + std::to_string(term.order);
    }
    text += "\"\n";
  }
  text += "[[case]]\nname = \"c\"\nrelations = [";
  for (std::size_t r = 0; r < relations.size(); ++r) text += (r > 0 ? ", \"" : "\"") + relations[r].text + "\"";
  return text + "]\norder = { " + order + " }\nexpand_to = " + std::to_string(expand_to) + "\n";
}

}  // namespace secular::fuzz
