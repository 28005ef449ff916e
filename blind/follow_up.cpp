#include "blind/follow_up.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "blind/campaign_work.hpp"
#include "blind/random.hpp"
#include "blind/sealed_files.hpp"
#include "input/folder_lock.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

// What a diagnosis that left a set proposes.
std::optional<FurtherDwell> proposal_of(const nlohmann::json& diagnosis, std::size_t dwells) {
  const nlohmann::json next = diagnosis.value("next_experiment", nlohmann::json::object());
  if (!next.is_object() || !next.value("proposed", false)) return std::nullopt;
  const std::string file = next.value("like", "");
  for (std::size_t d = 0; d < dwells; ++d)
    if (file == dwell_file(d))
      return FurtherDwell{d, next.value("level_factor", 1.0), two_pi * next.value("frequency_hz", 0.0),
                          static_cast<std::size_t>(std::clamp(next.value("length_factor", 1.0), 1.0, 100.0))};
  return std::nullopt;
}

// The part of a group's name that says which resonance it belongs to: "mode 1, level 3".
std::string resonance_of(const Dwell& dwell) {
  return dwell.group.substr(0, dwell.group.find(','));
}

// As long as the one that it is compared with.
FurtherDwell random_dwell(const Specimen& specimen, std::size_t length, Random& random) {
  FurtherDwell further;
  further.length = length;
  further.like = random.below(specimen.dwells.size());
  further.level = random.uniform(0.5, 1.5);
  const Dwell& like = specimen.dwells[further.like];
  std::size_t other = further.like;
  do other = random.below(specimen.dwells.size());
  while (resonance_of(specimen.dwells[other]) != resonance_of(like));
  further.frequency = specimen.dwells[other].drive.frequency;
  return further;
}

}  // namespace

fs::path follow_up_folder(const fs::path& place, const std::string& which) {
  return place / "next" / which;
}

Performer following(const CampaignWork& work) {
  return [plans = draw_plans(work.set), diagnoser = Diagnoser(work.how), work](std::size_t i) {
    const fs::path place = sealed_folder(work.folder, plans[i].number),
                   first = place / "diagnosis" / "diagnosis.json";
    const nlohmann::json diagnosis =
        fs::exists(first) ? nlohmann::json::parse(read_text(first), nullptr, false) : nlohmann::json();
    Answer answer = Answer::object();
    if (!diagnosis.is_object() || diagnosis.value("verdict", "") != "set") return answer;
    answer["set"] = true;
    const std::uint64_t seed = work.set.seed;
    const SealedCampaign sealed = draw_campaign(plans[i], seed);
    const std::optional<FurtherDwell> proposal = proposal_of(diagnosis, sealed.specimen.dwells.size());
    if (!proposal) return answer;
    answer["proposed"] = true;
    Random random(seed, 2'000'000 + plans[i].number);
    const FurtherDwell compared = random_dwell(sealed.specimen, proposal->length, random);
    for (const std::string which : follow_ups) {
      const bool asked = which == std::string(follow_ups[0]);
      const fs::path target = follow_up_folder(place, which);
      if (fs::exists(target / "diagnosis" / "diagnosis.json")) continue;
      std::error_code ignored;
      fs::remove_all(target, ignored);
      make_folder(target);
      write_extended_campaign(sealed, seed, asked ? *proposal : compared, place / "campaign", target / "campaign");
      if (const std::optional<std::string> fault = diagnoser.run(place, target / "campaign", target))
        answer["faults"].push_back(which + ": " + *fault);
    }
    return answer;
  };
}

FollowUpSummary follow_up_set(const fs::path& folder, const RunOptions& options, const Progress& progress) {
  const SetOptions set = options_of(folder);
  const FolderLock lock = lock_or_refuse(folder);
  const std::vector<Answer> answers = for_all_campaigns({"follow", folder, set, options}, set.campaigns, progress);
  return {count_of(answers, "set"), count_of(answers, "proposed"), failed_of(answers)};
}

}  // namespace secular::blind
