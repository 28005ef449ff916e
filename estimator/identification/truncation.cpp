#include <Eigen/Dense>
#include <cmath>
#include <complex>

#include "estimator/identification/equation_data.hpp"
#include "estimator/identification/estimate.hpp"
#include "estimator/regression/confidence.hpp"
#include "estimator/regression/nonlinear_fit.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Lumps of all cases of the estimate, one after the other, and their slope.
VectorXd all_lumps(const Estimate& estimate, const VectorXd& parameters, RowMajor* slope) {
  VectorXd lumps(static_cast<Index>(estimate.lumps.size()));
  if (slope) slope->resize(lumps.size(), parameters.size());
  Index at = 0;
  for (const CompiledCase* resonance : estimate.cases) {
    const auto count = static_cast<Index>(resonance->lumps.size());
    if (count == 0) continue;
    resonance->evaluate_lumps(parameters.data(), lumps.data() + at);
    if (slope) resonance->evaluate_lumps_jacobian(parameters.data(), slope->row(at).data());
    at += count;
  }
  return lumps;
}

// Parameters near `start` that give the estimated lumps and natural frequencies, each weighed by its error bar.
VectorXd representative(const Estimate& estimate, const VectorXd& start, const CompiledModel& model) {
  std::vector<std::size_t> lumps_used, parameters_used;
  for (std::size_t l = 0; l < estimate.lumps.size(); ++l)
    if (estimate.lumps[l].value && estimate.lumps[l].sd > 0) lumps_used.push_back(l);
  for (std::size_t p = 0; p < model.symbols.size(); ++p)
    if (estimate.parameters[p].value && (estimate.parameters[p].sd > 0 || estimate.parameters[p].fixed))
      parameters_used.push_back(p);
  const ResidualFunction function = [&](const VectorXd& parameters, VectorXd& residual, MatrixXd& jacobian) {
    RowMajor slope;
    const VectorXd lumps = all_lumps(estimate, parameters, &slope);
    Index r = 0;
    for (const std::size_t l : lumps_used) {
      const EstimatedValue& v = estimate.lumps[l];
      residual(r) = (lumps(static_cast<Index>(l)) - *v.value) / v.sd;
      jacobian.row(r++) = slope.row(static_cast<Index>(l)) / v.sd;
    }
    for (const std::size_t p : parameters_used) {
      const EstimatedValue& v = estimate.parameters[p];
      const double sd = v.fixed ? 1e-9 * (1e-9 + std::abs(*v.value)) : v.sd;
      residual(r) = (parameters(static_cast<Index>(p)) - *v.value) / sd;
      jacobian.row(r).setZero();
      jacobian(r++, static_cast<Index>(p)) = 1 / sd;
    }
  };
  const auto rows = static_cast<Index>(lumps_used.size() + parameters_used.size());
  return rows > 0 ? nonlinear_fit(function, rows, start).parameters : start;
}

}  // namespace

std::vector<ObservationSet> with_truncation(std::span<const ObservationSet> sets,
                                            std::span<const ObservationSet> replayed, const VectorXd& parameters) {
  std::vector<ObservationSet> result;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    ObservationSet set = sets[s];
    const ObservationSet& exact = replayed[s];
    const CompiledCase& resonance = *set.resonance;
    std::vector<std::size_t> blocks;
    for (std::size_t b = 0; b < resonance.blocks.size(); ++b)
      if (resonance.blocks[b].kind == BlockKind::modulation || resonance.blocks[b].order <= 1) blocks.push_back(b);
    std::vector<double> lumps(resonance.lumps.size());
    if (!lumps.empty()) resonance.evaluate_lumps(parameters.data(), lumps.data());
    const std::vector<double> natural(parameters.data(), parameters.data() + set.model->modes());
    EquationData data(exact, blocks);
    data.evaluate(natural);
    std::vector<Observation> kept;
    set.truncation = Eigen::MatrixXcd::Zero(static_cast<Index>(set.observations.size()),
                                            static_cast<Index>(resonance.blocks.size()));
    std::size_t from = 0;  // both are in the same order
    for (const Observation& o : set.observations) {
      while (from < exact.observations.size() &&
             (exact.observations[from].record < o.record ||
              (exact.observations[from].record == o.record && exact.observations[from].centre_s < o.centre_s)))
        ++from;
      if (from == exact.observations.size() || exact.observations[from].record != o.record ||
          exact.observations[from].centre_s != o.centre_s)
        continue;
      const EquationData::Rows rows = data.rows(from, {}, lumps, natural, natural);
      for (Index r = 0; r < rows.response.size(); ++r) {
        const std::size_t b = rows.block[static_cast<std::size_t>(r)];
        const bool imaginary = r > 0 && rows.block[static_cast<std::size_t>(r - 1)] == b;
        const std::complex<double> part = imaginary ? std::complex<double>(0, rows.response(r)) : rows.response(r);
        set.truncation(static_cast<Index>(kept.size()), static_cast<Index>(b)) += part;
      }
      kept.push_back(o);
    }
    set.observations = std::move(kept);
    set.truncation.conservativeResize(static_cast<Index>(set.observations.size()), Eigen::NoChange);
    result.push_back(std::move(set));
  }
  return result;
}

Estimate with_truncation_error(Estimate corrected, const Estimate& raw) {
  const auto add = [](std::vector<EstimatedValue>& values, const std::vector<EstimatedValue>& before) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      EstimatedValue& value = values[i];
      if (!value.value || !before[i].value || value.fixed) continue;
      value.truncation = *before[i].value - *value.value;
      value.sd = std::hypot(value.sd, 0.5 * value.truncation);
      value.significant =
          value.sd > 0 && two_sided_p_value(*value.value / value.sd, value.degrees_of_freedom) < 0.05;
    }
  };
  add(corrected.parameters, raw.parameters);
  add(corrected.lumps, raw.lumps);
  return corrected;
}

Estimate with_unsettled_correction(Estimate latest, const Estimate& before) {
  std::string moved;
  const auto add = [&](std::vector<EstimatedValue>& values, const std::vector<EstimatedValue>& earlier) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      EstimatedValue& value = values[i];
      if (!value.value || !earlier[i].value || value.fixed) continue;
      const double change = std::abs(*value.value - *earlier[i].value);
      if (change > value.sd) {
        value.doubtful = true;
        if ((moved + ",").find(" " + value.name + ",") == std::string::npos)
          moved += (moved.empty() ? " " : ", ") + value.name;
      }
      value.sd = std::hypot(value.sd, change);
      value.significant =
          value.sd > 0 && two_sided_p_value(*value.value / value.sd, value.degrees_of_freedom) < 0.05;
    }
  };
  add(latest.parameters, before.parameters);
  add(latest.lumps, before.lumps);
  if (!moved.empty())
    latest.warnings.push_back("the correction for the expansion's truncation has not come to rest, doubtful:" +
                              moved);
  return latest;
}

Estimate truncation_corrected(const Estimate& raw, const Estimate& replayed, const VectorXd& replay_parameters,
                              const CompiledModel& model) {
  Estimate corrected = raw;
  const VectorXd lumps = all_lumps(raw, replay_parameters, nullptr);
  const auto correct = [](EstimatedValue& value, const EstimatedValue& again, double truth) {
    if (!value.value || !again.value || value.fixed) return;
    value.truncation = *again.value - truth;
    *value.value -= value.truncation;
    value.sd = std::hypot(value.sd, 0.5 * value.truncation);
    value.significant = value.sd > 0 && two_sided_p_value(*value.value / value.sd, value.degrees_of_freedom) < 0.05;
    if (value.bootstrap) {
      value.bootstrap->low -= value.truncation;
      value.bootstrap->high -= value.truncation;
    }
  };
  for (std::size_t l = 0; l < corrected.lumps.size(); ++l)
    correct(corrected.lumps[l], replayed.lumps[l], lumps(static_cast<Index>(l)));
  for (std::size_t p = 0; p < model.symbols.size(); ++p)
    correct(corrected.parameters[p], replayed.parameters[p], replay_parameters(static_cast<Index>(p)));
  corrected.parameter_values = representative(corrected, replay_parameters, model);
  return corrected;
}

}  // namespace secular
