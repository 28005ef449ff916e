#include "app/procedure/two_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "app/procedure/harmonics.hpp"
#include "app/procedure/variance.hpp"
#include "input/numerical_failure.hpp"
#include "measure/signal/bispectral_phase.hpp"
#include "numerics/hertz.hpp"
#include "thesis/procedures/block_rows.hpp"
#include "thesis/procedures/engine_lumps.hpp"
#include "thesis/procedures/two_mode_regression.hpp"

namespace secular::app {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using report::Figure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

void check_locking(const ProcedureData& test) {
  std::map<int, std::vector<const Observation*>> members;
  for (const Observation& o : test.run.measured.observations) members[o.condition].push_back(&o);
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
      test.run.warnings.push_back(fmt::format(
          "{}: the bispectral phase does not stand still (bicoherence {:.2f}): this is no combination resonance",
          test.run.campaign.records[ensembles.front()->record].file, phase.bicoherence));
  }
}

void add_lumps(const ProcedureData& test, const TwoModeFit& right, const TwoModeFit& printed) {
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
      test.centre * to_hz, 1 / singular(singular.size() - 1));
  std::optional<VectorXd> truth;
  if (test.truth.known()) truth = two_mode_lumps(*test.run.model, *test.run.resonance, test.truth.parameters());
  static constexpr const char* units[] = {"1/s", "1/s",   "s/(kg m^2)",     "s/(kg m^2)",     "1/m",  "1/m",
                                          "1/m", "1/s^3", "1/(kg m^2 s^3)", "1/(kg m^2 s^3)", "s/m^2"};
  for (Index l = 0; l < right.lumps.size(); ++l)
    section.rows.push_back(procedure_row(std::string(name_of(static_cast<TwoModeLump>(l))), units[l], "6.51",
                                         {right.lumps(l), right.sd(l), printed.lumps(l),
                                          truth ? std::optional<double>((*truth)(l)) : std::nullopt}));
  test.run.sections.push_back(std::move(section));
  for (Index l = 0; l < right.lumps.size(); ++l)
    if (right.sd(l) > std::abs(right.lumps(l)))
      test.run.warnings.push_back(
          fmt::format("{} cannot be distinguished from zero by this campaign ({:.3g}, sd {:.3g})",
                      name_of(static_cast<TwoModeLump>(l)), right.lumps(l), right.sd(l)));
}

void add_fits(const ProcedureData& test, const TwoModeData& data, const TwoModeFit& fit) {
  ProcedureSection& section = test.run.sections.back();
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
    report::Panel panel{"", {std::string("Peak amplitude ") + name, test.unit, false, {}}, {measured, fitted}};
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
  for (const DwellMean& c : test.dwells)
    if (std::find(groups.begin(), groups.end(), c.group) == groups.end()) groups.push_back(c.group);
  for (int mode = 0; mode < 2; ++mode) {
    report::Panel panel{"", {mode == 0 ? "Peak amplitude a1" : "Peak amplitude a2", test.unit, false, {}}, {}};
    for (std::size_t g = 0; g < groups.size(); ++g) {
      Series points;
      points.style = SeriesStyle::points;
      points.role = SeriesRole::data;
      points.group = static_cast<int>(g);
      points.name = mode == 0 ? groups[g] : "";
      for (Index i = 0; i < data.first.size(); ++i) {
        const Observation& o = test.run.measured.observations[static_cast<std::size_t>(i)];
        if (test.run.campaign.records[o.record].group != groups[g]) continue;
        points.x.push_back(data.excitation_frequency(i) * to_hz);
        points.y.push_back(mode == 0 ? data.first(i) : data.second(i));
      }
      panel.series.push_back(std::move(points));
    }
    response.panels.push_back(std::move(panel));
  }
  section.figures.emplace_back(std::move(response), "Every ensemble used.");
}

}  // namespace

void two_mode_procedures(const ProcedureData& test) {
  const auto& seen = test.run.measured.observations;
  check_locking(test);
  if (test.wants("harmonic")) harmonic_procedure(test);
  if (!test.wants("two_modes")) return;
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
  const std::vector<double> mean = mean_frequencies(test.run.measured);
  data.omega1 = mean[0] * test.centre / (mean[0] + mean[1]);
  data.omega2 = mean[1] * test.centre / (mean[0] + mean[1]);
  TwoModeFit right, printed;
  try {
    right = two_mode_regression(data, false);
    printed = two_mode_regression(data, true);
  } catch (const NumericalFailure& failure) {
    test.run.warnings.push_back(std::string("the regression of two modes is left out: ") + failure.what());
    return;
  }
  add_lumps(test, right, printed);
  add_fits(test, data, right);
  if (test.wants("anova") && !test.values_only) thesis_variance(test, right);
}

}  // namespace secular::app
