#include "blind/leave_out.hpp"

#include <atomic>
#include <nlohmann/json.hpp>
#include <optional>

#include "blind/sealed_campaign.hpp"
#include "blind/sealed_files.hpp"
#include "input/folder_lock.hpp"

namespace secular::blind {

namespace fs = std::filesystem;

fs::path left_out_folder(const fs::path& place) {
  return place / "left_out";
}

fs::path look_alikes_file(const fs::path& place) {
  return left_out_folder(place) / "look_alikes.json";
}

LeaveOutSummary leave_out_of_set(const fs::path& folder, const RunOptions& options, const Progress& progress) {
  const SetOptions set = options_of(folder);
  const FolderLock lock = lock_or_refuse(folder);
  const Diagnoser diagnoser(options);
  const std::vector<CampaignPlan> plans = draw_plans(set);
  LeaveOutSummary summary;
  Failures failures;
  std::atomic<std::size_t> done{0}, campaigns{0}, kept{0};
  in_parallel(plans.size(), options.threads, [&](std::size_t i) {
    const fs::path place = sealed_folder(folder, plans[i].number), out = left_out_folder(place);
    if (plans[i].kind == "single") {
      const bool complete = fs::exists(out / "diagnosis" / "diagnosis.json") && fs::exists(look_alikes_file(place));
      ++campaigns;
      if (complete) ++kept;
      if (!complete) {
        make_folder(out);
        const SealedCampaign sealed = draw_campaign(plans[i], set.seed);
        write_text(look_alikes_file(place), nlohmann::json(rest_that_explains(sealed, set.seed)).dump() + "\n");
        if (const std::optional<std::string> fault =
                diagnoser.run(place, place / "campaign", out, plans[i].effects))
          failures.add(plans[i].number, *fault);
      }
    }
    if (progress) progress(++done, plans.size());
  });
  summary.campaigns = campaigns;
  summary.kept = kept;
  summary.failed = failures.by_number();
  return summary;
}

}  // namespace secular::blind
