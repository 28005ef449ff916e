#include "measure/data/campaign_text.hpp"

#include <utility>

#include "measure/formats/number_table.hpp"

namespace secular {
namespace {

std::string quoted(const std::string& text) {
  static const char* const hex = "0123456789ABCDEF";
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      result += std::string("\\") + c;
    else if (code < 0x20 || code == 0x7f)
      result += std::string("\\u00") + hex[code / 16] + hex[code % 16];
    else
      result += c;
  }
  return result + "\"";
}

// TOML floats need a point or an exponent to stay floats.
std::string toml_number(double value) {
  std::string text = number_text(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + quoted(name);
  return "[" + text + "]";
}

}  // namespace

std::string campaign_text(const Campaign& campaign) {
  std::string text =
      "schema = 1\nname = " + quoted(campaign.name) + "\n" +
      (campaign.sample_rate_hz > 0 ? "sample_rate_hz = " + toml_number(campaign.sample_rate_hz) + "\n" : "");
  for (const Channel& channel : campaign.channels)
    text += "\n[[channel]]\nname = " + quoted(channel.name) + "\nrole = " + quoted(to_string(channel.role)) +
            "\nquantity = " + quoted(to_string(channel.quantity)) + "\nunit = " + quoted(channel.unit) + "\n" +
            (channel.frame == Frame::absolute ? "frame = \"absolute\"\n" : "");
  if (campaign.modal_basis) {
    text += "\n[modal_basis]\nchannels = " + quoted_list(campaign.modal_basis->channels) +
            "\nmodes = " + quoted_list(campaign.modal_basis->modes) + "\nmass_normalised_shapes = [";
    for (std::size_t r = 0; r < campaign.modal_basis->mass_normalised_shapes.size(); ++r) {
      text += r ? ", [" : "[";
      const std::vector<double>& row = campaign.modal_basis->mass_normalised_shapes[r];
      for (std::size_t c = 0; c < row.size(); ++c) text += (c ? ", " : "") + toml_number(row[c]);
      text += "]";
    }
    text += "]\n";
  }
  std::string table;
  for (const RecordEntry& entry : campaign.records) {
    if (entry.row) {  // all rows of a table are one [[record]]
      if (entry.row->table == std::exchange(table, entry.row->table)) continue;
      text +=
          "\n[[record]]\nfile = " + quoted(entry.row->table) + "\nkind = " + quoted(to_string(entry.kind)) + "\n";
      if (!entry.group.empty()) text += "group = " + quoted(entry.group) + "\n";
      continue;
    }
    text += "\n[[record]]\nfile = " + quoted(entry.file) + "\nkind = " + quoted(to_string(entry.kind)) + "\n";
    const auto add = [&](const char* key, const std::optional<double>& value) {
      if (value) text += std::string(key) + " = " + toml_number(*value) + "\n";
    };
    add("excitation_frequency_hz", entry.excitation_frequency_hz);
    add("excitation_amplitude", entry.excitation_amplitude);
    add("ensemble_s", entry.ensemble_s);
    add("started_s", entry.started_s);
    if (!entry.group.empty()) text += "group = " + quoted(entry.group) + "\n";
    if (!entry.variables.empty()) {
      std::string pairs;
      for (const auto& [channel, variable] : entry.variables)
        pairs += (pairs.empty() ? " " : ", ") + quoted(channel) + " = " + quoted(variable);
      text += "variables = {" + pairs + " }\n";
    }
  }
  return text;
}

}  // namespace secular
