#include "measure/formats/quantity.hpp"

namespace secular {

std::string to_string(Quantity quantity) {
  for (const auto& [name, value] : quantity_names)
    if (value == quantity) return std::string(name);
  return {};
}

std::optional<Quantity> parse_quantity(std::string_view text) {
  for (const auto& [name, value] : quantity_names)
    if (name == text) return value;
  return std::nullopt;
}

}  // namespace secular
