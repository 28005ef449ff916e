#include "diagnose/evidence/condition_rows.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "diagnose/evidence/saturation.hpp"
#include "motion/balance/balance_sweep.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Nothing measured is trusted beyond this share of the largest line of its kind: truncated lines and leakage of
/// what was not fitted are of this size.
constexpr double line_floor = 1e-5;

/// Slaved lines are moved by this share of the largest line to find what depends on them.
constexpr double line_step = 1e-6;

/// A cut is undone to this share of a line, in no more than so many steps, none longer than a share of the line;
/// the reading of a line grows with it by at least this factor, or nothing can be said of it.
constexpr double undone = 1e-10, longest_undoing = 0.3, least_slope = 1e-3;
constexpr int most_undoings = 30;

// Without the channel's gain and delay (cut-off and cross-axis sensitivity are taken care of by the caller).
Complex restored(Complex measured, const ChannelFault& fault, Complex rate) {
  return measured * std::exp(rate * fault.delay) / (1 + fault.gain);
}

class Evaluation {
 public:
  Evaluation(const Condition& c, const MotionBalance& balance, const SensorModel& sensors, const Faults& faults,
             std::span<const double> parameters)
      : c_(c), balance_(balance), sensors_(sensors), faults_(faults), parameters_(drifted(parameters)) {
    shapes_ = sensors.shapes;
    filter_ = sensors.filter;
    if (!faults.mixing.isZero(0)) {
      shapes_ += sensors.shapes * faults.mixing;
      filter_ = shapes_.completeOrthogonalDecomposition().pseudoInverse();
    }
    restore_excitation();
  }

  MotionSetting setting() const {
    MotionSetting setting{
        c_.torus, c_.rate,
        MatrixXcd::Zero(static_cast<Index>(balance_.model().excitations.size()), c_.torus->lines()), c_.masters,
        c_.resting};
    for (Index j = 0; j < true_excitation_.rows(); ++j)
      for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
        setting.excitation(j, c_.excitation_lines[l]) = true_excitation_(j, static_cast<Index>(l));
    return setting;
  }
  const std::vector<double>& parameters() const { return parameters_; }
  // Parameters at the condition's time.
  std::vector<double> drifted(std::span<const double> parameters) const {
    std::vector<double> values(parameters.begin(), parameters.end());
    for (std::size_t s = 0; s < values.size(); ++s) values[s] *= drift(s);
    return values;
  }
  // What a parameter has become by the condition's time, over what it was.
  double drift(std::size_t symbol) const {
    return symbol < faults_.frequency_drift.size() ? 1 + faults_.frequency_drift[symbol] * c_.time_s : 1;
  }

  ConditionForecast forecast(const VectorXcd& amplitudes, const Motion* start) const {
    return forecast_of(amplitudes, balance_.solve(setting(), amplitudes, parameters_, start));
  }

  // The largest displacement that the strongest lines could be, 1 where nothing is seen: a size of motions beside
  // rest.
  double measured_displacement() const {
    double largest = 0;
    for (std::size_t l = 0; l < c_.lines.size(); ++l)
      if (c_.lines[l] != 0)
        largest =
            std::max(largest, c_.response.col(static_cast<Index>(l)).cwiseAbs().maxCoeff() /
                                  std::abs(derivative_power(c_.line_rate(c_.lines[l]), sensors_.derivatives)));
    return largest > 0 ? largest : 1;
  }

  ConditionRows run(const Motion* start) const {
    ConditionRows rows;
    rows.amplitudes = master_amplitudes(start ? start->displacement : MatrixXcd());
    ConditionForecast expected = forecast(rows.amplitudes, start);
    if (saturates())
      for (int i = 0; i < most_undoings && expected.motion.converged; ++i) {
        const VectorXcd next = master_amplitudes(expected.motion.displacement);
        const double change = (next - rows.amplitudes).norm();
        if (change <= undone * next.norm()) break;
        rows.amplitudes = next;
        const Motion motion = std::move(expected.motion);
        expected = forecast(rows.amplitudes, &motion);
      }
    rows.values = differences(rows.amplitudes, expected);
    rows.motion = std::move(expected.motion);
    return rows;
  }

  // Amplitudes of the masters, as measured; the rows of a motion with them. Of a channel that saturates what is cut
  // off depends on the other lines of the motion: `displacement` (empty: none).
  VectorXcd master_amplitudes(const MatrixXcd& displacement) const {
    const auto channels = c_.response.rows();
    VectorXcd uncut = VectorXcd::Ones(channels);
    if (saturates()) {
      MatrixXcd lines = displacement.size() > 0 ? unsaturated_responses(displacement)
                                                : MatrixXcd::Zero(channels, c_.torus->lines());
      for (Index c = 0; c < channels; ++c)
        if (level_of(c) > 0) uncut(c) = uncut_share(lines, c);
    }
    VectorXcd amplitudes(static_cast<Index>(c_.masters.size()));
    for (std::size_t m = 0; m < c_.masters.size(); ++m) {
      const MasterLine& master = c_.masters[m];
      const auto column =
          static_cast<Index>(std::find(c_.lines.begin(), c_.lines.end(), master.line) - c_.lines.begin());
      VectorXcd seen(channels);
      for (Index c = 0; c < channels; ++c) {
        const ChannelFault& fault = faults_.response[static_cast<std::size_t>(c)];
        seen(c) = restored(uncut(c) * c_.response(c, column), fault, c_.line_rate(master.line)) -
                  fault.cross * excitation_at(master.line) -
                  extra_response(static_cast<std::size_t>(c), master.line);
      }
      amplitudes(static_cast<Index>(m)) = (filter_.row(static_cast<Index>(master.mode)).cast<Complex>() * seen)(0) /
                                          derivative_power(c_.line_rate(master.line), sensors_.derivatives);
    }
    return amplitudes;
  }

  VectorXd rows_of(const VectorXcd& amplitudes, Motion motion) const {
    return differences(amplitudes, forecast_of(amplitudes, std::move(motion)));
  }

 private:
  ConditionForecast forecast_of(const VectorXcd& amplitudes, Motion motion) const {
    ConditionForecast forecast;
    forecast.motion = std::move(motion);
    forecast.balance = forecast.motion.balance.cwiseQuotient(amplitudes);
    const MatrixXcd lines = predicted_responses(forecast.motion);
    forecast.response.resize(lines.rows(), static_cast<Index>(c_.lines.size()));
    for (std::size_t l = 0; l < c_.lines.size(); ++l)
      forecast.response.col(static_cast<Index>(l)) = lines.col(c_.lines[l]);
    forecast.excitation = expected_excitation();
    return forecast;
  }

  // Measured minus expected.
  VectorXd differences(const VectorXcd& amplitudes, const ConditionForecast& expected) const {
    std::vector<double> values;
    const auto push = [&](Complex value, bool real) {
      values.push_back(value.real());
      if (!real) values.push_back(value.imag());
    };
    for (Index m = 0; m < amplitudes.size(); ++m) {
      Complex balance = expected.balance(m);
      // An amplitude B(t) exp(i w t) has the inertia -(s^2 B + 2 s dB/dt).
      if (!c_.creep.empty())
        balance -= 2.0 * c_.line_rate(c_.masters[static_cast<std::size_t>(m)].line) *
                   c_.creep[static_cast<std::size_t>(m)];
      push(balance, false);
    }
    for (Index c = 0; c < c_.response.rows(); ++c)
      for (Index l = 0; l < c_.response.cols(); ++l)
        push(c_.response(c, l) - expected.response(c, l), c_.lines[static_cast<std::size_t>(l)] == 0);
    for (Index j = 0; j < c_.excitation.rows(); ++j)
      for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
        if (c_.excitation_lines[l] != c_.fundamental)
          push(c_.excitation(j, static_cast<Index>(l)) - expected.excitation(j, static_cast<Index>(l)),
               c_.excitation_lines[l] == 0);
    return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
  }

  // The fundamental as measured, harmonics in the ratio to it that the faults say, a mean only where the quantity
  // can have one.
  void restore_excitation() {
    true_excitation_ = c_.excitation;
    for (Index j = 0; j < c_.excitation.rows(); ++j) {
      const ChannelFault& fault = faults_.excitation[static_cast<std::size_t>(j)];
      Complex fundamental = 0;
      for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
        if (c_.excitation_lines[l] == c_.fundamental) {
          fundamental = c_.excitation(j, static_cast<Index>(l));
          if (fault.saturates())
            fundamental *=
                unsaturated_amplitude(std::abs(fundamental), fault.level(), noise(c_.excitation_noise, j)) /
                std::abs(fundamental);
          fundamental = restored(fundamental, fault, c_.line_rate(c_.fundamental));
        }
      const Complex turned = fundamental == 0.0 ? Complex(1) : fundamental / std::abs(fundamental);
      for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l) {
        const Index line = c_.excitation_lines[l];
        Complex& value = true_excitation_(j, static_cast<Index>(l));
        if (line == 0) {
          value = sensors_.excitation_derivatives > 0
                      ? Complex(0)
                      : (c_.excitation(j, static_cast<Index>(l)) - fault.offset) / (1 + fault.gain);
        } else if (line == c_.fundamental) {
          value = fundamental;
        } else {
          const int order = c_.torus->phase(line)[1] != 0
                                ? c_.torus->phase(line)[1] / c_.torus->phase(c_.fundamental)[1]
                                : c_.torus->phase(line)[0] / c_.torus->phase(c_.fundamental)[0];
          value = faults_.shaker_harmonic[static_cast<std::size_t>(order - 2)] * std::abs(fundamental) *
                  std::pow(turned, order);
        }
      }
    }
  }

  Complex excitation_at(Index line) const {
    if (true_excitation_.rows() == 0) return 0;
    for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
      if (c_.excitation_lines[l] == line) return true_excitation_(0, static_cast<Index>(l));
    return 0;
  }

  Complex extra_response(std::size_t channel, Index line) const {
    if (faults_.extra.amplitude[channel] == 0 || line == 0) return 0;
    return faults_.extra.response(channel, c_.line_rate(line), sensors_.derivatives, excitation_at(line));
  }

  Index strongest_line(Index channel) const {
    Index strongest = 0;
    for (Index l = 0; l < c_.response.cols(); ++l)
      if (c_.lines[static_cast<std::size_t>(l)] != 0 &&
          std::abs(c_.response(channel, l)) >= std::abs(c_.response(channel, strongest)))
        strongest = l;
    return strongest;
  }

  // What the channels would show if they had no limits and no offsets: channel x line of the torus.
  MatrixXcd unsaturated_responses(const MatrixXcd& displacement) const {
    MatrixXcd lines = shapes_ * displacement;
    for (Index l = 0; l < lines.cols(); ++l) {
      const Complex s = c_.line_rate(l);
      lines.col(l) *= derivative_power(s, sensors_.derivatives);
      for (Index c = 0; c < lines.rows(); ++c) {
        const ChannelFault& fault = faults_.response[static_cast<std::size_t>(c)];
        Complex& value = lines(c, l);
        value += fault.cross * excitation_at(l) + extra_response(static_cast<std::size_t>(c), l);
        value *= (1 + fault.gain) * std::exp(-s * fault.delay);
      }
    }
    return lines;
  }

  MatrixXcd predicted_responses(const Motion& motion) const {
    MatrixXcd lines = unsaturated_responses(motion.displacement);
    for (Index c = 0; c < lines.rows(); ++c) {
      if (level_of(c) > 0) saturate(lines, c, level_of(c), noise(c_.response_noise, c));
      lines(c, 0) += faults_.response[static_cast<std::size_t>(c)].offset;
    }
    return lines;
  }

  // Where a response channel saturates; 0: nowhere.
  double level_of(Index channel) const {
    const ChannelFault& fault = faults_.response[static_cast<std::size_t>(channel)];
    return fault.saturates() ? fault.level() : 0;
  }
  bool saturates() const {
    return std::any_of(faults_.response.begin(), faults_.response.end(),
                       [](const ChannelFault& fault) { return fault.saturates(); });
  }

  // What a channel's strongest line was before the cut, over what it shows: the line that, with all others as they
  // are in `lines`, is shown as measured. Newton's method with the slopes of the describing function of a sinusoid,
  // along the line's own phase and across it.
  Complex uncut_share(const MatrixXcd& lines, Index channel) const {
    const Index column = strongest_line(channel), line = c_.lines[static_cast<std::size_t>(column)];
    const Complex shown = c_.response(channel, column);
    if (shown == 0.0) return 1;
    const double level = level_of(channel), noise_sd = noise(c_.response_noise, channel);
    const auto fundamental = [&](double half) { return saturated_fundamental(half, level, noise_sd); };
    const double alone = unsaturated_amplitude(std::abs(shown), level, noise_sd);
    Complex uncut = shown * (alone / std::abs(shown));
    for (int i = 0; i < most_undoings; ++i) {
      MatrixXcd cut = lines.row(channel);
      cut(0, line) = uncut;
      saturate(cut, 0, level, noise_sd);
      const double half = std::abs(uncut), step = 1e-4 * half;
      const Complex direction = uncut / half;
      const Complex lacking = (shown - cut(0, line)) / direction;
      const double along = (fundamental(half + step) - fundamental(half - step)) / (2 * step);
      Complex change(lacking.real() / std::max(along, least_slope), lacking.imag() * half / fundamental(half));
      if (std::abs(change) > longest_undoing * half) change *= longest_undoing * half / std::abs(change);
      uncut += change * direction;
      if (std::abs(change) <= undone * half) break;
    }
    return uncut / shown;
  }

  static double noise(const VectorXd& by_channel, Index channel) {
    return by_channel.size() > 0 ? by_channel(channel) : 0;
  }

  // Lines of the reading that is expected on the mean; what stays clear of the level is not touched.
  void saturate(MatrixXcd& lines, Index row, double level, double noise_sd) const {
    MatrixXd samples = c_.torus->samples(lines.row(row));
    const double peak = samples.cwiseAbs().maxCoeff();
    if (saturated(peak, level, noise_sd) == peak) return;
    samples = samples.unaryExpr([&](double x) { return saturated(x, level, noise_sd); });
    lines.row(row) = c_.torus->coefficients(samples);
  }

  // What the excitation channels should show: a fundamental, and what faults and believed harmonics add.
  MatrixXcd expected_excitation() const {
    MatrixXcd expected = MatrixXcd::Zero(c_.excitation.rows(), c_.excitation.cols());
    for (Index j = 0; j < expected.rows(); ++j) {
      const ChannelFault& fault = faults_.excitation[static_cast<std::size_t>(j)];
      MatrixXcd lines = MatrixXcd::Zero(1, c_.torus->lines());
      for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l) {
        const Index line = c_.excitation_lines[l];
        lines(0, line) = true_excitation_(j, static_cast<Index>(l)) * (1 + fault.gain) *
                         std::exp(-c_.line_rate(line) * fault.delay);
      }
      if (fault.saturates()) saturate(lines, 0, fault.level(), noise(c_.excitation_noise, j));
      lines(0, 0) += fault.offset;
      for (std::size_t l = 0; l < c_.excitation_lines.size(); ++l)
        expected(j, static_cast<Index>(l)) = lines(0, c_.excitation_lines[l]);
    }
    return expected;
  }

  const Condition& c_;
  const MotionBalance& balance_;
  const SensorModel& sensors_;
  const Faults& faults_;
  std::vector<double> parameters_;
  MatrixXd shapes_, filter_;
  MatrixXcd true_excitation_;
};

/// Rows of a condition, and what its slaved lines lack to their balance, where these lines are held near
/// `displacement` instead of solved for. What they change of the cut of a channel that saturates is left out.
class HeldLines {
 public:
  struct Values {
    VectorXd rows, steps;
  };

  HeldLines(const Condition& condition, const MotionBalance& balance, const SensorModel& sensors,
            const Faults& faults, std::span<const double> parameters, const MatrixXcd& displacement)
      : balance_(balance),
        faults_(faults),
        evaluation_(condition, balance, sensors, faults_, parameters),
        setting_(evaluation_.setting()),
        sweep_(balance.model(), balance.forces(), setting_),
        amplitudes_(evaluation_.master_amplitudes(displacement)) {}
  HeldLines(const HeldLines&) = delete;
  HeldLines& operator=(const HeldLines&) = delete;

  std::vector<SlavedLine> slaves() const {
    return slaved_lines(setting_, balance_.model(), evaluation_.parameters());
  }

  BalanceSweep::Path path(MatrixXcd displacement) const {
    place_masters(setting_, amplitudes_, displacement);
    return sweep_.path(std::move(displacement));
  }

  Values at(const BalanceSweep::Path& path, const std::vector<SlavedLine>& slaves) {
    return values(path, evaluation_.parameters(), slaves);
  }
  // With other parameters of the model.
  Values at(const BalanceSweep::Path& path, std::span<const double> parameters,
            const std::vector<SlavedLine>& slaves) {
    return values(path, evaluation_.drifted(parameters), slaves);
  }

  // What moves with the slaved lines, or with symbols of the model: rows x entries, steps x entries.
  struct Slopes {
    MatrixXd rows, steps;
  };
  Slopes symbol_slopes(const BalanceSweep::Path& path, const std::vector<std::size_t>& symbols, Index rows,
                       const std::vector<SlavedLine>& slaves) {
    const std::vector<MatrixXcd> slopes = sweep_.parameter_slopes(path, evaluation_.parameters(), symbols);
    Slopes result{MatrixXd::Zero(rows, static_cast<Index>(symbols.size())),
                  MatrixXd(gathered(slaves, path.lines).size(), static_cast<Index>(symbols.size()))};
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      const auto column = static_cast<Index>(i);
      const MatrixXcd slope = slopes[i] * evaluation_.drift(symbols[i]);
      // A row of the equations of motion is the masters' balance over their amplitudes.
      const VectorXcd balance = balance_of_masters(setting_, slope).cwiseQuotient(amplitudes_);
      for (Index m = 0; m < balance.size(); ++m) {
        result.rows(2 * m, column) = balance(m).real();
        result.rows(2 * m + 1, column) = balance(m).imag();
      }
      result.steps.col(column) = BalanceSweep::steps(slaves, slope);
    }
    return result;
  }
  Slopes line_slopes(const BalanceSweep::Path& path, const std::vector<SlavedLine>& slaves) {
    const double motion = path.lines.cwiseAbs().maxCoeff();
    const double step = line_step * (motion > 0 ? motion : evaluation_.measured_displacement());
    const MatrixXcd residual = sweep_.residual(path, evaluation_.parameters());
    const MatrixXcd slopes = sweep_.residual_slopes(path, evaluation_.parameters(), slaves, step);
    const VectorXd base = rows(path.lines, residual);
    Slopes result{MatrixXd(base.size(), slopes.cols()), MatrixXd(slopes.cols(), slopes.cols())};
    for (Index s = 0; s < slopes.cols(); ++s) {
      const MatrixXcd slope = slopes.col(s).reshaped(residual.rows(), residual.cols());
      result.rows.col(s) = (rows(with_step(slaves, path.lines, s, step), residual + step * slope) - base) / step;
      result.steps.col(s) = BalanceSweep::steps(slaves, slope);
    }
    return result;
  }

 private:
  VectorXd rows(const MatrixXcd& displacement, const MatrixXcd& residual) const {
    return evaluation_.rows_of(amplitudes_, {displacement, balance_of_masters(setting_, residual), true});
  }
  Values values(const BalanceSweep::Path& path, std::span<const double> parameters,
                const std::vector<SlavedLine>& slaves) {
    const MatrixXcd residual = sweep_.residual(path, parameters);
    return {rows(path.lines, residual), BalanceSweep::steps(slaves, residual)};
  }

  const MotionBalance& balance_;
  Faults faults_;
  Evaluation evaluation_;
  MotionSetting setting_;
  BalanceSweep sweep_;
  VectorXcd amplitudes_;
};

}  // namespace

ConditionRows ConditionModel::rows(const Condition& condition, const VectorXd& unknowns,
                                   const Motion* start) const {
  const std::size_t symbols = balance_.model().symbols.size();
  const Faults faults = table_.faults(unknowns.data() + symbols);
  return Evaluation(condition, balance_, sensors_, faults, {unknowns.data(), symbols}).run(start);
}

ConditionForecast ConditionModel::forecast(const Condition& condition, const VectorXcd& amplitudes,
                                           const VectorXd& unknowns, const Motion* start) const {
  const std::size_t symbols = balance_.model().symbols.size();
  const Faults faults = table_.faults(unknowns.data() + symbols);
  return Evaluation(condition, balance_, sensors_, faults, {unknowns.data(), symbols}).forecast(amplitudes, start);
}

MatrixXd ConditionModel::slopes(const Condition& condition, const VectorXd& unknowns, const MatrixXcd& displacement,
                                const std::vector<std::size_t>& which, const VectorXd& scale) const {
  const std::size_t symbols = balance_.model().symbols.size();
  const auto held = [&](const VectorXd& at) {
    return HeldLines(condition, balance_, sensors_, table_.faults(at.data() + symbols), {at.data(), symbols},
                     displacement);
  };
  HeldLines here = held(unknowns);
  const std::vector<SlavedLine> slaves = here.slaves();
  const BalanceSweep::Path path = here.path(displacement);
  const HeldLines::Slopes by_line = here.line_slopes(path, slaves);
  const Eigen::PartialPivLU<MatrixXd> to_balance(by_line.steps);
  const auto followed = [&](VectorXd rows, const VectorXd& steps) {
    if (!slaves.empty()) rows -= by_line.rows * to_balance.solve(steps);
    return rows;
  };
  MatrixXd slopes(by_line.rows.rows(), static_cast<Index>(which.size()));
  std::vector<std::size_t> in_equations;
  std::vector<Index> columns;
  for (std::size_t w = 0; w < which.size(); ++w) {
    const auto column = static_cast<Index>(w), u = static_cast<Index>(which[w]);
    if (which[w] < symbols && !is_shape(which[w])) {
      in_equations.push_back(which[w]);
      columns.push_back(column);
      continue;
    }
    const auto at = [&](double value) {
      VectorXd moved = unknowns;
      moved(u) = value;
      if (which[w] < symbols) return here.at(path, {moved.data(), symbols}, slaves);
      HeldLines there = held(moved);
      return there.at(there.path(displacement), slaves);
    };
    const HeldLines::Values up = at(unknowns(u) + 0.5 * scale(column)),
                            down = at(unknowns(u) - 0.5 * scale(column));
    slopes.col(column) = followed(up.rows - down.rows, up.steps - down.steps);
  }
  const HeldLines::Slopes by_symbol = here.symbol_slopes(path, in_equations, slopes.rows(), slaves);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto column = static_cast<Index>(i);
    slopes.col(columns[i]) = scale(columns[i]) * followed(by_symbol.rows.col(column), by_symbol.steps.col(column));
  }
  return slopes;
}

// Forces whose law the equations of motion do not hold depend on their shapes in ways that these do not show.
bool ConditionModel::is_shape(std::size_t symbol) const {
  return std::any_of(balance_.forces().begin(), balance_.forces().end(),
                     [symbol](const StateForce& force) { return force.shape_symbol == symbol; });
}

std::vector<RowMeaning> ConditionModel::meanings(const Condition& condition) const {
  std::vector<RowMeaning> rows;
  const auto push = [&](RowMeaning meaning, bool real) {
    rows.push_back(meaning);
    if (real) return;
    meaning.imaginary = true;
    rows.push_back(meaning);
  };
  for (const MasterLine& master : condition.masters)
    push({RowMeaning::Kind::balance, master.mode, 0, master.line, false}, false);
  for (std::size_t c = 0; c < sensors_.responses.size(); ++c)
    for (const Index line : condition.lines) push({RowMeaning::Kind::response, 0, c, line, false}, line == 0);
  for (std::size_t j = 0; j < static_cast<std::size_t>(condition.excitation.rows()); ++j)
    for (const Index line : condition.excitation_lines)
      if (line != condition.fundamental) push({RowMeaning::Kind::excitation, 0, j, line, false}, line == 0);
  return rows;
}

MatrixXd ConditionModel::covariance(const Condition& condition, const VectorXd& unknowns,
                                    const Motion* start) const {
  const ConditionRows base = rows(condition, unknowns, start);
  MatrixXd covariance = MatrixXd::Zero(base.values.size(), base.values.size());
  Condition moved = condition;
  const auto add = [&](double sd) {
    if (!(sd > 0)) return;
    const VectorXd difference = rows(moved, unknowns, &base.motion).values - base.values;
    covariance += difference * difference.transpose();
  };
  const auto vary = [&](Complex& value, double sd, bool real) {
    const Complex kept = value;
    value = kept + sd;
    add(sd);
    if (!real) {
      value = kept + Complex(0, sd);
      add(sd);
    }
    value = kept;
  };
  // A line that no motion follows from is in its own rows alone.
  const std::vector<RowMeaning> meanings = this->meanings(condition);
  const auto stays_alone = [&](RowMeaning::Kind kind, std::size_t channel, Index line, double sd) {
    for (std::size_t r = 0; r < meanings.size(); ++r)
      if (meanings[r].kind == kind && meanings[r].channel == channel && meanings[r].line == line)
        covariance(static_cast<Index>(r), static_cast<Index>(r)) += sd * sd;
  };
  const Faults faults = table_.faults(unknowns.data() + balance_.model().symbols.size());
  const bool saturates = std::any_of(faults.response.begin(), faults.response.end(),
                                     [](const ChannelFault& fault) { return fault.saturates(); });
  const auto is_master = [&](Index line) {
    return std::any_of(condition.masters.begin(), condition.masters.end(),
                       [line](const MasterLine& master) { return master.line == line; });
  };
  for (Index c = 0; c < condition.response.rows(); ++c) {
    const double largest = condition.response.row(c).cwiseAbs().maxCoeff();
    for (std::size_t l = 0; l < condition.lines.size(); ++l) {
      const auto column = static_cast<Index>(l);
      const Index line = condition.lines[l];
      const double sd = std::hypot(condition.response_sd(c, column), line_floor * largest);
      if (saturates || is_master(line))
        vary(moved.response(c, column), sd, line == 0);
      else
        stays_alone(RowMeaning::Kind::response, static_cast<std::size_t>(c), line, sd);
    }
  }
  for (Index j = 0; j < condition.excitation.rows(); ++j) {
    const double largest = condition.excitation.row(j).cwiseAbs().maxCoeff();
    for (std::size_t l = 0; l < condition.excitation_lines.size(); ++l) {
      const auto column = static_cast<Index>(l);
      const Index line = condition.excitation_lines[l];
      const double sd = std::hypot(condition.excitation_sd(j, column), line_floor * largest);
      if (line == 0 || line == condition.fundamental)
        vary(moved.excitation(j, column), sd, line == 0);
      else
        stays_alone(RowMeaning::Kind::excitation, static_cast<std::size_t>(j), line, sd);
    }
  }
  for (std::size_t m = 0; m < condition.creep_sd.size(); ++m) vary(moved.creep[m], condition.creep_sd[m], false);
  return covariance;
}

}  // namespace secular
