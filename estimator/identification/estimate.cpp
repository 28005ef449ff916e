#include "estimator/identification/estimate.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "estimator/identification/unit_text.hpp"
#include "estimator/regression/confidence.hpp"
#include "estimator/regression/linear_fit.hpp"
#include "estimator/regression/nonlinear_fit.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The measured quantities that enter the rows of one observation, as real numbers that can be varied.
struct Measured {
  std::vector<Complex> amplitude, forcing;
  std::vector<double> excitation_frequency;
  std::vector<Complex> rate;
  Complex harmonic;
};

// Value and columns of one block at one observation: target - sum columns*lumps, target and columns complex.
struct Row {
  Complex target;
  std::vector<Complex> columns;
};

Row evaluate(const RegressorBlock& block, const double* natural_frequency, const Measured& m) {
  std::vector<const Complex*> amplitude, forcing;
  std::vector<const double*> excitation;
  for (const Complex& a : m.amplitude) amplitude.push_back(&a);
  for (const Complex& f : m.forcing) forcing.push_back(&f);
  for (const double& w : m.excitation_frequency) excitation.push_back(&w);
  Row row;
  row.columns.resize(block.lumps.size());
  std::vector<Complex*> columns;
  for (Complex& c : row.columns) columns.push_back(&c);
  const ObservationBatch batch{1, natural_frequency, excitation.data(), amplitude.data(), forcing.data()};
  block.columns(batch, columns.data());
  const auto mode = static_cast<std::size_t>(block.mode);
  row.target = block.kind == BlockKind::modulation ? m.rate[mode] * m.amplitude[mode] : m.harmonic;
  return row;
}

double observed_frequency(const CompiledModel& model, const CompiledCase& resonance, std::size_t mode,
                          const std::vector<double>& excitation, double fallback) {
  const std::size_t modes = model.modes(), columns = modes + model.excitations.size();
  double sum = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    const Ratio r = resonance.observed_frequency[mode * columns + i];
    if (r.numerator == 0) continue;
    if (i < modes) return fallback;  // not locked: what was measured
    sum += r.numerator * excitation[i - modes] / r.denominator;
  }
  return sum;
}

class Estimator {
 public:
  Estimator(const ObservationSet& set, const std::string& coordinate_unit,
            const std::vector<std::string>& excitation_units, const EstimateOptions& options)
      : set_(set), model_(*set.model), case_(*set.resonance), options_(options) {
    coordinate_units_.assign(model_.modes(), coordinate_unit);
    excitation_units_ = excitation_units;
    excitation_units_.resize(model_.excitations.size(), "1");
    for (std::size_t k = 0; k < model_.modes(); ++k) {
      double sum = 0;
      for (const Observation& o : set.observations) sum += o.rate[k].imag();
      natural_frequency_.push_back(sum / static_cast<double>(std::max<std::size_t>(1, set.observations.size())));
    }
    // A locked mode's frequency is the excitation's: close to the natural one by the resonance relation.
    lump_value_.assign(case_.lumps.size(), 0.0);
    lump_state_.assign(case_.lumps.size(), State::open);
    for (const auto& [name, value] : options.fixed) fix(name, value);
  }

  Estimate run() {
    result_.warnings = set_.warnings;
    for (const RegressorBlock& block : case_.blocks)
      if (block.kind == BlockKind::modulation) fit_modulation(block);
    for (const RegressorBlock& block : case_.blocks)
      if (block.kind == BlockKind::harmonic && block.order <= 1 && sees_something_new(block)) fit_harmonic(block);
    physical_parameters();
    report_lumps();
    return std::move(result_);
  }

 private:
  enum class State { open, fixed, estimated, not_identifiable };

  void fix(const std::string& name, double value) {
    std::string known;
    bool found = false;
    for (const CompiledSymbol& symbol : model_.symbols) {
      known += (known.empty() ? "" : ", ") + std::string(symbol.name);
      found = found || symbol.name == name;
    }
    if (!found)
      throw InputError("--fix " + name, "", "is no symbol of model " + std::string(model_.name),
                       "its symbols are " + known);
    for (std::size_t k = 0; k < model_.modes(); ++k)
      if (model_.symbols[k].name == name) {
        natural_frequency_[k] = value;
        fixed_frequency_.insert(k);
      }
    for (std::size_t l = 0; l < case_.lumps.size(); ++l)
      if (case_.lumps[l].name == name) {
        lump_value_[l] = value;
        lump_state_[l] = State::fixed;
      }
  }

  Measured measured(const Observation& o, std::size_t block) const {
    return {o.amplitude, o.forcing, o.excitation_frequency, o.rate, o.harmonic[block]};
  }

  // Left side minus right side with the current lumps and frequencies: what noise makes of it tells the weight.
  Complex misfit(const RegressorBlock& block, const Measured& m) const {
    const Row row = evaluate(block, natural_frequency_.data(), m);
    Complex sum = row.target;
    if (block.kind == BlockKind::modulation) {
      const auto mode = static_cast<std::size_t>(block.mode);
      sum -= Complex(0, natural_frequency_[mode]) * m.amplitude[mode];
    }
    for (std::size_t j = 0; j < row.columns.size(); ++j)
      sum -= lump_value_[static_cast<std::size_t>(block.lumps[j])] * row.columns[j];
    return sum;
  }

  // Covariance of real and imaginary part of the misfit from the noise of everything measured in it.
  Eigen::Matrix2d noise_covariance(const RegressorBlock& block, std::size_t b, const Observation& o) const {
    const Measured centre = measured(o, b);
    const Complex base = misfit(block, centre);
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    const auto vary = [&](double sd, const auto& change) {
      if (!(sd > 0)) return;
      Measured moved = centre;
      change(moved, sd);
      const Complex difference = misfit(block, moved) - base;
      const Eigen::Vector2d d(difference.real(), difference.imag());
      covariance += d * d.transpose();
    };
    for (std::size_t k = 0; k < o.amplitude.size(); ++k) {
      vary(o.amplitude_sd[k], [k](Measured& m, double sd) { m.amplitude[k] += sd; });
      vary(o.amplitude_sd[k], [k](Measured& m, double sd) { m.amplitude[k] += Complex(0, sd); });
      vary(o.growth_sd[k], [k](Measured& m, double sd) { m.rate[k] += sd; });
      vary(o.frequency_sd[k], [k](Measured& m, double sd) { m.rate[k] += Complex(0, sd); });
    }
    for (std::size_t j = 0; j < o.forcing.size(); ++j) {
      vary(o.forcing_sd[j], [j](Measured& m, double sd) { m.forcing[j] += sd; });
      vary(o.forcing_sd[j], [j](Measured& m, double sd) { m.forcing[j] += Complex(0, sd); });
      vary(o.excitation_frequency_sd[j], [&, j](Measured& m, double sd) {
        m.excitation_frequency[j] += sd;
        for (std::size_t k = 0; k < m.rate.size(); ++k)
          m.rate[k].imag(observed_frequency(model_, case_, k, m.excitation_frequency, m.rate[k].imag()));
      });
    }
    if (block.kind == BlockKind::harmonic) {
      covariance(0, 0) += o.harmonic_sd[b] * o.harmonic_sd[b];
      covariance(1, 1) += o.harmonic_sd[b] * o.harmonic_sd[b];
    }
    // Noise-free data: equal weights relative to the size of the equation.
    const double floor = std::norm(1e-12 * evaluate(block, natural_frequency_.data(), centre).target);
    covariance.diagonal().array() += floor + std::numeric_limits<double>::min();
    return covariance;
  }

  std::size_t index_of(const RegressorBlock& block) const {
    return static_cast<std::size_t>(&block - case_.blocks.data());
  }

  // Whitened rows: two real ones (real and imaginary part, decorrelated) for every observation.
  struct System {
    MatrixXd design;
    VectorXd response;
    std::vector<int> cluster;
    std::vector<std::size_t> unknown;  // lumps by column; the natural frequency's column comes last if it is free
    bool frequency = false;
  };

  System assemble(const RegressorBlock& block, bool first_pass) const {
    const std::size_t b = index_of(block);
    System system;
    for (const int lump : block.lumps) {
      const auto l = static_cast<std::size_t>(lump);
      if (lump_state_[l] == State::open) system.unknown.push_back(l);
    }
    const auto mode = static_cast<std::size_t>(block.mode);
    system.frequency = block.kind == BlockKind::modulation && fixed_frequency_.count(mode) == 0;
    const auto columns = static_cast<Index>(system.unknown.size()) + (system.frequency ? 1 : 0);
    std::vector<const Observation*> used;
    for (const Observation& o : set_.observations)
      if (block.kind == BlockKind::modulation || o.harmonic_sd[b] >= 0) used.push_back(&o);
    system.design.resize(2 * static_cast<Index>(used.size()), columns);
    system.response.resize(system.design.rows());
    Index r = 0;
    for (const Observation* o : used) {
      const Measured m = measured(*o, b);
      const Row row = evaluate(block, natural_frequency_.data(), m);
      Complex target = row.target;
      if (block.kind == BlockKind::modulation && !system.frequency)
        target -= Complex(0, natural_frequency_[mode]) * m.amplitude[mode];
      Eigen::Matrix<double, 2, Eigen::Dynamic> pair(2, columns);
      Index column = 0;
      for (std::size_t j = 0; j < row.columns.size(); ++j) {
        const auto l = static_cast<std::size_t>(block.lumps[j]);
        if (lump_state_[l] != State::open) {
          if (lump_state_[l] != State::not_identifiable) target -= lump_value_[l] * row.columns[j];
          continue;
        }
        pair.col(column++) << row.columns[j].real(), row.columns[j].imag();
      }
      if (system.frequency) {
        const Complex turned = Complex(0, 1) * m.amplitude[mode];
        pair.col(column) << turned.real(), turned.imag();
      }
      Eigen::Vector2d right(target.real(), target.imag());
      if (first_pass) {
        const double scale =
            std::abs(block.kind == BlockKind::modulation ? m.amplitude[mode] : Complex(o->harmonic_sd[b]));
        const double weight = scale > 0 ? 1 / scale : 1;
        pair *= weight;
        right *= weight;
      } else {
        const Eigen::LLT<Eigen::Matrix2d> cholesky(noise_covariance(block, b, *o));
        cholesky.matrixL().solveInPlace(pair);
        cholesky.matrixL().solveInPlace(right);
      }
      system.design.middleRows(r, 2) = pair;
      system.response.segment(r, 2) = right;
      system.cluster.insert(system.cluster.end(), 2, o->condition);
      r += 2;
    }
    return system;
  }

  LinearFit fit(const RegressorBlock& block) {
    const auto mode = static_cast<std::size_t>(block.mode);
    LinearFit last;
    System system;
    for (int pass = 0; pass < 12; ++pass) {
      system = assemble(block, pass == 0);
      if (system.design.rows() == 0 || system.design.cols() == 0) return last;
      last = linear_fit(system.design, system.response, system.cluster);
      double change = 0;
      for (std::size_t j = 0; j < system.unknown.size(); ++j) {
        const double value = last.coefficients(static_cast<Index>(j));
        change = std::max(change, std::abs(value - lump_value_[system.unknown[j]]) / (std::abs(value) + 1e-300));
        lump_value_[system.unknown[j]] = value;
      }
      if (system.frequency) {
        const double value = last.coefficients(last.coefficients.size() - 1);
        change = std::max(change, std::abs(value / natural_frequency_[mode] - 1));
        natural_frequency_[mode] = value;
      }
      if (pass > 1 && change < 1e-10) break;
    }
    record(block, system, last);
    return last;
  }

  // Keeps values, covariance and quality of a fitted block.
  void record(const RegressorBlock& block, const System& system, const LinearFit& fit) {
    BlockQuality quality;
    quality.name = std::string(block.name);
    quality.equations = static_cast<std::size_t>(system.design.rows());
    quality.conditions = std::set<int>(system.cluster.begin(), system.cluster.end()).size();
    quality.normalised_residual = fit.residual_sd;
    quality.condition_index = fit.condition_indices(std::max<Index>(0, fit.rank - 1));
    quality.clustered = fit.covariance_kind == CovarianceKind::clustered;
    const auto mode = static_cast<std::size_t>(block.mode);
    const auto name_of = [&](std::size_t column) {
      return column < system.unknown.size() ? std::string(case_.lumps[system.unknown[column]].name)
                                            : std::string(model_.symbols[mode].name);
    };
    Entry entry;
    entry.block = std::string(block.name);
    entry.degrees_of_freedom = fit.degrees_of_freedom;
    std::vector<Index> kept;
    for (std::size_t c = 0; c < fit.identifiable.size(); ++c) {
      const std::string name = name_of(c);
      quality.variance_inflation[name] = fit.variance_inflation(static_cast<Index>(c));
      const bool frequency = c >= system.unknown.size();
      if (fit.identifiable[c]) {
        kept.push_back(static_cast<Index>(c));
        entry.names.push_back(name);
        entry.lumps.push_back(frequency ? -1 : static_cast<int>(system.unknown[c]));
        entry.mode = mode;
        if (!frequency) lump_state_[system.unknown[c]] = State::estimated;
      } else if (!frequency) {
        lump_state_[system.unknown[c]] = State::not_identifiable;
        for (const int other : fit.entangled_with[c])
          lump_entangled_[system.unknown[c]].push_back(name_of(static_cast<std::size_t>(other)));
      }
    }
    entry.values.resize(static_cast<Index>(kept.size()));
    entry.covariance.resize(entry.values.size(), entry.values.size());
    for (Index i = 0; i < entry.values.size(); ++i) {
      entry.values(i) = fit.coefficients(kept[static_cast<std::size_t>(i)]);
      for (Index j = 0; j < entry.values.size(); ++j)
        entry.covariance(i, j) =
            fit.covariance(kept[static_cast<std::size_t>(i)], kept[static_cast<std::size_t>(j)]);
    }
    if (!quality.clustered)
      result_.warnings.push_back(
          quality.name +
          ": too few conditions for error bars from their scatter; they come from the residuals of " +
          std::to_string(quality.conditions) + " conditions and may be too small");
    entries_.push_back(std::move(entry));
    result_.blocks.push_back(std::move(quality));
  }

  void fit_modulation(const RegressorBlock& block) {
    if (set_.observations.empty()) return;
    fit(block);
  }

  void fit_harmonic(const RegressorBlock& block) {
    const std::size_t b = index_of(block);
    const bool any = std::any_of(set_.observations.begin(), set_.observations.end(),
                                 [&](const Observation& o) { return o.harmonic_sd[b] >= 0; });
    if (any) fit(block);
  }

  // Jacobian of all lumps and natural frequencies at a generic point, rows of what is known so far.
  MatrixXd known_jacobian(const VectorXd& parameters, const std::vector<bool>& lump_known) const {
    const auto count = static_cast<Index>(model_.symbols.size());
    MatrixXd all(static_cast<Index>(case_.lumps.size()), count);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> row_major(all.rows(), count);
    case_.evaluate_lumps_jacobian(parameters.data(), row_major.data());
    std::vector<Index> rows;
    for (std::size_t l = 0; l < case_.lumps.size(); ++l)
      if (lump_known[l]) rows.push_back(static_cast<Index>(l));
    MatrixXd known =
        MatrixXd::Zero(static_cast<Index>(rows.size() + model_.modes() + options_.fixed.size()), count);
    Index r = 0;
    for (const Index l : rows) known.row(r++) = row_major.row(l);
    for (std::size_t k = 0; k < model_.modes(); ++k) known(r++, static_cast<Index>(k)) = 1;
    for (const auto& [name, value] : options_.fixed)
      for (Index p = 0; p < count; ++p)
        if (model_.symbols[static_cast<std::size_t>(p)].name == name) known(r, p) = 1;
    return known;
  }

  // Parameters that the known lumps fix, at a generic point.
  struct Identifiability {
    std::vector<bool> fixed;
    std::vector<std::vector<int>> entangled_with;
  };
  Identifiability identifiability(const std::vector<bool>& lump_known) const {
    VectorXd generic(static_cast<Index>(model_.symbols.size()));
    for (Index p = 0; p < generic.size(); ++p)  // irrational-looking values of order one, the same in every run
      generic(p) = 1 + std::fmod(0.6180339887498949 * static_cast<double>(p + 1), 1.0);
    const MatrixXd known = known_jacobian(generic, lump_known);
    VectorXd scale = known.colwise().norm().transpose();
    for (Index c = 0; c < scale.size(); ++c) scale(c) = scale(c) > 0 ? 1 / scale(c) : 1;
    const Eigen::BDCSVD<MatrixXd> svd(known * scale.asDiagonal(), Eigen::ComputeFullV);
    Index rank = 0;
    while (rank < svd.singularValues().size() && svd.singularValues()(rank) > 1e-10 * svd.singularValues()(0))
      ++rank;
    const MatrixXd null = svd.matrixV().rightCols(generic.size() - rank);
    const MatrixXd projection = null * null.transpose();
    Identifiability result;
    result.entangled_with.resize(static_cast<std::size_t>(generic.size()));
    for (Index p = 0; p < generic.size(); ++p) {
      result.fixed.push_back(projection(p, p) < 1e-10);
      for (Index q = 0; q < generic.size(); ++q)
        if (q != p && !result.fixed.back() && std::abs(projection(p, q)) > 1e-8)
          result.entangled_with[static_cast<std::size_t>(p)].push_back(static_cast<int>(q));
    }
    return result;
  }

  std::vector<bool> known_lumps() const {
    std::vector<bool> known;
    for (const State state : lump_state_) known.push_back(state == State::fixed || state == State::estimated);
    return known;
  }

  bool sees_something_new(const RegressorBlock& block) const {
    std::vector<bool> known = known_lumps();
    const std::vector<bool> before = identifiability(known).fixed;
    // A parameter of an open lump that is not fixed yet.
    VectorXd generic = VectorXd::LinSpaced(static_cast<Index>(model_.symbols.size()), 1.1, 1.9);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(
        static_cast<Index>(case_.lumps.size()), generic.size());
    case_.evaluate_lumps_jacobian(generic.data(), jacobian.data());
    const bool zero_frequency = std::all_of(block.phase.begin(), block.phase.end(), [](int p) { return p == 0; });
    if (zero_frequency) return false;  // sensors drift there
    for (const int lump : block.lumps) {
      if (lump_state_[static_cast<std::size_t>(lump)] != State::open) continue;
      for (Index p = 0; p < generic.size(); ++p)
        if (jacobian(lump, p) != 0 && !before[static_cast<std::size_t>(p)]) return true;
    }
    return false;
  }

  void physical_parameters() {
    const auto count = static_cast<Index>(model_.symbols.size());
    VectorXd start = VectorXd::Zero(count);
    for (std::size_t k = 0; k < model_.modes(); ++k) start(static_cast<Index>(k)) = natural_frequency_[k];
    for (Index p = 0; p < count; ++p)
      for (std::size_t l = 0; l < case_.lumps.size(); ++l)
        if (case_.lumps[l].name == model_.symbols[static_cast<std::size_t>(p)].name &&
            lump_state_[l] != State::open && lump_state_[l] != State::not_identifiable)
          start(p) = lump_value_[l];
    for (const auto& [name, value] : options_.fixed)
      for (Index p = 0; p < count; ++p)
        if (model_.symbols[static_cast<std::size_t>(p)].name == name) start(p) = value;

    std::vector<bool> given(static_cast<std::size_t>(count), false);
    for (Index p = 0; p < count; ++p)
      given[static_cast<std::size_t>(p)] =
          options_.fixed.count(std::string(model_.symbols[static_cast<std::size_t>(p)].name)) != 0;
    Index rows = 0;
    for (const Entry& entry : entries_) rows += entry.values.size();
    FitReport report;
    report.parameters = start;
    report.covariance = MatrixXd::Zero(count, count);
    if (rows > 0) {
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> lump_jacobian(
          static_cast<Index>(case_.lumps.size()), count);
      VectorXd lumps(static_cast<Index>(case_.lumps.size()));
      const ResidualFunction function = [&](const VectorXd& parameters, VectorXd& residual, MatrixXd& jacobian) {
        case_.evaluate_lumps(parameters.data(), lumps.data());
        case_.evaluate_lumps_jacobian(parameters.data(), lump_jacobian.data());
        Index r = 0;
        for (const Entry& entry : entries_) {
          const Index size = entry.values.size();
          VectorXd difference(size);
          MatrixXd slope = MatrixXd::Zero(size, count);
          for (Index i = 0; i < size; ++i) {
            const int lump = entry.lumps[static_cast<std::size_t>(i)];
            if (lump < 0) {
              difference(i) = parameters(static_cast<Index>(entry.mode)) - entry.values(i);
              slope(i, static_cast<Index>(entry.mode)) = 1;
            } else {
              difference(i) = lumps(lump) - entry.values(i);
              slope.row(i) = lump_jacobian.row(lump);
            }
          }
          for (Index p = 0; p < count; ++p)
            if (given[static_cast<std::size_t>(p)]) slope.col(p).setZero();
          // Whitened through scaled variables: lumps differ by many powers of ten.
          const VectorXd sd = entry.covariance.diagonal().cwiseSqrt().cwiseMax(std::numeric_limits<double>::min());
          const MatrixXd correlation =
              sd.cwiseInverse().asDiagonal() * entry.covariance * sd.cwiseInverse().asDiagonal();
          const Eigen::LLT<MatrixXd> cholesky(correlation + 1e-12 * MatrixXd::Identity(size, size));
          difference = sd.cwiseInverse().asDiagonal() * difference;
          slope = sd.cwiseInverse().asDiagonal() * slope;
          cholesky.matrixL().solveInPlace(difference);
          cholesky.matrixL().solveInPlace(slope);
          residual.segment(r, size) = difference;
          jacobian.middleRows(r, size) = slope;
          r += size;
        }
      };
      report = nonlinear_fit(function, rows, start);
    }
    result_.parameter_values = report.parameters;
    const Identifiability known = identifiability(known_lumps());
    for (Index p = 0; p < count; ++p) {
      const auto index = static_cast<std::size_t>(p);
      EstimatedValue value;
      value.name = std::string(model_.symbols[index].name);
      value.unit = unit_text(model_.symbols[index].dimension, coordinate_units_, excitation_units_);
      if (given[index]) {
        value.fixed = true;
        value.identifiable = true;
        value.value = start(p);
        value.from = "given";
      } else if (known.fixed[index] && rows > 0) {
        value.identifiable = true;
        value.value = report.parameters(p);
        value.sd = std::sqrt(std::max(0.0, report.covariance(p, p)));
        value.degrees_of_freedom = smallest_degrees_of_freedom();
        value.from = source_of(value.name);
        value.significant = is_significant(value);
      } else {
        value.from = "not determined by this campaign";
        for (const int other : known.entangled_with[index])
          value.entangled_with.emplace_back(model_.symbols[static_cast<std::size_t>(other)].name);
      }
      result_.parameters.push_back(std::move(value));
    }
  }

  double smallest_degrees_of_freedom() const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Entry& entry : entries_) smallest = std::min(smallest, entry.degrees_of_freedom);
    return smallest;
  }

  static bool is_significant(const EstimatedValue& value) {
    return value.sd > 0 && two_sided_p_value(*value.value / value.sd, value.degrees_of_freedom) < 0.05;
  }

  std::string source_of(const std::string& name) const {
    for (const Entry& entry : entries_)
      if (std::find(entry.names.begin(), entry.names.end(), name) != entry.names.end()) return entry.block;
    return "lumps";
  }

  void report_lumps() {
    for (std::size_t l = 0; l < case_.lumps.size(); ++l) {
      EstimatedValue value;
      value.name = std::string(case_.lumps[l].name);
      value.definition = std::string(case_.lumps[l].definition);
      value.unit = unit_text(case_.lumps[l].dimension, coordinate_units_, excitation_units_);
      if (lump_state_[l] == State::fixed) {
        value.fixed = value.identifiable = true;
        value.value = lump_value_[l];
        value.from = "given";
      } else if (lump_state_[l] == State::estimated) {
        for (const Entry& entry : entries_)
          for (std::size_t i = 0; i < entry.lumps.size(); ++i)
            if (entry.lumps[i] == static_cast<int>(l)) {
              const auto at = static_cast<Index>(i);
              value.identifiable = true;
              value.value = entry.values(at);
              value.sd = std::sqrt(std::max(0.0, entry.covariance(at, at)));
              value.degrees_of_freedom = entry.degrees_of_freedom;
              value.from = entry.block;
              value.significant = is_significant(value);
            }
      } else {
        value.from = lump_state_[l] == State::open ? "not used" : "not determined by this campaign";
        const auto entangled = lump_entangled_.find(l);
        if (entangled != lump_entangled_.end()) value.entangled_with = entangled->second;
      }
      result_.lumps.push_back(std::move(value));
    }
  }

  // Estimated lumps (and the natural frequency, lump -1) of one block.
  struct Entry {
    std::string block;
    std::vector<std::string> names;
    std::vector<int> lumps;
    std::size_t mode = 0;
    VectorXd values;
    MatrixXd covariance;
    double degrees_of_freedom = 0;
  };

  const ObservationSet& set_;
  const CompiledModel& model_;
  const CompiledCase& case_;
  const EstimateOptions& options_;
  std::vector<std::string> coordinate_units_, excitation_units_;
  std::vector<double> natural_frequency_;
  std::set<std::size_t> fixed_frequency_;
  std::vector<double> lump_value_;
  std::vector<State> lump_state_;
  std::map<std::size_t, std::vector<std::string>> lump_entangled_;
  std::vector<Entry> entries_;
  Estimate result_;
};

}  // namespace

Estimate estimate(const ObservationSet& set, const std::string& coordinate_unit,
                  const std::vector<std::string>& excitation_units, const EstimateOptions& options) {
  if (set.observations.empty())
    throw InputError(
        "case " + std::string(set.resonance->name), "", "no observations are left to identify it from",
        set.warnings.empty() ? "the campaign has no record of the kind it needs" : set.warnings.front());
  return Estimator(set, coordinate_unit, excitation_units, options).run();
}

namespace {

// Parameters near `start` that give the estimated lumps and natural frequencies, each weighed by its error bar.
VectorXd representative(const Estimate& estimate, const VectorXd& start, const CompiledModel& model,
                        const CompiledCase& resonance) {
  const Index count = start.size();
  std::vector<std::size_t> lumps_used, parameters_used;
  for (std::size_t l = 0; l < estimate.lumps.size(); ++l)
    if (estimate.lumps[l].value && estimate.lumps[l].sd > 0) lumps_used.push_back(l);
  for (std::size_t p = 0; p < model.symbols.size(); ++p)
    if (estimate.parameters[p].value && (estimate.parameters[p].sd > 0 || estimate.parameters[p].fixed))
      parameters_used.push_back(p);
  VectorXd lumps(static_cast<Index>(resonance.lumps.size()));
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> slope(lumps.size(), count);
  const ResidualFunction function = [&](const VectorXd& parameters, VectorXd& residual, MatrixXd& jacobian) {
    resonance.evaluate_lumps(parameters.data(), lumps.data());
    resonance.evaluate_lumps_jacobian(parameters.data(), slope.data());
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

Estimate truncation_corrected(const Estimate& raw, const Estimate& replayed, const VectorXd& replay_parameters,
                              const CompiledModel& model, const CompiledCase& resonance) {
  Estimate corrected = raw;
  std::vector<double> lumps(resonance.lumps.size());
  resonance.evaluate_lumps(replay_parameters.data(), lumps.data());
  const auto correct = [](EstimatedValue& value, const EstimatedValue& again, double truth) {
    if (!value.value || !again.value || value.fixed) return;
    value.truncation = *again.value - truth;
    *value.value -= value.truncation;
    value.sd = std::hypot(value.sd, 0.5 * value.truncation);
    value.significant = value.sd > 0 && two_sided_p_value(*value.value / value.sd, value.degrees_of_freedom) < 0.05;
  };
  for (std::size_t l = 0; l < corrected.lumps.size(); ++l) correct(corrected.lumps[l], replayed.lumps[l], lumps[l]);
  for (std::size_t p = 0; p < model.symbols.size(); ++p)
    correct(corrected.parameters[p], replayed.parameters[p], replay_parameters(static_cast<Index>(p)));
  corrected.parameter_values = representative(corrected, replay_parameters, model, resonance);
  return corrected;
}

}  // namespace secular
