#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "input/input_error.hpp"
#include "input/whole_folder.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/campaign_target.hpp"
#include "measure/data/campaign_text.hpp"
#include "measure/data/campaign_writer.hpp"
#include "measure/data/held_campaign.hpp"
#include "measure/data/names.hpp"
#include "measure/data/record_data.hpp"
#include "measure/data/written_table.hpp"
#include "measure/formats/channel_name.hpp"
#include "measure/formats/number_table.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

// A record as it stands in the new folder: a CSV with the channels' names in its header.
RecordEntry as_csv(RecordEntry entry) {
  entry.file = fs::path(entry.file).replace_extension(".csv").generic_string();
  entry.variables.clear();
  return entry;
}

void check_record(const Campaign& campaign, const RecordEntry& entry, const Record& record,
                  const fs::path& folder) {
  if (record.channels.size() != campaign.channels.size())
    throw std::invalid_argument("write_campaign: a record has another number of channels than its campaign");
  if (!(std::abs(record.sample_rate_hz / campaign.sample_rate_hz - 1) <= measure_thresholds().same_setting) ||
      !std::isfinite(record.start_s))
    throw std::invalid_argument("write_campaign: a record's time axis contradicts its campaign");
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const std::vector<double>& samples = record.channels[c];
    if (samples.size() != record.samples() || samples.size() < 2)
      throw std::invalid_argument("write_campaign: channels of a record need one length, two samples or more");
    const std::vector<std::size_t> none = filled_samples(record, c);
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (!std::isfinite(samples[i]) && !std::binary_search(none.begin(), none.end(), i))
        throw InputError(folder.string(), entry.file + ", channel " + campaign.channels[c].name,
                         fmt::format("sample {} is not a finite number", i + 1),
                         "only finite samples can be stored");
  }
}

// What has just been written must be what read_campaign accepts: units, names, modal basis, UTF-8.
void check_readable(const WholeFolder& building) {
  try {
    read_campaign(building.path());
  } catch (const InputError& error) {
    throw InputError((building.target() / "campaign.toml").string(), error.place(), error.wrong(), error.right());
  }
}

// Before long work, and again before a folder is replaced.
void check_campaign_target(const fs::path& folder, bool replace) {
  std::error_code error;
  if (folder.empty()) throw InputError("", "", "the campaign folder has no name", "name a new folder");
  if (!fs::exists(fs::symlink_status(folder, error))) return;
  const bool is_folder = fs::is_directory(folder, error);
  if (is_folder && fs::is_empty(folder, error)) return;
  if (!is_folder || !replace)
    throw InputError(folder.string(), "", "exists and is not an empty folder",
                     "name a new folder or remove this one");
  if (const std::string fault = fault_of_replaced(folder); !fault.empty())
    throw InputError(folder.string(), "", fault,
                     "name another folder, or remove this one yourself: campaigns alone are replaced");
}

}  // namespace

std::vector<std::vector<double>> measured_columns(const Record& record, std::size_t first, std::size_t count) {
  const auto is_among = [](const std::vector<std::size_t>& rising, std::size_t row) {
    return std::binary_search(rising.begin(), rising.end(), row);
  };
  std::vector<std::vector<double>> columns(record.channels.size() + 1);
  for (std::size_t row = first; row < first + count; ++row) {
    if (is_among(record.lost, row)) continue;
    columns[0].push_back(record.start_s + static_cast<double>(row) / record.sample_rate_hz);
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
      const bool is_measured = c >= record.no_numbers.size() || !is_among(record.no_numbers[c], row);
      columns[c + 1].push_back(is_measured ? record.channels[c][row] : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return columns;
}

struct CampaignWriter::Building {
  Building(const fs::path& target, bool to_replace) : named(target), replace(to_replace), folder(target) {}

  // A place inside the folder that no other record has.
  void reserve(const std::string& name) {
    const fs::path file = fs::path(name).lexically_normal();
    if (file.is_absolute() || file.empty() || *file.begin() == ".." || !file.has_filename())
      throw InputError(named.string(), "record " + name, "is no file inside the campaign folder",
                       "give a path such as records/0001.csv");
    const std::lock_guard lock(guard);
    if (!files.insert(file).second)
      throw InputError(named.string(), "record " + name, "is a file name used twice",
                       "every record is a file of its own");
  }

  fs::path named;  // as the caller spells it
  bool replace = false;
  WholeFolder folder;
  std::mutex guard;
  std::set<fs::path> files = {"campaign.toml"};
};

CampaignWriter::CampaignWriter(const fs::path& folder, bool replace) {
  check_campaign_target(folder, replace);
  building_ = std::make_unique<Building>(folder, replace);
}

CampaignWriter::~CampaignWriter() = default;

void CampaignWriter::write(const Campaign& campaign, const RecordEntry& entry, const Record& record) {
  const RecordEntry written = as_csv(entry);
  for (const Channel& channel : campaign.channels)
    if (const std::string fault = channel_name_fault(channel.name); !fault.empty())
      throw InputError(building_->named.string(), "channel name", fault);
  building_->reserve(written.file);
  check_record(campaign, written, record, building_->named);
  // Rows in blocks: the text of a long record would take several times the space of its samples.
  constexpr std::size_t block = 4096;
  std::size_t row = 0;
  bool begun = false;
  building_->folder.write(written.file, [&] {
    if (!begun) {
      begun = true;
      std::vector<std::string> names = {"t"};
      for (const Channel& channel : campaign.channels) names.push_back(channel.name);
      return csv_header(names);
    }
    const std::size_t count = std::min(block, record.samples() - row);
    const std::vector<std::vector<double>> columns = measured_columns(record, row, count);
    row += count;
    return csv_rows(columns);
  });
}

void CampaignWriter::write(const Campaign& campaign, const RecordEntry& entry, const std::vector<LineRow>& rows) {
  const RecordEntry written = as_csv(entry);
  building_->reserve(written.file);
  const WrittenTable table = written_table(rows, campaign.channels);
  std::string text = csv_header(table.names) + csv_rows(table.columns);
  building_->folder.write(written.file, [&] { return std::exchange(text, {}); });
}

void CampaignWriter::finish(const Campaign& campaign) {
  Campaign written = campaign;
  for (RecordEntry& entry : written.records) entry = as_csv(entry);
  std::string text = campaign_text(written);
  building_->folder.write("campaign.toml", [&] { return std::exchange(text, {}); });
  check_readable(building_->folder);
  check_campaign_target(building_->named, building_->replace);
  building_->folder.finish(building_->replace);
}

void write_campaign(const Campaign& campaign, const fs::path& folder, bool replace) {
  CampaignWriter writer(folder, replace);
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    RecordEntry entry = campaign.records[r];
    if (!entry.row) {
      writer.write(campaign, entry, read_record(campaign, entry));
      continue;
    }
    std::vector<LineRow> rows;
    while (r < campaign.records.size() && campaign.records[r].row &&
           campaign.records[r].row->table == entry.row->table)
      rows.push_back(*campaign.records[r++].row);
    --r;
    entry.file = entry.row->table;
    entry.row.reset();
    writer.write(campaign, entry, rows);
  }
  writer.finish(campaign);
}

}  // namespace secular
