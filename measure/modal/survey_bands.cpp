#include "measure/modal/survey_bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <optional>

#include "measure/modal/survey_decays.hpp"
#include "measure/modal/survey_poles.hpp"

namespace secular {
namespace {

using Eigen::Index;

/// From band to band. What a band finds depends on it only near its limits.
constexpr Index rate_step = 4;

/// Of a band's sample rate: what passes decimate() unchanged, 0.8 of half of it (decimation_factor()).
constexpr double usable_share = 0.4;

/// Of a limit, by which bands overlap: a mode on it is within its error bar of it in both.
constexpr double overlap = 0.05;

const DecaySummary& longest_of(const std::vector<DecaySummary>& decays) {
  return *std::max_element(decays.begin(), decays.end(), [](const DecaySummary& a, const DecaySummary& b) {
    return static_cast<double>(a.rows) / a.sample_rate_hz < static_cast<double>(b.rows) / b.sample_rate_hz;
  });
}

// The same survey of one band, with nothing found yet, and its records: those of the whole band where it reaches up
// to its end.
struct BandOfSurvey {
  BandOfSurvey(const ModalSurvey& whole, SurveyRecords& of_whole, const SurveyBand& band) : records(&of_whole) {
    survey.campaign = whole.campaign;
    survey.options = whole.options;
    survey.options.lowest_hz = band.lowest_hz;
    survey.options.highest_hz = band.highest_hz;
    if (band.highest_hz == whole.options.highest_hz) {
      survey.channels = whole.channels;
      survey.form = whole.form;
      survey.unit = whole.unit;
    } else {
      records = &own.emplace(survey, of_whole);
    }
  }
  BandOfSurvey(const BandOfSurvey&) = delete;
  BandOfSurvey& operator=(const BandOfSurvey&) = delete;

  ModalSurvey survey;
  std::optional<SurveyRecords> own;
  SurveyRecords* records;
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
}

// The survey of several bands.
void survey_several(ModalSurvey& survey, SurveyRecords& records, const std::vector<SurveyBand>& bands) {
  std::list<BandOfSurvey> parts;
  std::vector<StableMode> found;
  std::vector<StabilisationDiagram*> diagrams;
  for (const SurveyBand& band : bands) {
    BandOfSurvey& part = parts.emplace_back(survey, records, band);
    const std::size_t before = parts.size() - 1, count = bands.size();
    if (survey.options.progress)
      part.survey.options.progress = [&survey, before, count](std::size_t done, std::size_t total) {
        survey.options.progress((before * total + done) / count, total);
      };
    const std::size_t short_ones = records.decays().size() - part.records->decays().size();
    if (short_ones > 0)
      survey.warnings.push_back(fmt::format("{} of {} records are too short for modes below {:.4g} Hz", short_ones,
                                            records.decays().size(), band.highest_hz));
    if (part.records->decays().empty()) continue;
    find_poles(part.survey, *part.records, found);
    append(found, part.survey.diagram.modes);
    append(found, part.survey.diagram.no_resonances);
    diagrams.push_back(&part.survey.diagram);
  }
  keep_strongest(diagrams, survey.options.modes);
  for (BandOfSurvey& part : parts) {
    if (part.records->decays().empty()) continue;
    follow_decays(part.survey, *part.records, WindowMisfit::warned);
    take(survey, part.survey);
  }
}

}  // namespace

std::vector<SurveyBand> survey_bands(Index rows, double rate_hz, double lowest_hz, double highest_hz) {
  std::vector<SurveyBand> bands{{lowest_hz, highest_hz}};
  while (rows > most_decay_rows) {
    rows /= rate_step;
    rate_hz /= static_cast<double>(rate_step);
    const double limit = usable_share * rate_hz;
    if (limit <= lowest_hz) break;
    if (highest_hz > 0 && limit >= highest_hz) continue;
    bands.back().lowest_hz = (1 - overlap) * limit;
    bands.push_back({lowest_hz, limit});
  }
  std::reverse(bands.begin(), bands.end());
  return bands;
}

void survey_decays(ModalSurvey& survey, SurveyRecords& records) {
  if (!survey.references.empty()) return follow_decays(survey, records);
  const DecaySummary& longest = longest_of(records.decays());
  const std::vector<SurveyBand> bands =
      survey_bands(longest.rows, longest.sample_rate_hz, survey.options.lowest_hz, survey.options.highest_hz);
  if (bands.size() == 1) {
    find_poles(survey, records, {});
    keep_strongest({&survey.diagram}, survey.options.modes);
    follow_decays(survey, records);
  } else {
    survey_several(survey, records, bands);
  }
  store_spectrum(survey, records);
}

}  // namespace secular
