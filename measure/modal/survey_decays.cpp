#include "measure/modal/survey_decays.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "input/input_error.hpp"
#include "measure/modal/pole.hpp"
#include "measure/modal/survey_poles.hpp"
#include "measure/signal/transform_length.hpp"
#include "numerics/fourier_transform.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Adds up the power spectra of the decays as they come.
class DecaySpectrum {
 public:
  explicit DecaySpectrum(const std::vector<DecaySummary>& decays) : rate_(decays.front().sample_rate_hz) {
    for (const DecaySummary& decay : decays) samples_ = std::min(samples_, cut_transform_length(decay.rows));
    power_ = VectorXd::Zero(samples_ / 2 + 1);
  }

  void add(const MatrixXd& decay) {
    for (Index c = 0; c < decay.cols(); ++c) {
      VectorXd column = decay.col(c).head(samples_);
      column.array() -= column.mean();
      for (Index i = 0; i < samples_; ++i)
        column(i) *= 1 - std::cos(two_pi * (static_cast<double>(i) + 0.5) / static_cast<double>(samples_));
      power_ += half_spectrum(column).cwiseAbs2();
      ++count_;
    }
  }

  void store(ModalSurvey& survey) const {
    const Index lines = power_.size();
    survey.spectrum_hz =
        VectorXd::LinSpaced(lines, 0, static_cast<double>(lines - 1)) * (rate_ / static_cast<double>(samples_));
    survey.spectrum = (power_ / count_).cwiseSqrt() * (2 / static_cast<double>(samples_));
  }

 private:
  Index samples_ = std::numeric_limits<Index>::max();
  double rate_, count_ = 0;
  VectorXd power_;
};

// Noise fills all rows of a Hankel matrix, a motion only those before it is over: what lasts a quarter of the rows
// and less stands out better without the others. Of heads a quarter as long each time, down to those of which a
// matrix of the largest order is square, the poles that are over in them (a time constant below a quarter) and that
// longer ones do not show.
void add_short_lived(ModalSurvey& survey, const MotionsBeside& beside, Index rows) {
  StabilisationDiagram& all = survey.diagram;
  const auto references = static_cast<Index>(beside.count());
  const Index least = 4 * (survey.options.largest_order + references - 1) / references;
  for (rows /= 4; rows >= std::max<Index>(least, 4); rows /= 4) {
    const FreeMotions head = beside.motions(rows);
    const double quarter_s = static_cast<double>(head.samples.rows()) / head.sample_rate_hz / 4;
    StabilisationDiagram found = diagram_of(survey, as_references(head), head.sample_rate_hz, false);
    const auto take = [&](std::vector<StableMode>& from, std::vector<StableMode>& to) {
      for (StableMode& mode : from) {
        const auto same = [&](const StableMode& known) { return same_pole(known, mode, all.options); };
        const bool over = std::abs(mode.pole.real()) * quarter_s > 1;
        if (over && std::none_of(all.modes.begin(), all.modes.end(), same) &&
            std::none_of(all.others.begin(), all.others.end(), same))
          to.push_back(std::move(mode));
      }
    };
    take(found.modes, all.modes);
    take(found.others, all.others);
  }
  for (std::vector<StableMode>* list : {&all.modes, &all.others})
    std::sort(list->begin(), list->end(), [](const StableMode& a, const StableMode& b) {
      return natural_frequency(a.pole) < natural_frequency(b.pole);
    });
}

// Within both resonances together: of one record the same mode, seen in two bands.
bool is_one_of(const StableMode& mode, const std::vector<StableMode>& known) {
  return std::any_of(known.begin(), known.end(), [&](const StableMode& other) {
    const Complex pole = other.support.pole;
    return std::abs(mode.pole - pole) < std::abs(mode.pole.real()) + std::abs(pole.real());
  });
}

// What stands in slower bands is fitted along, from there.
void take_slower(StabilisationDiagram& diagram, const std::vector<StableMode>& slower) {
  for (std::vector<StableMode>* list : {&diagram.modes, &diagram.others})
    std::erase_if(*list, [&](const StableMode& mode) { return is_one_of(mode, slower); });
  for (const StableMode& mode : slower) {
    diagram.others.push_back(mode);
    diagram.others.back().pole = mode.support.pole;
  }
}

// Long enough that the slowest mode loses a fifth and the lowest swings eight times; a quarter of the shortest
// decay at most.
double chosen_window(const ModalSurvey& survey, const SurveyRecords& records) {
  double periods = 0, loss = 0, limit = std::numeric_limits<double>::infinity();
  for (const SurveyMode& mode : survey.modes) {
    periods = std::max(periods, 8 / mode.natural_frequency_hz);
    loss = std::max(loss, 0.25 / std::max(1e-12, std::abs(mode.pole.real())));
  }
  double least = 0;
  for (const DecaySummary& decay : records.decays()) {
    limit = std::min(limit, 0.25 * static_cast<double>(decay.rows) / decay.sample_rate_hz);
    least = static_cast<double>(12 + 8 * survey.modes.size()) / decay.sample_rate_hz;
  }
  return std::max(least, std::min(limit, std::max(periods, loss)));
}

// Modes that stand but were not asked for move in the windows all the same: the strongest of them are fitted along,
// as many as a third of the window's samples determines.
void add_others(const ModalSurvey& survey, double rate, std::vector<Complex>& poles) {
  std::vector<StableMode> others = survey.diagram.others;
  std::sort(others.begin(), others.end(),
            [](const StableMode& a, const StableMode& b) { return a.strength > b.strength; });
  const double fits = survey.modes.front().window_s * rate / 12;
  for (const StableMode& mode : others)
    if (static_cast<double>(poles.size()) + 1 < fits) poles.push_back(mode.support.pole);
}

// Whether the line through a mode's windows speaks of that mode: it is known to better than the resonance is wide,
// and no other mode is nearer.
bool follows(const ModalSurvey& survey, std::size_t r, const AmplitudeDependence& line) {
  const Complex pole = survey.modes[r].diagram.support.pole;
  const double bandwidth_hz = 2 * std::abs(pole.real()) * to_hz;
  if (!(std::max(line.frequency_law.intercept_sd, line.damping_law.intercept_sd) < bandwidth_hz)) return false;
  const Complex found(line.damping_law.at(0) / to_hz, line.frequency_law.at(0) / to_hz);
  return std::none_of(survey.modes.begin(), survey.modes.end(), [&](const SurveyMode& other) {
    return std::abs(found - other.diagram.support.pole) < std::abs(found - pole);
  });
}

// The values of the one fit over all samples are the better estimate where neither these, Eq. (M5), nor the windows
// tell a change with amplitude: windows lose the phase from one to the next.
void take_values(SurveyMode& mode, const AmplitudeDependence& dependence) {
  const AmplitudeLaw &frequency = dependence.frequency_law, &damping = dependence.damping_law;
  const PoleSupport& support = mode.diagram.support;
  const bool windows_constant =
      frequency.degree == 0 && damping.degree == 0 && !frequency.excess && !damping.excess;
  if (support.stands && (windows_constant || support.all_constant)) {
    mode.from = "maximum likelihood over the free motions, in their own noise; no change with amplitude";
    return;
  }
  mode.natural_frequency_hz = dependence.natural_frequency_hz;
  mode.natural_frequency_sd_hz = dependence.natural_frequency_sd_hz;
  mode.damping_ratio = dependence.damping_ratio;
  mode.damping_ratio_sd = dependence.damping_ratio_sd;
  mode.pole = {damping.at(0) / to_hz, frequency.at(0) / to_hz};
  mode.degrees_of_freedom = dependence.degrees_of_freedom;
  mode.from = "regression over windows to zero amplitude";
}

// Of the survey's modes, beside all poles, which begin with theirs.
void find_windows(ModalSurvey& survey, SurveyRecords& records, const std::vector<Complex>& poles,
                  const ModeWindowOptions& options, WindowMisfit misfit) {
  for (std::size_t i = 0; i < records.decays().size(); ++i) {
    const SurveyDecay& decay = records.decay(i);
    const std::size_t record = records.decays()[i].record;
    const bool fits =
        window_fits(decay.samples.rows(), decay.sample_rate_hz, static_cast<Index>(poles.size()), options.length_s);
    if (!fits && misfit == WindowMisfit::warned) {
      survey.windows.clear();
      survey.warnings.push_back(fmt::format(
          "a window of {:.4g} s does not fit {} modes below {:.4g} Hz: choose another --window for them",
          options.length_s, poles.size(), survey.options.highest_hz));
      return;
    }
    if (!fits)
      throw InputError(
          (survey.campaign.folder / survey.campaign.records[record].file).string(), "",
          fmt::format("a window of {:.4g} s does not fit {} modes and the record", options.length_s, poles.size()),
          "choose another --window, or fewer --modes");
    for (ModeWindow& window : mode_windows(decay.samples, decay.sample_rate_hz, poles, options)) {
      if (window.mode >= static_cast<Index>(survey.modes.size())) continue;
      window.record = record;
      window.centre_s += decay.start_s;
      survey.windows.push_back(std::move(window));
    }
  }
}

}  // namespace

void find_poles(ModalSurvey& survey, const SurveyRecords& records, const std::vector<StableMode>& slower) {
  // Decays of one structure resemble each other: many of them would fill the Hankel matrix with repetitions in the
  // place of delays. A few, spread over the campaign, show every mode.
  constexpr std::size_t most_decays = 8;
  const std::vector<DecaySummary>& decays = records.decays();
  const std::size_t count = std::min(decays.size(), most_decays);
  MotionsBeside beside;
  for (std::size_t j = 0; j < count; ++j) {
    const DecaySummary& decay = decays[j * decays.size() / count];
    beside.add(decay.head, decay.sample_rate_hz, survey.campaign.records[decay.record].group, decay.to_the_end);
  }
  // As many rows as the Hankel matrix can take, from where every mode still moves.
  const auto p = static_cast<Index>(survey.channels.size());
  const FreeMotions motions = beside.motions(4000 / p + 2 * survey.options.largest_order);
  survey.diagram = diagram_of(survey, as_references(motions), motions.sample_rate_hz, false);
  add_short_lived(survey, beside, motions.samples.rows());
  take_slower(survey.diagram, slower);
  keep_supported(survey, beside.motions());
  // Poles of slower bands are not this one's to drop.
  std::erase_if(survey.dropped, [&](const DroppedPole& dropped) {
    return std::any_of(slower.begin(), slower.end(),
                       [&](const StableMode& mode) { return mode.support.pole == dropped.pole; });
  });
}

void store_spectrum(ModalSurvey& survey, SurveyRecords& records) {
  DecaySpectrum spectrum(records.decays());
  for (std::size_t i = 0; i < records.decays().size(); ++i) spectrum.add(records.decay(i).samples);
  spectrum.store(survey);
}

void follow_decays(ModalSurvey& survey, SurveyRecords& records, WindowMisfit misfit) {
  const bool alone = survey.references.empty();
  if (alone)
    for (const StableMode& stable : survey.diagram.modes) survey.modes.push_back(begin_mode(stable));
  if (survey.modes.empty()) return;
  ModeWindowOptions options;
  options.length_s = survey.options.window_s > 0 ? survey.options.window_s : chosen_window(survey, records);
  options.overlap = survey.options.overlap;
  for (SurveyMode& mode : survey.modes) mode.window_s = options.length_s;
  std::vector<Complex> poles;
  for (const SurveyMode& mode : survey.modes) poles.push_back(mode.pole);
  if (alone) add_others(survey, records.decays().front().sample_rate_hz, poles);
  find_windows(survey, records, poles, options, misfit);
  for (std::size_t r = 0; r < survey.modes.size(); ++r) {
    SurveyMode& mode = survey.modes[r];
    const AmplitudeDependence dependence =
        amplitude_dependence(survey.windows, static_cast<Index>(r), survey.options.fit_below);
    if (dependence.windows < 3) {
      mode.remarks.push_back(
          "seen in fewer than three windows: the values are those of one fit to the beginning of the records, "
          "whatever "
          "the amplitude; a narrower --band or another --window may help");
      continue;
    }
    if (!alone) {
      mode.amplitude = dependence;
      continue;
    }
    if (!follows(survey, r, dependence)) {
      mode.remarks.push_back(
          "not followed by its windows: the values are those of one fit to the beginning of the records, whatever "
          "the "
          "amplitude; a narrower --band or another --window may help");
      continue;
    }
    mode.amplitude = dependence;
    mode.shape = mean_shape(survey.windows, static_cast<Index>(r));
    take_values(mode, dependence);
    if (!mode.frequency_interval_hz())
      mode.remarks.push_back(
          "windows scatter by more than their noise, and too few determine by how much: the values have no "
          "interval; a "
          "shorter --window or more records would give one");
    if (dependence.frequency_hz.curvature_p < 0.05 || dependence.damping_factor_hz.curvature_p < 0.05)
      mode.remarks.push_back(
          fmt::format("{} against amplitude is no straight line; --fit-below keeps to small amplitudes",
                      dependence.frequency_hz.curvature_p < 0.05 ? "frequency" : "damping"));
  }
}

}  // namespace secular
