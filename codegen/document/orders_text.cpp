#include "codegen/document/orders_text.hpp"

namespace secular {

std::string orders_text(const CanonicalCase& c) {
  std::string text;
  for (const auto& [name, order] : c.chosen_orders) text += name + " = " + std::to_string(order) + ", ";
  return text + "others 0; terms by their degree";
}

}  // namespace secular
