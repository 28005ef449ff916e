#include "measure/data/campaign_text.hpp"

#include <utility>

#include "measure/data/geometry_text.hpp"
#include "measure/data/toml_text.hpp"

namespace secular {
std::string campaign_text(const Campaign& campaign) {
  std::string text =
      "schema = 1\nname = " + toml_string(campaign.name) + "\n" +
      (campaign.sample_rate_hz > 0 ? "sample_rate_hz = " + toml_number(campaign.sample_rate_hz) + "\n" : "");
  for (const Channel& channel : campaign.channels)
    text += "\n[[channel]]\nname = " + toml_string(channel.name) +
            "\nrole = " + toml_string(to_string(channel.role)) +
            "\nquantity = " + toml_string(to_string(channel.quantity)) + "\nunit = " + toml_string(channel.unit) +
            "\n" + (channel.frame == Frame::absolute ? "frame = \"absolute\"\n" : "") +
            (channel.delay_s != 0 ? "delay_s = " + toml_number(channel.delay_s) + "\n" : "");
  if (campaign.modal_basis) {
    text += "\n[modal_basis]\nchannels = " + toml_list(campaign.modal_basis->channels) +
            "\nmodes = " + toml_list(campaign.modal_basis->modes) + "\nmass_normalised_shapes = [";
    for (std::size_t r = 0; r < campaign.modal_basis->mass_normalised_shapes.size(); ++r) {
      text += r ? ", [" : "[";
      const std::vector<double>& row = campaign.modal_basis->mass_normalised_shapes[r];
      for (std::size_t c = 0; c < row.size(); ++c) text += (c ? ", " : "") + toml_number(row[c]);
      text += "]";
    }
    text += "]\n";
  }
  if (campaign.geometry) text += geometry_text(*campaign.geometry);
  std::string table;
  for (const RecordEntry& entry : campaign.records) {
    if (entry.row) {  // all rows of a table are one [[record]]
      if (entry.row->table == std::exchange(table, entry.row->table)) continue;
      text += "\n[[record]]\nfile = " + toml_string(entry.row->table) +
              "\nkind = " + toml_string(to_string(entry.kind)) + "\n";
      if (!entry.group.empty()) text += "group = " + toml_string(entry.group) + "\n";
      continue;
    }
    text +=
        "\n[[record]]\nfile = " + toml_string(entry.file) + "\nkind = " + toml_string(to_string(entry.kind)) + "\n";
    const auto add = [&](const char* key, const std::optional<double>& value) {
      if (value) text += std::string(key) + " = " + toml_number(*value) + "\n";
    };
    add("excitation_frequency_hz", entry.excitation_frequency_hz);
    add("excitation_amplitude", entry.excitation_amplitude);
    add("ensemble_s", entry.ensemble_s);
    add("started_s", entry.started_s);
    if (!entry.group.empty()) text += "group = " + toml_string(entry.group) + "\n";
    if (!entry.variables.empty()) {
      std::string pairs;
      for (const auto& [channel, variable] : entry.variables)
        pairs += (pairs.empty() ? " " : ", ") + toml_string(channel) + " = " + toml_string(variable);
      text += "variables = {" + pairs + " }\n";
    }
  }
  return text;
}

}  // namespace secular
