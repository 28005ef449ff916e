#include "app/procedure/variance.hpp"

#include <algorithm>

#include "input/input_error.hpp"
#include "thesis/procedures/block_rows.hpp"

namespace secular::app {
namespace {

// Every column by itself, and those that the caller asks for together.
AnovaTable anova_of(const BlockRows& rows, const ProcedureRequest& request) {
  std::vector<AnovaTerm> terms;
  for (std::size_t c = 0; c < rows.names.size(); ++c) terms.push_back({rows.names[c], {static_cast<int>(c)}});
  for (const std::vector<std::string>& together : request.terms) {
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

void check_terms(const ProcedureSection& section, const ProcedureRequest& request) {
  const auto known = [&](const std::string& name) {
    for (const auto& [block, table] : section.anova)
      for (const AnovaRow& row : table.rows)
        if (row.name == name) return true;
    return false;
  };
  for (const std::vector<std::string>& together : request.terms)
    for (const std::string& name : together)
      if (!known(name))
        throw InputError("--term " + name, "", "is no column of the case's modulation equations",
                         "see the names that the analysis of variance lists");
}

}  // namespace

void thesis_variance(const ProcedureData& test, const TwoModeFit& fit) {
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
  for (const Observation& o : test.run.measured.observations) condition.push_back(o.condition);
  const auto table = [&](const RealRegression& r, const std::vector<AnovaTerm>& terms) {
    return added_last_anova(r.design, r.response, condition, terms);
  };
  section.anova.emplace_back(
      "Eq. (6.49)",
      table(fit.first, {{"mu13 a1^3", {0}}, {"Gamma_5 F a2 sin gamma", {1}}, {"Gamma_6 F a2 cos gamma", {2}}}));
  section.anova.emplace_back(
      "Eq. (6.50)",
      table(fit.second, {{"mu23 a2^3", {0}}, {"Gamma_11 F a1 sin gamma", {1}}, {"Gamma_12 F a1 cos gamma", {2}}}));
  section.anova.emplace_back("Eq. (6.51)", table(fit.combined, {{"w2 Gamma_1 + w1 Gamma_7", {0}},
                                                                {"w2 Gamma_2 + w1 Gamma_9", {1}},
                                                                {"w2 Gamma_3 + w1 Gamma_8", {2}},
                                                                {"both cubic sums", {1, 2}},
                                                                {"w2 Gamma_4 + w1 Gamma_10", {3}},
                                                                {"Gamma_5", {4}}}));
  test.run.sections.push_back(std::move(section));
}

void generated_variance(const ProcedureData& test) {
  std::vector<double> natural = mean_frequencies(test.run.measured);
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
  for (std::size_t b = 0; b < test.run.resonance->blocks.size(); ++b) {
    if (test.run.resonance->blocks[b].kind != BlockKind::modulation) continue;
    const std::string name(test.run.resonance->blocks[b].name);
    section.anova.emplace_back(
        name + ", weighted by measured noise",
        anova_of(weighted_block_rows(test.run.measured, b, natural, test.request.left_out), test.request));
    section.anova.emplace_back(
        name + ", equal weights",
        anova_of(block_rows(test.run.measured, b, natural, test.request.left_out), test.request));
  }
  check_terms(section, test.request);
  test.run.sections.push_back(std::move(section));
}

}  // namespace secular::app
