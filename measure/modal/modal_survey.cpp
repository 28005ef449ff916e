#include "measure/modal/modal_survey.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "measure/data/campaign_text.hpp"
#include "measure/modal/modal_assurance.hpp"
#include "measure/modal/modal_mass.hpp"
#include "measure/modal/mode_scaling.hpp"
#include "measure/modal/pole.hpp"
#include "measure/modal/pole_fit.hpp"
#include "measure/modal/survey_bands.hpp"
#include "measure/modal/survey_poles.hpp"
#include "measure/modal/survey_records.hpp"
#include "measure/modal/survey_tones.hpp"
#include "measure/signal/transform_length.hpp"
#include "numerics/confidence.hpp"
#include "numerics/fourier_transform.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

// The decay that an exponential window needs so that the responses end three decades below their largest value.
double chosen_decay(SurveyRecords& records) {
  double decay = 0;
  for (const SurveyImpacts& group : records.impacts())
    for (const ImpactPlace& place : group.places) {
      const ImpactBlock block = records.impact(place);
      const Index tail = std::max<Index>(1, block.responses.rows() / 20);
      const double duration = static_cast<double>(block.responses.rows()) / records.impact_rate_hz();
      for (Index c = 0; c < block.responses.cols(); ++c) {
        const double largest = block.responses.col(c).cwiseAbs().maxCoeff();
        if (!(largest > 0)) continue;
        const double left = std::sqrt(block.responses.col(c).tail(tail).squaredNorm() / static_cast<double>(tail));
        decay = std::max(decay, std::log(1e3 * left / largest) / duration);
      }
    }
  return decay;
}

// Lines x (responses of every reference side by side).
MatrixXcd side_by_side(const std::vector<SurveyReference>& references) {
  const Index p = references.front().response.h1.cols();
  MatrixXcd all(references.front().response.h1.rows(), p * static_cast<Index>(references.size()));
  for (std::size_t q = 0; q < references.size(); ++q)
    all.middleCols(static_cast<Index>(q) * p, p) = references[q].response.h1;
  return all;
}

// What the lines of the band say of the modes: poles (windows' decay taken off), shapes, masses.
struct ImpactModes {
  VectorXcd poles;
  std::vector<VectorXcd> shapes;
  std::vector<std::vector<MassEstimate>> masses;
  std::vector<std::optional<double>> mass;
};

ImpactModes modes_of_lines(const ModalSurvey& survey, const std::vector<SurveyReference>& references,
                           const VectorXcd& start) {
  const ResponseForm form = survey.form;
  const double lowest_hz = survey.options.lowest_hz, highest_hz = survey.options.highest_hz;
  const FrequencyResponse& first = references.front().response;
  const double decay = first.windows.decay;
  const Index lines = first.frequency_hz.size();
  const double spacing = first.frequency_hz(1);
  const double top = highest_hz > 0 ? highest_hz : 0.8 * first.frequency_hz(lines - 1);
  const Index low = std::max<Index>(1, static_cast<Index>(std::ceil(lowest_hz / spacing)));
  const Index high = std::min<Index>(lines - 1, static_cast<Index>(std::floor(top / spacing)));
  const MatrixXcd all = side_by_side(references).middleRows(low, high - low + 1);
  const VectorXd omega = first.frequency_hz.segment(low, high - low + 1) / to_hz;
  const PoleFit fit = refine_poles(omega, all, form, (start.array() - decay).matrix());
  ImpactModes result;
  result.poles = (fit.poles.array() + decay).matrix();
  const Index p = first.h1.cols(), q = static_cast<Index>(references.size());
  for (Index r = 0; r < fit.poles.size(); ++r) {
    const Complex pole = result.poles(r);
    MatrixXcd residue(p, q);  // of the receptance, A_pqr
    for (Index j = 0; j < q; ++j)
      for (Index c = 0; c < p; ++c)
        residue(c, j) = convert_residue(fit.residues(r, j * p + c), pole, form, ResponseForm::receptance);
    const Eigen::JacobiSVD<MatrixXcd> svd(residue, Eigen::ComputeThinU);
    const VectorXcd leading = svd.matrixU().col(0);
    const VectorXcd shape = scale_shape(leading).shape;
    result.shapes.push_back(shape);
    std::vector<MassEstimate> estimates;
    double largest = 0;
    for (const SurveyReference& reference : references)
      if (reference.driving_channel >= 0)
        largest = std::max(largest, std::abs(shape(reference.driving_channel).real()));
    double sum = 0;
    int used = 0;
    for (Index j = 0; j < q; ++j) {
      const SurveyReference& reference = references[static_cast<std::size_t>(j)];
      if (reference.driving_channel < 0) continue;
      const Complex amplitude = shape.dot(residue.col(j)) / shape.squaredNorm();  // B(r, q) for C = shape
      const Complex driving = static_cast<double>(reference.sign) * shape(reference.driving_channel);
      const double mass = modal_mass(pole, driving, amplitude).real();
      // Eq. (2.7) divides by what the blow does to the mode: a point near a node tells nothing.
      const bool moves = std::abs(driving.real()) >= 0.3 * largest && mass > 0;
      estimates.push_back({reference.group, mass, moves});
      if (!moves) continue;
      sum += mass;
      ++used;
    }
    result.masses.push_back(std::move(estimates));
    // Eq. (2.7) holds for the scale of Eq. (2.2).
    result.mass.push_back(used > 0 && !squares_cancel(leading) ? std::optional<double>(sum / used) : std::nullopt);
  }
  return result;
}

// Sums over the impacts of every group.
std::vector<ImpactSpectra> sums_of(SurveyRecords& records, const ImpactWindows& windows) {
  std::vector<ImpactSpectra> sums(records.impacts().size());
  for (std::size_t g = 0; g < sums.size(); ++g)
    for (const ImpactPlace& place : records.impacts()[g].places)
      sums[g].add(impact_spectra(records.impact(place), records.impact_rate_hz(), windows));
  return sums;
}

std::vector<SurveyReference> references_of(const ModalSurvey& survey, const SurveyRecords& records,
                                           const std::vector<ImpactSpectra>& sums, const ImpactWindows& windows) {
  std::vector<SurveyReference> references;
  for (std::size_t g = 0; g < sums.size(); ++g) {
    SurveyReference reference;
    reference.group = records.impacts()[g].group;
    std::string channel = reference.group;
    if (const auto given = survey.options.driving_points.find(reference.group);
        given != survey.options.driving_points.end()) {
      channel = given->second.channel;
      reference.sign = given->second.sign;
    }
    for (std::size_t c = 0; c < survey.channels.size(); ++c)
      if (survey.campaign.channels[survey.channels[c]].name == channel)
        reference.driving_channel = static_cast<Index>(c);
    reference.response = frequency_response(sums[g], records.impact_rate_hz(), windows);
    references.push_back(std::move(reference));
  }
  return references;
}

void check_driving_points(const ModalSurvey& survey, const SurveyRecords& records) {
  for (const auto& [group, point] : survey.options.driving_points) {
    const bool known =
        std::any_of(records.impacts().begin(), records.impacts().end(),
                    [&, &name = group](const SurveyImpacts& impacts) { return impacts.group == name; });
    if (!known)
      throw InputError("--driving-point " + group + "=" + point.channel, "", "no impact record has this group",
                       "the `group` of [[record]], or 'impacts' where it has none");
    const bool response =
        std::any_of(survey.channels.begin(), survey.channels.end(),
                    [&, &at = point](std::size_t c) { return survey.campaign.channels[c].name == at.channel; });
    if (!response)
      throw InputError("--driving-point " + group + "=" + point.channel, "",
                       "'" + point.channel + "' is no response channel",
                       "name one, with - before it for a blow "
                       "against its positive sense");
  }
}

// Modes from all impacts but one, each in turn; a reference struck once or twice cannot spare one. `sums`: of all.
std::vector<ImpactModes> leaving_one_out(const ModalSurvey& survey, SurveyRecords& records,
                                         std::vector<ImpactSpectra> sums, const ImpactWindows& windows,
                                         const VectorXcd& poles) {
  std::vector<ImpactModes> without;
  for (std::size_t g = 0; g < sums.size(); ++g) {
    const std::vector<ImpactPlace>& places = records.impacts()[g].places;
    if (places.size() < 3) continue;
    const ImpactSpectra all_of_group = sums[g];
    for (const ImpactPlace& place : places) {
      sums[g].remove(impact_spectra(records.impact(place), records.impact_rate_hz(), windows));
      without.push_back(modes_of_lines(survey, references_of(survey, records, sums, windows), poles));
      sums[g] = all_of_group;
    }
  }
  return without;
}

// Standard deviation by the jackknife of what `value` says of the modes, `whole` for all impacts; 0 where none
// could be left out.
template <class Value>
double jackknife_sd(const std::vector<ImpactModes>& without, const Value& value, double whole) {
  const auto n = static_cast<double>(without.size());
  double square = 0;
  for (const ImpactModes& other : without) square += std::pow(value(other) - whole, 2);
  return n > 0 ? std::sqrt((n - 1) / n * square) : 0.0;
}

SurveyMode impact_mode(const StableMode& stable, const ImpactModes& found, std::size_t r,
                       const std::vector<ImpactModes>& without) {
  const auto row = static_cast<Index>(r);
  SurveyMode mode = begin_mode(stable);
  mode.shape = mean_shape(std::vector<VectorXcd>{found.shapes[r]});
  mode.masses = found.masses[r];
  mode.mass = found.mass[r];
  if (without.empty()) return mode;
  const auto sd = [&](const auto& value, double whole) { return jackknife_sd(without, value, whole); };
  if (!stable.support.stands) {  // nothing follows the blows
    mode.pole = found.poles(row);
    mode.natural_frequency_hz = natural_frequency(mode.pole) * to_hz;
    mode.damping_ratio = damping_ratio(mode.pole);
    mode.degrees_of_freedom = static_cast<double>(without.size() - 1);
    mode.from = "frequency responses; leaving out one impact at a time";
    mode.natural_frequency_sd_hz = sd([&](const ImpactModes& m) { return natural_frequency(m.poles(row)) * to_hz; },
                                      mode.natural_frequency_hz);
    mode.damping_ratio_sd =
        sd([&](const ImpactModes& m) { return damping_ratio(m.poles(row)); }, mode.damping_ratio);
  }
  mode.shape.windows = without.size();
  for (Index c = 0; c < mode.shape.mean.size(); ++c) {
    mode.shape.real_sd(c) =
        sd([&](const ImpactModes& m) { return m.shapes[r](c).real(); }, mode.shape.mean(c).real());
    mode.shape.imaginary_sd(c) =
        sd([&](const ImpactModes& m) { return m.shapes[r](c).imag(); }, mode.shape.mean(c).imag());
  }
  if (mode.mass)
    mode.mass_sd = sd([&](const ImpactModes& m) { return m.mass[r].value_or(*mode.mass); }, *mode.mass);
  return mode;
}

// What the swings show and the frequency responses do not: those of few blows, or of blows in a row, are the
// noisier.
void add_swinging(ModalSurvey& survey, const MotionsBeside& beside) {
  const auto p = static_cast<Index>(survey.channels.size());
  const FreeMotions motions = beside.motions(4000 / p + 2 * survey.options.largest_order);
  StabilisationDiagram found = diagram_of(survey, as_references(motions), motions.sample_rate_hz, false);
  StabilisationDiagram& all = survey.diagram;
  for (const auto& [from, to] : {std::pair(&found.modes, &all.modes), std::pair(&found.others, &all.others)})
    for (StableMode& mode : *from) {
      const auto same = [&](const StableMode& known) { return same_pole(known, mode, all.options); };
      if (std::none_of(all.modes.begin(), all.modes.end(), same) &&
          std::none_of(all.others.begin(), all.others.end(), same))
        to->push_back(std::move(mode));
    }
}

// The swings after the blows, or where they are many some of them, spread over the campaign: signals enough to tell
// noise from motion, and not so many that the fits take long.
void keep_supported_by_swings(ModalSurvey& survey, const SurveyRecords& records) {
  const std::vector<FreeSwing>& swings = records.swings();
  if (swings.empty()) {
    survey.warnings.push_back(
        "the records end with the blows: their poles could not be held against noise; give more time after them");
    return;
  }
  constexpr std::size_t most_signals = 64;
  const std::size_t most = std::max<std::size_t>(1, most_signals / survey.channels.size());
  const std::size_t count = std::min(most, swings.size());
  MotionsBeside beside;
  for (std::size_t i = 0; i < count; ++i) {
    const FreeSwing& swing = swings[i * swings.size() / count];
    beside.add(swing.head, swing.sample_rate_hz, swing.group, false);
  }
  add_swinging(survey, beside);
  keep_supported(survey, beside.motions());
}

void survey_impacts(ModalSurvey& survey, SurveyRecords& records) {
  check_driving_points(survey, records);
  const double decay = survey.options.response_decay ? *survey.options.response_decay : chosen_decay(records);
  const ImpactWindows impact_windows{survey.options.force_window_s, decay};
  std::vector<ImpactSpectra> sums = sums_of(records, impact_windows);
  survey.references = references_of(survey, records, sums, impact_windows);
  const FrequencyResponse& first = survey.references.front().response;
  const double nyquist = records.impact_rate_hz() / 2;
  const double top =
      survey.options.highest_hz > 0 ? std::min(nyquist, survey.options.highest_hz * 1.25) : 0.8 * nyquist;
  std::vector<MatrixXcd> lines;
  for (const SurveyReference& reference : survey.references) lines.push_back(reference.response.h1);
  const PulseResponse pulse = pulse_response(first.frequency_hz, lines, top);
  survey.diagram = diagram_of(survey, pulse.samples, pulse.sample_rate_hz, true);
  for (std::vector<StableMode>* list : {&survey.diagram.modes, &survey.diagram.others})
    for (StableMode& stable : *list) stable.pole += decay;
  for (StabilisationPole& pole : survey.diagram.poles) pole.pole += decay;
  keep_supported_by_swings(survey, records);
  keep_strongest({&survey.diagram}, survey.options.modes);
  const MatrixXcd all = side_by_side(survey.references);
  survey.spectrum_hz = first.frequency_hz;
  survey.spectrum = (all.cwiseAbs2().rowwise().sum() / static_cast<double>(all.cols())).cwiseSqrt();
  if (survey.diagram.modes.empty()) return;
  // Modes that nobody asked for are fitted too where their resonance lies on the lines.
  std::vector<Complex> fitted;
  const auto start_of = [](const StableMode& m) { return m.support.stands ? m.support.pole : m.pole; };
  for (const StableMode& stable : survey.diagram.modes) fitted.push_back(start_of(stable));
  for (const StableMode& stable : survey.diagram.others) {
    const double hz = natural_frequency(stable.pole) * to_hz;
    if (hz >= survey.options.lowest_hz && hz <= (survey.options.highest_hz > 0 ? survey.options.highest_hz : top))
      fitted.push_back(start_of(stable));
  }
  const VectorXcd start = Eigen::Map<const VectorXcd>(fitted.data(), static_cast<Index>(fitted.size()));
  const ImpactModes found = modes_of_lines(survey, survey.references, start);
  const std::vector<ImpactModes> without =
      leaving_one_out(survey, records, std::move(sums), impact_windows, found.poles);
  for (std::size_t r = 0; r < survey.diagram.modes.size(); ++r)
    survey.modes.push_back(impact_mode(survey.diagram.modes[r], found, r, without));
}

void give_masses(ModalSurvey& survey) {
  const std::vector<double>& masses = survey.options.modal_masses;
  if (masses.empty()) return;
  if (masses.size() != survey.modes.size())
    throw InputError("--modal-mass", "", fmt::format("{} masses for {} modes", masses.size(), survey.modes.size()),
                     "one for every mode, in order of frequency; --band and --modes choose the modes");
  for (std::size_t r = 0; r < masses.size(); ++r) {
    if (!(masses[r] > 0) || !std::isfinite(masses[r]))
      throw InputError("--modal-mass", "", fmt::format("{} is not positive", masses[r]), "a mass in kg");
    survey.modes[r].mass = masses[r];
    survey.modes[r].mass_sd = 0;
  }
}

void remark_on_excess(ModalSurvey& survey) {
  for (SurveyMode& mode : survey.modes)
    if (mode.leaves_more_than_noise())
      mode.remarks.push_back(
          "one damped motion leaves more than noise: there may be two modes, or one that changes with amplitude; "
          "error "
          "bars hold a part along its motion as large as the one that is seen");
}

std::string nothing_stands(const ModalSurvey& survey) {
  if (survey.dropped.empty()) return "no mode stands in the stabilisation diagram";
  std::string list;
  for (const DroppedPole& dropped : survey.dropped)
    list += fmt::format("{}{:.4g} Hz {}", list.empty() ? "" : "; ", natural_frequency(dropped.pole) * to_hz,
                        dropped.reason);
  return "no pole of the stabilisation diagram stands out of the noise: " + list;
}

void remark_on_whirling(ModalSurvey& survey) {
  for (SurveyMode& mode : survey.modes)
    if (squares_cancel(mode.shape.mean))
      mode.remarks.push_back(
          "travels or whirls: the squares of the shape cancel, and Eq. (2.2) cannot scale it; the squared moduli "
          "of the "
          "entries sum to one instead, and there is no modal mass");
}

// What grows, and what does not tell whether it does.
void remark_on_growth(ModalSurvey& survey) {
  for (SurveyMode& mode : survey.modes) {
    const PoleSupport& support = mode.diagram.support;
    if (mode.trend() == MotionTrend::grows)
      mode.remarks.push_back(fmt::format(
          "grows in the records: by {:.4g} a second with a standard deviation of {:.2g}, a damping of {:.3g} %",
          support.value.real(), support.growth_error, 100 * damping_ratio(support.value)));
    if (mode.trend() == MotionTrend::undetermined)
      mode.remarks.push_back(
          "the records do not distinguish the damping from zero; a tone from outside looks the same");
  }
}

void remark_on_phases(ModalSurvey& survey) {
  for (SurveyMode& mode : survey.modes) {
    mode.phase_collinearity = phase_collinearity(mode.shape.mean);
    if (mode.phase_collinearity < 0.9)
      mode.remarks.push_back(
          "complex (phase collinearity below 0.9): the real part of the shape is no normal mode");
  }
}

// One warning a remark, with all modes that it holds for.
void warn_of_modes(ModalSurvey& survey) {
  std::vector<std::pair<std::string, std::vector<std::size_t>>> modes_of;
  for (std::size_t r = 0; r < survey.modes.size(); ++r)
    for (const std::string& remark : survey.modes[r].remarks) {
      auto known = std::find_if(modes_of.begin(), modes_of.end(), [&](const auto& m) { return m.first == remark; });
      if (known == modes_of.end()) known = modes_of.insert(known, {remark, {}});
      known->second.push_back(r);
    }
  for (const auto& [remark, modes] : modes_of) {
    std::vector<std::string> numbers, hertz;
    for (const std::size_t r : modes) {
      numbers.push_back(std::to_string(r + 1));
      hertz.push_back(fmt::format("{:.4g}", survey.modes[r].natural_frequency_hz));
    }
    survey.warnings.push_back(fmt::format("mode{} {} ({} Hz): {}", modes.size() == 1 ? "" : "s",
                                          fmt::join(numbers, ", "), fmt::join(hertz, ", "), remark));
  }
}

}  // namespace

std::string to_string(MotionTrend trend) {
  switch (trend) {
    case MotionTrend::decays:
      return "decays";
    case MotionTrend::grows:
      return "grows";
    case MotionTrend::undetermined:
      return "undetermined";
  }
  throw std::logic_error("MotionTrend without a name");
}

MotionTrend SurveyMode::trend() const {
  const PoleSupport& support = diagram.support;
  if (!support.stands) return MotionTrend::undetermined;
  const Interval growth = confidence_interval(support.value.real(), support.growth_error, infinite);
  if (growth.high < 0) return MotionTrend::decays;
  return growth.low > 0 ? MotionTrend::grows : MotionTrend::undetermined;
}

namespace {

// With one degree of freedom Student's law (Cauchy's) has no mean: one number says nothing of a scatter.
std::optional<Interval> interval_of(double value, double sd, double degrees_of_freedom) {
  if (!(degrees_of_freedom > 1)) return std::nullopt;
  return confidence_interval(value, sd, degrees_of_freedom);
}

}  // namespace

std::optional<Interval> SurveyMode::frequency_interval_hz() const {
  return interval_of(natural_frequency_hz, natural_frequency_sd_hz, degrees_of_freedom);
}

std::optional<Interval> SurveyMode::damping_interval() const {
  return interval_of(damping_ratio, damping_ratio_sd, degrees_of_freedom);
}

std::optional<MatrixXd> ModalSurvey::mass_normalised() const {
  if (modes.empty()) return std::nullopt;
  MatrixXd shapes(static_cast<Index>(channels.size()), static_cast<Index>(modes.size()));
  VectorXd masses(static_cast<Index>(modes.size()));
  for (std::size_t r = 0; r < modes.size(); ++r) {
    if (!modes[r].mass) return std::nullopt;
    shapes.col(static_cast<Index>(r)) = modes[r].shape.mean.real();
    masses(static_cast<Index>(r)) = *modes[r].mass;
  }
  return mass_normalised_shapes(shapes, masses);
}

std::string ModalSurvey::channel_name(Index channel) const {
  return campaign.channels[channels[static_cast<std::size_t>(channel)]].name;
}

ModalSurvey modal_survey(const std::filesystem::path& folder, const ModalSurveyOptions& options) {
  return modal_survey(read_campaign(folder), options);
}

ModalSurvey modal_survey(const Campaign& campaign, const ModalSurveyOptions& options) {
  ModalSurvey survey;
  survey.campaign = campaign;
  survey.options = options;
  if (options.highest_hz > 0 && survey.campaign.sample_rate_hz > 0 &&
      options.highest_hz >= 0.5 * survey.campaign.sample_rate_hz)
    throw InputError("--band", "", fmt::format("{} Hz is not below half the sample rate", options.highest_hz),
                     fmt::format("{} samples/s allow less than {} Hz", survey.campaign.sample_rate_hz,
                                 0.5 * survey.campaign.sample_rate_hz));
  SurveyRecords records(survey);
  if (!records.impacts().empty()) survey_impacts(survey, records);
  if (!records.decays().empty()) survey_decays(survey, records);
  if (survey.modes.empty())
    throw NumericalFailure(Ending::out_of_range,
                           toml_of(survey) + ": " + nothing_stands(survey) +
                               "; another --band, a larger --order or a part with less noise (--from, --to) may "
                               "show more");
  set_tones_aside(survey);
  remark_on_excess(survey);
  remark_on_phases(survey);
  remark_on_growth(survey);
  remark_on_whirling(survey);
  warn_of_modes(survey);
  MatrixXcd shapes(static_cast<Index>(survey.channels.size()), static_cast<Index>(survey.modes.size()));
  for (std::size_t r = 0; r < survey.modes.size(); ++r)
    shapes.col(static_cast<Index>(r)) = survey.modes[r].shape.mean;
  survey.mac = modal_assurance_matrix(shapes, shapes);
  give_masses(survey);
  if (options.progress) options.progress(100, 100);
  for (std::string& warning : records.faults()) survey.warnings.push_back(std::move(warning));
  return survey;
}

std::string modal_basis_text(const ModalSurvey& survey) {
  const std::optional<MatrixXd> shapes = survey.mass_normalised();
  if (!shapes)
    throw InputError("--basis", "", "the modal masses are not known",
                     "impacts with a force channel, struck where a response is measured (--driving-point), or "
                     "--modal-mass M1,M2,...");
  if (shapes->cols() > shapes->rows())
    throw InputError(
        "--basis", "",
        fmt::format("{} modes seen by {} channels cannot be told apart", shapes->cols(), shapes->rows()),
        "keep no more modes than channels: --modes, --band");
  Campaign carrier;
  ModalBasis basis;
  for (Index c = 0; c < shapes->rows(); ++c) {
    basis.channels.push_back(survey.channel_name(c));
    basis.mass_normalised_shapes.emplace_back();
    for (Index r = 0; r < shapes->cols(); ++r) basis.mass_normalised_shapes.back().push_back((*shapes)(c, r));
  }
  for (Index r = 0; r < shapes->cols(); ++r) basis.modes.push_back(fmt::format("v{}", r + 1));
  carrier.modal_basis = basis;
  const std::string text = campaign_text(carrier);
  return text.substr(text.find("[modal_basis]"));
}

}  // namespace secular
