#include "perturb/model.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "input/input_error.hpp"
#include "input/nearest_word.hpp"
#include "input/toml_table.hpp"
#include "perturb/automatic_order.hpp"
#include "perturb/formula_value.hpp"
#include "perturb/rest_position.hpp"

namespace secular {
namespace {

constexpr int highest_order = 6;

bool is_identifier(const std::string& name) {
  if (name.empty() || name.size() > 64 || std::isdigit(static_cast<unsigned char>(name.front()))) return false;
  return std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

bool is_reserved(const std::string& name) {
  static const std::set<std::string> reserved = {"t", "eps", "Pi", "I"};
  const auto functions = equation_functions();
  return reserved.count(name) != 0 ||
         std::any_of(functions.begin(), functions.end(), [&](const FormulaFunction& f) { return f.name == name; });
}

// "F" pairs with "Omega", "F2" with "Omega2": the number behind the letter, or nothing for other names.
std::optional<std::string> excitation_suffix(const std::string& name, const std::string& stem) {
  if (name.rfind(stem, 0) != 0) return std::nullopt;
  const std::string suffix = name.substr(stem.size());
  if (!std::all_of(suffix.begin(), suffix.end(), [](unsigned char c) { return std::isdigit(c); }))
    return std::nullopt;
  return suffix;
}

FormulaSource formula(const TomlTable& table, const std::string& key) {
  return {table.string(key), table.file(), table.first_text_line_of(key)};
}

std::string identifier(const TomlTable& table, const std::string& key) {
  std::string name = table.string(key);
  if (!is_identifier(name))
    table.fail(key, "'" + name + "' is not a symbol",
               "letters, digits and '_' were expected, not starting with a digit");
  if (is_reserved(name)) table.fail(key, "'" + name + "' is reserved", "choose another name");
  return name;
}

void read_modes(const TomlTable& root, Model& model) {
  const bool lagrangian = root.has("lagrangian");
  for (const TomlTable& table : root.tables("mode")) {
    table.refuse_unknown_keys({"coordinate", "frequency", "equation", "force", "rest"});
    Mode mode;
    mode.coordinate = identifier(table, "coordinate");
    mode.frequency = identifier(table, "frequency");
    for (const Mode& other : model.modes)
      if (other.coordinate == mode.coordinate || other.frequency == mode.frequency)
        table.fail("coordinate", "coordinate or frequency is used by another mode",
                   "every mode has its own symbols");
    if (mode.coordinate == mode.frequency)
      table.fail("frequency", "is the coordinate's symbol", "choose another name");
    if (!lagrangian) {
      mode.source = formula(table, "equation");
      mode.equation = parse_equation(mode.source);
    } else {
      if (table.has("equation"))
        table.fail("equation", "stands beside [lagrangian]", "give `force` instead: the equation is derived");
      mode.source = table.has("force") ? formula(table, "force") : FormulaSource{"0", table.file(), table.line()};
      mode.force = parse_expression(mode.source);
    }
    model.modes.push_back(std::move(mode));
  }
  if (model.modes.empty())
    throw InputError(root.file(), "", "has no [[mode]]", "a model needs at least one mode with its equation");
  if (!lagrangian) return;
  const TomlTable table = root.table("lagrangian");
  table.refuse_unknown_keys({"kinetic", "potential"});
  FormulaSource kinetic = formula(table, "kinetic"), potential = formula(table, "potential");
  Expression t = parse_expression(kinetic), v = parse_expression(potential);
  model.lagrangian = Lagrangian{std::move(kinetic), std::move(potential), std::move(t), std::move(v)};
}

// All identifiers of the equations in reading order.
std::vector<std::string> equation_identifiers(const Model& model) {
  std::vector<std::string> names;
  const auto add = [&](const Expression& expression) {
    for (const std::string& name : identifiers(expression))
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  if (model.lagrangian) {
    add(model.lagrangian->kinetic);
    add(model.lagrangian->potential);
  }
  for (const Mode& mode : model.modes) {
    if (mode.equation) {
      add(mode.equation->left);
      add(mode.equation->right.front());
    }
    if (mode.force) add(*mode.force);
  }
  return names;
}

void declare_symbols(Model& model) {
  std::set<std::string> coordinates;
  for (const Mode& mode : model.modes) coordinates.insert(mode.coordinate);
  for (const Mode& mode : model.modes) model.symbols.add_positive(mode.frequency);
  const std::vector<std::string> names = equation_identifiers(model);
  std::set<std::string> suffixes;
  for (const std::string& name : names)
    for (const char* stem : {"F", "Omega"})
      if (const auto suffix = excitation_suffix(name, stem)) suffixes.insert(*suffix);
  for (const std::string& suffix : suffixes) {
    model.excitations.push_back({"F" + suffix, "Omega" + suffix});
    model.symbols.add_positive("Omega" + suffix);
  }
  for (const Excitation& excitation : model.excitations) model.symbols.add_positive(excitation.amplitude);
  for (const std::string& name : names) {
    if (name == "eps" || name == "I")
      throw InputError(model.file, "", "symbol " + name + " in an equation",
                       name == "eps" ? "powers of eps come from the case's `order` table" : "equations are real");
    if (name == "pi") throw InputError(model.file, "", "symbol pi in an equation", "the number is written Pi");
    if (coordinates.count(name) || is_reserved(name) || model.symbols.contains(name)) continue;
    model.symbols.add_real(name);
    if (!model.rest || !model.rest->is_value(name)) model.parameters.push_back(name);
  }
}

// By mode: the name that the file gives to the rest position.
std::vector<std::string> rest_names(const TomlTable& root) {
  std::vector<std::string> names;
  for (const TomlTable& table : root.tables("mode")) {
    if (table.has("rest") && !root.has("reference"))
      table.fail("rest", "names a rest position of a model whose coordinates count from zero",
                 "write reference = \"rest\" at the head of the file");
    names.push_back(table.has("rest") ? identifier(table, "rest") : "");
  }
  return names;
}

void take_reference(const TomlTable& root, Model& model) {
  const std::vector<std::string> names = rest_names(root);
  if (!root.has("reference")) return;
  if (root.string("reference") != "rest")
    root.fail("reference", "is '" + root.string("reference") + "'", "'rest' was expected, or no such key");
  model = about_rest(std::move(model), names);
  model.symbols = {};
  model.parameters.clear();
  model.excitations.clear();
  declare_symbols(model);
  // What stands in values of functions alone.
  const auto need = [&](const std::string& name) {
    if (name.empty() || model.symbols.contains(name)) return;
    model.symbols.add_real(name);
    if (!model.rest->is_value(name)) model.parameters.push_back(name);
  };
  for (const RestValue& value : model.rest->values) {
    need(value.name);
    for (const std::string& name : identifiers(value.argument)) need(name);
  }
  for (const std::string& name : model.rest->symbols) need(name);
}

// Of the factors of frequencies that are rational numbers.
GiNaC::numeric common_denominator(const GiNaC::ex& difference, const Model& model) {
  GiNaC::numeric common = 1;
  for (std::size_t i = 0; i < model.frequency_count(); ++i) {
    const GiNaC::ex multiple = difference.coeff(model.frequency(i), 1);
    if (GiNaC::is_a<GiNaC::numeric>(multiple) && GiNaC::ex_to<GiNaC::numeric>(multiple).is_rational())
      common = GiNaC::lcm(common, GiNaC::ex_to<GiNaC::numeric>(multiple).denom());
  }
  return common;
}

ResonanceRelation read_relation(const TomlTable& table, const std::string& text, Model& model) {
  const FormulaSource source{text, table.file(), table.line_of("relations")};
  const Equation equation = parse_equation(source);
  ResonanceRelation relation;
  relation.text = text;
  relation.line = source.first_line;
  const GiNaC::symbol eps("eps");
  std::string detuning;
  const auto value_of = [&](const Expression& symbol) -> GiNaC::ex {
    if (symbol.text == "eps") return eps;
    for (std::size_t i = 0; i < model.frequency_count(); ++i)
      if (model.frequency_name(i) == symbol.text) return model.frequency(i);
    if (is_reserved(symbol.text) || model.symbols.contains(symbol.text)) {
      const bool parameter =
          std::find(model.parameters.begin(), model.parameters.end(), symbol.text) != model.parameters.end();
      if (parameter || is_reserved(symbol.text))
        fail_at(source, symbol.place, "'" + symbol.text + "' cannot stand in a resonance relation",
                "a relation joins frequencies and one detuning, as in Omega = 2*omega0 + eps^2*sigma");
    }
    if (excitation_suffix(symbol.text, "Omega"))
      fail_at(source, symbol.place, "unknown frequency '" + symbol.text + "'",
              "no equation of this model is excited at it");
    for (const Mode& mode : model.modes)
      if (mode.coordinate == symbol.text)
        fail_at(source, symbol.place, "'" + symbol.text + "' is a coordinate", "a frequency was expected");
    if (!detuning.empty() && detuning != symbol.text)
      fail_at(source, symbol.place, "'" + symbol.text + "' is a second detuning or an unknown frequency",
              "every relation has one detuning of its own");
    detuning = symbol.text;
    return model.symbols.add_real(symbol.text);
  };
  GiNaC::ex difference =
      (formula_value(equation.left, source, value_of) - formula_value(equation.right.front(), source, value_of))
          .expand();
  difference *= common_denominator(difference, model);
  difference = difference.expand();
  GiNaC::ex rest = difference;
  const std::string expected =
      "multiples and integer fractions were expected, as in Omega = 2*omega0 + eps^2*sigma or Omega = omega0/3 + "
      "eps^2*sigma";
  for (std::size_t i = 0; i < model.frequency_count(); ++i) {
    const GiNaC::ex multiple = difference.coeff(model.frequency(i), 1);
    if (!GiNaC::is_a<GiNaC::numeric>(multiple) || !GiNaC::ex_to<GiNaC::numeric>(multiple).is_integer() ||
        GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(multiple)) > largest_multiple)
      fail_at(source, {source.first_line, 1},
              "the factor of " + model.frequency_name(i) + " is no ratio of integers up to " +
                  std::to_string(largest_multiple),
              expected);
    relation.multiples.push_back(GiNaC::ex_to<GiNaC::numeric>(multiple).to_int());
    rest -= multiple * model.frequency(i);
  }
  rest = rest.expand();
  if (std::all_of(relation.multiples.begin(), relation.multiples.end(), [](int m) { return m == 0; }))
    fail_at(source, {source.first_line, 1}, "relates no frequency", expected);
  if (!rest.is_zero()) {
    if (detuning.empty())
      fail_at(source, {source.first_line, 1}, "is not homogeneous in the frequencies", expected);
    const GiNaC::ex& sigma = model.symbols.at(detuning);
    const int order = rest.degree(eps);
    const GiNaC::ex coefficient = -rest.coeff(sigma, 1).coeff(eps, order);
    if (order < 1 || order > highest_order || !GiNaC::is_a<GiNaC::numeric>(coefficient) ||
        !(rest + coefficient * GiNaC::pow(eps, order) * sigma).expand().is_zero())
      fail_at(source, {source.first_line, 1},
              "the detuning does not enter as eps^n*" + detuning + " with n = 1, 2, ...", expected);
    relation.detuning = detuning;
    relation.order = order;
    relation.coefficient = GiNaC::ex_to<GiNaC::numeric>(coefficient);
  }
  return relation;
}

void read_order(const TomlTable& table, const Model& model, ResonanceCase& resonance) {
  if (table.has("ordering")) {
    if (table.string("ordering") != "degree")
      table.fail("ordering", "is '" + table.string("ordering") + "'", "'degree' was expected, or no such key");
    resonance.degree_ordering = true;
  }
  // Coefficients about rest are composite.
  if (model.rest) resonance.degree_ordering = true;
  if (!table.has("order")) return;
  if (table.is_string("order")) {
    if (table.string("order") != "auto")
      table.fail("order", "is '" + table.string("order") + "'", "\"auto\" or a table was expected, as { mu = 2 }");
    resonance.automatic_order = true;
    return;
  }
  const TomlTable order = table.table("order");
  for (const std::string& symbol : order.keys()) {
    const std::int64_t power = order.integer(symbol);
    if (power < 0 || power > highest_order)
      order.fail(symbol, "is " + std::to_string(power),
                 "a power of eps from 0 to " + std::to_string(highest_order));
    if (model.rest && model.rest->holds(symbol))
      order.fail(symbol, "follows from the rest position and the natural frequencies", "remove the entry");
    if (std::find(model.parameters.begin(), model.parameters.end(), symbol) == model.parameters.end())
      order.fail(symbol, "is no coefficient symbol of this model's equations",
                 "remove the entry or correct the symbol");
    resonance.order[symbol] = static_cast<int>(power);
  }
}

void read_cases(const TomlTable& root, Model& model) {
  for (const TomlTable& table : root.tables("case")) {
    table.refuse_unknown_keys(
        {"name", "relations", "order", "ordering", "expand_to", "modes_at_rest", "excitation"});
    ResonanceCase resonance;
    resonance.name = identifier(table, "name");
    resonance.line = table.line();
    for (const ResonanceCase& other : model.cases)
      if (other.name == resonance.name)
        table.fail("name", "'" + resonance.name + "' is used twice", "case names differ");
    if (table.has("expand_to")) {
      const std::int64_t order = table.integer("expand_to");
      if (order < 1 || order > highest_order)
        table.fail("expand_to", "is " + std::to_string(order),
                   "an order of expansion from 1 to " + std::to_string(highest_order));
      resonance.expand_to = static_cast<int>(order);
    }
    resonance.excited = table.boolean_or("excitation", true);
    resonance.mode_at_rest.assign(model.modes.size(), false);
    if (table.has("modes_at_rest"))
      for (const std::string& coordinate : table.strings("modes_at_rest")) {
        const auto mode = std::find_if(model.modes.begin(), model.modes.end(),
                                       [&](const Mode& m) { return m.coordinate == coordinate; });
        if (mode == model.modes.end())
          table.fail("modes_at_rest", "'" + coordinate + "' is no coordinate of this model",
                     "name a mode's coordinate");
        resonance.mode_at_rest[static_cast<std::size_t>(mode - model.modes.begin())] = true;
      }
    if (table.has("relations"))
      for (const std::string& text : table.strings("relations"))
        resonance.relations.push_back(read_relation(table, text, model));
    read_order(table, model, resonance);
    model.cases.push_back(std::move(resonance));
  }
  if (model.cases.empty())
    throw InputError(root.file(), "", "has no [[case]]",
                     "a model needs at least one resonance case (free vibration: no relations)");
}

void read_shorthands(const TomlTable& root, Model& model) {
  if (!root.has("shorthand")) return;
  const TomlTable table = root.table("shorthand");
  for (const std::string& name : table.keys()) {
    if (!is_identifier(name) || is_reserved(name) || model.symbols.contains(name))
      table.fail(name, "is not a free name", "a shorthand is a new symbol: letters, digits and '_'");
    FormulaSource source = formula(table, name);
    Expression expression = parse_expression(source);
    for (const std::string& symbol : identifiers(expression))
      if (symbol != "Pi" && !model.symbols.contains(symbol))
        table.fail(name, "unknown symbol '" + symbol + "'", "a shorthand combines symbols of the equations");
    model.shorthands.push_back({name, std::move(source), std::move(expression)});
  }
}

void read_nominal(const TomlTable& root, Model& model) {
  if (!root.has("nominal")) return;
  const TomlTable table = root.table("nominal");
  for (const std::string& name : table.keys()) {
    if (!model.symbols.contains(name) && !(model.rest && model.rest->holds(name)))
      table.fail(name, "is no symbol of this model", "remove the entry or correct the symbol");
    model.nominal[name] = table.number(name);
  }
  if (model.rest) take_rest_position(model, model.nominal, table.file() + ", [nominal]");
  for (std::size_t i = 0; i < model.frequency_count(); ++i) {
    const auto entry = model.nominal.find(model.frequency_name(i));
    if (entry != model.nominal.end() && entry->second <= 0)
      table.fail(entry->first, "is not positive", "a frequency in rad/s");
  }
}

Model read(const TomlTable& root) {
  root.refuse_unknown_keys(
      {"schema", "name", "source", "mode", "case", "nominal", "lagrangian", "shorthand", "reference"});
  if (root.integer("schema") != 1)
    root.fail("schema", "is " + std::to_string(root.integer("schema")), "this program reads schema 1");
  Model model;
  model.file = root.file();
  model.name = identifier(root, "name");
  model.source = root.string_or("source", "");
  read_modes(root, model);
  declare_symbols(model);
  take_reference(root, model);
  read_cases(root, model);
  read_shorthands(root, model);
  read_nominal(root, model);
  for (ResonanceCase& resonance : model.cases)
    if (resonance.automatic_order) choose_orders(model, resonance);
  return model;
}

}  // namespace

std::string ResonanceCase::place() const {
  return "line " + std::to_string(line) + ", case " + name;
}

const ResonanceCase& Model::find_case(const std::string& wanted) const {
  std::vector<std::string> names;
  std::string listed;
  for (const ResonanceCase& resonance : cases) {
    if (resonance.name == wanted) return resonance;
    names.push_back(resonance.name);
    listed += (listed.empty() ? "" : ", ") + resonance.name;
  }
  throw InputError(file, "", "has no case '" + wanted + "'",
                   remedy_for_word("its cases are " + listed, wanted, names));
}

const std::string& Model::frequency_name(std::size_t index) const {
  return index < modes.size() ? modes[index].frequency : excitations[index - modes.size()].frequency;
}

GiNaC::ex Model::frequency(std::size_t index) const {
  return symbols.at(frequency_name(index));
}

Model read_model(const std::filesystem::path& path) {
  return read(TomlTable::from_file(path));
}

Model read_model_text(const std::string& text, const std::string& name) {
  return read(TomlTable::from_text(text, name));
}

}  // namespace secular
