#include "blind/signature.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "input/numerical_failure.hpp"

namespace secular::blind {
namespace {

// Steps of differences: small beside a period and beside a half-bandwidth.
constexpr double late_step_s = 1e-4, frequency_step = 1e-4;

// A structure that differs little from the settled one is settled again soon.
Settling resettling(const Specimen& specimen) {
  Settling settling = specimen.settling;
  settling.least_blocks = 5;
  settling.most_blocks = 25;
  settling.tolerance = 1e-3;
  return settling;
}

// Columns 1, cos, sin of the harmonics of the response's fundamental, at the samples from `first` on.
Eigen::MatrixXd harmonic_basis(double fundamental, std::size_t harmonics, std::size_t first) {
  Eigen::MatrixXd basis(ensemble_samples, 2 * harmonics + 1);
  for (Eigen::Index i = 0; i < basis.rows(); ++i) {
    const double phase = fundamental * static_cast<double>(first + static_cast<std::size_t>(i)) / sample_rate_hz;
    basis(i, 0) = 1;
    for (std::size_t h = 1; h <= harmonics; ++h) {
      const auto column = static_cast<Eigen::Index>(2 * h - 1);
      basis(i, column) = std::cos(static_cast<double>(h) * phase);
      basis(i, column + 1) = std::sin(static_cast<double>(h) * phase);
    }
  }
  return basis;
}

}  // namespace

Drive drive_of(const Dwell& dwell, const Reality& reality) {
  Drive drive = dwell.drive;
  drive.second = reality.second;
  drive.third = reality.third;
  return drive;
}

Levels levels_of(const Specimen& specimen, const Reality& reality) {
  const std::size_t channels = specimen.measurement.names.size();
  Levels levels{std::vector<double>(channels), std::vector<double>(channels)};
  std::vector<std::vector<double>> rms(channels);
  const auto take = [&](const Drive& drive, const State& from, std::size_t count) {
    const Motion motion = recorded_motion(reality.structure, drive, from, count, specimen.settling.substeps);
    const auto samples = measured(reality.measurement, drive, motion, true);
    for (std::size_t c = 0; c < channels; ++c) {
      double squares = 0;
      for (const double x : samples[c]) {
        squares += x * x;
        levels.peak[c] = std::max(levels.peak[c], std::abs(x));
      }
      rms[c].push_back(std::sqrt(squares / static_cast<double>(samples[c].size())));
    }
  };
  for (const Dwell& dwell : specimen.dwells) take(drive_of(dwell, reality), dwell.state, 256);
  if (specimen.dwells.empty())
    for (const Stretch& stretch : specimen.stretches) take(stretch.drive, stretch.state, stretch.samples);
  for (std::size_t c = 0; c < channels; ++c) {
    std::sort(rms[c].begin(), rms[c].end());
    levels.median_rms[c] = rms[c].empty() ? 0 : rms[c][rms[c].size() / 2];
  }
  // A channel of an excitation that is at rest reads noise as it would of one that is not.
  if (levels.peak[0] == 0) {
    levels.peak[0] = specimen.typical_drive;
    levels.median_rms[0] = specimen.typical_drive / std::sqrt(2.0);
  }
  return levels;
}

Signatures::Signatures(const Specimen& specimen, std::vector<double> noise_sd, Disturbances disturbances)
    : specimen_(specimen),
      noise_{std::move(noise_sd), std::move(disturbances)},
      harmonics_(specimen.settling.periods_of_two == 2 ? 6 : 4) {}

const Eigen::VectorXd& Signatures::nominal(bool all_ensembles) const {
  Eigen::VectorXd& amplitudes_of_model = nominal_[all_ensembles];
  if (amplitudes_of_model.size() == 0) amplitudes_of_model = amplitudes(reality_of(specimen_), all_ensembles);
  return amplitudes_of_model;
}

Eigen::VectorXd Signatures::amplitudes(const Reality& reality, bool all_ensembles, double of_drive) const {
  return has_dwells() ? lines_of_dwells(reality, all_ensembles, of_drive)
                      : stretch_spectra(specimen_, reality, noise_);
}

Eigen::VectorXd Signatures::lines_of_dwells(const Reality& reality, bool all_ensembles, double of_drive) const {
  const std::size_t ensembles = all_ensembles ? ensembles_per_dwell : 1, channels = noise_.sd.size();
  Eigen::VectorXd result(static_cast<Eigen::Index>(specimen_.dwells.size() * ensembles * channels) * components());
  const Settling settling = resettling(specimen_);
  Eigen::Index at = 0;
  for (const Dwell& dwell : specimen_.dwells) {
    Drive drive = drive_of(dwell, reality);
    drive.amplitude *= of_drive;
    const State state = settled_state(reality.structure, drive, dwell.state, settling);
    const Motion motion =
        recorded_motion(reality.structure, drive, state, ensembles * ensemble_samples, settling.substeps);
    const auto samples = measured(reality.measurement, drive, motion, true);
    const double fundamental = drive.frequency / static_cast<double>(settling.periods_of_two);
    for (std::size_t e = 0; e < ensembles; ++e) {
      const Eigen::MatrixXd basis = harmonic_basis(fundamental, harmonics_, e * ensemble_samples);
      const Eigen::LDLT<Eigen::MatrixXd> normal(Eigen::MatrixXd(basis.transpose() * basis));
      for (std::size_t c = 0; c < channels; ++c) {
        const Eigen::Map<const Eigen::VectorXd> y(samples[c].data() + e * ensemble_samples, ensemble_samples);
        result.segment(at, components()) = normal.solve(Eigen::VectorXd(basis.transpose() * y));
        for (Eigen::Index i = 0; i < components(); ++i) {
          const double hz = static_cast<double>((i + 1) / 2) * fundamental / two_pi;
          result(at + i) /= noise_.as_white(c, hz) * std::sqrt(2.0 / static_cast<double>(ensemble_samples));
        }
        result(at) *= std::sqrt(2.0);  // the mean's standard deviation is the smaller one
        at += components();
      }
    }
  }
  return result;
}

Eigen::VectorXd Signatures::difference(const Reality& reality, bool all_ensembles) const {
  Eigen::VectorXd change = amplitudes(reality, all_ensembles) - nominal(all_ensembles);
  return has_dwells() ? change : beside_excitation_noise(specimen_, noise_, std::move(change));
}

Eigen::MatrixX2d Signatures::excitation_noise(bool all_ensembles) const {
  constexpr double step = 0.002;
  const Eigen::VectorXd& here = nominal(all_ensembles);
  const Eigen::VectorXd larger = (amplitudes(reality_of(specimen_), all_ensembles, 1 + step) - here) / step;
  if (!larger.allFinite())
    throw NumericalFailure(Ending::ran_away, "a dwell of the model alone has no bounded motion");
  Eigen::MatrixX2d noise = Eigen::MatrixX2d::Zero(here.size(), 2);
  const Eigen::Index width = static_cast<Eigen::Index>(noise_.sd.size()) * components();
  const auto driven = static_cast<Eigen::Index>(specimen_.settling.periods_of_two);  // harmonic of the fundamental
  for (Eigen::Index first = 0; first < here.size(); first += width) {
    const double of_one = 1 / here.segment<2>(first + 2 * driven - 1).norm();
    for (Eigen::Index i = first + components(); i < first + width; i += components()) {
      noise.col(0).segment(i, components()) = of_one * larger.segment(i, components());
      // A later phase: every harmonic turns by its own multiple of it.
      for (Eigen::Index h = 1; h <= static_cast<Eigen::Index>(harmonics_); ++h) {
        const double turn = of_one * static_cast<double>(h) / static_cast<double>(driven);
        noise(i + 2 * h - 1, 1) = turn * here(i + 2 * h);
        noise(i + 2 * h, 1) = -turn * here(i + 2 * h - 1);
      }
    }
  }
  return noise;
}

// A lot of a whole record is the same in all of its ensembles, whose mean has a standard deviation that is the root
// of their number smaller: counted in that of one ensemble the lot is larger by this root.
const Eigen::MatrixXd& Signatures::noise_of_records(bool all_ensembles) const {
  Eigen::MatrixXd& noise = noise_of_records_[all_ensembles];
  if (noise.rows() > 0) return noise;
  noise = has_dwells() ? Eigen::MatrixXd(excitation_noise(all_ensembles))
                       : Eigen::MatrixXd(nominal(all_ensembles).size(), 0);
  const double of_one = has_dwells() ? std::sqrt(static_cast<double>(ensembles_per_dwell)) : 1;
  const auto add_column = [&](const Eigen::VectorXd& column) {
    noise.conservativeResize(Eigen::NoChange, noise.cols() + 1);
    noise.rightCols<1>() = column;
  };
  // Standard deviation of what is drawn evenly from 0 to T: T/sqrt(12).
  if (noise_.disturbances.latest_s > 0) {
    Reality late = reality_of(specimen_);
    late.measurement.fault[0].late -= late_step_s;
    add_column(of_one * noise_.disturbances.latest_s / std::sqrt(12.0) / late_step_s *
               difference(late, all_ensembles));
  }
  if (noise_.disturbances.frequency_scatter > 0) {
    Reality shifted = reality_of(specimen_);
    for (ModeTerms& mode : shifted.structure.mode) mode.omega *= 1 + frequency_step;
    add_column(of_one * noise_.disturbances.frequency_scatter / frequency_step *
               difference(shifted, all_ensembles));
  }
  return noise;
}

std::vector<RowsOfStretch> Signatures::rows_of_records(Eigen::Index all) const {
  if (!has_dwells()) return rows_of_stretches(specimen_);
  const Eigen::Index width = static_cast<Eigen::Index>(noise_.sd.size()) * components();
  std::vector<RowsOfStretch> rows;
  for (Eigen::Index first = 0; first < all; first += width) rows.push_back({first, width});
  return rows;
}

// (I + N N^T)^(-1/2) by the singular values s of N: along its left vectors 1/sqrt(1 + s^2), elsewhere 1.
Eigen::VectorXd Signatures::change(const Reality& reality, bool all_ensembles) const {
  Eigen::VectorXd result = difference(reality, all_ensembles);
  const Eigen::MatrixXd& noise = noise_of_records(all_ensembles);
  if (noise.cols() == 0) return result;
  for (const auto& [first, width] : rows_of_records(result.size())) {
    const Eigen::MatrixXd of_dwell = noise.middleRows(first, width);  // thin U needs columns counted at run time
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(of_dwell, Eigen::ComputeThinU);
    const Eigen::VectorXd kept = (1 + svd.singularValues().array().square()).rsqrt();
    auto here = result.segment(first, width);
    const Eigen::VectorXd along = svd.matrixU().transpose() * here;
    here -= svd.matrixU() * (along.array() * (1 - kept.array())).matrix();
  }
  return result;
}

namespace {

const std::string begin = "begin";

struct OwnParameter {
  std::string effect;
  std::size_t mode = 0;
  double step = 0;
  std::size_t channel = 0;                // of an offset
  std::size_t stretch = 0, of_state = 0;  // of a begin: which of the first mode's; 0 for the displacement

  void move(Reality& reality, double by) const {
    if (effect == begin)
      reality.begun.at(stretch).at(of_state) += by;
    else if (channel > 0)
      reality.measurement.fault[channel].offset += by;
    else
      *coefficient(reality.structure, effect, mode) += by;
  }
};

// The natural frequencies, then the coefficients, then what the response channels read at rest and, where decays
// are all there is, how these begin, with steps that change the response a little.
std::vector<OwnParameter> own_parameters_of(const Specimen& specimen, const std::vector<double>& noise_sd) {
  std::vector<OwnParameter> parameters;
  for (std::size_t k = 0; k < specimen.structure.modes; ++k)
    parameters.push_back({"natural_frequency", k, 0.02 * specimen.decay_rate[k]});
  Structure own = specimen.structure;
  for (const OwnTerm& term : specimen.own)
    parameters.push_back({term.effect, term.mode, 0.01 * *coefficient(own, term.effect, term.mode)});
  for (std::size_t c = 1; c < noise_sd.size(); ++c) parameters.push_back({"", 0, 0.1 * noise_sd[c], c});
  if (!specimen.dwells.empty()) return parameters;
  for (std::size_t i = 0; i < specimen.stretches.size(); ++i) {
    if (specimen.stretches[i].is_driven()) continue;
    const double step = 1e-3 * specimen.typical_amplitude[0];
    parameters.push_back({begin, 0, step, 0, i, 0});
    parameters.push_back({begin, 0, step * specimen.structure.mode[0].omega, 0, i, 1});
  }
  return parameters;
}

}  // namespace

const Eigen::MatrixXd& Signatures::own_parameters(bool all_ensembles) const {
  Eigen::MatrixXd& columns = own_[all_ensembles];
  if (columns.cols() > 0) return columns;
  const std::vector<OwnParameter> parameters = own_parameters_of(specimen_, noise_.sd);
  columns.resize(nominal(all_ensembles).size(), static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Reality reality = reality_of(specimen_);
    reality.begun.resize(specimen_.stretches.size());
    parameters[i].move(reality, parameters[i].step);
    const Eigen::VectorXd found = change(reality, all_ensembles);
    const double norm = found.norm();
    columns.col(static_cast<Eigen::Index>(i)) = norm > 0 ? Eigen::VectorXd(found / norm) : found;
    steps_[all_ensembles].push_back(norm > 0 ? parameters[i].step / norm : 0);
  }
  return columns;
}

Eigen::VectorXd Signatures::linear_unexplained(const Eigen::VectorXd& change_seen, bool all_ensembles) const {
  const Eigen::MatrixXd& columns = own_parameters(all_ensembles);
  return change_seen - columns * Eigen::VectorXd(columns.colPivHouseholderQr().solve(change_seen));
}

Eigen::VectorXd Signatures::change_with_own(Reality reality, const Eigen::VectorXd& moved,
                                            bool all_ensembles) const {
  own_parameters(all_ensembles);  // their steps
  const std::vector<OwnParameter> parameters = own_parameters_of(specimen_, noise_.sd);
  reality.begun.resize(specimen_.stretches.size());
  for (std::size_t i = 0; i < parameters.size(); ++i)
    parameters[i].move(reality, moved(static_cast<Eigen::Index>(i)) * steps_[all_ensembles][i]);
  return change(reality, all_ensembles);
}

Eigen::VectorXd Signatures::unexplained(const Eigen::VectorXd& change_seen, bool all_ensembles) const {
  const Eigen::MatrixXd& columns = own_parameters(all_ensembles);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  Eigen::VectorXd fitted = qr.solve(change_seen), best = change_seen - columns * fitted;
  for (int iteration = 0; iteration < 2; ++iteration) {
    const Eigen::VectorXd left = change_seen - change_with_own(reality_of(specimen_), fitted, all_ensembles);
    if (!left.allFinite()) break;
    const Eigen::VectorXd further = qr.solve(left), remaining = left - columns * further;
    if (remaining.norm() >= best.norm()) break;
    best = remaining;
    fitted += further;
  }
  return best;
}

namespace {

// What is left of `seen` by Gauss and Newton from zero on; Broyden's update after every step, slopes anew where
// these lead no further, halving where even those do not.
Eigen::VectorXd least_unexplained(const Eigen::VectorXd& seen, Eigen::MatrixXd slopes,
                                  const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& change_of) {
  constexpr double worth_a_step = 0.97;
  constexpr int most_steps = 15, most_slopes = 2, most_halvings = 5;
  Eigen::VectorXd fitted = Eigen::VectorXd::Zero(slopes.cols()), left = seen - change_of(fitted);
  bool local = true;
  int times_anew = 0;
  for (int step = 0; step < most_steps; ++step) {
    Eigen::VectorXd move = slopes.colPivHouseholderQr().solve(left);
    if (local && (left - slopes * move).norm() > worth_a_step * left.norm()) break;
    Eigen::VectorXd there = seen - change_of(fitted + move);
    const auto better = [&] { return there.allFinite() && there.norm() < left.norm(); };
    if (!better() && !local) {
      if (times_anew++ == most_slopes) break;
      const Eigen::VectorXd here = seen - left;
      for (Eigen::Index i = 0; i < slopes.cols(); ++i)
        slopes.col(i) = change_of(fitted + Eigen::VectorXd::Unit(slopes.cols(), i)) - here;
      if (!slopes.allFinite()) break;
      local = true;
      continue;
    }
    for (int halvings = 0; !better() && halvings < most_halvings; ++halvings) {
      move *= 0.5;
      there = seen - change_of(fitted + move);
    }
    if (!better()) break;
    slopes += (left - there - slopes * move) * move.transpose() / move.squaredNorm();
    const bool slow = there.norm() > worth_a_step * left.norm();
    fitted += move;
    left = there;
    if (slow && times_anew == most_slopes) break;
    local = false;
  }
  return left;
}

}  // namespace

Eigen::VectorXd Signatures::refitted_unexplained(const Eigen::VectorXd& change_seen, bool all_ensembles) const {
  return least_unexplained(change_seen, own_parameters(all_ensembles), [&](const Eigen::VectorXd& moved) {
    return change_with_own(reality_of(specimen_), moved, all_ensembles);
  });
}

Eigen::VectorXd Signatures::refitted_unexplained(const Eigen::VectorXd& change_seen, bool all_ensembles,
                                                 const std::function<Reality(double coefficient)>& rival,
                                                 double coefficient_at_first) const {
  const Eigen::MatrixXd& own = own_parameters(all_ensembles);
  const Eigen::VectorXd of_rival = change(rival(coefficient_at_first), all_ensembles);
  const double norm = of_rival.norm();
  if (!std::isfinite(norm) || norm == 0) return change_seen;
  Eigen::MatrixXd slopes(own.rows(), own.cols() + 1);
  slopes << own, of_rival / norm;
  return least_unexplained(change_seen, std::move(slopes), [&](const Eigen::VectorXd& moved) {
    const double more = moved(own.cols()) / norm;
    return change_with_own(rival(coefficient_at_first * (1 + more)), moved, all_ensembles);
  });
}

double Signatures::strength(const Eigen::VectorXd& change_seen, bool all_ensembles) const {
  double parts = static_cast<double>(specimen_.dwells.size() * (all_ensembles ? ensembles_per_dwell : 1));
  if (!has_dwells())
    for (const Stretch& stretch : specimen_.stretches)
      parts += static_cast<double>(stretch.samples) / static_cast<double>(ensemble_samples);
  return change_seen.norm() / std::sqrt(parts);
}

double Signatures::recorded_alike(bool all_ensembles) const {
  return has_dwells() && !all_ensembles ? static_cast<double>(ensembles_per_dwell) : 1;
}

double Signatures::relative(const Reality& reality, bool all_ensembles) const {
  return difference(reality, all_ensembles).norm() / nominal(all_ensembles).norm();
}

}  // namespace secular::blind
