#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <set>
#include <stdexcept>
#include <system_error>

#include "estimator/campaign/campaign.hpp"
#include "estimator/campaign/campaign_text.hpp"
#include "estimator/campaign/names.hpp"
#include "estimator/campaign/number_table.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

// The campaign as it stands in the new folder: every record a CSV with the channels' names in its header.
Campaign with_csv_records(Campaign campaign) {
  for (RecordEntry& entry : campaign.records) {
    entry.file = fs::path(entry.file).replace_extension(".csv").generic_string();
    entry.variables.clear();
  }
  return campaign;
}

void check_record(const Campaign& campaign, const RecordEntry& entry, const Record& record,
                  const fs::path& folder) {
  if (record.channels.size() != campaign.channels.size())
    throw std::invalid_argument("write_campaign: a record has another number of channels than its campaign");
  if (!(std::abs(record.sample_rate_hz / campaign.sample_rate_hz - 1) <= 1e-3) || !std::isfinite(record.start_s))
    throw std::invalid_argument("write_campaign: a record's time axis contradicts its campaign");
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const std::vector<double>& samples = record.channels[c];
    if (samples.size() != record.samples() || samples.size() < 2)
      throw std::invalid_argument("write_campaign: channels of a record need one length, two samples or more");
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (!std::isfinite(samples[i]))
        throw InputError(folder.string(), entry.file + ", channel " + campaign.channels[c].name,
                         fmt::format("sample {} is not a finite number", i + 1),
                         "only finite samples can be stored");
  }
}

void check(const Campaign& campaign, const std::vector<Record>& samples, const fs::path& folder) {
  if (samples.size() != campaign.records.size())
    throw std::invalid_argument("write_campaign: as many sample sets as records were expected");
  for (const Channel& channel : campaign.channels)
    if (const std::string fault = channel_name_fault(channel.name); !fault.empty())
      throw InputError(folder.string(), "channel name", fault);
  std::set<fs::path> files = {"campaign.toml"};
  for (std::size_t r = 0; r < samples.size(); ++r) {
    const fs::path file = fs::path(campaign.records[r].file).lexically_normal();
    if (file.is_absolute() || file.empty() || *file.begin() == ".." || !file.has_filename())
      throw InputError(folder.string(), "record " + campaign.records[r].file,
                       "is no file inside the campaign folder", "give a path such as records/0001.csv");
    if (!files.insert(file).second)
      throw InputError(folder.string(), "record " + campaign.records[r].file, "is a file name used twice",
                       "every record is a file of its own");
    check_record(campaign, campaign.records[r], samples[r], folder);
  }
}

std::string record_text(const Campaign& campaign, const Record& record) {
  NumberTable table;
  table.names.push_back("t");
  table.columns.emplace_back(record.samples());
  for (std::size_t i = 0; i < record.samples(); ++i)
    table.columns[0][i] = record.start_s + static_cast<double>(i) / record.sample_rate_hz;
  for (std::size_t c = 0; c < campaign.channels.size(); ++c) {
    table.names.push_back(campaign.channels[c].name);
    table.columns.push_back(record.channels[c]);
  }
  return csv_text(table);
}

/// A folder that is built beside its target and becomes it, or leaves nothing: neither itself nor parents made for
/// it.
class UnfinishedFolder {
 public:
  explicit UnfinishedFolder(const fs::path& target) : target_(fs::absolute(target).lexically_normal()) {
    if (target_.filename().empty()) target_ = target_.parent_path();
    std::error_code error;
    for (fs::path parent = target_.parent_path(); !parent.empty() && !fs::exists(parent, error);
         parent = parent.parent_path())
      made_ = parent;
    fs::create_directories(target_.parent_path(), error);
    for (int attempt = 0; !error && path_.empty(); ++attempt) {
      const fs::path name = target_.parent_path() /
                            fmt::format(".{}.unfinished-{}-{}", target_.filename().string(), ::getpid(), attempt);
      if (fs::create_directory(name, error)) path_ = name;
    }
    if (error) {
      remove();
      throw InputError(target.string(), "", "cannot be created: " + error.message(),
                       "name a folder in a place that you may write to");
    }
  }
  UnfinishedFolder(const UnfinishedFolder&) = delete;
  UnfinishedFolder& operator=(const UnfinishedFolder&) = delete;
  ~UnfinishedFolder() {
    if (!finished_) remove();
  }

  const fs::path& path() const { return path_; }
  const fs::path& target() const { return target_; }

  void write(const fs::path& file, const std::string& text) const {
    std::error_code error;
    fs::create_directories((path_ / file).parent_path(), error);
    std::ofstream stream(path_ / file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
      throw InputError((target_ / file).string(), "", "cannot be written",
                       "check the name, the permissions and the free space");
  }

  void finish() {
    std::error_code error;
    fs::rename(path_, target_, error);  // takes the place of an empty folder
    if (error)
      throw InputError(target_.string(), "", "cannot be put in place: " + error.message(), "name a new folder");
    finished_ = true;
  }

 private:
  void remove() const {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
    if (made_.empty()) return;
    for (fs::path parent = target_.parent_path(); fs::remove(parent, ignored) && parent != made_;)
      parent = parent.parent_path();
  }

  fs::path target_, path_, made_;  // made_: the topmost parent that did not exist before
  bool finished_ = false;
};

// What has just been written must be what read_campaign accepts: units, names, modal basis, UTF-8.
void check_readable(const UnfinishedFolder& building) {
  try {
    read_campaign(building.path());
  } catch (const InputError& error) {
    throw InputError((building.target() / "campaign.toml").string(), error.place(), error.wrong(), error.right());
  }
}

}  // namespace

void check_campaign_target(const fs::path& folder) {
  std::error_code error;
  if (folder.empty()) throw InputError("", "", "the campaign folder has no name", "name a new folder");
  if (fs::exists(fs::symlink_status(folder, error)) &&
      !(fs::is_directory(folder, error) && fs::is_empty(folder, error)))
    throw InputError(folder.string(), "", "exists and is not an empty folder",
                     "name a new folder or remove this one");
}

void write_campaign(const Campaign& campaign, const std::vector<Record>& samples, const fs::path& folder) {
  const Campaign written = with_csv_records(campaign);
  check_campaign_target(folder);
  check(written, samples, folder);
  UnfinishedFolder building(folder);
  building.write("campaign.toml", campaign_text(written));
  for (std::size_t r = 0; r < samples.size(); ++r)
    building.write(written.records[r].file, record_text(written, samples[r]));
  check_readable(building);
  building.finish();
}

}  // namespace secular
