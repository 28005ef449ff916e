#include "blind/score_set.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "blind/case_files.hpp"
#include "blind/follow_up.hpp"
#include "blind/sealed_set.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

Said said_of(const fs::path& place) {
  Said said;
  const fs::path diagnosis = place / "diagnosis" / "diagnosis.json", run = place / "run.json";
  if (fs::exists(diagnosis)) said = what_was_said(nlohmann::json::parse(read_text(diagnosis), nullptr, false));
  if (fs::exists(run)) {
    const nlohmann::json how = nlohmann::json::parse(read_text(run), nullptr, false);
    if (how.is_object()) said.seconds = how.value("seconds", 0.0);
  }
  for (const char* const which : follow_ups) {
    const fs::path after = follow_up_folder(place, which) / "diagnosis" / "diagnosis.json";
    if (!fs::exists(after)) continue;
    const Said then = what_was_said(nlohmann::json::parse(read_text(after), nullptr, false));
    said.named_after[which] = then.verdict == "cause" ? then.cause : "";
  }
  return said;
}

}  // namespace

Score score_set(const fs::path& folder) {
  const nlohmann::json labels = read_labels(folder);
  std::vector<Said> said;
  for (const nlohmann::json& label : labels.at("labels"))
    said.push_back(said_of(case_folder(folder, label.at("case").get<std::size_t>())));
  return score_of(labels, said);
}

void write_score(const Score& score, const std::string& set_name, const fs::path& page) {
  fs::create_directories(page);
  write_text(page / "score.json", score_json(score).dump(1) + "\n");
  write_text(page / "calibration.svg", calibration_svg(score.calibration));
  write_text(page / "score.md", score_markdown(score, set_name));
}

std::string name_of_set(const fs::path& folder) {
  const nlohmann::json labels = read_labels(folder);
  return fmt::format("{} set of {} cases, seed {}", labels.at("set").get<std::string>(),
                     labels.at("cases").get<std::size_t>(), labels.at("seed").get<std::uint64_t>());
}

}  // namespace secular::blind
