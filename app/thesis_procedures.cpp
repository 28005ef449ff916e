#include "app/thesis_procedures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

#include "app/model_loading.hpp"
#include "app/parameter_file.hpp"
#include "app/shipped_models.hpp"
#include "app/thesis_tables.hpp"
#include "estimator/hertz.hpp"
#include "estimator/identification/modal_projection.hpp"
#include "estimator/procedures/block_rows.hpp"
#include "estimator/procedures/combination_dwells.hpp"
#include "estimator/procedures/competing_terms.hpp"
#include "estimator/procedures/engine_lumps.hpp"
#include "estimator/procedures/frequency_response_regression.hpp"
#include "estimator/procedures/harmonic_regression.hpp"
#include "estimator/procedures/jump_frequencies.hpp"
#include "estimator/procedures/saddle_node_regression.hpp"
#include "estimator/procedures/thesis_harmonics.hpp"
#include "estimator/procedures/two_mode_regression.hpp"
#include "estimator/signal/bispectral_phase.hpp"
#include "input/input_error.hpp"
#include "simulate/experiment.hpp"

namespace secular::app {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using report::Figure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

/// Levels closer than this, relative, are one.
constexpr double same_level = 0.01;

// Omega = 2 omega0 of a model with one mode.
bool is_principal_parametric(const CompiledModel& model, const CompiledCase& resonance) {
  return model.modes() == 1 && model.excitations.size() == 1 && resonance.relations.size() == 2 &&
         std::abs(resonance.relations[0]) == 2 && resonance.relations[1] == -resonance.relations[0] / 2;
}

std::string covered_case(const ModelSource& source, const std::string& wanted) {
  for (const CaseOutline& outline : source.cases()) {
    if (!wanted.empty() && outline.name != wanted) continue;
    if (!outline.excited || outline.relations.size() != 1) continue;
    const std::vector<int>& r = outline.relations[0];
    const bool one = source.modes() == 1 && r.size() == 2 && std::abs(r[0]) == 2 && r[1] == -r[0] / 2;
    const bool two = source.modes() == 2 && r.size() == 3 && std::abs(r[0]) == 1 && r[1] == r[0] && r[2] == -r[0];
    if (one || two) return outline.name;
  }
  throw InputError(wanted.empty() ? "--model " + source.name() : "--case " + wanted, "",
                   "is no case that these procedures cover",
                   "Omega = 2 omega0 of one mode, or Omega = omega1 + omega2 of two");
}

// Mean over the ensembles of one dwell.
struct Condition {
  std::size_t record = 0;
  std::string group;
  double frequency = 0, forcing = 0, amplitude = 0, amplitude_sd = 0;
};

class Runner {
 public:
  explicit Runner(const ProcedureRequest& request) : request_(request) {}

  ProcedureRun run() {
    const ModelSource source(request_.model, request_.interpret);
    const std::string name = covered_case(source, request_.resonance);
    result_.campaign = read_campaign(request_.campaign);
    result_.model = source.load({name});
    for (const CompiledCase& resonance : result_.model->cases)
      if (resonance.name == name) result_.resonance = &resonance;
    unit_ = modal_projection(result_.campaign, *result_.model).unit;
    read_truth();
    const RecordReader read = [&](std::size_t r) {
      return read_record(result_.campaign, result_.campaign.records[r]);
    };
    const bool one = is_principal_parametric(*result_.model, *result_.resonance);
    result_.measured =
        one ? observe_dwells(result_.campaign, read, *result_.model, *result_.resonance, request_.window)
            : observe_combination_dwells(result_.campaign, read, *result_.model, *result_.resonance,
                                         request_.window);
    result_.warnings = result_.measured.warnings;
    if (result_.measured.observations.empty())
      throw InputError(request_.campaign, "", "no dwell of it responds in case " + name,
                       "dwells with a response near this resonance were expected");
    find_conditions();
    find_centre(one ? 2 : 1);
    if (one)
      one_mode();
    else
      two_modes();
    if (wants("anova")) generated_anova();
    return std::move(result_);
  }

 private:
  bool wants(const std::string& method) const {
    return request_.methods.empty() ||
           std::find(request_.methods.begin(), request_.methods.end(), method) != request_.methods.end();
  }

  void read_truth() {
    if (request_.truth.empty()) return;
    const CompiledModel& model = *result_.model;
    VectorXd values = VectorXd::Zero(static_cast<Index>(model.symbols.size()));
    const std::filesystem::path path(request_.truth);
    const bool experiment = path.extension() == ".toml" || request_.truth.rfind("experiments/", 0) == 0;
    if (experiment) {
      values = read_experiment(resolve_model(request_.truth), model).parameters;
    } else {
      const std::map<std::string, double> given = read_parameter_file(request_.truth);
      for (std::size_t s = 0; s < model.symbols.size(); ++s) {
        const auto found = given.find(std::string(model.symbols[s].name));
        if (found == given.end())
          throw InputError(request_.truth, "", "gives no value for " + std::string(model.symbols[s].name),
                           "the numbers that the campaign was simulated with, all of them");
        values(static_cast<Index>(s)) = found->second;
      }
    }
    truth_ = values;
  }

  std::optional<double> symbol(std::string_view name) const {
    if (!truth_) return {};
    for (std::size_t s = 0; s < result_.model->symbols.size(); ++s)
      if (result_.model->symbols[s].name == name) return (*truth_)(static_cast<Index>(s));
    return {};
  }

  std::optional<double> lump(std::string_view name) const {
    if (!truth_) return {};
    std::vector<double> values(result_.resonance->lumps.size());
    result_.resonance->evaluate_lumps(truth_->data(), values.data());
    for (std::size_t l = 0; l < values.size(); ++l)
      if (result_.resonance->lumps[l].name == name) return values[l];
    return symbol(name);
  }

  void find_conditions() {
    std::map<std::size_t, std::vector<const Observation*>> members;
    for (const Observation& o : result_.measured.observations) members[o.record].push_back(&o);
    for (const auto& [record, ensembles] : members) {
      Condition c;
      c.record = record;
      c.group = result_.campaign.records[record].group;
      const auto n = static_cast<double>(ensembles.size());
      double square = 0;
      for (const Observation* o : ensembles) {
        const double a = 2 * std::abs(o->amplitude[0]);
        c.frequency += o->excitation_frequency[0] / n;
        c.forcing += std::abs(o->forcing[0]) / n;
        c.amplitude += a / n;
        square += a * a / n;
      }
      c.amplitude_sd = std::sqrt(std::max(0.0, square - c.amplitude * c.amplitude));
      conditions_.push_back(c);
    }
  }

  // Exact resonance from the onsets of a forward and a reverse sweep; otherwise from the model's nominal numbers.
  void find_centre(int modes_in_sum) {
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t r = 0; r < result_.campaign.records.size(); ++r) {
      const RecordEntry& entry = result_.campaign.records[r];
      if (entry.kind == RecordKind::dwell && entry.excitation_frequency_hz &&
          matches_pattern(request_.window.records, entry.file))
        groups[entry.group].push_back(r);
    }
    std::optional<Onset> forward, reverse;
    for (const auto& [name, records] : groups) {
      std::vector<SweepDwell> sweep;
      for (const std::size_t r : records) {
        const bool responds =
            std::any_of(conditions_.begin(), conditions_.end(), [&](const Condition& c) { return c.record == r; });
        sweep.push_back({*result_.campaign.records[r].excitation_frequency_hz / to_hz, responds});
      }
      const auto rising = [](const SweepDwell& a, const SweepDwell& b) { return a.frequency < b.frequency; };
      const auto falling = [](const SweepDwell& a, const SweepDwell& b) { return a.frequency > b.frequency; };
      if (sweep.size() < 2) continue;
      if (std::is_sorted(sweep.begin(), sweep.end(), rising) && !forward) forward = onset_of(sweep);
      if (std::is_sorted(sweep.begin(), sweep.end(), falling) && !reverse) reverse = onset_of(sweep);
    }
    if (forward && reverse) {
      const ResonanceCentre centre = resonance_centre(*forward, *reverse);
      centre_ = centre.bracketed;
      ProcedureSection section;
      section.method = "jump_frequencies";
      section.title = "Natural frequency from the two jump frequencies";
      section.text = fmt::format(
          "The state of rest is unstable in an interval that is symmetric about exact resonance (Eq. (5.27), "
          "section "
          "6.4). The forward sweep is quiet at {:.4f} Hz and responds at {:.4f} Hz, the reverse sweep is quiet at "
          "{:.4f} Hz and responds at {:.4f} Hz. Recovered: the mean of the middles of both brackets; as printed: "
          "the "
          "mean of the first frequencies that respond.",
          forward->quiet * to_hz, forward->responds * to_hz, reverse->quiet * to_hz, reverse->responds * to_hz);
      ProcedureRow row;
      row.name = modes_in_sum == 2 ? "omega0" : "omega1 + omega2";
      row.unit = "rad/s";
      row.recovered = centre.bracketed / modes_in_sum;
      row.sd = centre.sd / modes_in_sum;
      row.as_printed = centre.thesis / modes_in_sum;
      row.truth = modes_in_sum == 2 ? symbol("omega0") : symbol("omega1");
      if (modes_in_sum == 1 && row.truth) row.truth = *row.truth + *symbol("omega2");
      section.rows.push_back(row);
      result_.sections.push_back(std::move(section));
      return;
    }
    centre_ = 0;
    for (std::size_t k = 0; k < result_.model->modes(); ++k) centre_ += modes_in_sum * result_.model->nominal[k];
    if (modes_in_sum == 1) centre_ = result_.model->nominal[0] + result_.model->nominal[1];
    if (!std::isfinite(centre_))
      throw InputError(
          request_.campaign, "", "has no forward and reverse sweep that starts quiet and then responds",
          "add such sweeps (groups of dwells with rising and with falling frequency), or give the model "
          "a [nominal] frequency");
    result_.warnings.push_back(
        fmt::format("no forward and reverse sweep that starts quiet and then responds: exact resonance is taken "
                    "from the model's "
                    "nominal numbers, {:.4f} Hz, on which every stiffness here depends",
                    centre_ * to_hz));
  }

  ProcedureRow row(const std::string& name, const std::string& unit, const std::string& equation, double recovered,
                   std::optional<double> sd, std::optional<double> as_printed, std::optional<double> truth) const {
    ProcedureRow r;
    r.name = name;
    r.unit = unit;
    r.equation = equation;
    r.recovered = recovered;
    r.sd = sd;
    r.as_printed = as_printed;
    r.truth = truth;
    if (const auto printed = printed_value(equation, name)) {
      r.source = printed->value;
      r.source_sd = printed->sd;
      r.table = printed->table;
    }
    return r;
  }

  // ---------------------------------------------------------------------------------------------- one mode
  // The points of the saddle-node diagram: per level the largest amplitude, of the groups that vary the level.
  std::vector<const Condition*> saddle_node_points() const {
    std::map<std::string, std::vector<const Condition*>> groups;
    for (const Condition& c : conditions_) groups[c.group].push_back(&c);
    const auto levels_of = [](std::vector<const Condition*> members) {
      std::sort(members.begin(), members.end(), [](auto* a, auto* b) { return a->forcing < b->forcing; });
      std::vector<const Condition*> best;
      for (const Condition* c : members) {
        if (best.empty() || c->forcing > best.back()->forcing * (1 + same_level))
          best.push_back(c);
        else if (c->amplitude > best.back()->amplitude)
          best.back() = c;
      }
      return best;
    };
    std::vector<const Condition*> chosen, all;
    for (const auto& [name, members] : groups) {
      all.insert(all.end(), members.begin(), members.end());
      const auto levels = levels_of(members);
      if (levels.size() >= 3) chosen.insert(chosen.end(), levels.begin(), levels.end());
    }
    return levels_of(chosen.empty() ? all : chosen);
  }

  FrequencyResponseData response_data(const SaddleNodeFit& damping, DampingLaw law, bool with_phase) const {
    FrequencyResponseData data;
    const auto& seen = result_.measured.observations;
    const auto count = static_cast<Index>(seen.size());
    data.amplitude.resize(count);
    data.forcing.resize(count);
    data.excitation_frequency.resize(count);
    if (with_phase) data.cos_gamma.resize(count);
    for (Index i = 0; i < count; ++i) {
      const Observation& o = seen[static_cast<std::size_t>(i)];
      data.amplitude(i) = 2 * std::abs(o.amplitude[0]);
      data.forcing(i) = std::abs(o.forcing[0]);
      data.excitation_frequency(i) = o.excitation_frequency[0];
      if (with_phase) data.cos_gamma(i) = std::cos(std::arg(o.forcing[0]) - 2 * std::arg(o.amplitude[0]));
      data.condition.push_back(o.condition);
    }
    data.omega0 = 0.5 * centre_;
    data.linear = damping.shifted_linear;
    (law == DampingLaw::quadratic ? data.quadratic : data.cubic) = damping.nonlinear;
    return data;
  }

  void one_mode() {
    const double w0 = 0.5 * centre_;
    const std::vector<const Condition*> points = saddle_node_points();
    const bool damping_needed = wants("saddle_node") || wants("frequency_response");
    if (damping_needed && points.size() < 4) {
      result_.warnings.push_back(fmt::format(
          "{} excitation level{}: the saddle-node regression needs four or more, and without it the frequency "
          "response has no damping; both are left out",
          points.size(), points.size() == 1 ? "" : "s"));
    } else if (damping_needed) {
      saddle_node_and_response(points, w0);
    }
    if (wants("harmonic")) harmonics();
  }

  void saddle_node_and_response(const std::vector<const Condition*>& points, double w0) {
    VectorXd amplitude(static_cast<Index>(points.size())), forcing(amplitude.size());
    for (Index i = 0; i < amplitude.size(); ++i) {
      amplitude(i) = points[static_cast<std::size_t>(i)]->amplitude;
      forcing(i) = points[static_cast<std::size_t>(i)]->forcing;
    }
    struct Outcome {
      DampingLaw law;
      SaddleNodeFit printed, right;
      FrequencyResponseFit printed_response, right_response;
    };
    std::vector<Outcome> outcomes;
    for (const DampingLaw law : {DampingLaw::quadratic, DampingLaw::cubic}) {
      Outcome o{law, saddle_node_regression(law, amplitude, forcing, w0), {}, {}, {}};
      o.printed_response = frequency_response_regression(response_data(o.printed, law, false));
      // The saddle-node needs |alpha_e/eta_e|, the frequency response the damping: in turn until both stand.
      o.right = o.printed;
      for (int pass = 0; pass < 50; ++pass) {
        o.right_response = frequency_response_regression(response_data(o.right, law, true));
        const double before = o.right.nonlinear;
        o.right = saddle_node_regression(law, amplitude, forcing, w0,
                                         std::abs(o.right_response.stiffness / o.right_response.excitation));
        if (std::abs(o.right.nonlinear - before) < 1e-10 * std::abs(before)) break;
      }
      outcomes.push_back(std::move(o));
    }
    decide_damping();
    const std::size_t chosen = outcomes[0].right.residual_sd < outcomes[1].right.residual_sd ? 0 : 1;
    for (std::size_t i = 0; i < 2; ++i) {
      const Outcome& o = outcomes[i];
      const bool cubic = o.law == DampingLaw::cubic;
      const std::string nonlinear = cubic ? "mu3" : "mu2", equation = cubic ? "5.37" : "5.35";
      const double eta = std::abs(o.right_response.excitation),
                   eta_printed = std::abs(o.printed_response.excitation);
      const auto truth_over = [&](const char* name) -> std::optional<double> {
        const auto value = symbol(name), excitation = lump("eta_e");
        if (!value || !excitation) return {};
        return *value / std::abs(*excitation);
      };
      const std::string ratio_unit = cubic ? "s/(kg m)" : "";
      if (wants("saddle_node")) {
        ProcedureSection section;
        section.method = "saddle_node";
        section.title = fmt::format("Saddle-node regression, linear and {} damping", cubic ? "cubic" : "quadratic");
        section.text = fmt::format(
            "Eqs. {} on {} points; residual {:.3g} m/s^2 ({} law fits better). As printed the line is the peak of "
            "the "
            "response (vanishing radicand of (5.25)); recovered with the saddle-node's own force, where "
            "d(sigma)/d(a) "
            "= 0. The linear damping is lowered by {:.3g} (as printed: {:.3g}) so that every point lies on the "
            "right "
            "side of the line.",
            cubic ? "(5.36), (5.37)" : "(5.34), (5.35)", points.size(), o.right.residual_sd,
            i == chosen ? "this" : "the other", o.right.linear - o.right.shifted_linear,
            o.printed.linear - o.printed.shifted_linear);
        section.rows.push_back(row("mu1/|eta_e|", "m/s", equation, o.right.shifted_linear,
                                   std::sqrt(o.right.covariance(0, 0)), o.printed.shifted_linear,
                                   truth_over("mu1")));
        section.rows.push_back(row(nonlinear + "/|eta_e|", ratio_unit, equation, o.right.nonlinear,
                                   std::sqrt(o.right.covariance(1, 1)), o.printed.nonlinear,
                                   truth_over(nonlinear.c_str())));
        section.figures.emplace_back(saddle_node_figure(points, o.right, o.printed, cubic),
                                     "Points close to the saddle-nodes (bars: two standard deviations of one "
                                     "ensemble) and the fitted lines after the shift.");
        result_.sections.push_back(std::move(section));
      }
      if (wants("frequency_response") && i == chosen) {
        const LinearFit& fit = o.right_response.fit;
        ProcedureSection section;
        section.method = "frequency_response";
        section.title = "Frequency-response regression";
        section.text = fmt::format(
            "Eqs. (5.39), (5.40) with the {} law's damping over {} ensembles ({} left out: there the damping needs "
            "more force than there was). As printed every point takes the plus sign of the radicand; recovered "
            "with "
            "the side of the peak that the measured phase tells (sign of cos gamma).",
            cubic ? "cubic" : "quadratic", fit.residual.size(), o.right_response.left_out);
        section.rows.push_back(row("alpha_e", "1/(kg m^2 s^2)", "5.40", o.right_response.stiffness,
                                   std::sqrt(fit.covariance(0, 0)), o.printed_response.stiffness, lump("alpha_e")));
        auto excitation = lump("eta_e");
        if (excitation) excitation = std::abs(*excitation);
        section.rows.push_back(row("|eta_e|", "1/m", "5.40", eta, std::sqrt(fit.covariance(1, 1)),
                                   o.printed_response.excitation, excitation));
        const double eta_share = std::sqrt(fit.covariance(1, 1)) / eta;
        const auto product_sd = [&](double ratio, double ratio_sd) {
          return std::hypot(ratio_sd * eta, ratio * eta * eta_share);
        };
        section.rows.push_back(row("mu1", "1/s", "5.40", o.right.shifted_linear * eta,
                                   product_sd(o.right.shifted_linear, std::sqrt(o.right.covariance(0, 0))),
                                   o.printed.shifted_linear * eta_printed, symbol("mu1")));
        section.rows.push_back(row(nonlinear, cubic ? "s/(kg m^2)" : "1/(kg^(1/2) m)", "5.40",
                                   o.right.nonlinear * eta,
                                   product_sd(o.right.nonlinear, std::sqrt(o.right.covariance(1, 1))),
                                   o.printed.nonlinear * eta_printed, symbol(nonlinear)));
        section.figures.emplace_back(
            response_figure(o.right, o.right_response, o.law, w0),
            "Frequency response: measured, and Eq. (5.25) with the recovered numbers at the "
            "level of most dwells.");
        result_.sections.push_back(std::move(section));
      }
    }
  }

  // Drag against cubic damping on all ensembles, beside the saddle-node diagram's eight points.
  void decide_damping() {
    std::vector<std::string> laws;
    for (const char* name : {"mu2", "mu3"})
      for (const CompiledLump& lump : result_.resonance->lumps)
        if (lump.name == name) laws.emplace_back(name);
    if (laws.size() < 2 || !wants("saddle_node")) return;
    const std::vector<CompetingTerm> order =
        compare_terms(result_.measured, unit_, {result_.campaign.channels.front().unit}, laws);
    ProcedureSection section;
    section.method = "damping_law";
    section.title = "Drag or cubic damping";
    section.text = fmt::format(
        "All {} ensembles on the generated modulation equations with one of the two laws at a time: with {} the "
        "residual is {:.3g} times what noise explains, with {} {:.3g} times. {} is decided for.",
        result_.measured.observations.size(), order[0].name, order[0].normalised_residual, order[1].name,
        order[1].normalised_residual, order[0].name == "mu3" ? "Cubic damping" : "Drag");
    result_.sections.push_back(std::move(section));
  }

  Figure saddle_node_figure(const std::vector<const Condition*>& points, const SaddleNodeFit& right,
                            const SaddleNodeFit& printed, bool cubic) const {
    Figure figure;
    figure.title = cubic ? "Saddle-node diagram, linear and cubic damping"
                         : "Saddle-node diagram, linear and quadratic damping";
    figure.x = {"Excitation amplitude", "m/s^2", false, {}};
    Series data, line, other;
    data.name = "measured";
    data.style = SeriesStyle::error_bars;
    data.role = SeriesRole::data;
    line.name = "saddle-node";
    other.name = "as printed";
    other.role = SeriesRole::alternative;
    const double w0 = 0.5 * centre_;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Condition& c = *points[i];
      const double a = c.amplitude, y = cubic ? a * a : a;
      data.x.push_back(c.forcing);
      data.y.push_back(y);
      data.y_error.push_back(2 * (cubic ? 2 * a : 1) * c.amplitude_sd);
      const auto at = static_cast<Index>(i);
      // The shift lowers the force of the line in proportion to its own factor, 1 as printed.
      const auto shifted = [&](const SaddleNodeFit& fit) {
        const double nonlinear =
            fit.nonlinear * (cubic ? 0.375 * std::pow(w0, 3) * a * a : 4 * w0 * w0 / (3 * std::numbers::pi) * a);
        const double factor = fit.fitted(at) / (w0 * fit.linear + nonlinear);
        return factor * (w0 * fit.shifted_linear + nonlinear);
      };
      line.x.push_back(shifted(right));
      line.y.push_back(y);
      other.x.push_back(shifted(printed));
      other.y.push_back(y);
    }
    figure.panels.push_back({"",
                             {cubic ? "Amplitude squared" : "Peak amplitude", cubic ? "kg m^2" : unit_, false, {}},
                             {data, line, other}});
    return figure;
  }

  Figure response_figure(const SaddleNodeFit& damping, const FrequencyResponseFit& response, DampingLaw law,
                         double w0) const {
    std::vector<double> levels;
    for (const Condition& c : conditions_) levels.push_back(c.forcing);
    std::sort(levels.begin(), levels.end());
    double level = levels.front();
    std::ptrdiff_t most = 0;
    for (const double l : levels) {
      const auto near =
          std::count_if(levels.begin(), levels.end(), [&](double o) { return std::abs(o / l - 1) < same_level; });
      if (near > most) {
        most = near;
        level = l;
      }
    }
    Figure figure;
    figure.title = fmt::format("Frequency response at F = {:.4g}", level);
    figure.x = {"Excitation frequency", "Hz", false, {}};
    Series data, upper, lower;
    data.name = "measured";
    data.style = SeriesStyle::error_bars;
    data.role = SeriesRole::data;
    for (const Condition& c : conditions_) {
      if (std::abs(c.forcing / level - 1) > same_level) continue;
      data.x.push_back(c.frequency * to_hz);
      data.y.push_back(c.amplitude);
      data.y_error.push_back(2 * c.amplitude_sd);
    }
    upper.name = "Eq. (5.25), side of the measured points";
    lower.name = "Eq. (5.25), beyond the peak";
    lower.role = SeriesRole::unstable;
    const double eta = std::abs(response.excitation);
    // The amplitude where the radicand vanishes, by doubling and bisection.
    const auto radicand = [&](double a) {
      const double d = w0 * damping.shifted_linear +
                       damping.nonlinear * (law == DampingLaw::cubic ? 0.375 * std::pow(w0, 3) * a * a
                                                                     : 4 * w0 * w0 / (3 * std::numbers::pi) * a);
      return level * level - d * d;
    };
    double high = data.y.empty() ? 1e-3 : *std::max_element(data.y.begin(), data.y.end());
    for (int i = 0; i < 40 && radicand(high) > 0; ++i) high *= 1.2;
    double low = 0;
    for (int i = 0; i < 60; ++i) (radicand(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
    const double softening = response.stiffness < 0 ? 1 : -1;
    for (int i = 0; i <= 200; ++i) {
      const double a = low * i / 200, root = eta * std::sqrt(std::max(0.0, radicand(a)));
      const auto frequency = [&](double side) {
        return (2 * w0 + 2 / w0 * (response.stiffness * a * a + side * root)) * to_hz;
      };
      upper.x.push_back(frequency(softening));
      upper.y.push_back(a);
      lower.x.push_back(frequency(-softening));
      lower.y.push_back(a);
    }
    figure.panels.push_back({"", {"Peak amplitude", unit_, false, {}}, {data, upper, lower}});
    return figure;
  }

  // ---------------------------------------------------------------------------------------------- harmonics
  EnsembleTones tones_of(const Observation& o) const {
    EnsembleTones tones;
    tones.excitation_frequency = o.excitation_frequency[0];
    tones.excitation = o.forcing[0];
    for (std::size_t k = 0; k < result_.model->modes(); ++k) {
      tones.mode_frequency[k] = o.rate[k].imag();
      tones.mode[k] = 2.0 * o.amplitude[k];
    }
    return tones;
  }

  // Observed frequency of a block's harmonic in an ensemble.
  double block_frequency(const RegressorBlock& block, const Observation& o) const {
    double frequency = 0;
    const std::size_t modes = result_.model->modes();
    for (std::size_t i = 0; i < block.phase.size(); ++i)
      frequency += block.phase[i] * (i < modes ? o.rate[i].imag() : o.excitation_frequency[i - modes]);
    return frequency;
  }

  std::optional<double> harmonic_truth(std::string_view unknown) const {
    const auto combined = [&](const char* alpha, const char* delta, double factor) -> std::optional<double> {
      const auto a = symbol(alpha), d = symbol(delta);
      if (!a || !d) return {};
      return *a - factor * *d;
    };
    if (!truth_) return {};
    const VectorXd& p = *truth_;
    if (unknown == "alpha2 - 3 delta2 w0^2") return combined("alpha2", "delta2", 3 * p(0) * p(0));
    if (unknown == "alpha22 - w1 w2 delta22 - w1^2 delta22")
      return combined("alpha22", "delta22", p(0) * p(1) + p(0) * p(0));
    if (unknown == "alpha23 - w1 w2 delta23 - w2^2 delta23")
      return combined("alpha23", "delta23", p(0) * p(1) + p(1) * p(1));
    return symbol(unknown);
  }

  void harmonics() {
    for (const ThesisHarmonic& equation : thesis_harmonics()) {
      if (equation.modes != result_.model->modes()) continue;
      const Observation& first = result_.measured.observations.front();
      std::optional<std::size_t> measured_in;
      for (std::size_t b = 0; b < result_.resonance->blocks.size(); ++b) {
        const RegressorBlock& block = result_.resonance->blocks[b];
        const double wanted = equation.frequency(tones_of(first));
        if (block.kind == BlockKind::harmonic && static_cast<std::size_t>(block.mode) == equation.mode &&
            std::abs(block_frequency(block, first) - wanted) < 1e-3 * wanted && first.harmonic_sd[b] > 0)
          measured_in = b;
      }
      if (!measured_in) {
        result_.warnings.push_back(
            fmt::format("Eq. ({}): this model's expansion has no such harmonic, left out", equation.equation));
        continue;
      }
      add_harmonic(equation, *measured_in);
    }
  }

  void add_harmonic(const ThesisHarmonic& equation, std::size_t block) {
    const auto& seen = result_.measured.observations;
    HarmonicFit fits[2];
    for (const bool printed : {false, true}) {
      HarmonicData data;
      data.columns.resize(static_cast<Index>(seen.size()), static_cast<Index>(equation.unknowns.size()));
      data.target.resize(data.columns.rows());
      std::vector<Complex> columns(equation.unknowns.size());
      for (Index i = 0; i < data.target.size(); ++i) {
        const Observation& o = seen[static_cast<std::size_t>(i)];
        equation.columns(tones_of(o), printed, columns.data());
        for (std::size_t j = 0; j < columns.size(); ++j) data.columns(i, static_cast<Index>(j)) = columns[j];
        data.target(i) = 2.0 * o.harmonic[block];
        data.condition.push_back(o.condition);
      }
      fits[printed ? 1 : 0] = harmonic_regression(data);
    }
    ProcedureSection section;
    section.method = "harmonic";
    section.title = fmt::format("Harmonic regression, Eq. ({})", equation.equation);
    section.text = fmt::format(
        "{} of the response{}. Recovered: all {} ensembles at once, standard deviation from the scatter between "
        "conditions; the scatter is that of every condition's own estimate, which the source's tables give. As "
        "printed: {}.",
        result_.resonance->blocks[block].name, result_.model->modes() == 1 ? "" : " signals", seen.size(),
        equation.misprint);
    const HarmonicFit& right = fits[0];
    for (std::size_t j = 0; j < equation.unknowns.size(); ++j) {
      const auto at = static_cast<Index>(j);
      ProcedureRow r =
          row(std::string(equation.unknowns[j]), "", std::string(equation.equation), right.pooled.coefficients(at),
              std::sqrt(right.pooled.covariance(at, at)), fits[1].mean(at), harmonic_truth(equation.unknowns[j]));
      r.scatter = right.sd(at);
      section.rows.push_back(std::move(r));
    }
    section.figures.emplace_back(harmonic_figure(equation, right), "Every condition's own estimate.");
    result_.sections.push_back(std::move(section));
  }

  Figure harmonic_figure(const ThesisHarmonic& equation, const HarmonicFit& fit) const {
    Figure figure;
    figure.title = fmt::format("Estimates by condition, Eq. ({})", equation.equation);
    figure.x = {fmt::format("Peak amplitude of {}", result_.model->coordinates[0]), unit_, false, {}};
    for (std::size_t j = 0; j < equation.unknowns.size(); ++j) {
      const auto at = static_cast<Index>(j);
      Series points, level;
      points.style = SeriesStyle::points;
      points.role = SeriesRole::data;
      points.name = j == 0 ? "condition" : "";
      level.role = SeriesRole::reference;
      level.name = j == 0 ? "all at once" : "";
      for (Index c = 0; c < fit.by_condition.rows(); ++c) {
        const int label = fit.conditions[static_cast<std::size_t>(c)];
        double mean = 0, count = 0;
        for (const Observation& o : result_.measured.observations)
          if (o.condition == label) {
            mean += 2 * std::abs(o.amplitude[0]);
            ++count;
          }
        points.x.push_back(mean / count);
        points.y.push_back(fit.by_condition(c, at));
      }
      const auto [low, high] = std::minmax_element(points.x.begin(), points.x.end());
      level.x = {*low, *high};
      level.y = {fit.pooled.coefficients(at), fit.pooled.coefficients(at)};
      figure.panels.push_back({"", {std::string(equation.unknowns[j]), "", false, {}}, {points, level}});
    }
    return figure;
  }

  // ---------------------------------------------------------------------------------------------- two modes
  void two_modes() {
    const auto& seen = result_.measured.observations;
    check_locking();
    if (wants("harmonic")) harmonics();
    if (!wants("two_modes")) return;
    TwoModeData data;
    const auto count = static_cast<Index>(seen.size());
    for (VectorXd* v : {&data.first, &data.second, &data.forcing, &data.gamma, &data.excitation_frequency})
      v->resize(count);
    for (Index i = 0; i < count; ++i) {
      const Observation& o = seen[static_cast<std::size_t>(i)];
      data.first(i) = 2 * std::abs(o.amplitude[0]);
      data.second(i) = 2 * std::abs(o.amplitude[1]);
      data.forcing(i) = std::abs(o.forcing[0]);
      data.gamma(i) = std::arg(o.forcing[0] * std::conj(o.amplitude[0]) * std::conj(o.amplitude[1]));
      data.excitation_frequency(i) = o.excitation_frequency[0];
      data.condition.push_back(o.condition);
    }
    const std::vector<double> mean = mean_frequencies(result_.measured);
    data.omega1 = mean[0] * centre_ / (mean[0] + mean[1]);
    data.omega2 = mean[1] * centre_ / (mean[0] + mean[1]);
    TwoModeFit right, printed;
    try {
      right = two_mode_regression(data, false);
      printed = two_mode_regression(data, true);
    } catch (const std::invalid_argument& error) {
      result_.warnings.push_back(std::string("modulation equations of two modes: ") + error.what());
      return;
    }
    add_lumps(right, printed);
    add_fits(data, right);
    if (wants("anova")) thesis_anova(right);
  }

  void check_locking() {
    std::map<int, std::vector<const Observation*>> members;
    for (const Observation& o : result_.measured.observations) members[o.condition].push_back(&o);
    for (const auto& [label, ensembles] : members) {
      if (ensembles.size() < 2) continue;
      Eigen::VectorXcd f(static_cast<Index>(ensembles.size())), a1(f.size()), a2(f.size());
      for (Index i = 0; i < f.size(); ++i) {
        const Observation& o = *ensembles[static_cast<std::size_t>(i)];
        f(i) = o.forcing[0];
        a1(i) = o.amplitude[0];
        a2(i) = o.amplitude[1];
      }
      const EnsembleLayout apart{1, 1, f.size()};
      const BispectralPhase phase = bispectral_phase(f, a1, a2, apart);
      if (!phase.locked)
        result_.warnings.push_back(fmt::format(
            "{}: the bispectral phase does not stand still (bicoherence {:.2f}): this is no combination resonance",
            result_.campaign.records[ensembles.front()->record].file, phase.bicoherence));
    }
  }

  void add_lumps(const TwoModeFit& right, const TwoModeFit& printed) {
    ProcedureSection section;
    section.method = "two_modes";
    section.title = "Modulation equations of two modes, Eqs. (6.49)-(6.52)";
    const VectorXd& singular = right.combined.fit.condition_indices;
    section.text = fmt::format(
        "Damping rows (6.49), (6.50), then (6.51) with the ratios they found, phase from the bispectrum, w1 + w2 = "
        "{:.4f} Hz. Recovered with the sign of the detuning put right (misprint of (6.34), (6.40)); as printed "
        "every "
        "lump changes its sign, so that both dampings come out negative. Standard deviations: the whole procedure "
        "repeated without each condition. Smallest over largest singular value of (6.51) in scaled columns: {:.2g} "
        "(the source: 0.00377).",
        centre_ * to_hz, 1 / singular(singular.size() - 1));
    std::optional<VectorXd> truth;
    if (truth_) truth = two_mode_lumps(*result_.model, *result_.resonance, *truth_);
    static constexpr const char* units[] = {"1/s", "1/s",   "s/(kg m^2)",     "s/(kg m^2)",     "1/m",  "1/m",
                                            "1/m", "1/s^3", "1/(kg m^2 s^3)", "1/(kg m^2 s^3)", "s/m^2"};
    for (Index l = 0; l < right.lumps.size(); ++l)
      section.rows.push_back(row(std::string(name_of(static_cast<TwoModeLump>(l))), units[l], "6.51",
                                 right.lumps(l), right.sd(l), printed.lumps(l),
                                 truth ? std::optional<double>((*truth)(l)) : std::nullopt));
    result_.sections.push_back(std::move(section));
    for (Index l = 0; l < right.lumps.size(); ++l)
      if (right.sd(l) > std::abs(right.lumps(l)))
        result_.warnings.push_back(fmt::format("{} cannot be told from zero by this campaign ({:.3g}, sd {:.3g})",
                                               name_of(static_cast<TwoModeLump>(l)), right.lumps(l), right.sd(l)));
  }

  void add_fits(const TwoModeData& data, const TwoModeFit& fit) {
    ProcedureSection& section = result_.sections.back();
    Figure figure;
    figure.title = "Data, fit and the share of every term, Eqs. (6.49), (6.50)";
    figure.x = {"Ensemble", "", false, {}};
    const std::pair<const RealRegression*, const char*> parts[] = {{&fit.first, "a1"}, {&fit.second, "a2"}};
    for (const auto& [regression, name] : parts) {
      Series measured, fitted;
      measured.style = SeriesStyle::points;
      measured.role = SeriesRole::data;
      measured.name = "measured";
      fitted.name = "fit";
      const VectorXd values = regression->design * regression->fit.coefficients;
      for (Index i = 0; i < values.size(); ++i) {
        measured.x.push_back(static_cast<double>(i + 1));
        measured.y.push_back(regression->response(i));
      }
      fitted.x = measured.x;
      fitted.y.assign(values.data(), values.data() + values.size());
      report::Panel panel{"", {std::string("Peak amplitude ") + name, unit_, false, {}}, {measured, fitted}};
      static constexpr const char* terms[] = {"cubic damping", "sin gamma", "cos gamma"};
      for (Index c = 0; c < 3; ++c) {
        Series term;
        term.name = terms[c];
        term.role = c == 0 ? SeriesRole::held_out : c == 1 ? SeriesRole::reference : SeriesRole::alternative;
        const VectorXd share = regression->design.col(c) * regression->fit.coefficients(c);
        term.x = measured.x;
        term.y.assign(share.data(), share.data() + share.size());
        panel.series.push_back(std::move(term));
      }
      figure.panels.push_back(std::move(panel));
    }
    section.figures.emplace_back(std::move(figure),
                                 "What the source shows in Figures 6.10 to 6.13: ensembles in the order of the "
                                 "campaign.");
    Figure response;
    response.title = "Amplitudes of both modes";
    response.x = {"Excitation frequency", "Hz", false, {}};
    std::vector<std::string> groups;
    for (const Condition& c : conditions_)
      if (std::find(groups.begin(), groups.end(), c.group) == groups.end()) groups.push_back(c.group);
    for (int mode = 0; mode < 2; ++mode) {
      report::Panel panel{"", {mode == 0 ? "Peak amplitude a1" : "Peak amplitude a2", unit_, false, {}}, {}};
      for (std::size_t g = 0; g < groups.size(); ++g) {
        Series points;
        points.style = SeriesStyle::points;
        points.role = SeriesRole::data;
        points.group = static_cast<int>(g);
        points.name = mode == 0 ? groups[g] : "";
        for (Index i = 0; i < data.first.size(); ++i) {
          const Observation& o = result_.measured.observations[static_cast<std::size_t>(i)];
          if (result_.campaign.records[o.record].group != groups[g]) continue;
          points.x.push_back(data.excitation_frequency(i) * to_hz);
          points.y.push_back(mode == 0 ? data.first(i) : data.second(i));
        }
        panel.series.push_back(std::move(points));
      }
      response.panels.push_back(std::move(panel));
    }
    section.figures.emplace_back(std::move(response), "Every ensemble used.");
  }

  void thesis_anova(const TwoModeFit& fit) {
    ProcedureSection section;
    section.method = "anova";
    section.title = "Analysis of variance, terms added last (Tables D.1-D.5)";
    section.text =
        "F compares the growth of the residual without a term to the residual, every ensemble taken as independent "
        "(the source's reading; its tables print 306 where rows minus terms is 307). By condition: the term's "
        "coefficients against their covariance from leaving out one condition at a time, because ten ensembles of "
        "one dwell are not ten conditions. Equal weights, as in the regressions (6.49)-(6.51) that these tables "
        "test.";
    std::vector<int> condition;
    for (const Observation& o : result_.measured.observations) condition.push_back(o.condition);
    const auto table = [&](const RealRegression& r, const std::vector<AnovaTerm>& terms) {
      return added_last_anova(r.design, r.response, condition, terms);
    };
    section.anova.emplace_back(
        "Eq. (6.49)",
        table(fit.first, {{"mu13 a1^3", {0}}, {"Gamma_5 F a2 sin gamma", {1}}, {"Gamma_6 F a2 cos gamma", {2}}}));
    section.anova.emplace_back("Eq. (6.50)", table(fit.second, {{"mu23 a2^3", {0}},
                                                                {"Gamma_11 F a1 sin gamma", {1}},
                                                                {"Gamma_12 F a1 cos gamma", {2}}}));
    section.anova.emplace_back("Eq. (6.51)", table(fit.combined, {{"w2 Gamma_1 + w1 Gamma_7", {0}},
                                                                  {"w2 Gamma_2 + w1 Gamma_9", {1}},
                                                                  {"w2 Gamma_3 + w1 Gamma_8", {2}},
                                                                  {"both cubic sums", {1, 2}},
                                                                  {"w2 Gamma_4 + w1 Gamma_10", {3}},
                                                                  {"Gamma_5", {4}}}));
    result_.sections.push_back(std::move(section));
  }

  // The same of the generated modulation equations, whatever the model.
  void generated_anova() {
    std::vector<double> natural = mean_frequencies(result_.measured);
    ProcedureSection section;
    section.method = "anova";
    section.title = "Analysis of variance of the generated modulation equations, terms added last";
    section.text =
        "The engine's columns, divided by the mode's amplitude and turned by its phase: growth and frequency rows. "
        "Weighted by measured noise: as `secular identify` regresses them, residuals of equal variance, which is "
        "what "
        "an F test supposes; sums of squares are over noise. Equal weights: rows in 1/s as they are, the source's "
        "way, "
        "in which noisy small amplitudes have as much say as large ones. What the data cannot tell apart shows as "
        "a "
        "large p for each and a small one together.";
    for (std::size_t b = 0; b < result_.resonance->blocks.size(); ++b) {
      if (result_.resonance->blocks[b].kind != BlockKind::modulation) continue;
      const std::string name(result_.resonance->blocks[b].name);
      section.anova.emplace_back(name + ", weighted by measured noise",
                                 anova_of(weighted_block_rows(result_.measured, b, natural, request_.left_out)));
      section.anova.emplace_back(name + ", equal weights",
                                 anova_of(block_rows(result_.measured, b, natural, request_.left_out)));
    }
    check_terms(section);
    result_.sections.push_back(std::move(section));
  }

  // Every column by itself, and those that the caller asks for together.
  AnovaTable anova_of(const BlockRows& rows) const {
    std::vector<AnovaTerm> terms;
    for (std::size_t c = 0; c < rows.names.size(); ++c) terms.push_back({rows.names[c], {static_cast<int>(c)}});
    for (const std::vector<std::string>& together : request_.terms) {
      AnovaTerm term;
      for (const std::string& name : together) {
        const auto found = std::find(rows.names.begin(), rows.names.end(), name);
        if (found == rows.names.end()) continue;
        term.name += (term.name.empty() ? "" : ", ") + name;
        term.columns.push_back(static_cast<int>(found - rows.names.begin()));
      }
      if (!term.columns.empty()) terms.push_back(std::move(term));
    }
    return added_last_anova(rows.regression.design, rows.regression.response, rows.condition, terms);
  }

  void check_terms(const ProcedureSection& section) const {
    const auto known = [&](const std::string& name) {
      for (const auto& [block, table] : section.anova)
        for (const AnovaRow& row : table.rows)
          if (row.name == name) return true;
      return false;
    };
    for (const std::vector<std::string>& together : request_.terms)
      for (const std::string& name : together)
        if (!known(name))
          throw InputError("--term " + name, "", "is no column of the case's modulation equations",
                           "see the names that the analysis of variance lists");
  }

  const ProcedureRequest& request_;
  ProcedureRun result_;
  std::optional<VectorXd> truth_;
  std::vector<Condition> conditions_;
  double centre_ = 0;  // excitation frequency at exact resonance, rad/s
  std::string unit_;
};

}  // namespace

ProcedureRun run_procedures(const ProcedureRequest& request) {
  return Runner(request).run();
}

}  // namespace secular::app
