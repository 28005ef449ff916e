#include "jobs/identify/response_levels.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include "estimator/identification/identified_lumps.hpp"
#include "motion/response/response_curve.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

constexpr double to_degrees = 180 / std::numbers::pi;

// Phase of the response against the excitation, and the turn after which it repeats. Locked modes: the response's
// phase minus its share of the excitation's (half in a 2:1 lock, ambiguous by half a turn of the excitation). Two
// modes with a free frequency: gamma = arg(F conj(A1) conj(A2)).
struct RelativePhase {
  double phase = 0, turn = 0;
};
RelativePhase relative_phase(const CaseView& view, const Observation& o) {
  const std::size_t mode = first_mode(view);
  if (!view.modes.free.empty()) {
    std::complex<double> product = o.forcing[0];
    for (std::size_t k = 0; k < view.model->modes(); ++k)
      if (view.modes.oscillates[k]) product *= std::conj(o.amplitude[k]);
    return {std::arg(product), two_pi};
  }
  const double ratio = o.rate[mode].imag() / o.excitation_frequency[0];
  return {std::arg(o.amplitude[mode]) - ratio * std::arg(o.forcing[0]), two_pi * ratio};
}

// Mean and the mean's standard deviation, from the scatter; from one value alone 0.
struct MeanOf {
  double sum = 0, square = 0, count = 0;
  void add(double value) {
    sum += value;
    square += value * value;
    ++count;
  }
  double mean() const { return sum / count; }
  double sd() const {
    return count < 2 ? 0 : std::sqrt(std::max(0.0, square / count - mean() * mean()) / (count - 1));
  }
};

// The widest steps of the continuation along pieces.
struct Steps {
  double frequency_hz = 0, amplitude = 0;
};

Steps widest_steps(const std::vector<CurvePiece>& pieces) {
  Steps widest;
  for (const CurvePiece& piece : pieces)
    for (std::size_t i = 1; i < piece.amplitude.size(); ++i) {
      widest.frequency_hz =
          std::max(widest.frequency_hz, std::abs(piece.frequency_hz[i] - piece.frequency_hz[i - 1]));
      widest.amplitude = std::max(widest.amplitude, std::abs(piece.amplitude[i] - piece.amplitude[i - 1]));
    }
  return widest;
}

// Solutions that differ in phase alone have one amplitude: whether two pieces begin and end together, each end
// within a step of where it would be.
bool same_amplitudes(const CurvePiece& a, const CurvePiece& b, const Steps& step) {
  const auto together = [&](std::size_t i, std::size_t j) {
    return std::abs(a.frequency_hz[i] - b.frequency_hz[j]) <= 2 * step.frequency_hz &&
           std::abs(a.amplitude[i] - b.amplitude[j]) <= 2 * step.amplitude;
  };
  const std::size_t last_a = a.frequency_hz.size() - 1, last_b = b.frequency_hz.size() - 1;
  return a.stable == b.stable &&
         ((together(0, 0) && together(last_a, last_b)) || (together(0, last_b) && together(last_a, 0)));
}

std::vector<CurvePiece> different_pieces(std::vector<CurvePiece> pieces) {
  const Steps step = widest_steps(pieces);
  std::vector<CurvePiece> different;
  for (CurvePiece& piece : pieces)
    if (std::none_of(different.begin(), different.end(),
                     [&](const CurvePiece& other) { return same_amplitudes(piece, other, step); }))
      different.push_back(std::move(piece));
  return different;
}

// Beyond rest a branch goes on as its mirror image, of the opposite phase.
bool passes_rest(const ResponsePoint& a, const ResponsePoint& b, std::size_t mode) {
  return (std::conj(a.modes.amplitude[mode]) * b.modes.amplitude[mode]).real() < 0;
}

// Of a branch; a closed one from where its stability changes or it passes rest, wherever it was begun.
void add_pieces(const ResponseBranch& branch, std::size_t mode, std::vector<CurvePiece>& pieces) {
  std::vector<const ResponsePoint*> points;
  for (const ResponsePoint& point : branch.points)
    if (!point.at_rest) points.push_back(&point);
  const auto stable = [](const ResponsePoint* point) { return point->unstable == 0; };
  const auto parts = [&](const ResponsePoint* a, const ResponsePoint* b) {
    return stable(a) != stable(b) || passes_rest(*a, *b, mode);
  };
  if (branch.closed && points.size() > 1) {
    points.pop_back();  // the first one again
    const auto change = std::adjacent_find(points.begin(), points.end(), parts);
    if (change != points.end()) std::rotate(points.begin(), change + 1, points.end());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i]->parameter * to_hz, y = 2 * std::abs(points[i]->modes.amplitude[mode]);
    if (i > 0 && parts(points[i - 1], points[i]) && !passes_rest(*points[i - 1], *points[i], mode)) {
      pieces.back().frequency_hz.push_back(x);  // they meet in one point
      pieces.back().amplitude.push_back(y);
    }
    if (i == 0 || parts(points[i - 1], points[i])) pieces.push_back({stable(points[i]), {}, {}});
    pieces.back().frequency_hz.push_back(x);
    pieces.back().amplitude.push_back(y);
  }
}

}  // namespace

std::vector<DwellMean> dwell_means(const CaseView& view) {
  const std::size_t mode = first_mode(view);
  std::map<std::size_t, std::vector<std::size_t>> members;
  const auto& seen = view.measured.observations;
  for (std::size_t i = 0; i < seen.size(); ++i) members[seen[i].record].push_back(i);
  std::vector<DwellMean> means;
  for (const auto& [record, ensembles] : members) {
    MeanOf frequency, forcing, amplitude, computed, phase;
    for (const std::size_t i : ensembles) {
      const Observation& o = seen[i];
      frequency.add(o.excitation_frequency[0] * to_hz);
      forcing.add(std::abs(o.forcing[0]));
      amplitude.add(2 * std::abs(o.amplitude[mode]));
      if (!view.is_replayed()) continue;
      const Observation& m = view.replayed.observations[i];
      computed.add(2 * std::abs(m.amplitude[mode]));
      const RelativePhase here = relative_phase(view, o);
      phase.add(std::remainder(here.phase - relative_phase(view, m).phase, here.turn) * to_degrees);
    }
    DwellMean dwell{record, frequency.mean(), forcing.mean(), amplitude.mean(), amplitude.sd(), 0, 0, 0};
    if (view.is_replayed()) {
      dwell.phase_sd = phase.sd();
      dwell.model_amplitude = computed.mean();
      dwell.phase_difference = phase.mean();
    }
    means.push_back(dwell);
  }
  return means;
}

std::vector<ResponseLevel> response_levels(const CaseView& view) {
  std::vector<DwellMean> dwells = dwell_means(view);
  std::sort(dwells.begin(), dwells.end(),
            [](const DwellMean& a, const DwellMean& b) { return a.forcing < b.forcing; });
  std::vector<ResponseLevel> levels;
  for (const DwellMean& dwell : dwells) {
    if (levels.empty() || dwell.forcing > (1 + same_level) * levels.back().dwells.front().forcing)
      levels.emplace_back();
    levels.back().dwells.push_back(dwell);
  }
  for (ResponseLevel& level : levels) {
    for (const DwellMean& dwell : level.dwells)
      level.forcing += dwell.forcing / static_cast<double>(level.dwells.size());
    std::sort(level.dwells.begin(), level.dwells.end(),
              [](const DwellMean& a, const DwellMean& b) { return a.frequency_hz < b.frequency_hz; });
  }
  return levels;
}

std::vector<CurvePiece> model_curve(const CaseView& view, const ResponseLevel& level, double low_hz,
                                    double high_hz) {
  const std::vector<const CompiledCase*> known = identified_cases(view.estimate);
  if (view.model->excitations.size() != 1 || !(low_hz < high_hz) ||
      std::find(known.begin(), known.end(), view.resonance) == known.end())
    return {};
  const ResponseField field(*view.model, *view.resonance);
  const Eigen::VectorXd symbols = representative_parameters(view.estimate);
  if (symbols.size() != static_cast<Eigen::Index>(view.model->symbols.size()) || !symbols.allFinite()) return {};
  ResponseRequest request;
  request.parameters.resize(symbols.size() + 2);
  request.parameters << symbols, low_hz / to_hz, level.forcing;
  request.parameter = symbols.size();
  request.lower = low_hz / to_hz;
  request.upper = high_hz / to_hz;
  const auto strongest =
      std::max_element(level.dwells.begin(), level.dwells.end(),
                       [](const DwellMean& a, const DwellMean& b) { return a.amplitude < b.amplitude; });
  request.search_at = {strongest->frequency_hz / to_hz};
  const std::size_t mode = first_mode(view);
  std::vector<CurvePiece> pieces;
  for (const ResponseBranch& branch : response_diagram(field, request).branches)
    if (!branch.at_rest) add_pieces(branch, mode, pieces);
  return different_pieces(std::move(pieces));
}

}  // namespace secular
