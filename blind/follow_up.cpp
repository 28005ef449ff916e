#include "blind/follow_up.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

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

FollowUpSummary follow_up_set(const fs::path& folder, const RunOptions& options, const Progress& progress) {
  const SetOptions set = options_of(folder);
  const FolderLock lock = lock_or_refuse(folder);
  const Diagnoser diagnoser(options);
  const std::vector<CampaignPlan> plans = draw_plans(set);
  FollowUpSummary summary;
  Failures failures;
  std::atomic<std::size_t> done{0}, sets{0}, proposed{0};
  in_parallel(plans.size(), options.threads, [&](std::size_t i) {
    const fs::path place = sealed_folder(folder, plans[i].number), first = place / "diagnosis" / "diagnosis.json";
    const nlohmann::json diagnosis =
        fs::exists(first) ? nlohmann::json::parse(read_text(first), nullptr, false) : nlohmann::json();
    if (diagnosis.is_object() && diagnosis.value("verdict", "") == "set") {
      const SealedCampaign sealed = draw_campaign(plans[i], set.seed);
      const std::optional<FurtherDwell> proposal = proposal_of(diagnosis, sealed.specimen.dwells.size());
      ++sets;
      if (proposal) {
        ++proposed;
        Random random(set.seed, 2'000'000 + plans[i].number);
        const FurtherDwell compared = random_dwell(sealed.specimen, proposal->length, random);
        for (const std::string which : follow_ups) {
          const bool asked = which == std::string(follow_ups[0]);
          const fs::path target = follow_up_folder(place, which);
          if (fs::exists(target / "diagnosis" / "diagnosis.json")) continue;
          std::error_code ignored;
          fs::remove_all(target, ignored);
          make_folder(target);
          write_extended_campaign(sealed, set.seed, asked ? *proposal : compared, place / "campaign",
                                  target / "campaign");
          if (const std::optional<std::string> fault = diagnoser.run(place, target / "campaign", target))
            failures.add(plans[i].number, which + ": " + *fault);
        }
      }
    }
    if (progress) progress(++done, plans.size());
  });
  summary.sets = sets;
  summary.proposed = proposed;
  summary.failed = failures.by_number();
  return summary;
}

}  // namespace secular::blind
