#include "codegen/runtime/canonical_json.hpp"

#include <map>
#include <memory>
#include <nlohmann/json.hpp>

namespace secular {
namespace {

using Json = nlohmann::json;

struct Writer {
  // A term is [coefficient, symbol, exponent, symbol, exponent, ...], and at last, where it has divisors,
  // [sum, power, sum, power, ...]: few of many symbols occur in each.
  static Json packed(const std::vector<PolynomialTerm>& terms) {
    Json list = Json::array();
    for (const PolynomialTerm& term : terms) {
      Json item = Json::array({term.coefficient});
      for (std::size_t s = 0; s < term.exponents.size(); ++s)
        if (term.exponents[s] != 0) {
          item.push_back(s);
          item.push_back(term.exponents[s]);
        }
      if (!term.divisors.empty()) {
        Json divisors = Json::array();
        for (const auto& [sum, power] : term.divisors) {
          divisors.push_back(packed(*sum));
          divisors.push_back(power);
        }
        item.push_back(std::move(divisors));
      }
      list.push_back(std::move(item));
    }
    return list;
  }
  static Json packed(const RationalFunction& f) { return {packed(f.numerator), packed(f.denominator)}; }
  static Json packed(const CanonicalRatio& r) { return {r.numerator, r.denominator}; }
  template <class Value>
  static Json packed(const std::vector<Value>& values) {
    Json list = Json::array();
    for (const Value& value : values) list.push_back(packed(value));
    return list;
  }
  static Json packed(const CanonicalDimension& dimension) { return dimension ? packed(*dimension) : Json(); }
  static Json packed(const CanonicalFactor& f) {
    Json argument = Json::array();
    for (const auto& [name, ratio] : f.argument) argument.push_back({name, packed(ratio)});
    return {static_cast<int>(f.kind),
            f.index,
            f.derivative,
            f.multiple,
            f.power,
            argument,
            static_cast<int>(f.function),
            packed(f.exponent),
            packed(f.inner)};
  }
  static Json packed(const CanonicalMotionTerm& term) {
    return {packed(term.coefficient), packed(term.factors),
            term.acceleration_of ? Json(*term.acceleration_of) : Json()};
  }
  static Json packed(const CanonicalRestValue& value) {
    return {value.name, static_cast<int>(value.function), packed(value.exponent), packed(value.argument),
            packed(value.slope)};
  }
  static Json packed(const CanonicalPowers& p) {
    return {p.amplitude, p.conjugate, p.modulus, p.forcing, p.phase, p.slow_phase};
  }
  static Json packed(const CanonicalColumnTerm& term) {
    return {packed(term.factor), term.imaginary, packed(term.powers)};
  }
  static Json packed(const CanonicalBlock::Column& column) { return {column.lump, packed(column.terms)}; }
  static Json packed(const CanonicalBlock& block) {
    return {block.modulation, block.mode, block.order, block.phase, block.name, packed(block.columns)};
  }
  static Json packed(const CanonicalLump& lump) {
    return {lump.name, packed(lump.definition), packed(lump.dimension)};
  }
  static Json packed(const CanonicalRelation& r) {
    return {r.multiples, r.detuning, r.order, packed(r.coefficient), r.text};
  }
  static Json packed(const CanonicalCase& c) {
    return {{"name", c.name},
            {"expand_to", c.expand_to},
            {"excited", c.excited},
            {"mode_at_rest", c.mode_at_rest},
            {"relations", packed(c.relations)},
            {"observed_frequency", packed(c.observed_frequency)},
            {"lumps", packed(c.lumps)},
            {"blocks", packed(c.blocks)}};
  }
};

class Reader {
 public:
  explicit Reader(std::size_t symbols) : symbols_(symbols) {}

  void read(const Json& j, std::vector<PolynomialTerm>& terms) const {
    for (const Json& item : j) {
      PolynomialTerm term{item.at(0).get<std::string>(), std::vector<int>(symbols_, 0)};
      for (std::size_t i = 1; i < item.size(); i += 2) {
        if (item.at(i).is_array()) {
          read_divisors(item.at(i), term);
          break;
        }
        term.exponents.at(item.at(i).get<std::size_t>()) = item.at(i + 1).get<int>();
      }
      terms.push_back(std::move(term));
    }
  }
  void read_divisors(const Json& j, PolynomialTerm& term) const {
    for (std::size_t i = 0; i < j.size(); i += 2) {
      std::vector<PolynomialTerm> sum;
      read(j.at(i), sum);
      auto& known = divisors_[j.at(i).dump()];
      if (!known) known = std::make_shared<const std::vector<PolynomialTerm>>(std::move(sum));
      term.divisors.push_back({known, j.at(i + 1).get<int>()});
    }
  }
  void read(const Json& j, RationalFunction& f) const {
    read(j.at(0), f.numerator);
    read(j.at(1), f.denominator);
  }
  void read(const Json& j, CanonicalRatio& r) const { r = {j.at(0).get<int>(), j.at(1).get<int>()}; }
  template <class Value>
  void read(const Json& j, std::vector<Value>& values) const {
    for (const Json& item : j) read(item, values.emplace_back());
  }
  void read(const Json& j, CanonicalDimension& dimension) const {
    if (!j.is_null()) read(j, dimension.emplace());
  }
  void read(const Json& j, CanonicalFactor& f) const {
    f.kind = static_cast<CanonicalFactor::Kind>(j.at(0).get<int>());
    f.index = j.at(1).get<std::size_t>();
    f.derivative = j.at(2).get<int>();
    f.multiple = j.at(3).get<int>();
    f.power = j.at(4).get<int>();
    for (const Json& item : j.at(5)) {
      auto& [name, ratio] = f.argument.emplace_back();
      name = item.at(0).get<std::string>();
      read(item.at(1), ratio);
    }
    f.function = static_cast<SmoothKind>(j.at(6).get<int>());
    read(j.at(7), f.exponent);
    read(j.at(8), f.inner);
  }
  void read(const Json& j, CanonicalMotionTerm& term) const {
    read(j.at(0), term.coefficient);
    read(j.at(1), term.factors);
    if (!j.at(2).is_null()) term.acceleration_of = j.at(2).get<std::size_t>();
  }
  void read(const Json& j, CanonicalRestValue& value) const {
    value.name = j.at(0).get<std::string>();
    value.function = static_cast<SmoothKind>(j.at(1).get<int>());
    read(j.at(2), value.exponent);
    read(j.at(3), value.argument);
    read(j.at(4), value.slope);
  }
  void read(const Json& j, CanonicalPowers& p) const {
    std::size_t i = 0;
    for (std::vector<int>* list : {&p.amplitude, &p.conjugate, &p.modulus, &p.forcing, &p.phase, &p.slow_phase})
      *list = j.at(i++).get<std::vector<int>>();
  }
  void read(const Json& j, CanonicalColumnTerm& term) const {
    read(j.at(0), term.factor);
    term.imaginary = j.at(1).get<bool>();
    read(j.at(2), term.powers);
  }
  void read(const Json& j, CanonicalBlock::Column& column) const {
    column.lump = j.at(0).get<std::size_t>();
    read(j.at(1), column.terms);
  }
  void read(const Json& j, CanonicalBlock& block) const {
    block.modulation = j.at(0).get<bool>();
    block.mode = j.at(1).get<std::size_t>();
    block.order = j.at(2).get<int>();
    block.phase = j.at(3).get<std::vector<int>>();
    block.name = j.at(4).get<std::string>();
    read(j.at(5), block.columns);
  }
  void read(const Json& j, CanonicalLump& lump) const {
    lump.name = j.at(0).get<std::string>();
    read(j.at(1), lump.definition);
    read(j.at(2), lump.dimension);
  }
  void read(const Json& j, CanonicalRelation& r) const {
    r.multiples = j.at(0).get<std::vector<int>>();
    r.detuning = j.at(1).get<std::string>();
    r.order = j.at(2).get<int>();
    read(j.at(3), r.coefficient);
    r.text = j.at(4).get<std::string>();
  }
  void read(const Json& j, CanonicalCase& c) const {
    c.name = j.at("name").get<std::string>();
    c.expand_to = j.at("expand_to").get<int>();
    c.excited = j.at("excited").get<bool>();
    c.mode_at_rest = j.at("mode_at_rest").get<std::vector<bool>>();
    read(j.at("relations"), c.relations);
    read(j.at("observed_frequency"), c.observed_frequency);
    read(j.at("lumps"), c.lumps);
    read(j.at("blocks"), c.blocks);
  }

 private:
  std::size_t symbols_;
  mutable std::map<std::string, std::shared_ptr<const std::vector<PolynomialTerm>>> divisors_;  // by their text
};

// The lists of names.
template <class Model>
auto names_of(Model& model) {
  return std::vector{std::pair("coordinates", &model.coordinates),
                     std::pair("natural_frequencies", &model.natural_frequencies),
                     std::pair("excitations", &model.excitations),
                     std::pair("excitation_frequencies", &model.excitation_frequencies),
                     std::pair("parameters", &model.parameters),
                     std::pair("strengths", &model.strengths),
                     std::pair("order", &model.order)};
}

}  // namespace

std::string canonical_json(const CanonicalModel& model) {
  Json j = {{"name", model.name}, {"source", model.source}, {"fingerprint", model.fingerprint}};
  for (const auto& [key, names] : names_of(model)) j[key] = *names;
  j["nominal"] = Json::array();
  for (const std::optional<double>& value : model.nominal) j["nominal"].push_back(value ? Json(*value) : Json());
  j["dimensions"] = Writer::packed(model.parameter_dimensions);
  j["rest_values"] = Writer::packed(model.rest_values);
  j["motion"] = Writer::packed(model.motion);
  j["cases"] = Writer::packed(model.cases);
  return j.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<CanonicalModel> canonical_from_json(const std::string& text) try {
  const Json j = Json::parse(text);
  CanonicalModel model;
  model.name = j.at("name").get<std::string>();
  model.source = j.at("source").get<std::string>();
  model.fingerprint = j.at("fingerprint").get<std::string>();
  for (const auto& [key, names] : names_of(model)) *names = j.at(key).get<std::vector<std::string>>();
  const Reader reader(model.order.size());
  for (const Json& value : j.at("nominal"))
    model.nominal.push_back(value.is_null() ? std::nullopt : std::optional(value.get<double>()));
  reader.read(j.at("dimensions"), model.parameter_dimensions);
  reader.read(j.at("rest_values"), model.rest_values);
  reader.read(j.at("motion"), model.motion);
  reader.read(j.at("cases"), model.cases);
  return model;
} catch (const std::exception&) {  // another form, or an index beyond what there is
  return std::nullopt;
}

}  // namespace secular
