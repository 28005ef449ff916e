#include "app/procedure/one_mode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "app/procedure/harmonics.hpp"
#include "app/procedure/one_mode_figures.hpp"
#include "input/numerical_failure.hpp"
#include "thesis/procedures/competing_terms.hpp"
#include "thesis/procedures/frequency_response_regression.hpp"
#include "thesis/procedures/saddle_node_regression.hpp"

namespace secular::app {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// The points of the saddle-node diagram: per level the largest amplitude, of the groups that vary the level.
std::vector<const DwellMean*> saddle_node_points(const std::vector<DwellMean>& dwells) {
  std::map<std::string, std::vector<const DwellMean*>> groups;
  for (const DwellMean& c : dwells) groups[c.group].push_back(&c);
  const auto levels_of = [](std::vector<const DwellMean*> members) {
    std::sort(members.begin(), members.end(), [](auto* a, auto* b) { return a->forcing < b->forcing; });
    std::vector<const DwellMean*> best;
    for (const DwellMean* c : members) {
      if (best.empty() || c->forcing > best.back()->forcing * (1 + same_level))
        best.push_back(c);
      else if (c->amplitude > best.back()->amplitude)
        best.back() = c;
    }
    return best;
  };
  std::vector<const DwellMean*> chosen, all;
  for (const auto& [name, members] : groups) {
    all.insert(all.end(), members.begin(), members.end());
    const auto levels = levels_of(members);
    if (levels.size() >= 3) chosen.insert(chosen.end(), levels.begin(), levels.end());
  }
  return levels_of(chosen.empty() ? all : chosen);
}

FrequencyResponseData response_data(const ProcedureData& test, const SaddleNodeFit& damping, NonlinearDamping law,
                                    bool with_phase) {
  FrequencyResponseData data;
  const auto& seen = test.run.measured.observations;
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
  data.omega0 = 0.5 * test.centre;
  data.linear = damping.lowered_linear;
  (law == NonlinearDamping::quadratic ? data.quadratic : data.cubic) = damping.nonlinear;
  return data;
}

// Drag against cubic damping on all ensembles, beside the saddle-node diagram's eight points.
void decide_damping(const ProcedureData& test) {
  std::vector<std::string> laws;
  for (const char* name : {"mu2", "mu3"})
    for (const CompiledLump& lump : test.run.resonance->lumps)
      if (lump.name == name) laws.emplace_back(name);
  if (laws.size() < 2 || !test.wants("saddle_node")) return;
  std::vector<CompetingTerm> order;
  try {
    order = compare_terms(test.run.measured, test.unit, {test.run.campaign.channels.front().unit}, laws);
  } catch (const NumericalFailure& failure) {
    test.run.warnings.push_back(std::string("drag and cubic damping are not compared: ") + failure.what());
    return;
  }
  ProcedureSection section;
  section.method = "damping_law";
  section.title = "Drag or cubic damping";
  section.text = fmt::format(
      "All {} ensembles on the generated modulation equations with one of the two laws at a time: with {} the "
      "residual is {:.3g} times what noise explains, with {} {:.3g} times. {} is decided for.",
      test.run.measured.observations.size(), order[0].name, order[0].normalised_residual, order[1].name,
      order[1].normalised_residual, order[0].name == "mu3" ? "Cubic damping" : "Drag");
  test.run.sections.push_back(std::move(section));
}

/// One damping law: both regressions with what is printed and with what is right.
struct LawFit {
  NonlinearDamping law;
  SaddleNodeFit printed, right;
  FrequencyResponseFit printed_response, right_response;

  bool cubic() const { return law == NonlinearDamping::cubic; }
  std::string nonlinear() const { return cubic() ? "mu3" : "mu2"; }
};

// The saddle-node needs |alpha_e/eta_e|, the frequency response the damping: in turn until both stand.
LawFit fit_law(const ProcedureData& test, NonlinearDamping law, const std::vector<const DwellMean*>& points) {
  const double w0 = 0.5 * test.centre;
  VectorXd amplitude(static_cast<Index>(points.size())), forcing(amplitude.size());
  for (Index i = 0; i < amplitude.size(); ++i) {
    amplitude(i) = points[static_cast<std::size_t>(i)]->amplitude;
    forcing(i) = points[static_cast<std::size_t>(i)]->forcing;
  }
  LawFit fit{law, saddle_node_regression(law, amplitude, forcing, w0), {}, {}, {}};
  fit.printed_response = frequency_response_regression(response_data(test, fit.printed, law, false));
  fit.right = fit.printed;
  for (int pass = 0; pass < 50; ++pass) {
    fit.right_response = frequency_response_regression(response_data(test, fit.right, law, true));
    const double before = fit.right.nonlinear;
    fit.right = saddle_node_regression(law, amplitude, forcing, w0,
                                       std::abs(fit.right_response.stiffness / fit.right_response.excitation));
    if (std::abs(fit.right.nonlinear - before) < 1e-10 * std::abs(before)) break;
  }
  return fit;
}

ProcedureSection saddle_node_section(const ProcedureData& test, const LawFit& fit, const std::string& comparison,
                                     const std::vector<const DwellMean*>& points) {
  const bool cubic = fit.cubic();
  const std::string equation = cubic ? "5.37" : "5.35", nonlinear = fit.nonlinear();
  const auto truth_over = [&](const std::string& name) -> std::optional<double> {
    const auto value = test.truth.symbol(name), excitation = test.truth.lump("eta_e");
    if (!value || !excitation) return {};
    return *value / std::abs(*excitation);
  };
  ProcedureSection section;
  section.method = "saddle_node";
  section.title = fmt::format("Saddle-node regression, linear and {} damping", cubic ? "cubic" : "quadratic");
  section.text = fmt::format(
      "Eqs. {} on {} points; residual {:.3g} m/s^2 ({}). As printed the line is the peak of the "
      "response (vanishing radicand of (5.25)); recovered with the saddle-node's own force, where d(sigma)/d(a) "
      "= 0. The linear damping is lowered by {:.3g} (as printed: {:.3g}) so that every point lies on the right "
      "side of the line.",
      cubic ? "(5.36), (5.37)" : "(5.34), (5.35)", points.size(), fit.right.residual_sd, comparison,
      fit.right.linear - fit.right.lowered_linear, fit.printed.linear - fit.printed.lowered_linear);
  section.rows.push_back(procedure_row("mu1/|eta_e|", "m/s", equation,
                                       {fit.right.lowered_linear, std::sqrt(fit.right.covariance(0, 0)),
                                        fit.printed.lowered_linear, truth_over("mu1")}));
  section.rows.push_back(procedure_row(
      nonlinear + "/|eta_e|", cubic ? "s/(kg m)" : "", equation,
      {fit.right.nonlinear, std::sqrt(fit.right.covariance(1, 1)), fit.printed.nonlinear, truth_over(nonlinear)}));
  section.figures.emplace_back(saddle_node_figure(test, points, fit.right, fit.printed, cubic),
                               "Points close to the saddle-nodes (bars: two standard deviations of one "
                               "ensemble) and the fitted lines after the shift.");
  return section;
}

ProcedureSection response_section(const ProcedureData& test, const LawFit& law_fit) {
  const LinearFit& fit = law_fit.right_response.fit;
  const SaddleNodeFit &right = law_fit.right, &printed = law_fit.printed;
  const double eta = std::abs(law_fit.right_response.excitation),
               eta_printed = std::abs(law_fit.printed_response.excitation);
  const bool cubic = law_fit.cubic();
  const std::string nonlinear = law_fit.nonlinear();
  ProcedureSection section;
  section.method = "frequency_response";
  section.title = "Frequency-response regression";
  section.text = fmt::format(
      "Eqs. (5.39), (5.40) with the {} law's damping over {} ensembles ({} left out: there the damping needs "
      "more force than there was). As printed every point takes the plus sign of the radicand; recovered with "
      "the side of the peak that the measured phase tells (sign of cos gamma).",
      cubic ? "cubic" : "quadratic", fit.residual.size(), law_fit.right_response.left_out);
  section.rows.push_back(procedure_row("alpha_e", "1/(kg m^2 s^2)", "5.40",
                                       {law_fit.right_response.stiffness, std::sqrt(fit.covariance(0, 0)),
                                        law_fit.printed_response.stiffness, test.truth.lump("alpha_e")}));
  auto excitation = test.truth.lump("eta_e");
  if (excitation) excitation = std::abs(*excitation);
  section.rows.push_back(
      procedure_row("|eta_e|", "1/m", "5.40",
                    {eta, std::sqrt(fit.covariance(1, 1)), law_fit.printed_response.excitation, excitation}));
  const double eta_share = std::sqrt(fit.covariance(1, 1)) / eta;
  const auto product_sd = [&](double ratio, double ratio_sd) {
    return std::hypot(ratio_sd * eta, ratio * eta * eta_share);
  };
  section.rows.push_back(procedure_row(
      "mu1", "1/s", "5.40",
      {right.lowered_linear * eta, product_sd(right.lowered_linear, std::sqrt(right.covariance(0, 0))),
       printed.lowered_linear * eta_printed, test.truth.symbol("mu1")}));
  section.rows.push_back(
      procedure_row(nonlinear, cubic ? "s/(kg m^2)" : "1/(kg^(1/2) m)", "5.40",
                    {right.nonlinear * eta, product_sd(right.nonlinear, std::sqrt(right.covariance(1, 1))),
                     printed.nonlinear * eta_printed, test.truth.symbol(nonlinear)}));
  section.figures.emplace_back(response_figure(test, right, law_fit.right_response, law_fit.law),
                               "Frequency response: measured, and Eq. (5.25) with the recovered numbers at the "
                               "level of most dwells.");
  return section;
}

void saddle_node_and_response(const ProcedureData& test, const std::vector<const DwellMean*>& points) {
  std::vector<LawFit> laws;
  for (const NonlinearDamping law : {NonlinearDamping::quadratic, NonlinearDamping::cubic}) {
    try {
      laws.push_back(fit_law(test, law, points));
    } catch (const NumericalFailure& failure) {
      test.run.warnings.push_back(fmt::format(
          "saddle-node and frequency-response regressions with {} damping, each of which needs the other, are left "
          "out: {}",
          law == NonlinearDamping::cubic ? "cubic" : "quadratic", failure.what()));
    }
  }
  if (!test.values_only) decide_damping(test);
  auto chosen = laws.begin();
  for (auto law = laws.begin(); law != laws.end(); ++law)
    if (!(chosen->right.residual_sd < law->right.residual_sd)) chosen = law;
  for (auto law = laws.begin(); law != laws.end(); ++law) {
    const char* comparison = laws.size() < 2 ? "the other law has no fit"
                             : law == chosen ? "this law fits better"
                                             : "the other law fits better";
    if (test.wants("saddle_node")) test.run.sections.push_back(saddle_node_section(test, *law, comparison, points));
    if (test.wants("frequency_response") && law == chosen)
      test.run.sections.push_back(response_section(test, *law));
  }
}

}  // namespace

void one_mode_procedures(const ProcedureData& test) {
  const std::vector<const DwellMean*> points = saddle_node_points(test.dwells);
  const bool damping_needed = test.wants("saddle_node") || test.wants("frequency_response");
  if (damping_needed && points.size() < 4) {
    test.run.warnings.push_back(fmt::format(
        "{} excitation level{}: the saddle-node regression needs four or more, and without it the frequency "
        "response has no damping; both are left out",
        points.size(), points.size() == 1 ? "" : "s"));
  } else if (damping_needed) {
    saddle_node_and_response(test, points);
  }
  if (test.wants("harmonic")) harmonic_procedure(test);
}

}  // namespace secular::app
