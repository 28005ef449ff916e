#include "blind/campaign_work.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <stdexcept>
#include <utility>

namespace secular::blind {
namespace {

Crew& crew() {
  static Crew other_processes;
  return other_processes;
}

}  // namespace

void set_crew(Crew other_processes) {
  crew() = std::move(other_processes);
}

Performer performer_of(const CampaignWork& work) {
  static const std::map<std::string, Performer (*)(const CampaignWork&)> performers = {{"generate", generating},
                                                                                       {"run", running},
                                                                                       {"follow", following},
                                                                                       {"leave_out", leaving_out},
                                                                                       {"identify", identifying}};
  return performers.at(work.kind)(work);
}

std::string text_of(const CampaignWork& work) {
  return Answer{{"kind", work.kind},           {"folder", work.folder.string()},
                {"set", heading(work.set)},    {"program", work.how.program.string()},
                {"threads", work.how.threads}, {"limit_s", work.how.limit_s}}
      .dump();
}

CampaignWork work_of(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text);
  CampaignWork work;
  work.kind = json.at("kind").get<std::string>();
  work.folder = json.at("folder").get<std::string>();
  work.set = options_of_heading(json.at("set"), work.folder);
  work.how = {json.at("program").get<std::string>(), json.at("threads").get<unsigned>(),
              json.at("limit_s").get<double>()};
  return work;
}

std::vector<Answer> for_all_campaigns(const CampaignWork& work, std::size_t count, const Progress& progress) {
  if (crew()) return crew()(work, count, progress);
  const Performer perform = performer_of(work);
  std::vector<Answer> answers(count);
  std::atomic<std::size_t> done{0};
  in_parallel(count, work.how.threads, [&](std::size_t i) {
    answers[i] = perform(i);
    if (progress) progress(++done, count);
  });
  return answers;
}

std::vector<FailedCampaign> failed_of(const std::vector<Answer>& answers) {
  std::vector<FailedCampaign> failed;
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (answers[i].contains("faults"))
      for (const Answer& fault : answers[i]["faults"]) failed.push_back({i + 1, fault.get<std::string>()});
  return failed;
}

std::size_t count_of(const std::vector<Answer>& answers, const char* key) {
  return static_cast<std::size_t>(
      std::count_if(answers.begin(), answers.end(), [key](const Answer& answer) { return answer.contains(key); }));
}

}  // namespace secular::blind
