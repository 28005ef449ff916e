#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "input/input_error.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/campaign_text.hpp"
#include "measure/data/campaign_writer.hpp"
#include "measure/data/names.hpp"
#include "measure/data/number_table.hpp"

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

  /// Writes a file from pieces: `next` gives them in order, an empty one ends the file.
  template <class Next>
  void write(const fs::path& file, const Next& next) const {
    std::error_code error;
    fs::create_directories((path_ / file).parent_path(), error);
    std::ofstream stream(path_ / file, std::ios::binary);
    for (std::string piece = next(); stream && !piece.empty(); piece = next()) stream << piece;
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

// Before long work.
void check_campaign_target(const fs::path& folder) {
  std::error_code error;
  if (folder.empty()) throw InputError("", "", "the campaign folder has no name", "name a new folder");
  if (fs::exists(fs::symlink_status(folder, error)) &&
      !(fs::is_directory(folder, error) && fs::is_empty(folder, error)))
    throw InputError(folder.string(), "", "exists and is not an empty folder",
                     "name a new folder or remove this one");
}

}  // namespace

struct CampaignWriter::Building {
  explicit Building(const fs::path& target) : named(target), folder(target) {}

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
  UnfinishedFolder folder;
  std::mutex guard;
  std::set<fs::path> files = {"campaign.toml"};
};

CampaignWriter::CampaignWriter(const fs::path& folder) {
  check_campaign_target(folder);
  building_ = std::make_unique<Building>(folder);
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
    std::vector<std::vector<double>> columns(1, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i)
      columns[0][i] = record.start_s + static_cast<double>(row + i) / record.sample_rate_hz;
    for (const std::vector<double>& samples : record.channels) {
      const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(row);
      columns.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(count));
    }
    row += count;
    return csv_rows(columns);
  });
}

void CampaignWriter::finish(const Campaign& campaign) {
  Campaign written = campaign;
  for (RecordEntry& entry : written.records) entry = as_csv(entry);
  std::string text = campaign_text(written);
  building_->folder.write("campaign.toml", [&] { return std::exchange(text, {}); });
  check_readable(building_->folder);
  building_->folder.finish();
}

}  // namespace secular
