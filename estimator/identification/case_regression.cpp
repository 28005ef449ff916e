#include "estimator/identification/case_regression.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>

#include "estimator/identification/equation_data.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int pass_limit = 14;

/// Reweighting ends where fitted values move by less than this share of the residual: with n rows no coefficient
/// then moves by more than sqrt(n) times that of its standard deviation.
constexpr double converged_change = 1e-4;

/// Each halves the digits that are missing; the adjustments are small.
constexpr int adjustment_rounds = 3;

/// Probability that a campaign without outliers has one down-weighted.
constexpr double outlier_false_alarm = 0.01;

/// Ensembles of a condition that are needed to tell an outlier.
constexpr std::size_t replicates_needed = 4;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class CaseRegression {
 public:
  CaseRegression(const ObservationSet& set, const std::vector<std::size_t>& blocks, const CaseKnowledge& known)
      : set_(set), case_(*set.resonance), known_(known), data_(set, blocks) {
    result_.set = &set;
    result_.blocks = blocks;
    result_.weight.assign(set.observations.size(), 1.0);
    result_.distance.assign(set.observations.size(), 0.0);
    lump_.assign(case_.lumps.size(), 0.0);
    natural_ = reference_ = known.natural_frequency;
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
      const auto given = known.fixed.find(std::string(case_.lumps[l].name));
      if (given != known.fixed.end())
        lump_[l] = given->second;
      else
        result_.columns.push_back({CaseColumn::Kind::lump, l});
    }
    for (const std::size_t k : frequencies) result_.columns.push_back({CaseColumn::Kind::natural_frequency, k});
    for (const std::size_t k : offsets) result_.columns.push_back({CaseColumn::Kind::sensor_offset, k});
    result_.reference = VectorXd::Zero(static_cast<Index>(result_.columns.size()));
    for (std::size_t c = 0; c < result_.columns.size(); ++c)
      if (result_.columns[c].kind == CaseColumn::Kind::natural_frequency)
        result_.reference(static_cast<Index>(c)) = reference_[result_.columns[c].index];
  }

  CaseFit run() {
    if (result_.columns.empty() || set_.observations.empty()) return std::move(result_);
    iterate();
    if (set_.resonance->excited && weigh_ensembles()) iterate();
    if (known_.errors_in_variables)
      for (int round = 0; round < adjustment_rounds; ++round) {
        adjust();
        iterate();
      }
    assemble(false, true);
    if (result_.system.design.rows() > 0) {
      result_.fit = linear_fit(result_.system.design, result_.system.response, result_.system.condition, 1e-9,
                               result_.system.column_noise);
      result_.residual.resize(result_.system.design.rows());
      for (std::size_t r = 0; r < marginals_.size(); ++r)
        result_.residual(static_cast<Index>(r)) =
            marginals_[r].response - marginals_[r].row.dot(result_.fit.coefficients);
    }
    if (result_.fit.coefficients.size() > 0) result_.fit.coefficients += result_.reference;
    return std::move(result_);
  }

 private:
  void iterate() {
    for (int pass = 0; pass < pass_limit; ++pass) {
      assemble(pass == 0, false);
      if (result_.system.design.rows() == 0) return;
      const double change = solve();
      block_misfits();
      if (pass > 1 && change < converged_change) break;
    }
  }

  // Least squares of the current rows; by how much fitted values moved, over the residual. A blocked QR of the many
  // rows comes first; the rank is found on its triangle.
  double solve() {
    const MatrixXd& x = result_.system.design;
    const Index columns = x.cols();
    VectorXd scale = x.colwise().norm().transpose();
    for (Index c = 0; c < scale.size(); ++c) scale(c) = scale(c) > 0 ? 1 / scale(c) : 1;
    MatrixXd both(x.rows(), columns + 1);
    both.leftCols(columns) = x * scale.asDiagonal();
    both.col(columns) = result_.system.response;
    MatrixXd triangle;
    if (both.rows() > both.cols()) {
      const Eigen::HouseholderQR<Eigen::Ref<MatrixXd>> qr(both);  // in place
      triangle = qr.matrixQR().topRows(columns + 1).triangularView<Eigen::Upper>();
    } else {
      triangle = both;
    }
    const MatrixXd core = triangle.leftCols(columns);
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(1e-10);
    solver.compute(core);
    const VectorXd scaled = solver.solve(triangle.col(columns));
    VectorXd before(columns);
    values_ = scale.asDiagonal() * scaled;
    for (std::size_t c = 0; c < result_.columns.size(); ++c) {
      const CaseColumn& column = result_.columns[c];
      const auto at = static_cast<Index>(c);
      double* old = column.kind == CaseColumn::Kind::lump                ? &lump_[column.index]
                    : column.kind == CaseColumn::Kind::natural_frequency ? &natural_[column.index]
                                                                         : &offset_[column.index];
      before(at) = (*old - result_.reference(at)) / scale(at);
      *old = values_(at) + result_.reference(at);
    }
    const double left = (triangle.col(columns) - core * scaled).norm();
    const double moved = (core * (scaled - before)).norm();
    // Noise-free rows leave rounding alone.
    return moved / (left + 1e-9 * triangle.col(columns).norm() + std::numeric_limits<double>::min());
  }

  // Residual of every block alone over its noise, to weigh blocks against each other.
  void block_misfits() {
    std::map<std::size_t, std::pair<double, double>> sums;
    for (const Marginal& m : marginals_) {
      double left = m.response - m.row.dot(values_);
      auto& [sum, count] = sums[m.block];
      sum += left * left * m.weight;
      count += m.weight;
    }
    for (const auto& [block, sum] : sums) {
      const double misfit = std::sqrt(sum.first / std::max(1.0, sum.second));
      result_.block_misfit[block] = misfit;
      if (std::isfinite(misfit)) scale_[block] = std::max(1.0, misfit);
    }
  }

  void assemble(bool first_pass, bool last_pass) {
    EquationData& data = adjusted_data_ ? *adjusted_data_ : data_;
    data.evaluate(natural_);
    WhitenedSystem& system = result_.system;
    const auto columns = static_cast<Index>(result_.columns.size());
    const Index most = 2 * static_cast<Index>(set_.observations.size() * result_.blocks.size());
    system = {};
    system.design.resize(most, columns);
    system.response.resize(most);
    if (last_pass) system.column_noise = MatrixXd::Zero(columns, columns);
    marginals_.clear();
    Index used = 0;
    for (std::size_t i = 0; i < set_.observations.size(); ++i) {
      const Observation& o = set_.observations[i];
      EquationData::Rows rows = data.rows(i, result_.columns, lump_, natural_, reference_);
      const Index count = rows.response.size();
      if (count == 0) continue;
      // From the adjusted values back to the measured ones, along the tangent.
      if (adjusted_data_) rows.response += rows.variants * moved_[i];
      MatrixXd design = rows.design;
      VectorXd response = rows.response;
      const VectorXd noise_sd = (rows.variants.rowwise().squaredNorm() + rows.own_variance).cwiseSqrt();
      const double weight = std::sqrt(result_.weight[i]);
      if (first_pass) {
        for (Index r = 0; r < count; ++r) {
          const double size = data.first_scale(i, rows.block[static_cast<std::size_t>(r)]);
          design.row(r) /= size;
          response(r) /= size;
        }
      } else {
        MatrixXd covariance = rows.variants * rows.variants.transpose();
        covariance.diagonal() += rows.own_variance;
        for (Index r = 0; r < count; ++r) {
          const std::size_t block = rows.block[static_cast<std::size_t>(r)];
          marginals_.push_back(
              {block, rows.response(r) / noise_sd(r), rows.design.row(r) / noise_sd(r), result_.weight[i]});
        }
        for (Index r = 0; r < count; ++r)
          for (Index c = 0; c < count; ++c)
            covariance(r, c) *= scale_.at(rows.block[static_cast<std::size_t>(r)]) *
                                scale_.at(rows.block[static_cast<std::size_t>(c)]);
        const VectorXd sd = covariance.diagonal().cwiseSqrt();
        const MatrixXd correlation = sd.cwiseInverse().asDiagonal() * covariance * sd.cwiseInverse().asDiagonal();
        // Equations that share all their noise (noise-free data, or a common error) stay a little apart.
        const Eigen::LLT<MatrixXd> cholesky(correlation + 1e-9 * MatrixXd::Identity(count, count));
        const auto whiten = [&](MatrixXd& m) {
          m = sd.cwiseInverse().asDiagonal() * m;
          cholesky.matrixL().solveInPlace(m);
          m *= weight;
        };
        whiten(design);
        MatrixXd right = response;
        whiten(right);
        response = right;
        if (last_pass) {
          MatrixXd unit = noise_sd.asDiagonal();
          whiten(unit);
          system.whitener.push_back(std::move(unit));
          for (MatrixXd error : data.column_errors(i, result_.columns)) {
            whiten(error);
            system.column_noise += error.transpose() * error;
          }
        }
      }
      system.design.middleRows(used, count) = design;
      system.response.segment(used, count) = response;
      used += count;
      for (Index r = 0; r < count; ++r) {
        system.condition.push_back(o.condition);
        system.observation.push_back(i);
        system.block.push_back(rows.block[static_cast<std::size_t>(r)]);
        system.part.push_back(rows.part[static_cast<std::size_t>(r)]);
        system.noise_sd.push_back(noise_sd(r));
      }
    }
    system.design.conservativeResize(used, columns);
    system.response.conservativeResize(used);
  }

  // Moves everything measured to where the equations hold, by the least that its noise allows.
  void adjust() {
    if (!adjusted_data_) {
      adjusted_ = set_;
      adjusted_data_.emplace(adjusted_, result_.blocks);
      moved_.assign(set_.observations.size(), VectorXd::Zero(adjusted_data_->quantities()));
    }
    adjusted_data_->evaluate(natural_);
    ObservationSet next = set_;
    for (std::size_t i = 0; i < set_.observations.size(); ++i) {
      const EquationData::Rows rows = adjusted_data_->rows(i, result_.columns, lump_, natural_, reference_);
      if (rows.response.size() == 0) continue;
      const VectorXd misfit = rows.response + rows.variants * moved_[i] - rows.design * values_;
      MatrixXd covariance = rows.variants * rows.variants.transpose();
      covariance.diagonal() += rows.own_variance;
      const VectorXd sd = covariance.diagonal().cwiseSqrt();
      const MatrixXd correlation = sd.cwiseInverse().asDiagonal() * covariance * sd.cwiseInverse().asDiagonal() +
                                   1e-9 * MatrixXd::Identity(sd.size(), sd.size());
      const VectorXd solved =
          sd.cwiseInverse().asDiagonal() * correlation.llt().solve(sd.cwiseInverse().asDiagonal() * misfit);
      moved_[i] = rows.variants.transpose() * solved;
      adjusted_data_->move(next.observations[i], moved_[i]);
    }
    adjusted_ = std::move(next);
    adjusted_data_.emplace(adjusted_, result_.blocks);
  }

  // Deviation of each ensemble's whitened residual from the median of its condition; true if a weight changed.
  bool weigh_ensembles() {
    assemble(false, false);
    const VectorXd residual = result_.system.response - result_.system.design * values_;
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
        const double centre = median(values);
        for (std::size_t e = 0; e < ensembles.size(); ++e) square[e] += (values[e] - centre) * (values[e] - centre);
      }
      for (std::size_t e = 0; e < ensembles.size(); ++e) {
        result_.distance[ensembles[e]] = std::sqrt(square[e] / static_cast<double>(size));
        all.push_back(result_.distance[ensembles[e]]);
      }
      largest = std::max(largest, size);
    }
    if (all.empty()) return false;
    const boost::math::chi_squared law(static_cast<double>(largest));
    const double rows = static_cast<double>(largest);
    const double usual = median(all) / std::sqrt(boost::math::quantile(law, 0.5) / rows);
    if (!(usual > 0)) return false;
    const double tail = outlier_false_alarm / static_cast<double>(all.size());
    const double cut = std::sqrt(boost::math::quantile(boost::math::complement(law, tail)) / rows);
    bool changed = false;
    for (std::size_t i = 0; i < result_.distance.size(); ++i) {
      result_.distance[i] /= usual;
      if (result_.distance[i] <= cut) continue;
      result_.weight[i] = cut * cut / (result_.distance[i] * result_.distance[i]);
      changed = true;
    }
    return changed;
  }

  // One real equation over its own noise alone.
  struct Marginal {
    std::size_t block;
    double response;
    Eigen::RowVectorXd row;
    double weight;
  };

  const ObservationSet& set_;
  const CompiledCase& case_;
  const CaseKnowledge& known_;
  EquationData data_;
  CaseFit result_;
  std::vector<double> lump_, natural_, reference_;
  ObservationSet adjusted_;                    // measured values moved to where the equations hold
  std::optional<EquationData> adjusted_data_;  // of `adjusted_`; empty: not adjusted
  std::vector<VectorXd> moved_;                // by observation: how far, in standard deviations
  std::map<std::size_t, double> offset_, scale_;
  VectorXd values_;
  std::vector<Marginal> marginals_;
};

}  // namespace

CaseFit fit_case(const ObservationSet& set, const std::vector<std::size_t>& blocks, const CaseKnowledge& known) {
  return CaseRegression(set, blocks, known).run();
}

}  // namespace secular
