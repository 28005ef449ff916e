#include "app/procedure/harmonics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "thesis/procedures/harmonic_regression.hpp"
#include "thesis/procedures/thesis_harmonics.hpp"

namespace secular::app {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;
using report::Figure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

EnsembleTones tones_of(const CompiledModel& model, const Observation& o) {
  EnsembleTones tones;
  tones.excitation_frequency = o.excitation_frequency[0];
  tones.excitation = o.forcing[0];
  for (std::size_t k = 0; k < model.modes(); ++k) {
    tones.mode_frequency[k] = o.rate[k].imag();
    tones.mode[k] = 2.0 * o.amplitude[k];
  }
  return tones;
}

// Observed frequency of a block's harmonic in an ensemble.
double block_frequency(const CompiledModel& model, const RegressorBlock& block, const Observation& o) {
  double frequency = 0;
  const std::size_t modes = model.modes();
  for (std::size_t i = 0; i < block.phase.size(); ++i)
    frequency += block.phase[i] * (i < modes ? o.rate[i].imag() : o.excitation_frequency[i - modes]);
  return frequency;
}

std::optional<double> harmonic_truth(const KnownTruth& truth, std::string_view unknown) {
  const auto combined = [&](const char* alpha, const char* delta, double factor) -> std::optional<double> {
    const auto a = truth.symbol(alpha), d = truth.symbol(delta);
    if (!a || !d) return {};
    return *a - factor * *d;
  };
  if (!truth.known()) return {};
  const VectorXd& p = truth.parameters();
  if (unknown == "alpha2 - 3 delta2 w0^2") return combined("alpha2", "delta2", 3 * p(0) * p(0));
  if (unknown == "alpha22 - w1 w2 delta22 - w1^2 delta22")
    return combined("alpha22", "delta22", p(0) * p(1) + p(0) * p(0));
  if (unknown == "alpha23 - w1 w2 delta23 - w2^2 delta23")
    return combined("alpha23", "delta23", p(0) * p(1) + p(1) * p(1));
  return truth.symbol(unknown);
}

Figure harmonic_figure(const ProcedureData& test, const ThesisHarmonic& equation, const HarmonicFit& fit) {
  Figure figure;
  figure.title = fmt::format("Estimates by condition, Eq. ({})", equation.equation);
  figure.x = {fmt::format("Peak amplitude of {}", test.run.model->coordinates[0]), test.unit, false, {}};
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
      for (const Observation& o : test.run.measured.observations)
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

void add_harmonic(const ProcedureData& test, const ThesisHarmonic& equation, std::size_t block) {
  const auto& seen = test.run.measured.observations;
  HarmonicFit fits[2];
  for (const bool printed : {false, true}) {
    HarmonicData data;
    data.columns.resize(static_cast<Index>(seen.size()), static_cast<Index>(equation.unknowns.size()));
    data.target.resize(data.columns.rows());
    std::vector<Complex> columns(equation.unknowns.size());
    for (Index i = 0; i < data.target.size(); ++i) {
      const Observation& o = seen[static_cast<std::size_t>(i)];
      equation.columns(tones_of(*test.run.model, o), printed, columns.data());
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
      test.run.resonance->blocks[block].name, test.run.model->modes() == 1 ? "" : " signals", seen.size(),
      equation.misprint);
  const HarmonicFit& right = fits[0];
  for (std::size_t j = 0; j < equation.unknowns.size(); ++j) {
    const auto at = static_cast<Index>(j);
    ProcedureRow r = procedure_row(std::string(equation.unknowns[j]), "", std::string(equation.equation),
                                   {right.pooled.coefficients(at), std::sqrt(right.pooled.covariance(at, at)),
                                    fits[1].mean(at), harmonic_truth(test.truth, equation.unknowns[j])});
    r.scatter = right.sd(at);
    section.rows.push_back(std::move(r));
  }
  section.figures.emplace_back(harmonic_figure(test, equation, right), "Every condition's own estimate.");
  test.run.sections.push_back(std::move(section));
}

}  // namespace

void harmonic_procedure(const ProcedureData& test) {
  for (const ThesisHarmonic& equation : thesis_harmonics()) {
    if (equation.modes != test.run.model->modes()) continue;
    const Observation& first = test.run.measured.observations.front();
    std::optional<std::size_t> measured_in;
    for (std::size_t b = 0; b < test.run.resonance->blocks.size(); ++b) {
      const RegressorBlock& block = test.run.resonance->blocks[b];
      const double wanted = equation.frequency(tones_of(*test.run.model, first));
      if (block.kind == BlockKind::harmonic && static_cast<std::size_t>(block.mode) == equation.mode &&
          std::abs(block_frequency(*test.run.model, block, first) - wanted) < 1e-3 * wanted &&
          first.harmonic_sd[b] > 0)
        measured_in = b;
    }
    if (!measured_in) {
      test.run.warnings.push_back(
          fmt::format("Eq. ({}): this model's expansion has no such harmonic, left out", equation.equation));
      continue;
    }
    add_harmonic(test, equation, *measured_in);
  }
}

}  // namespace secular::app
