#include "measure/modal/survey_bands.hpp"

#include <algorithm>
#include <list>
#include <optional>

#include "measure/modal/survey_decays.hpp"
#include "measure/modal/survey_poles.hpp"

namespace secular {
namespace {

using Eigen::Index;

constexpr Index rate_step = 4;

/// Of a band's sample rate: highest frequency that is looked for, 0.8 of half of it.
constexpr double usable_share = 0.4;

/// Of a limit, by which bands overlap.
constexpr double overlap = 0.05;

Index longest_of(const SurveyRecords& records) {
  Index rows = 0;
  for (const DecaySummary& decay : records.decays()) rows = std::max(rows, decay.rows);
  return rows;
}

// The same survey of one band, with nothing found yet, and its records.
struct BandOfSurvey {
  BandOfSurvey(const ModalSurvey& whole, const SurveyBand& band) {
    survey.campaign = whole.campaign;
    survey.options = whole.options;
    survey.options.lowest_hz = band.lowest_hz;
    survey.options.highest_hz = band.highest_hz;
    records.emplace(survey, ShortDecays::left_out);
  }
  BandOfSurvey(const BandOfSurvey&) = delete;
  BandOfSurvey& operator=(const BandOfSurvey&) = delete;

  ModalSurvey survey;
  std::optional<SurveyRecords> records;
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// The survey holds the bands that are slower.
void take(ModalSurvey& survey, ModalSurvey& band) {
  for (ModeWindow& window : band.windows) window.mode += static_cast<Index>(survey.modes.size());
  append(survey.windows, band.windows);
  append(survey.modes, band.modes);
  append(survey.dropped, band.dropped);
  append(survey.diagram.poles, band.diagram.poles);
  append(survey.diagram.modes, band.diagram.modes);
  append(survey.diagram.others, band.diagram.others);
  append(survey.warnings, band.warnings);
  survey.window_s = band.window_s;
  survey.spectrum_hz = band.spectrum_hz;
  survey.spectrum = band.spectrum;
}

}  // namespace

std::vector<SurveyBand> survey_bands(Index rows, double rate_hz, double lowest_hz, double highest_hz) {
  std::vector<SurveyBand> bands{{lowest_hz, highest_hz}};
  while (rows > most_decay_rows) {
    rows /= rate_step;
    rate_hz /= static_cast<double>(rate_step);
    const double limit = usable_share * rate_hz;
    if (limit <= lowest_hz) break;
    bands.back().lowest_hz = (1 - overlap) * limit;
    bands.push_back({lowest_hz, limit});
  }
  std::reverse(bands.begin(), bands.end());
  return bands;
}

void survey_decays(ModalSurvey& survey, SurveyRecords& records) {
  if (!survey.references.empty()) return follow_decays(survey, records, 0);
  const std::vector<SurveyBand> bands = survey_bands(longest_of(records), records.decays().front().sample_rate_hz,
                                                     survey.options.lowest_hz, survey.options.highest_hz);
  if (bands.size() == 1) {
    find_poles(survey, records, {});
    keep_strongest({&survey.diagram}, survey.options.modes);
    return follow_decays(survey, records, 0);
  }
  std::list<BandOfSurvey> parts;
  std::vector<StableMode> found;
  std::vector<StabilisationDiagram*> diagrams;
  for (const SurveyBand& band : bands) {
    BandOfSurvey& part = parts.emplace_back(survey, band);
    if (part.records->decays().empty()) continue;
    find_poles(part.survey, *part.records, found);
    append(found, part.survey.diagram.modes);
    diagrams.push_back(&part.survey.diagram);
  }
  keep_strongest(diagrams, survey.options.modes);
  for (BandOfSurvey& part : parts) {
    if (part.records->decays().empty()) continue;
    part.survey.warnings.clear();
    follow_decays(part.survey, *part.records, survey.modes.size());
    take(survey, part.survey);
  }
}

}  // namespace secular
