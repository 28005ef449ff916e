#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include "measure/data/campaign.hpp"

namespace secular {

inline constexpr std::pair<std::string_view, RecordKind> record_kind_names[] = {
    {"dwell", RecordKind::dwell},   {"sweep", RecordKind::sweep},         {"free_decay", RecordKind::free_decay},
    {"impact", RecordKind::impact}, {"broadband", RecordKind::broadband}, {"lines", RecordKind::lines}};

inline constexpr std::pair<std::string_view, ChannelRole> role_names[] = {{"excitation", ChannelRole::excitation},
                                                                          {"response", ChannelRole::response}};

inline constexpr std::string_view record_kind_list = "dwell, sweep, free_decay, impact, broadband or lines";

/// As campaign.toml writes them; nothing for any other text.
std::optional<ChannelRole> parse_role(std::string_view text);
std::optional<RecordKind> parse_record_kind(std::string_view text);

}  // namespace secular
