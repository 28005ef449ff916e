#include "motion/balance/balance_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/hertz.hpp"

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::RowVectorXcd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

namespace {

/// A velocity beside zero.
constexpr double vanishing = 1e-300;

/// Lines beyond the torus move turnings by a few hundredths of a radian, and one another's effect by that share.
constexpr int turning_rounds = 3;

}  // namespace

std::vector<SlavedLine> slaved_lines(const MotionSetting& setting, const CompiledModel& model,
                                     std::span<const double> parameters) {
  std::vector<SlavedLine> slaves;
  for (Index l = 0; l < setting.torus->lines(); ++l)
    for (Index k = 0; k < static_cast<Index>(model.modes()); ++k) {
      const auto is_this = [&](const MasterLine& m) { return static_cast<Index>(m.mode) == k && m.line == l; };
      const bool known = std::any_of(setting.masters.begin(), setting.masters.end(), is_this) ||
                         std::any_of(setting.resting.begin(), setting.resting.end(), is_this);
      const double frequency = parameters[static_cast<std::size_t>(k)], stiffness = frequency * frequency;
      const Complex rate = setting.line_rate(l), dynamic = stiffness + rate * rate;
      if (!known && std::abs(dynamic) >= least_slaved_stiffness * stiffness)
        slaves.push_back({k, l, 1.0 / dynamic});
    }
  return slaves;
}

VectorXd gathered(const std::vector<SlavedLine>& slaves, const MatrixXcd& all) {
  Index size = 0;
  for (const SlavedLine& s : slaves) size += s.line == 0 ? 1 : 2;
  VectorXd values(size);
  Index at = 0;
  for (const SlavedLine& s : slaves) {
    const Complex value = all(s.mode, s.line);
    values(at++) = value.real();
    if (s.line != 0) values(at++) = value.imag();
  }
  return values;
}

void scattered(const std::vector<SlavedLine>& slaves, const VectorXd& values, MatrixXcd& all) {
  Index at = 0;
  for (const SlavedLine& s : slaves) {
    const double real = values(at++);
    all(s.mode, s.line) = Complex(real, s.line == 0 ? 0 : values(at++));
  }
}

MatrixXcd with_step(const std::vector<SlavedLine>& slaves, const MatrixXcd& all, Index entry, double step) {
  VectorXd values = gathered(slaves, all);
  values(entry) += step;
  MatrixXcd moved = all;
  scattered(slaves, values, moved);
  return moved;
}

BalanceSweep::BalanceSweep(const CompiledModel& model, std::vector<StateForce> forces, const MotionSetting& setting)
    : model_(model),
      forces_(std::move(forces)),
      torus_(*setting.torus),
      rates_(torus_.lines()),
      acceleration_(static_cast<Index>(model.modes()), torus_.points()),
      excitation_(model.excitations.size()) {
  for (Index l = 0; l < rates_.size(); ++l) rates_(l) = setting.line_rate(l);
  for (Index j = 0; j < setting.excitation.rows(); ++j)
    if (!setting.excitation.row(j).isZero(0)) driven_.push_back(j);
  const MatrixXcd driving = setting.excitation(driven_, Eigen::all);
  force_ = torus_.samples(driving);
  force_rate_ = torus_.samples(driving * rates_.asDiagonal());
  force_acceleration_ = torus_.samples(driving * rates_.cwiseAbs2().asDiagonal() * Complex(-1));
  if (!driven_.empty() && driven_.front() == 0) level_ = squared_amplitude(force_.row(0));
}

BalanceSweep::Path BalanceSweep::path(MatrixXcd displacement) const {
  MatrixXd position = torus_.samples(displacement);
  MatrixXd velocity = torus_.samples(displacement * rates_.asDiagonal());
  return {std::move(displacement), std::move(position), std::move(velocity)};
}

// Laws of the whole turn, linear in it, line by line: dz/dt + z/tau = dx/dt.
RowVectorXd BalanceSweep::values_of(const StateForce& force, const MatrixXd& position, const MatrixXd& velocity,
                                    double shape) const {
  if (force.law.kind == ForceLaw::Kind::level) return RowVectorXd::Constant(position.cols(), level_);
  if (force.law.kind != ForceLaw::Kind::relaxation) return signal_over_turn(force, position, velocity, shape);
  MatrixXcd lines = torus_.coefficients(position.row(static_cast<Index>(force.mode)));
  for (Index l = 0; l < lines.cols(); ++l) lines(0, l) *= rates_(l) / (rates_(l) + 1 / shape);
  return torus_.samples(lines);
}

std::vector<BalanceSweep::Signal> BalanceSweep::signals(const MatrixXd& position, const MatrixXd& velocity,
                                                        std::span<const double> parameters,
                                                        const std::vector<std::size_t>& strengths) const {
  std::vector<Signal> signals;
  for (const StateForce& force : forces_)
    if (parameters[force.strength_symbol] != 0 ||
        std::find(strengths.begin(), strengths.end(), force.strength_symbol) != strengths.end())
      signals.push_back(
          {&force, values_of(force, position, velocity, force.shape(parameters)), force.shape(parameters)});
  return signals;
}

void BalanceSweep::excite(Index point, const std::vector<Signal>& signals) {
  for (Index d = 0; d < force_.rows(); ++d)
    excitation_[driven(d)] = {force_(d, point), force_rate_(d, point), force_acceleration_(d, point)};
  for (const Signal& signal : signals) excitation_[signal.force->excitation] = {signal.values(point), 0, 0};
}

const MatrixXd& BalanceSweep::accelerations(const MatrixXd& position, const MatrixXd& velocity,
                                            std::span<const double> parameters,
                                            const std::vector<Signal>& signals) {
  if (model_.acceleration_of_lanes) return accelerations_side_by_side(position, velocity, parameters, signals);
  std::fill(excitation_.begin(), excitation_.end(), ExcitationSample{});
  for (Index p = 0; p < position.cols(); ++p) {
    excite(p, signals);
    model_.acceleration(parameters.data(), excitation_.data(), position.col(p).data(), velocity.col(p).data(),
                        acceleration_.col(p).data());
  }
  return acceleration_;
}

// As many points at once; the last one fills what is left.
const MatrixXd& BalanceSweep::accelerations_side_by_side(const MatrixXd& position, const MatrixXd& velocity,
                                                         std::span<const double> parameters,
                                                         const std::vector<Signal>& signals) {
  const Index modes = position.rows(), points = position.cols();
  std::vector<LaneParameter> same;
  for (std::size_t s = 0; s < model_.symbols.size(); ++s)
    same.push_back({Lanes(parameters[s]), parameters[s] != 0});
  std::vector<LaneSample> excitation(excitation_.size());
  std::vector<Lanes> here(model_.modes()), speed = here, result = here;
  for (Index first = 0; first < points; first += static_cast<Index>(Lanes::count)) {
    const auto lanes_of = [&](const auto& row) {
      return Lanes::each([&](Index lane) { return row(std::min(first + lane, points - 1)); });
    };
    for (Index d = 0; d < force_.rows(); ++d)
      excitation[driven(d)] = {lanes_of(force_.row(d)), lanes_of(force_rate_.row(d)),
                               lanes_of(force_acceleration_.row(d))};
    for (const Signal& signal : signals) excitation[signal.force->excitation].value = lanes_of(signal.values);
    for (Index k = 0; k < modes; ++k) {
      here[static_cast<std::size_t>(k)] = lanes_of(position.row(k));
      speed[static_cast<std::size_t>(k)] = lanes_of(velocity.row(k));
    }
    model_.acceleration_of_lanes(same.data(), excitation.data(), here.data(), speed.data(), result.data());
    for (Index p = first; p < std::min(first + static_cast<Index>(Lanes::count), points); ++p)
      for (Index k = 0; k < modes; ++k)
        acceleration_(k, p) = result[static_cast<std::size_t>(k)][static_cast<std::size_t>(p - first)];
  }
  return acceleration_;
}

// Of the excitation the nearest point's counts: jumps that it multiplies change little from there.
template <class Side>
void BalanceSweep::beside_turnings(const Path& path, const std::vector<Turning>& turnings,
                                   const std::vector<Signal>& signals, const Side& side) {
  const MatrixXcd velocity_lines = path.lines * rates_.asDiagonal();
  const Index points = path.position.cols();
  for (std::size_t t = 0; t < turnings.size(); ++t) {
    RowVectorXcd waves(rates_.size());
    const Complex turn = std::polar(1.0, turnings[t].seen);
    waves(0) = 1;
    for (Index n = 1; n < waves.size(); ++n) waves(n) = (n == 1 ? 2.0 : waves(n - 1)) * turn;
    position_ = (path.lines * waves.transpose()).real();
    velocity_ = (velocity_lines * waves.transpose()).real();
    excite(static_cast<Index>(turnings[t].seen / two_pi * static_cast<double>(points)) % points, signals);
    for (const int sign : {1, -1}) {
      velocity_(turnings[t].mode) = std::copysign(vanishing, sign * turnings[t].slope);
      for (const Signal& signal : signals)
        if (const StateForce& force = *signal.force; force.law.kind == ForceLaw::Kind::state)
          excitation_[force.excitation].value =
              force.law.value(position_(static_cast<Index>(force.mode)), velocity_(static_cast<Index>(force.mode)),
                              signal.shape, force.scale);
      side(static_cast<Index>(t), sign);
    }
  }
}

double BalanceSweep::moves(const Turning& jump, const Turning& moved, std::span<const double> parameters) const {
  if (jump.mode != moved.mode) return 0;
  return -velocity_beyond(moved.phase - jump.phase, static_cast<int>(torus_.lines() - 1), rates_(1).imag(),
                          parameters[static_cast<std::size_t>(jump.mode)]) /
         moved.slope;
}

// Jumps make lines beyond the torus, whose velocity moves the turnings.
BalanceSweep::Jumps BalanceSweep::jumps(const Path& path, std::span<const double> parameters,
                                        const std::vector<Signal>& signals) {
  Jumps jumps{turnings(torus_, path.lines * rates_.asDiagonal(), path.velocity), {}};
  const auto count = static_cast<Index>(jumps.at.size());
  jumps.sizes = MatrixXd::Zero(path.position.rows(), count);
  VectorXd acceleration(path.position.rows());
  beside_turnings(path, jumps.at, signals, [&](Index turning, int sign) {
    model_.acceleration(parameters.data(), excitation_.data(), position_.data(), velocity_.data(),
                        acceleration.data());
    jumps.sizes.col(turning) += sign * acceleration;
  });
  if (jumps.sizes.isZero(0)) return jumps;
  const double most = 1 / static_cast<double>(torus_.lines());
  for (int i = 0; i < turning_rounds; ++i)
    for (Turning& moved : jumps.at) {
      double way = 0;
      for (Index j = 0; j < count; ++j)
        way += jumps.sizes(moved.mode, j) * moves(jumps.at[static_cast<std::size_t>(j)], moved, parameters);
      moved.phase = moved.seen + std::clamp(way, -most, most);
    }
  return jumps;
}

std::vector<MatrixXcd> BalanceSweep::parameter_slopes(const Path& path, std::span<const double> parameters,
                                                      const std::vector<std::size_t>& symbols) {
  if (symbols.empty()) return {};
  const auto modes = path.position.rows(), points = path.position.cols();
  const auto count = static_cast<Index>(symbols.size()), all = static_cast<Index>(model_.symbols.size());
  const std::vector<Signal> signals = this->signals(path.position, path.velocity, parameters, symbols);
  MatrixXd felt(count * modes, points);
  VectorXd slope(modes * all);
  std::fill(excitation_.begin(), excitation_.end(), ExcitationSample{});
  for (Index p = 0; p < points; ++p) {
    excite(p, signals);
    model_.acceleration_by_parameters(parameters.data(), excitation_.data(), path.position.col(p).data(),
                                      path.velocity.col(p).data(), slope.data());
    for (Index i = 0; i < count; ++i)
      for (Index k = 0; k < modes; ++k)
        felt(i * modes + k, p) = slope(k * all + static_cast<Index>(symbols[static_cast<std::size_t>(i)]));
  }
  const Jumps jumps = this->jumps(path, parameters, signals);
  MatrixXd sizes = MatrixXd::Zero(count * modes, jumps.sizes.cols());
  beside_turnings(path, jumps.at, signals, [&](Index turning, int sign) {
    model_.acceleration_by_parameters(parameters.data(), excitation_.data(), position_.data(), velocity_.data(),
                                      slope.data());
    for (Index i = 0; i < count; ++i)
      for (Index k = 0; k < modes; ++k)
        sizes(i * modes + k, turning) +=
            sign * slope(k * all + static_cast<Index>(symbols[static_cast<std::size_t>(i)]));
  });
  MatrixXcd lines = lines_with_jumps(torus_, felt, jumps.at, sizes);
  for (Index j = 0; j < sizes.cols(); ++j) {
    const Turning& moved = jumps.at[static_cast<std::size_t>(j)];
    if (jumps.sizes.col(j).isZero(0)) continue;
    const RowVectorXcd by_phase = slope_by_phase(torus_, moved.phase);
    for (Index i = 0; i < count; ++i) {
      double way = 0;
      for (Index other = 0; other < sizes.cols(); ++other)
        way += sizes(i * modes + moved.mode, other) *
               moves(jumps.at[static_cast<std::size_t>(other)], moved, parameters);
      lines.middleRows(i * modes, modes) += way * jumps.sizes.col(j) * by_phase;
    }
  }
  std::vector<MatrixXcd> slopes;
  for (Index i = 0; i < count; ++i) slopes.push_back(lines.middleRows(i * modes, modes));
  return slopes;
}

MatrixXcd BalanceSweep::residual(const Path& path, std::span<const double> parameters) {
  const std::vector<Signal> signals = this->signals(path.position, path.velocity, parameters);
  const Jumps jumps = this->jumps(path, parameters, signals);
  return lines_with_jumps(torus_, accelerations(path.position, path.velocity, parameters, signals), jumps.at,
                          jumps.sizes) -
         path.lines * rates_.cwiseProduct(rates_).asDiagonal();
}

std::vector<BalanceSweep::Entry> BalanceSweep::entries_of(const std::vector<SlavedLine>& slaves) {
  std::vector<Entry> entries;
  for (const SlavedLine& s : slaves) {
    entries.push_back({s.mode, s.line, Complex(1, 0)});
    if (s.line != 0) entries.push_back({s.mode, s.line, Complex(0, 1)});
  }
  return entries;
}

MatrixXd BalanceSweep::slope_at_points(const Path& path, std::span<const double> parameters, Index coordinate,
                                       Variable variable, double step) {
  const bool of_velocity = variable == Variable::velocity;
  MatrixXd position = path.position, velocity = path.velocity;
  // No difference is taken across a jump.
  if (of_velocity)
    for (double& v : velocity.row(coordinate)) v = std::copysign(std::max(std::abs(v), 2 * step), v);
  MatrixXd& moved = of_velocity ? velocity : position;
  moved.row(coordinate).array() += step;
  MatrixXd change = accelerations(position, velocity, parameters, signals(position, velocity, parameters));
  moved.row(coordinate).array() -= 2 * step;
  change -= accelerations(position, velocity, parameters, signals(position, velocity, parameters));
  return change / (2 * step);
}

std::vector<BalanceSweep::Memory> BalanceSweep::memories(const Path& path, std::span<const double> parameters,
                                                         const std::vector<Signal>& signals, double length) {
  std::vector<Memory> memories;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (!signals[i].force->law.has_memory()) continue;
    std::vector<Signal> stronger = signals;
    stronger[i].values.array() += length;  // which the accelerations are linear in
    MatrixXd change = accelerations(path.position, path.velocity, parameters, stronger);
    change -= accelerations(path.position, path.velocity, parameters, signals);
    memories.push_back({signals[i], change / length});
  }
  return memories;
}

// What a line moves, every point feels through its own displacement and velocity: a pair of evaluations for each of
// these instead of one for each line. A force with memory, which does not feel where the whole path lies, counts as
// a signal there; what a line changes of that signal goes through the accelerations' slope by it.
MatrixXcd BalanceSweep::felt_on_lines(const Path& path, std::span<const double> parameters,
                                      const std::vector<Signal>& signals, const std::vector<Entry>& entries,
                                      double length) {
  const auto modes = path.position.rows(), points = path.position.cols();
  double fastest = 0;
  for (Index l = 0; l < rates_.size(); ++l) fastest = std::max(fastest, std::abs(rates_(l)));
  MatrixXd slopes(2 * modes * modes, points);  // by position and by velocity of a coordinate: of all accelerations
  for (Index k = 0; k < modes; ++k) {
    slopes.middleRows(2 * k * modes, modes) = slope_at_points(path, parameters, k, Variable::position, length);
    slopes.middleRows((2 * k + 1) * modes, modes) =
        slope_at_points(path, parameters, k, Variable::velocity, length * fastest);
  }
  const MatrixXcd sums = torus_.coefficients_of_sums(slopes);
  const std::vector<Memory> memories = this->memories(path, parameters, signals, length);
  MatrixXcd felt = MatrixXcd::Zero(static_cast<Index>(entries.size()) * modes, torus_.lines());
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const Entry& entry = entries[e];
    auto lines = felt.middleRows(static_cast<Index>(e) * modes, modes);
    for (Index m = 0; m < modes; ++m) {
      const Index by_position = 2 * entry.mode * modes + m;
      torus_.add_product(sums.row(by_position), entry.line, entry.unit, lines.row(m));
      torus_.add_product(sums.row(by_position + modes), entry.line, entry.unit * rates_(entry.line), lines.row(m));
    }
    for (const Memory& memory : memories)
      if (memory.signal.force->mode == static_cast<std::size_t>(entry.mode))
        lines += torus_.coefficients(memory.felt *
                                     change_of(memory.signal, path, parameters, entry, length).asDiagonal());
  }
  return felt;
}

// Of the signal of a force with memory with an entry of its mode.
RowVectorXd BalanceSweep::change_of(const Signal& signal, const Path& path, std::span<const double> parameters,
                                    const Entry& entry, double length) const {
  MatrixXd position = path.position;
  position.row(entry.mode) += length * torus_.samples_of_line(entry.line, entry.unit);
  return (values_of(*signal.force, position, path.velocity, signal.force->shape(parameters)) - signal.values) /
         length;
}

// Jumps go with the turnings that a line of their mode moves.
void BalanceSweep::take_jumps_along(const Entry& entry, const Jumps& jumps, MatrixXcd& change) const {
  if (entry.line == 0) return;
  for (Index j = 0; j < jumps.sizes.cols(); ++j) {
    const Turning& moved = jumps.at[static_cast<std::size_t>(j)];
    if (moved.mode != entry.mode) continue;
    const double velocity =
        2 *
        (entry.unit * rates_(entry.line) * std::polar(1.0, static_cast<double>(entry.line) * moved.phase)).real();
    change -= velocity / moved.slope * jumps.sizes.col(j) * slope_by_phase(torus_, moved.phase);
  }
}

MatrixXcd BalanceSweep::residual_slopes(const Path& path, std::span<const double> parameters,
                                        const std::vector<SlavedLine>& slaves, double length) {
  const std::vector<Signal> signals = this->signals(path.position, path.velocity, parameters);
  const std::vector<Entry> entries = entries_of(slaves);
  const MatrixXcd changes = felt_on_lines(path, parameters, signals, entries, length);
  const Jumps jumps = this->jumps(path, parameters, signals);
  const Index modes = path.position.rows();
  MatrixXcd slopes(modes * torus_.lines(), static_cast<Index>(entries.size()));
  for (Index e = 0; e < slopes.cols(); ++e) {
    const Entry& entry = entries[static_cast<std::size_t>(e)];
    MatrixXcd change = changes.middleRows(e * modes, modes);
    take_jumps_along(entry, jumps, change);
    change(entry.mode, entry.line) -= entry.unit * rates_(entry.line) * rates_(entry.line);
    slopes.col(e) = change.reshaped();
  }
  return slopes;
}

VectorXd BalanceSweep::steps(const std::vector<SlavedLine>& slaves, const MatrixXcd& residual) {
  MatrixXcd steps = MatrixXcd::Zero(residual.rows(), residual.cols());
  for (const SlavedLine& s : slaves) steps(s.mode, s.line) = residual(s.mode, s.line) * s.compliance;
  return gathered(slaves, steps);
}

}  // namespace secular
