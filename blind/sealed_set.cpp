#include "blind/sealed_set.hpp"

#include <fmt/format.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "blind/campaign_work.hpp"
#include "blind/sealed_files.hpp"
#include "blind/sha256.hpp"
#include "input/folder_lock.hpp"
#include "input/input_error.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

// Labels of campaigns that are made, until all of them are sealed.
fs::path unsealed(const fs::path& folder) {
  return folder / "unsealed";
}

[[noreturn]] void refuse_other_set(const fs::path& folder) {
  throw InputError(
      folder.string(), "", "holds another set of campaigns",
      "name a new folder, or give the seed, the size and the number of campaigns that it was made with");
}

}  // namespace

fs::path sealed_folder(const fs::path& folder, std::size_t number) {
  return folder / fmt::format("case_{:04}", number);
}

ordered_json heading(const SetOptions& options) {
  ordered_json head = {{"schema", 1},
                       {"seed", options.seed},
                       {"set", options.size == SetSize::short_set ? "short" : "full"},
                       {"cases", options.campaigns}};
  if (options.disturbed) head["disturbed"] = true;
  if (options.nothing_withheld) head["nothing_withheld"] = true;
  if (options.programme != Programme::dwells) head["records"] = name_of(options.programme);
  return head;
}

SetOptions options_of_heading(const nlohmann::json& head, const fs::path& folder) {
  const auto is_count = [&](const char* key) { return head.contains(key) && head[key].is_number_unsigned(); };
  if (!head.is_object() || !is_count("cases") || !is_count("seed"))
    throw InputError(folder.string(), "", "is not a complete set of campaigns",
                     "a folder for which `secular blind generate` came to its end");
  SetOptions options;
  options.campaigns = head["cases"].get<std::size_t>();
  options.seed = head["seed"].get<std::uint64_t>();
  options.size = head.value("set", "") == "short" ? SetSize::short_set : SetSize::full_set;
  options.disturbed = head.value("disturbed", false);
  options.nothing_withheld = head.value("nothing_withheld", false);
  const std::string records = head.value("records", name_of(Programme::dwells));
  if (!is_programme(records))
    throw InputError(folder.string(), "", "is a set of records that this version does not know: " + records);
  options.programme = programme_named(records);
  return options;
}

SetOptions options_of(const fs::path& folder) {
  nlohmann::json head = nlohmann::json::parse(read_text(folder / "set.json"), nullptr, false);
  if (!fs::exists(folder / "labels.sha256")) head = nullptr;
  return options_of_heading(head, folder);
}

void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex guard;
  std::exception_ptr failure;
  const auto serve = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  for (unsigned i = 1; i < threads && i < count; ++i) others.emplace_back(serve);
  serve();
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

Performer generating(const CampaignWork& work) {
  return [plans = draw_plans(work.set), work](std::size_t i) {
    const fs::path label = unsealed(work.folder) / fmt::format("{:04}.json", plans[i].number);
    const fs::path target = sealed_folder(work.folder, plans[i].number);
    if (fs::exists(label) && fs::exists(target)) return ordered_json::parse(read_text(label));
    const SealedCampaign sealed = draw_campaign(plans[i], work.set.seed);
    write_sealed(sealed, work.set.seed, target);
    ordered_json made = label_of(sealed);
    write_text(label, made.dump() + "\n");
    return made;
  };
}

void generate_set(const fs::path& folder, const SetOptions& options, const Progress& progress) {
  const ordered_json head = heading(options);
  make_folder(folder);
  const FolderLock lock = lock_or_refuse(folder);
  if (fs::exists(folder / "labels.json")) {
    const nlohmann::json sealed = read_labels(folder);
    for (const auto& [key, value] : head.items())
      if (sealed.value(key, nlohmann::json()) != nlohmann::json(value)) refuse_other_set(folder);
    return;
  }
  const fs::path begun = folder / "set.json";
  if (fs::exists(begun)) {
    if (read_text(begun) != head.dump() + "\n") refuse_other_set(folder);
  } else {
    std::error_code error;
    if (!fs::is_empty(folder, error))
      throw InputError(folder.string(), "", "exists and is not an empty folder", "name a new folder");
    write_text(begun, head.dump() + "\n");
  }
  make_folder(unsealed(folder));
  const std::vector<Answer> labels =
      for_all_campaigns({"generate", folder, options, {{}, options.threads}}, options.campaigns, progress);
  ordered_json all = head;
  all["labels"] = labels;
  const std::string text = all.dump(1) + "\n";
  // The hash first: labels without it would never be accepted.
  write_text(folder / "labels.sha256", sha256(text) + "  labels.json\n");
  write_text(folder / "labels.json", text);
  std::error_code ignored;
  fs::remove_all(unsealed(folder), ignored);
}

nlohmann::json read_labels(const fs::path& folder) {
  const std::string text = read_text(folder / "labels.json");
  const std::string sealed = read_text(folder / "labels.sha256").substr(0, 64);
  if (sha256(text) != sealed)
    throw InputError((folder / "labels.json").string(), "",
                     "is not what was sealed: its SHA-256 differs from labels.sha256",
                     "the labels as they were generated");
  return nlohmann::json::parse(text);
}

}  // namespace secular::blind
