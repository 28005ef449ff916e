#include "blind/leave_out.hpp"

#include <nlohmann/json.hpp>
#include <optional>

#include "blind/campaign_work.hpp"
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

Performer leaving_out(const CampaignWork& work) {
  return [plans = draw_plans(work.set), diagnoser = Diagnoser(work.how), work](std::size_t i) {
    const fs::path place = sealed_folder(work.folder, plans[i].number), out = left_out_folder(place);
    if (plans[i].kind != "single") return Answer::object();
    Answer answer = {{"single", true}};
    if (fs::exists(out / "diagnosis" / "diagnosis.json") && fs::exists(look_alikes_file(place))) {
      answer.update(kept_before());
      return answer;
    }
    make_folder(out);
    const SealedCampaign sealed = draw_campaign(plans[i], work.set.seed);
    write_text(look_alikes_file(place), nlohmann::json(rest_that_explains(sealed, work.set.seed)).dump() + "\n");
    answer.update(done_now(diagnoser.run(place, place / "campaign", out, plans[i].effects)));
    return answer;
  };
}

LeaveOutSummary leave_out_of_set(const fs::path& folder, const RunOptions& options, const Progress& progress) {
  const SetOptions set = options_of(folder);
  const FolderLock lock = lock_or_refuse(folder);
  const std::vector<Answer> answers =
      for_all_campaigns({"leave_out", folder, set, options}, set.campaigns, progress);
  return {count_of(answers, "single"), count_of(answers, "kept"), failed_of(answers)};
}

}  // namespace secular::blind
