#include "measure/data/campaign_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <system_error>

#include "input/input_error.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/campaign_text.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

// Links followed as far as there is something.
fs::path links_followed(const fs::path& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(fs::absolute(path), error);
  if (error) result = fs::absolute(path).lexically_normal();
  return result.filename().empty() ? result.parent_path() : result;
}

bool is_within(const fs::path& inner, const fs::path& outer) {
  const auto [left, right] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  return left == outer.end();
}

}  // namespace

std::string fault_of_replaced(const fs::path& folder) {
  std::optional<Campaign> campaign;
  try {
    campaign = read_campaign(folder);
  } catch (const InputError&) {
    return "exists and is no campaign";
  }
  std::set<fs::path> own = {"campaign.toml"};
  for (const RecordEntry& entry : campaign->records) {
    fs::path file = fs::path((entry.row ? entry.row->table : entry.file)).lexically_normal();
    for (own.insert(file); file.has_parent_path(); own.insert(file)) file = file.parent_path();
  }
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    const fs::path inside = entry.path().lexically_relative(folder);
    if (!own.contains(inside))
      return fmt::format("holds {}, which is no part of its campaign", inside.generic_string());
  }
  std::ifstream stream(folder / "campaign.toml", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (text != campaign_text(*campaign)) return "exists, and its campaign.toml is not as a command writes it";
  return {};
}

std::string overlap(const fs::path& target, const fs::path& source) {
  if (target.empty()) return {};
  const fs::path written = links_followed(target);
  const fs::path read = links_followed(source);
  if (written == read) return "is";
  if (is_within(written, read)) return "lies inside";
  if (is_within(read, written)) return "contains";
  return {};
}

void check_apart(const fs::path& target, const fs::path& source, const std::string& what) {
  if (const std::string how = overlap(target, source); !how.empty())
    throw InputError(target.string(), "", fmt::format("{} {} that is read ({})", how, what, source.string()),
                     "name another place: what is read is never written to");
}

}  // namespace secular
