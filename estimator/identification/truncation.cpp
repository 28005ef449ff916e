#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>

#include "estimator/identification/equation_data.hpp"
#include "estimator/identification/estimate.hpp"
#include "estimator/identification/identified_lumps.hpp"
#include "estimator/identification/short_list.hpp"
#include "estimator/identification/unsupported_values.hpp"
#include "estimator/identification/value_errors.hpp"
#include "measure/observe/common_observations.hpp"
#include "numerics/confidence.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Observations x blocks: left minus right side of the truncated equations, at motions of the full ones, with the
// columns at `column_frequency`.
Eigen::MatrixXcd left_by_truncation(const ObservationSet& motions, const VectorXd& parameters,
                                    const std::vector<double>& column_frequency, unsigned threads) {
  const CompiledCase& resonance = *motions.resonance;
  std::vector<std::size_t> blocks;
  for (std::size_t b = 0; b < resonance.blocks.size(); ++b)
    if (resonance.blocks[b].kind == BlockKind::modulation || resonance.blocks[b].order <= 1) blocks.push_back(b);
  EquationPoint at{std::vector<double>(resonance.lumps.size()),
                   {parameters.data(), parameters.data() + motions.model->modes()}};
  if (!at.lump.empty()) resonance.evaluate_lumps(parameters.data(), at.lump.data());
  EquationData data(motions, blocks, EquationData::Errors::none);
  data.evaluate(column_frequency);
  Eigen::MatrixXcd left = Eigen::MatrixXcd::Zero(static_cast<Index>(motions.observations.size()),
                                                 static_cast<Index>(resonance.blocks.size()));
  in_parallel(motions.observations.size(), threads, [&](std::size_t i) {
    const EquationData::Rows rows = data.rows(i, {}, at, at.natural_frequency);
    for (Index r = 0; r < rows.response.size(); ++r) {
      const auto row = static_cast<std::size_t>(r);
      left(static_cast<Index>(i), static_cast<Index>(rows.block[row])) +=
          rows.part[row] == EquationPart::in_phase ? std::complex<double>(rows.response(r))
                                                   : std::complex<double>(0, rows.response(r));
    }
  });
  return left;
}

}  // namespace

std::vector<ObservationSet> with_truncation(std::span<const ObservationSet> sets,
                                            std::span<const ObservationSet> replayed, const VectorXd& parameters,
                                            unsigned threads) {
  std::vector<ObservationSet> result;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    ObservationSet set = sets[s];
    set.column_frequency.assign(parameters.data(), parameters.data() + set.model->modes());
    const Eigen::MatrixXcd left = left_by_truncation(replayed[s], parameters, set.column_frequency, threads);
    std::vector<Observation> kept;
    std::vector<Index> from;
    for_common_observations(set, replayed[s], [&](std::size_t i, std::size_t other) {
      kept.push_back(std::move(set.observations[i]));
      from.push_back(static_cast<Index>(other));
    });
    set.observations = std::move(kept);
    set.truncation = left(from, Eigen::all);
    result.push_back(std::move(set));
  }
  return result;
}

std::vector<Eigen::MatrixXcd> truncation_difference(std::span<const ObservationSet> corrected,
                                                    std::span<const ObservationSet> replayed,
                                                    const VectorXd& parameters, unsigned threads) {
  std::vector<Eigen::MatrixXcd> result;
  for (std::size_t s = 0; s < corrected.size(); ++s) {
    const Eigen::MatrixXcd &from = corrected[s].truncation,
                           to = left_by_truncation(replayed[s], parameters, corrected[s].column_frequency, threads);
    Eigen::MatrixXcd difference = Eigen::MatrixXcd::Zero(from.rows(), from.cols());
    for_common_observations(corrected[s], replayed[s], [&](std::size_t i, std::size_t other) {
      const auto row = static_cast<Index>(i);
      difference.row(row) = to.row(static_cast<Index>(other)) - from.row(row);
    });
    result.push_back(std::move(difference));
  }
  return result;
}

void keep_truncation_change(std::span<ObservationSet> to, std::span<const ObservationSet> from) {
  for (std::size_t s = 0; s < to.size(); ++s) {
    const auto kept = [&](const std::vector<Eigen::MatrixXcd>& changes) {
      std::vector<Eigen::MatrixXcd> result;
      for (const Eigen::MatrixXcd& known : changes) {
        Eigen::MatrixXcd change = Eigen::MatrixXcd::Zero(to[s].truncation.rows(), to[s].truncation.cols());
        for_common_observations(to[s], from[s], [&](std::size_t i, std::size_t other) {
          change.row(static_cast<Index>(i)) = known.row(static_cast<Index>(other));
        });
        result.push_back(std::move(change));
      }
      return result;
    };
    to[s].truncation_change = kept(from[s].truncation_change);
    to[s].truncation_of_moves = kept(from[s].truncation_of_moves);
  }
}

Estimate with_correction_shown(Estimate corrected, const Estimate& raw) {
  const auto add = [](std::vector<EstimatedValue>& values, const std::vector<EstimatedValue>& before) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      EstimatedValue& value = values[i];
      if (!value.value || !before[i].value || value.fixed) continue;
      value.truncation = *before[i].value - *value.value;
    }
  };
  add(corrected.parameters, raw.parameters);
  add(corrected.lumps, raw.lumps);
  return corrected;
}

Estimate with_unsettled_correction(Estimate latest, const VectorXd& before, const VectorXd& next) {
  std::vector<std::string> moved;
  const auto widen = [&](EstimatedValue& value, double change) {
    if (!value.value || value.fixed || !(change > 0)) return;
    if (change > value.sd) {
      doubt(value, "the correction for the expansion's truncation has not come to rest");
      const std::string label = label_of(value, latest);
      if (std::find(moved.begin(), moved.end(), label) == moved.end()) moved.push_back(label);
    }
    value.sd = std::hypot(value.sd, change);
    value.significant = value.sd > 0 && two_sided_p_value(*value.value / value.sd, value.degrees_of_freedom) < 0.05;
  };
  for (std::size_t p = 0; p < latest.parameters.size(); ++p)
    widen(latest.parameters[p], std::abs(next(static_cast<Index>(p)) - before(static_cast<Index>(p))));
  const VectorXd change = (lumps_of(latest.cases, next) - lumps_of(latest.cases, before)).cwiseAbs();
  for (std::size_t l = 0; l < latest.lumps.size(); ++l) widen(latest.lumps[l], change(static_cast<Index>(l)));
  latest.correction_settled = moved.empty();
  if (!moved.empty())
    latest.warnings.push_back("the correction for the expansion's truncation has not come to rest, doubtful: " +
                              short_list(moved));
  return latest;
}

Estimate with_failed_correction(Estimate raw, const std::string& why) {
  doubt_all(raw, "the full equations with these numbers do not make the motion that was measured");
  raw.warnings.push_back(
      "the full equations with these numbers do not make the motion that was measured (" + why +
      "): every value is doubtful, and standard deviations do not contain the expansion's truncation");
  take_out(raw, cases_of_few_conditions(raw),
           "of too few conditions, and the full equations with these numbers do not make the measured motion");
  return raw;
}

}  // namespace secular
