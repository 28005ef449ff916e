#include "blind/score_set.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "blind/follow_up.hpp"
#include "blind/leave_out.hpp"
#include "blind/sealed_files.hpp"
#include "blind/sealed_set.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;

// What the diagnosis below `folder` says; nothing where there is none.
std::optional<Said> said_below(const fs::path& folder) {
  const fs::path diagnosis = folder / "diagnosis" / "diagnosis.json";
  if (!fs::exists(diagnosis)) return std::nullopt;
  return what_was_said(nlohmann::json::parse(read_text(diagnosis), nullptr, false));
}

Said said_of(const fs::path& place) {
  Said said = said_below(place).value_or(Said{});
  const fs::path run = place / "run.json";
  if (fs::exists(run)) {
    const nlohmann::json how = nlohmann::json::parse(read_text(run), nullptr, false);
    if (how.is_object()) said.seconds = how.value("seconds", 0.0);
  }
  for (const char* const which : follow_ups)
    if (const std::optional<Said> then = said_below(follow_up_folder(place, which)))
      said.named_after[which] = then->verdict == "cause" ? then->cause : "";
  if (const std::optional<Said> without = said_below(left_out_folder(place));
      without && fs::exists(look_alikes_file(place))) {
    const nlohmann::json rest = nlohmann::json::parse(read_text(look_alikes_file(place)), nullptr, false);
    if (rest.is_array()) {
      said.verdict_without = without->verdict;
      said.explained_by_rest = rest.get<std::vector<std::string>>();
    }
  }
  return said;
}

}  // namespace

Score score_set(const fs::path& folder) {
  const nlohmann::json labels = read_labels(folder);
  std::vector<Said> said;
  for (const nlohmann::json& label : labels.at("labels"))
    said.push_back(said_of(sealed_folder(folder, label.at("case").get<std::size_t>())));
  return score_of(labels, said);
}

void write_score(const Score& score, const std::string& set_name, const fs::path& page) {
  make_folder(page);
  write_text(page / "score.json", score_json(score).dump(1) + "\n");
  write_text(page / "calibration.svg", calibration_svg(score.calibration));
  write_text(page / "score.md", score_markdown(score, set_name));
}

std::string name_of_set(const fs::path& folder) {
  const nlohmann::json labels = read_labels(folder);
  return fmt::format("{} set of {} campaigns, seed {}{}", labels.at("set").get<std::string>(),
                     labels.at("cases").get<std::size_t>(), labels.at("seed").get<std::uint64_t>(),
                     labels.value("disturbed", false) ? ", disturbed records" : "") +
         (labels.value("nothing_withheld", false) ? ", nothing withheld" : "");
}

}  // namespace secular::blind
