// Names of the enumerations as campaign.toml writes them.
#include "measure/data/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "measure/data/csv_dialect.hpp"

namespace secular {

std::string to_string(ChannelRole role) {
  return role == ChannelRole::excitation ? "excitation" : "response";
}

std::string to_string(Quantity quantity) {
  for (const auto& [name, value] : quantity_names)
    if (value == quantity) return std::string(name);
  return {};
}

std::string to_string(RecordKind kind) {
  for (const auto& [name, value] : record_kind_names)
    if (value == kind) return std::string(name);
  return {};
}

std::string channel_name_fault(std::string_view name) {
  if (name.empty()) return "is empty; every channel has a name";
  if (name == "t") return "is 't', which names time; every channel has a name of its own";
  for (const CsvDialect& dialect : csv_dialects)
    if (!dialect.in_names && name.find(dialect.separator) != std::string_view::npos)
      return fmt::format("'{}' has a {}, which a CSV header cannot hold", name, dialect.name);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (name.find('"') != std::string_view::npos || std::any_of(name.begin(), name.end(), is_control))
    return fmt::format("'{}' has a quote or control character, which a CSV header cannot hold", name);
  if (name.front() == ' ' || name.back() == ' ')
    return fmt::format("'{}' begins or ends with a blank, which a CSV header cannot hold", name);
  double number = 0;
  if (std::from_chars(name.data(), name.data() + name.size(), number).ptr == name.data() + name.size())
    return fmt::format("'{}' is a number, which a CSV header cannot hold", name);
  return {};
}

std::optional<ChannelRole> parse_role(std::string_view text) {
  if (text == "excitation") return ChannelRole::excitation;
  if (text == "response") return ChannelRole::response;
  return std::nullopt;
}

std::optional<Quantity> parse_quantity(std::string_view text) {
  for (const auto& [name, value] : quantity_names)
    if (name == text) return value;
  return std::nullopt;
}

std::optional<RecordKind> parse_record_kind(std::string_view text) {
  for (const auto& [name, value] : record_kind_names)
    if (name == text) return value;
  return std::nullopt;
}

}  // namespace secular
