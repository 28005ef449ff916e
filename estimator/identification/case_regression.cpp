#include "estimator/identification/case_regression.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>

#include "estimator/identification/equation_data.hpp"
#include "estimator/identification/instrument_rows.hpp"
#include "estimator/identification/record_scatter.hpp"
#include "estimator/identification/residual_information.hpp"
#include "estimator/identification/row_noise.hpp"
#include "estimator/identification/window_overlap.hpp"
#include "estimator/model/zero_frequency.hpp"
#include "estimator/regression/condensed_rows.hpp"
#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/in_parallel.hpp"
#include "numerics/median.hpp"
#include "numerics/unit_scale.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int pass_limit = 14;

/// Reweighting ends where no coefficient moves by more than this share of its standard deviation. Ensembles are
/// compared with others of their condition there.
constexpr double converged_change = 0.03;

/// Observations that one thread takes at a time.
constexpr std::size_t chunk = 16;

/// Rows that one thread takes at a time.
constexpr std::size_t rows_at_once = 1024;

/// Each halves the digits that are missing; the adjustments are small.
constexpr int adjustment_rounds = 3;

/// Probability that a campaign without outliers has one down-weighted.
constexpr auto& outlier_false_alarm = estimator_thresholds().outlier_false_alarm;

/// Ensembles of a condition that are needed to tell an outlier.
constexpr auto& replicates_needed = estimator_thresholds().replicates_needed;

// Rows times columns with many zeros: `factor` is lower triangular, and a row of `sparse` has few entries.
template <class Matrix>
void multiply_lower(const MatrixXd& factor, const MatrixXd& sparse, Matrix&& product) {
  const Index size = factor.rows();
  product.setZero();
  for (Index c = 0; c < sparse.cols(); ++c)
    for (Index r = 0; r < size; ++r)
      if (const double value = sparse(r, c); value != 0)
        product.col(c).tail(size - r) += value * factor.col(r).tail(size - r);
}

class CaseRegression {
 public:
  CaseRegression(const ObservationSet& set, const std::vector<std::size_t>& blocks, const CaseKnowledge& known,
                 const Reweighting& reweighting)
      : set_(set), case_(*set.resonance), known_(known), reweighting_(reweighting), data_(set, blocks) {
    result_.set = &set;
    result_.blocks = blocks;
    result_.weight.assign(set.observations.size(), 1.0);
    result_.distance.assign(set.observations.size(), 0.0);
    at_.lump.assign(case_.lumps.size(), 0.0);
    at_.natural_frequency = reference_ = known.natural_frequency;
    offset_.assign(set.model->modes(), 0.0);
    std::set<std::size_t> lumps, frequencies, offsets;
    for (const std::size_t b : blocks) {
      const RegressorBlock& block = case_.blocks[b];
      const auto mode = static_cast<std::size_t>(block.mode);
      for (const int l : block.lumps) lumps.insert(static_cast<std::size_t>(l));
      if (block.kind == BlockKind::modulation && known.fixed_frequency.count(mode) == 0) frequencies.insert(mode);
      if (is_zero_frequency(block)) offsets.insert(mode);
      scale_[b] = 1;
    }
    for (const std::size_t l : lumps) {
      const auto given = known.fixed.find(key_of(case_, l));
      if (given != known.fixed.end())
        at_.lump[l] = given->second;
      else
        result_.columns.push_back({CaseColumn::Kind::lump, l});
    }
    for (const std::size_t k : frequencies) result_.columns.push_back({CaseColumn::Kind::natural_frequency, k});
    for (const std::size_t k : offsets) result_.columns.push_back({CaseColumn::Kind::sensor_offset, k});
    result_.reference = VectorXd::Zero(static_cast<Index>(result_.columns.size()));
    for (std::size_t c = 0; c < result_.columns.size(); ++c)
      if (result_.columns[c].kind == CaseColumn::Kind::natural_frequency)
        result_.reference(static_cast<Index>(c)) = reference_[result_.columns[c].index];
    values_ = VectorXd::Zero(result_.reference.size());
    take_instruments();
    const RegressionState* start = reweighting.start;
    warm_ = start && start->weight.size() == set.observations.size() && start->at.lump.size() == at_.lump.size();
    if (warm_) take_up(*start);
  }

  CaseFit run() {
    if (result_.columns.empty() || set_.observations.empty()) return std::move(result_);
    const bool keep = warm_ && reweighting_.keep;
    if (!keep) iterate(converged_change);
    if (!keep && !reweighting_.rough) {
      if (case_.excited) weigh_ensembles();
      iterate(converged_change);
      for (int round = 0; round < (adjusts() ? adjustment_rounds : 0); ++round) {
        adjust();
        iterate(converged_change);
      }
    }
    assemble(Pass::last);
    WhitenedSystem& system = result_.system;
    // Columns at adjusted values have lost their errors already.
    if (adjusts()) system.errors.with_response.resize(0);
    if (system.design.rows() > 0) {
      result_.fit = linear_fit(system.design, system.response, system.condition, system.errors,
                               {.noisy_before = reweighting_.start ? reweighting_.start->noisy : std::nullopt,
                                .threads = reweighting_.threads});
      take_phases_into_account(result_.fit);
      take_overlap_into_account(result_.fit);
      take_records_into_account();
      take(result_.fit.coefficients);
      block_residuals(result_.fit.residual);
    }
    const MatrixXd change = whitened(set_.truncation_change);
    result_.truncation_effect = effect_of(change);
    result_.moves_effect = effect_of(whitened(set_.truncation_of_moves));
    // Stretches of one decay all lack the same of the truncation: they are no conditions that tell its errors.
    if (case_.excited) result_.residual_information = residual_information(change, result_.fit, system.condition);
    if (result_.fit.coefficients.size() > 0) result_.fit.coefficients += result_.reference;
    result_.state = {at_, offset_, scale_, result_.weight, result_.distance, result_.fit.noisy};
    return std::move(result_);
  }

 private:
  enum class Pass {
    first,     ///< nothing is known of the coefficients, and so of the noise of the equations
    whitened,  ///< by the noise at the present coefficients
    last,      ///< and the errors of the columns
  };

  // Known lumps and frequencies stay what they are given as.
  void take_up(const RegressionState& start) {
    for (std::size_t c = 0; c < result_.columns.size(); ++c) {
      const CaseColumn& column = result_.columns[c];
      const double value = column.kind == CaseColumn::Kind::lump ? start.at.lump[column.index]
                           : column.kind == CaseColumn::Kind::natural_frequency
                               ? start.at.natural_frequency[column.index]
                               : start.offset[column.index];
      values_(static_cast<Index>(c)) = value - result_.reference(static_cast<Index>(c));
    }
    take(values_);
    for (auto& [block, scale] : scale_)
      if (const auto known = start.block_scale.find(block); known != start.block_scale.end()) scale = known->second;
    result_.weight = start.weight;
    result_.distance = start.distance;
  }

  // Coefficients counted from the reference become the current ones.
  void take(const VectorXd& values) {
    values_ = values;
    for (std::size_t c = 0; c < result_.columns.size(); ++c)
      current(c) = values(static_cast<Index>(c)) + result_.reference(static_cast<Index>(c));
  }

  double& current(std::size_t column) {
    const CaseColumn& c = result_.columns[column];
    return c.kind == CaseColumn::Kind::lump                ? at_.lump[c.index]
           : c.kind == CaseColumn::Kind::natural_frequency ? at_.natural_frequency[c.index]
                                                           : offset_[c.index];
  }

  // Each unknown phase takes a degree of freedom of the residual.
  void take_phases_into_account(LinearFit& fit) const {
    const auto free = static_cast<double>(fit.residual.size() - fit.rank);
    const auto taken = static_cast<double>(result_.system.by_phase.size());
    if (taken == 0) return;
    const double factor = free > taken ? free / (free - taken) : std::numeric_limits<double>::quiet_NaN();
    fit.residual_sd *= std::sqrt(factor);
    fit.plain_covariance *= factor;
    if (fit.covariance_kind == CovarianceKind::clustered) return;
    fit.covariance *= factor;
    fit.degrees_of_freedom -= taken;
  }

  // docs/inference.md (45): where there are too few stretches the scatter of all windows tells the error bars.
  void take_overlap_into_account(LinearFit& fit) {
    if (case_.excited) return;
    result_.overlap = window_overlap(result_, adjusted_data_ ? *adjusted_data_ : data_, rows_by_noise_);
    const WindowOverlap& overlap = result_.overlap;
    if (fit.covariance_kind == CovarianceKind::clustered || !(overlap.left > 0 && overlap.left_squared > 0)) return;
    const MatrixXd spread = fit.basis * Eigen::PartialPivLU<MatrixXd>(fit.kept).inverse();
    fit.plain_covariance = fit.residual.squaredNorm() / overlap.left * (spread * overlap.gram * spread.transpose());
    fit.covariance = fit.plain_covariance;
    fit.degrees_of_freedom = overlap.left * overlap.left / overlap.left_squared;
  }

  // The degrees of freedom are those of the coefficient that records move most.
  void take_records_into_account() {
    if (case_.excited && set_.frequency_scatter.empty()) return;
    LinearFit& fit = result_.fit;
    RecordScatter scatter = record_scatter(result_);
    result_.record_scatter = std::move(scatter.frequencies);
    result_.record_moves = std::move(scatter.moves);
    if (result_.record_moves.cols() == 0) return;
    result_.record_freedom = static_cast<double>(count_of_records(set_)) - 1;
    const MatrixXd between = result_.record_moves * result_.record_moves.transpose();
    fit.covariance += between;
    double share = 0;
    for (Index c = 0; c < between.cols(); ++c)
      if (fit.covariance(c, c) > 0) share = std::max(share, between(c, c) / fit.covariance(c, c));
    fit.degrees_of_freedom =
        1 / (std::pow(1 - share, 2) / fit.degrees_of_freedom + share * share / result_.record_freedom);
  }

  // Until no coefficient moves by more than `enough` standard deviations.
  void iterate(double enough) {
    for (int pass = 0; pass < pass_limit; ++pass) {
      const bool first = pass == 0 && !warm_;
      assemble(first ? Pass::first : Pass::whitened);
      if (result_.system.design.rows() == 0) return;
      const double change = solve();
      if (!first) block_residuals(left());
      if (pass > (warm_ ? 0 : 1) && change < enough) break;
    }
    warm_ = true;
  }

  // Least squares of the current rows; by how much fitted values moved, over the standard deviation of a residual:
  // no coefficient moved by more than that times its own.
  double solve() {
    const MatrixXd& x = result_.system.design;
    const Index columns = x.cols();
    CondensedRows rows{x, result_.system.response};
    if (x.rows() > columns + 1) rows = condensed_rows(x, result_.system.response, reweighting_.threads);
    const VectorXd scale = unit_scale(rows.design), &target = rows.response;
    const MatrixXd core = rows.design * scale.asDiagonal();
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(1e-10);
    solver.compute(core);
    const VectorXd scaled = solver.solve(target);
    VectorXd before(columns);
    for (std::size_t c = 0; c < result_.columns.size(); ++c) {
      const auto at = static_cast<Index>(c);
      before(at) = (current(c) - result_.reference(at)) / scale(at);
    }
    take(scale.asDiagonal() * scaled);
    const double left = (target - core * scaled).norm();
    const double moved = (core * (scaled - before)).norm();
    // Noise-free rows leave rounding alone.
    const auto spare = static_cast<double>(std::max<Index>(1, x.rows() - columns));
    return moved * std::sqrt(spare) / (left + 1e-9 * target.norm() + std::numeric_limits<double>::min());
  }

  // Of the whitened rows, at the current coefficients.
  VectorXd left() const {
    const WhitenedSystem& system = result_.system;
    VectorXd result = system.response;
    const std::size_t chunks = (system.block.size() + rows_at_once - 1) / rows_at_once;
    in_parallel(chunks, reweighting_.threads, [&](std::size_t c) {
      const auto begin = static_cast<Index>(c * rows_at_once);
      const Index count = std::min(static_cast<Index>(rows_at_once), result.size() - begin);
      result.segment(begin, count).noalias() -= system.design.middleRows(begin, count) * values_;
    });
    return result;
  }

  // Residual of every equation alone over its own noise, from that of the whitened rows, and of every block, to
  // weigh blocks against each other.
  void block_residuals(const VectorXd& whitened) {
    const WhitenedSystem& system = result_.system;
    result_.residual.resize(whitened.size());
    Index begin = 0;
    for (const MatrixXd& colouring : system.colouring) {
      result_.residual.segment(begin, colouring.rows()) =
          colouring.triangularView<Eigen::Lower>() * whitened.segment(begin, colouring.rows());
      begin += colouring.rows();
    }
    VectorXd taken = VectorXd::Zero(whitened.size());  // of a row's variance, by the unknown phase
    begin = 0;
    for (std::size_t n = 0; n < system.by_phase.size(); ++n) {
      const VectorXd own = system.colouring[n].triangularView<Eigen::Lower>() * system.by_phase[n];
      for (Index r = 0; r < own.size(); ++r) {
        const auto at = static_cast<std::size_t>(begin + r);
        taken(begin + r) =
            result_.weight[system.observation[at]] * std::pow(own(r) / scale_.at(system.block[at]), 2);
      }
      begin += own.size();
    }
    std::map<std::size_t, std::pair<double, double>> sums;
    for (Index r = 0; r < whitened.size(); ++r) {
      const auto at = static_cast<std::size_t>(r);
      const double left = result_.residual(r), weight = result_.weight[system.observation[at]];
      auto& [sum, count] = sums[system.block[at]];
      sum += left * left * weight;
      count += weight * (1 - taken(r));
    }
    for (const auto& [block, sum] : sums) {
      const double ratio = std::sqrt(sum.first / std::max(1.0, sum.second));
      result_.block_residual[block] = ratio;
      if (std::isfinite(ratio)) scale_[block] = std::max(1.0, ratio);
    }
  }

  // How the response changes with what is subtracted from the equations: rows x directions.
  MatrixXd whitened(const std::vector<Eigen::MatrixXcd>& changes) const {
    const auto directions = static_cast<Index>(changes.size());
    const WhitenedSystem& system = result_.system;
    if (directions == 0 || result_.fit.coefficients.size() == 0) return MatrixXd::Zero(0, directions);
    MatrixXd change(system.response.size(), directions);
    std::vector<Index> begin;
    for (Index next = 0; const MatrixXd& colouring : system.colouring) {
      begin.push_back(next);
      next += colouring.rows();
    }
    in_parallel(begin.size(), reweighting_.threads, [&](std::size_t n) {
      const MatrixXd& colouring = system.colouring[n];
      auto rows = change.middleRows(begin[n], colouring.rows());
      for (Index d = 0; d < directions; ++d)
        for (Index r = 0; r < rows.rows(); ++r) {
          const auto at = static_cast<std::size_t>(begin[n] + r);
          const Complex all = changes[static_cast<std::size_t>(d)](static_cast<Index>(system.observation[at]),
                                                                   static_cast<Index>(system.block[at]));
          rows(r, d) = -part_of(all, system.part[at]) / system.noise_sd[at];
        }
      colouring.triangularView<Eigen::Lower>().solveInPlace(rows);
      if (!system.by_phase.empty()) take_out_direction(system.by_phase[n], rows);
    });
    return change;
  }

  // How coefficients do with it; errors of columns do so next to not at all.
  MatrixXd effect_of(const MatrixXd& change) const {
    if (change.rows() == 0) return MatrixXd::Zero(result_.fit.coefficients.size(), change.cols());
    return result_.fit.basis * (result_.fit.orthonormal.transpose() * change);
  }

  // Whether columns have instruments: they are not measured values that could be adjusted.
  bool has_instruments() const {
    return !set_.frequency_scatter.empty() && !set_.phase_unknown && !set_.observations.empty() &&
           set_.observations.front().instrument;
  }

  bool adjusts() const { return known_.errors_in_variables && !has_instruments(); }

  // docs/inference.md (54): columns and noise are taken at motions that do not know what a record's natural
  // frequency is off.
  void take_instruments() {
    if (!has_instruments()) return;
    at_instruments_ = set_;
    for (Observation& o : at_instruments_.observations) {
      if (!o.instrument->found) continue;
      o.amplitude = o.instrument->amplitude;
      o.rate = o.instrument->rate;
    }
    instruments_.emplace(at_instruments_, result_.blocks);
  }

  // (54): the equations at the measured motion, for the size of the other one; by row, the ratio of the sizes.
  EquationData::Rows rows_as_measured(std::size_t observation, VectorXd& size) const {
    EquationData::Rows rows = data_.rows(observation, result_.columns, at_, reference_);
    size = VectorXd::Ones(rows.response.size());
    for (Index r = 0; r < size.size(); ++r) {
      const RegressorBlock& block = case_.blocks[rows.block[static_cast<std::size_t>(r)]];
      const auto mode = static_cast<std::size_t>(block.mode);
      if (block.kind == BlockKind::modulation)
        size(r) = std::abs(at_instruments_.observations[observation].amplitude[mode]) /
                  std::abs(set_.observations[observation].amplitude[mode]);
    }
    rows.response.array() *= size.array();
    rows.design = size.asDiagonal() * rows.design;
    return rows;
  }

  // Rows by instruments, (53), in place of those at the measured motions and of the instruments.
  void project_on_instruments(Pass pass) {
    WhitenedSystem& system = result_.system;
    InstrumentRows rows = instrument_rows(system.design, measured_design_, system.response);
    system.design = std::move(rows.design);
    system.response = std::move(rows.response);
    if (pass != Pass::last) return;
    system.errors.with_response = rows.onto.transpose() * system.errors.with_response;
    const MatrixXd gram = rows.onto.transpose() * system.errors.gram;
    system.errors.gram = (gram + gram.transpose()) / 2;
    std::vector<std::size_t> record;
    for (const std::size_t i : system.observation) record.push_back(set_.observations[i].record);
    result_.instrument_relevance = instrument_relevance(system.design, measured_design_, record);
  }

  void assemble(Pass pass) {
    const bool by_instruments = pass != Pass::first && instruments_;
    EquationData& data = by_instruments ? *instruments_ : adjusted_data_ ? *adjusted_data_ : data_;
    data.evaluate(at_.natural_frequency);
    if (by_instruments) data_.evaluate(at_.natural_frequency);
    WhitenedSystem& system = result_.system;
    const auto columns = static_cast<Index>(result_.columns.size());
    const std::size_t count = set_.observations.size();
    std::vector<Index> first_row(count + 1, 0);
    std::vector<std::size_t> with_rows;
    for (std::size_t i = 0; i < count; ++i) {
      const Index rows = data.row_count(i);
      first_row[i + 1] = first_row[i] + rows;
      if (rows > 0) with_rows.push_back(i);
    }
    const auto rows = static_cast<std::size_t>(first_row.back());
    system.design.resize(first_row.back(), columns);
    measured_design_.resize(by_instruments ? first_row.back() : 0, columns);
    system.response.resize(first_row.back());
    system.condition.resize(rows);
    system.observation.resize(rows);
    system.block.resize(rows);
    system.part.resize(rows);
    system.noise_sd.resize(rows);
    system.colouring.resize(pass == Pass::first ? 0 : with_rows.size());
    system.by_phase.resize(set_.phase_unknown ? system.colouring.size() : 0);
    if (pass == Pass::last && !case_.excited) rows_by_noise_.resize(with_rows.size());
    const std::size_t chunks = (with_rows.size() + chunk - 1) / chunk;
    std::vector<ColumnErrors> errors(pass == Pass::last ? chunks : 0,
                                     {MatrixXd::Zero(columns, columns), VectorXd::Zero(columns)});
    in_parallel(chunks, reweighting_.threads, [&](std::size_t c) {
      for (std::size_t n = c * chunk; n < std::min(with_rows.size(), (c + 1) * chunk); ++n)
        assemble_observation(data, pass, {with_rows[n], n, first_row[with_rows[n]]},
                             pass == Pass::last ? &errors[c] : nullptr);
    });
    system.errors = {};
    if (pass == Pass::last) {
      system.errors = {MatrixXd::Zero(columns, columns), VectorXd::Zero(columns)};
      for (const ColumnErrors& part : errors) {
        system.errors.gram += part.gram;
        system.errors.with_response += part.with_response;
      }
      system.errors.gram = MatrixXd(system.errors.gram.selfadjointView<Eigen::Lower>());
    }
    if (by_instruments) project_on_instruments(pass);
  }

  /// An observation with rows.
  struct Place {
    std::size_t observation, number;  ///< among all, and among those with rows
    Index begin;                      ///< its first row
  };

  // Of the Gram matrix of `errors` the lower half.
  void assemble_observation(const EquationData& data, Pass pass, const Place& place, ColumnErrors* errors) {
    WhitenedSystem& system = result_.system;
    const auto [i, number, begin] = place;
    EquationData::Rows rows = data.rows(i, result_.columns, at_, reference_);
    const Index count = rows.response.size();
    // From the adjusted values back to the measured ones, along the tangent.
    if (adjusted_data_) rows.response += rows.variants * moved_[i];
    VectorXd noise_sd = row_noise_sd(rows);
    const bool by_instruments = instruments_ && &data == &*instruments_;
    MatrixXd as_measured;
    if (by_instruments) {
      VectorXd size;
      EquationData::Rows measured = rows_as_measured(i, size);
      as_measured = std::move(measured.design);
      rows.response = std::move(measured.response);
      noise_sd = noise_sd.cwiseQuotient(size);  // of the equation at the measured motion
      if (!set_.observations[i].instrument->found) rows.design.setZero();
    }
    for (Index r = 0; r < count; ++r) {
      const auto at = static_cast<std::size_t>(begin + r), from = static_cast<std::size_t>(r);
      system.condition[at] = set_.observations[i].condition;
      system.observation[at] = i;
      system.block[at] = rows.block[from];
      system.part[at] = rows.part[from];
      system.noise_sd[at] = noise_sd(r);
    }
    if (pass == Pass::first) {
      for (Index r = 0; r < count; ++r) {
        const double size = data.first_scale(i, rows.block[static_cast<std::size_t>(r)]);
        system.design.row(begin + r) = rows.design.row(r) / size;
        system.response(begin + r) = rows.response(r) / size;
      }
      return;
    }
    VectorXd scale(count);
    for (Index r = 0; r < count; ++r) scale(r) = scale_.at(rows.block[static_cast<std::size_t>(r)]);
    const RowNoise noise(rows);
    const double weight = std::sqrt(result_.weight[i]);
    MatrixXd factor = weight * MatrixXd::Identity(count, count);
    noise.correlation.matrixL().solveInPlace(factor);
    factor *= noise.sd.cwiseInverse().cwiseQuotient(scale).asDiagonal();
    system.colouring[number] = (scale / weight).asDiagonal() * MatrixXd(noise.correlation.matrixL());
    multiply_lower(factor, rows.design, system.design.middleRows(begin, count));
    if (by_instruments) multiply_lower(factor, as_measured, measured_design_.middleRows(begin, count));
    system.response.segment(begin, count) = factor.triangularView<Eigen::Lower>() * rows.response;
    if (set_.phase_unknown) {
      VectorXd& direction = system.by_phase[number];
      direction = (factor.triangularView<Eigen::Lower>() * rows.phase).stableNormalized();
      take_out_direction(direction, system.design.middleRows(begin, count));
      take_out_direction(direction, system.response.segment(begin, count));
    }
    if (!errors) return;
    if (!case_.excited) {
      MatrixXd noises(count, rows.variants.cols() + count);
      noises << rows.variants, MatrixXd(rows.own_variance.cwiseSqrt().asDiagonal());
      rows_by_noise_[number] = noise.whitened(noises);
    }
    const std::vector<EquationData::ColumnError> changes = data.column_errors(i, result_.columns);
    const auto size = count * static_cast<Index>(changes.size());
    MatrixXd whitened(size, rows.design.cols());
    VectorXd response(size);
    Index at = 0;
    for (const EquationData::ColumnError& change : changes) {
      multiply_lower(factor, change.design, whitened.middleRows(at, count));
      // Left minus right side changes by dy - dX b.
      response.segment(at, count) = factor.triangularView<Eigen::Lower>() *
                                    VectorXd(rows.variants.col(change.quantity) + change.design * values_);
      if (set_.phase_unknown) {
        take_out_direction(system.by_phase[number], whitened.middleRows(at, count));
        take_out_direction(system.by_phase[number], response.segment(at, count));
      }
      at += count;
    }
    const double noise_left = by_instruments ? set_.observations[i].instrument->noise_left : 1;
    errors->gram.selfadjointView<Eigen::Lower>().rankUpdate(whitened.transpose(), noise_left);
    errors->with_response += noise_left * (whitened.transpose() * response);
  }

  // Moves everything measured to where the equations hold, by the least that its noise allows.
  void adjust() {
    if (!adjusted_data_) {
      adjusted_ = set_;
      adjusted_data_.emplace(adjusted_, result_.blocks);
      moved_.assign(set_.observations.size(), VectorXd::Zero(adjusted_data_->quantities()));
    }
    adjusted_data_->evaluate(at_.natural_frequency);
    ObservationSet next = set_;
    for (std::size_t i = 0; i < set_.observations.size(); ++i) {
      const EquationData::Rows rows = adjusted_data_->rows(i, result_.columns, at_, reference_);
      if (rows.response.size() == 0) continue;
      const VectorXd left = rows.response + rows.variants * moved_[i] - rows.design * values_;
      const RowNoise noise(rows);
      const VectorXd solved = noise.sd.cwiseInverse().asDiagonal() *
                              noise.correlation.solve(VectorXd(noise.sd.cwiseInverse().asDiagonal() * left));
      moved_[i] = rows.variants.transpose() * solved;
      adjusted_data_->move(next.observations[i], moved_[i]);
    }
    adjusted_ = std::move(next);
    adjusted_data_.emplace(adjusted_, result_.blocks);
  }

  // Of an observation's rows, those that an unknown phase does not take up.
  double free_rows(std::size_t rows) const {
    return std::max(1.0, static_cast<double>(rows) - (set_.phase_unknown ? 1 : 0));
  }

  // By the deviation of each ensemble's whitened residual from the median of its condition.
  void weigh_ensembles() {
    result_.weight.assign(result_.weight.size(), 1.0);
    result_.distance.assign(result_.distance.size(), 0.0);
    assemble(Pass::whitened);
    const VectorXd residual = left();
    std::map<int, std::vector<std::size_t>> members;
    std::map<std::size_t, std::vector<double>> left;
    for (Index r = 0; r < residual.size(); ++r)
      left[result_.system.observation[static_cast<std::size_t>(r)]].push_back(residual(r));
    for (const auto& [i, rows] : left) members[set_.observations[i].condition].push_back(i);
    std::vector<double> all;
    std::size_t largest = 1;
    for (const auto& [condition, ensembles] : members) {
      const std::size_t size = left[ensembles.front()].size();
      const bool same =
          std::all_of(ensembles.begin(), ensembles.end(), [&](std::size_t i) { return left[i].size() == size; });
      if (ensembles.size() < replicates_needed || !same) continue;
      std::vector<double> square(ensembles.size(), 0.0);
      for (std::size_t r = 0; r < size; ++r) {
        std::vector<double> values;
        for (const std::size_t i : ensembles) values.push_back(left[i][r]);
        const double centre = upper_median(values);
        for (std::size_t e = 0; e < ensembles.size(); ++e) square[e] += (values[e] - centre) * (values[e] - centre);
      }
      for (std::size_t e = 0; e < ensembles.size(); ++e) {
        result_.distance[ensembles[e]] = std::sqrt(square[e] / free_rows(size));
        all.push_back(result_.distance[ensembles[e]]);
      }
      largest = std::max(largest, size);
    }
    if (all.empty()) return;
    const double rows = free_rows(largest);
    const double usual = upper_median(all) / std::sqrt(chi_squared_upper_quantile(0.5, rows) / rows);
    if (!(usual > 0)) return;
    const double tail = outlier_false_alarm / static_cast<double>(all.size());
    const double cut = std::sqrt(chi_squared_upper_quantile(tail, rows) / rows);
    for (std::size_t i = 0; i < result_.distance.size(); ++i) {
      result_.distance[i] /= usual;
      if (result_.distance[i] <= cut) continue;
      result_.weight[i] = cut * cut / (result_.distance[i] * result_.distance[i]);
    }
  }

  const ObservationSet& set_;
  const CompiledCase& case_;
  const CaseKnowledge& known_;
  const Reweighting& reweighting_;
  EquationData data_;
  bool warm_ = false;  // coefficients and weights are near the final ones
  CaseFit result_;
  EquationPoint at_;
  std::vector<double> reference_, offset_;
  ObservationSet adjusted_;                    // measured values moved to where the equations hold
  std::optional<EquationData> adjusted_data_;  // of `adjusted_`; empty: not adjusted
  ObservationSet at_instruments_;              // dwells with the motions of their instruments
  std::optional<EquationData> instruments_;    // of `at_instruments_`; empty: columns are their own
  MatrixXd measured_design_;                   // whitened columns at the measured motions
  std::vector<MatrixXd> rows_by_noise_;        // of window_overlap
  std::vector<VectorXd> moved_;                // by observation: how far, in standard deviations
  std::map<std::size_t, double> scale_;
  VectorXd values_;
};

}  // namespace

CaseFit fit_case(const ObservationSet& set, const std::vector<std::size_t>& blocks, const CaseKnowledge& known,
                 const Reweighting& reweighting) {
  return CaseRegression(set, blocks, known, reweighting).run();
}

}  // namespace secular
