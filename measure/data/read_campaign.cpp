#include <algorithm>
#include <iterator>
#include <set>
#include <system_error>

#include "input/input_error.hpp"
#include "input/nearest_word.hpp"
#include "input/toml_table.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/geometry_text.hpp"
#include "measure/data/held_campaign.hpp"
#include "measure/data/names.hpp"
#include "measure/data/table_entries.hpp"
#include "measure/formats/channel_name.hpp"
#include "measure/formats/unit.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

Frame read_frame(const TomlTable& table, const Channel& channel) {
  const std::string frame = table.string("frame");
  if (frame == "relative") return Frame::relative;
  if (frame != "absolute")
    table.fail("frame", "is '" + frame + "'",
               remedy_for_word("relative or absolute was expected", frame, {"relative", "absolute"}));
  if (channel.role != ChannelRole::response)
    table.fail("frame", "is absolute for an excitation", "frame belongs to responses");
  if (channel.quantity != Quantity::acceleration)
    table.fail("frame", "is absolute for a response that measures " + to_string(channel.quantity),
               "it is for accelerations, from which the base's is taken; take the base's " +
                   to_string(channel.quantity) + " out of the record's samples and give frame = \"relative\"");
  return Frame::absolute;
}

Channel read_channel(const TomlTable& table) {
  table.refuse_unknown_keys({"name", "role", "quantity", "unit", "frame", "delay_s"});
  Channel channel;
  channel.name = table.string("name");
  if (const std::string fault = channel_name_fault(channel.name); !fault.empty()) table.fail("name", fault);
  const auto role = parse_role(table.string("role"));
  if (!role)
    table.fail("role", "is '" + table.string("role") + "'",
               remedy_for_word("excitation or response was expected", table.string("role"), words_of(role_names)));
  channel.role = *role;
  const auto quantity = parse_quantity(table.string("quantity"));
  if (!quantity)
    table.fail("quantity", "is '" + table.string("quantity") + "'",
               remedy_for_word(std::string(quantity_list) + " was expected", table.string("quantity"),
                               words_of(quantity_names)));
  channel.quantity = *quantity;
  channel.unit = table.string("unit");
  const std::string fault = unit_fault(channel.quantity, channel.unit);
  if (!fault.empty()) table.fail("unit", fault);
  if (table.has("frame")) channel.frame = read_frame(table, channel);
  channel.delay_s = table.optional_number("delay_s").value_or(0);
  return channel;
}

ModalBasis read_basis(const TomlTable& table, const std::vector<Channel>& channels) {
  table.refuse_unknown_keys({"channels", "modes", "mass_normalised_shapes"});
  ModalBasis basis;
  basis.channels = table.strings("channels");
  basis.modes = table.strings("modes");
  basis.mass_normalised_shapes = table.number_rows("mass_normalised_shapes");
  if (basis.channels.empty()) table.fail("channels", "is empty", "name the response channels of the modal basis");
  if (basis.modes.empty()) table.fail("modes", "is empty", "name the model's coordinates");
  const Quantity* quantity = nullptr;
  for (const std::string& name : basis.channels) {
    const auto channel =
        std::find_if(channels.begin(), channels.end(), [&](const Channel& c) { return c.name == name; });
    if (channel == channels.end())
      table.fail("channels", "'" + name + "' is no channel of this campaign", "name a [[channel]]");
    if (channel->role != ChannelRole::response)
      table.fail("channels", "'" + name + "' is an excitation", "mode shapes belong to response channels");
    if (quantity && *quantity != channel->quantity)
      table.fail("channels", "'" + name + "' measures another quantity than the channels before it",
                 "one modal basis has channels of one quantity");
    quantity = &channel->quantity;
  }
  for (const char* const key : {"channels", "modes"}) {
    const std::vector<std::string> listed = table.strings(key);
    if (std::set<std::string>(listed.begin(), listed.end()).size() != listed.size())
      table.fail(key, "names something twice", "every name once");
  }
  if (basis.channels.size() < basis.modes.size())
    table.fail("modes", "names more modes than there are channels", "at least one channel for every mode");
  if (basis.mass_normalised_shapes.size() != basis.channels.size())
    table.fail("mass_normalised_shapes",
               "has " + std::to_string(basis.mass_normalised_shapes.size()) + " rows for " +
                   std::to_string(basis.channels.size()) + " channels",
               "one row for every channel");
  for (const std::vector<double>& row : basis.mass_normalised_shapes)
    if (row.size() != basis.modes.size())
      table.fail(
          "mass_normalised_shapes",
          "has a row of " + std::to_string(row.size()) + " for " + std::to_string(basis.modes.size()) + " modes",
          "one number for every mode");
  return basis;
}

std::optional<double> positive(const TomlTable& table, std::string_view key) {
  const auto value = table.optional_number(key);
  if (value && *value <= 0) table.fail(key, "is not positive", "a positive number was expected");
  return value;
}

bool is_table(const TomlTable& record) {
  return parse_record_kind(record.string("kind")) == RecordKind::lines;
}

// `in_memory`: the file is a name alone.
RecordEntry read_entry(const TomlTable& table, const Campaign& campaign, bool in_memory) {
  const bool of_lines = is_table(table);
  std::vector<std::string_view> keys = {"file", "kind", "excitation_amplitude", "started_s", "group", "variables"};
  if (of_lines)
    keys.insert(keys.end(), std::begin(table_keys), std::end(table_keys));
  else
    keys.insert(keys.end(), {"excitation_frequency_hz", "ensemble_s"});
  table.refuse_unknown_keys(keys);
  RecordEntry entry;
  entry.line = table.line();
  entry.file = table.string("file");
  const fs::path relative(entry.file);
  if (entry.file.find('\0') != std::string::npos) table.fail("file", "holds a zero byte", "a path was expected");
  const bool leaves = relative.is_absolute() || std::any_of(relative.begin(), relative.end(),
                                                            [](const fs::path& part) { return part == ".."; });
  if (leaves) table.fail("file", "'" + entry.file + "' leaves the campaign folder", "give a path inside it");
  std::error_code error;
  const fs::path target = fs::weakly_canonical(campaign.folder / relative, error),
                 home = fs::weakly_canonical(campaign.folder, error);
  if (!error && std::mismatch(home.begin(), home.end(), target.begin(), target.end()).first != home.end())
    table.fail("file", "'" + entry.file + "' is a link that leaves the campaign folder",
               "put the file itself there");
  std::error_code ignored;
  if (entry.file.empty() || (!in_memory && !fs::is_regular_file(campaign.folder / relative, ignored)))
    table.fail("file", "'" + entry.file + "' does not exist", "a file inside the campaign folder was expected");
  const auto kind = parse_record_kind(table.string("kind"));
  if (!kind)
    table.fail("kind", "is '" + table.string("kind") + "'",
               remedy_for_word(std::string(record_kind_list) + " was expected", table.string("kind"),
                               words_of(record_kind_names)));
  entry.kind = *kind;
  if (!of_lines) entry.excitation_frequency_hz = positive(table, "excitation_frequency_hz");
  if (entry.excitation_frequency_hz && *entry.excitation_frequency_hz >= 0.5 * campaign.sample_rate_hz)
    table.fail("excitation_frequency_hz", "is not below half the sample rate",
               "check the unit (Hz) and sample_rate_hz");
  entry.excitation_amplitude = positive(table, "excitation_amplitude");
  if (!of_lines) entry.ensemble_s = positive(table, "ensemble_s");
  entry.started_s = table.optional_number("started_s");
  entry.group = table.string_or("group", "");
  if (table.has("variables")) {
    const TomlTable variables = table.table("variables");
    for (const std::string& key : variables.keys()) {
      const bool known = key == "t" || std::any_of(campaign.channels.begin(), campaign.channels.end(),
                                                   [&](const Channel& c) { return c.name == key; });
      if (!known && !of_lines)
        variables.fail(key, "is no channel", "map 't' and channel names to variables of the file");
      entry.variables[key] = variables.string(key);
    }
  }
  return entry;
}

}  // namespace

std::vector<std::size_t> channels_of(const Campaign& campaign, ChannelRole role) {
  std::vector<std::size_t> channels;
  for (std::size_t c = 0; c < campaign.channels.size(); ++c)
    if (campaign.channels[c].role == role) channels.push_back(c);
  return channels;
}

std::vector<std::size_t> seen_responses(const Campaign& campaign) {
  std::vector<std::size_t> seen = channels_of(campaign, ChannelRole::response);
  if (!campaign.modal_basis) return seen;
  const std::vector<std::string>& names = campaign.modal_basis->channels;
  std::erase_if(seen, [&](std::size_t c) {
    return std::find(names.begin(), names.end(), campaign.channels[c].name) == names.end();
  });
  return seen;
}

std::optional<std::size_t> base_channel(const Campaign& campaign) {
  std::optional<std::size_t> base;
  for (std::size_t c = 0; c < campaign.channels.size(); ++c) {
    if (campaign.channels[c].role != ChannelRole::excitation ||
        campaign.channels[c].quantity != Quantity::acceleration)
      continue;
    if (base) return std::nullopt;
    base = c;
  }
  return base;
}

Campaign read_campaign(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored))
    throw InputError(folder.string(), "", "does not exist", "a campaign folder was expected");
  if (!fs::is_directory(folder, ignored))
    throw InputError(folder.string(), "", "is a file",
                     "a campaign folder was expected: make one with `secular import`");
  if (!fs::exists(folder / "campaign.toml", ignored))
    throw InputError(folder.string(), "",
                     fs::is_empty(folder, ignored) ? "is an empty folder" : "has no campaign.toml",
                     "make a campaign from its files with `secular import`");
  return described_campaign(TomlTable::from_file(folder / "campaign.toml"), folder, false);
}

Campaign described_campaign(const TomlTable& root, const fs::path& folder, bool in_memory) {
  root.refuse_unknown_keys({"schema", "name", "sample_rate_hz", "channel", "modal_basis", "geometry", "record"});
  if (root.integer("schema") != 1) root.fail("schema", "is not 1", "this program reads schema 1");
  Campaign campaign;
  campaign.folder = folder;
  campaign.name = root.string_or("name", folder.filename().string());
  const std::vector<TomlTable> records = root.tables("record");
  const bool tables_alone = !records.empty() && std::all_of(records.begin(), records.end(), is_table);
  if (!tables_alone || root.has("sample_rate_hz")) {
    campaign.sample_rate_hz = root.number("sample_rate_hz");
    if (campaign.sample_rate_hz <= 0) root.fail("sample_rate_hz", "is not positive", "a rate in Hz was expected");
  }
  std::set<std::string> names;
  for (const TomlTable& table : root.tables("channel")) {
    campaign.channels.push_back(read_channel(table));
    if (!names.insert(campaign.channels.back().name).second)
      table.fail("name", "'" + campaign.channels.back().name + "' is used twice", "every channel has its own name");
  }
  if (!base_channel(campaign))
    for (const TomlTable& table : root.tables("channel"))
      if (table.string_or("frame", "") == "absolute")
        table.fail("frame", "is absolute, and no one excitation is known to be the base's acceleration",
                   "exactly one [[channel]] with role = \"excitation\", quantity = \"acceleration\"");
  const bool any_response = std::any_of(campaign.channels.begin(), campaign.channels.end(),
                                        [](const Channel& c) { return c.role == ChannelRole::response; });
  if (!any_response) root.fail("channel", "no channel is a response", "describe at least one response [[channel]]");
  if (root.has("modal_basis")) campaign.modal_basis = read_basis(root.table("modal_basis"), campaign.channels);
  if (root.has("geometry")) campaign.geometry = read_geometry(root.table("geometry"), campaign.channels);
  for (const TomlTable& table : records) {
    RecordEntry entry = read_entry(table, campaign, in_memory);
    if (in_memory && entry.kind == RecordKind::lines)
      table.fail("kind", "is lines, which stand in a file", "give a folder, or a kind that has samples");
    if (entry.kind != RecordKind::lines) {
      campaign.records.push_back(std::move(entry));
      continue;
    }
    std::vector<RecordEntry> rows = table_entries(table, campaign, entry);
    std::move(rows.begin(), rows.end(), std::back_inserter(campaign.records));
  }
  if (campaign.records.empty()) root.fail("record", "there are no records", "add a [[record]] for every file");
  return campaign;
}

}  // namespace secular
