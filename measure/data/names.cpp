// Names of the enumerations as campaign.toml writes them.
#include "measure/data/names.hpp"

namespace secular {

std::string to_string(ChannelRole role) {
  return role == ChannelRole::excitation ? "excitation" : "response";
}

std::string to_string(RecordKind kind) {
  for (const auto& [name, value] : record_kind_names)
    if (value == kind) return std::string(name);
  return {};
}

std::optional<ChannelRole> parse_role(std::string_view text) {
  if (text == "excitation") return ChannelRole::excitation;
  if (text == "response") return ChannelRole::response;
  return std::nullopt;
}

std::optional<RecordKind> parse_record_kind(std::string_view text) {
  for (const auto& [name, value] : record_kind_names)
    if (name == text) return value;
  return std::nullopt;
}

}  // namespace secular
