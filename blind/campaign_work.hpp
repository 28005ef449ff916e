#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "blind/run_options.hpp"
#include "blind/sealed_campaign.hpp"
#include "blind/sealed_set.hpp"

namespace secular::blind {

/// What is done to every campaign of a set, each by itself: any process that sees the folder can do its part.
struct CampaignWork {
  std::string kind;  ///< generate, run, follow, leave_out or identify
  std::filesystem::path folder;
  SetOptions set;
  RunOptions how;
};

/// What came of one campaign: its label where it is made, else what is counted and what went wrong.
using Answer = nlohmann::ordered_json;

/// Does the work on plan `index` of the set. From any thread.
using Performer = std::function<Answer(std::size_t index)>;
Performer performer_of(const CampaignWork& work);

/// The same work as text, for another process.
std::string text_of(const CampaignWork& work);
CampaignWork work_of(const std::string& text);

/// Answers of campaigns 0 to count - 1, whoever does them and in whatever order. The first exception ends it.
std::vector<Answer> for_all_campaigns(const CampaignWork& work, std::size_t count, const Progress& progress);

/// Who does it: without a crew the threads of this process. Set before any work.
using Crew = std::function<std::vector<Answer>(const CampaignWork&, std::size_t count, const Progress&)>;
void set_crew(Crew crew);

/// Of every answer with "faults": its number and what they are.
std::vector<FailedCampaign> failed_of(const std::vector<Answer>& answers);
/// Answers that hold `key`.
std::size_t count_of(const std::vector<Answer>& answers, const char* key);

/// Of one kind each, in the file of its command.
Performer generating(const CampaignWork& work);
Performer running(const CampaignWork& work);
Performer following(const CampaignWork& work);
Performer leaving_out(const CampaignWork& work);
Performer identifying(const CampaignWork& work);

}  // namespace secular::blind
