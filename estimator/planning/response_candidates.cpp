#include "estimator/planning/response_candidates.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "motion/response/response_curve.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Multiples of a response's amplitude from which a release is tried; 1 % is a kick.
constexpr double releases[] = {1.0, 1.5, 0.01, 2.0, 0.6, 3.0, 0.3};

double total(const DwellState& state) {
  double sum = 0;
  for (const Complex& b : state.amplitude) sum += std::norm(b);
  return std::sqrt(sum);
}

class Candidates {
 public:
  Candidates(const ResponseField& field, const CandidateRequest& request) : field_(field), request_(request) {
    const CompiledModel& model = field.model();
    frequency_at_ = static_cast<Index>(model.symbols.size());
    forcing_at_ = frequency_at_ + static_cast<Index>(model.excitations.size());
  }

  // Stable responses at the given frequencies, one level.
  std::vector<DwellCandidate> at(const std::vector<double>& frequencies, double forcing, double lower,
                                 double upper) const {
    ResponseRequest request;
    request.parameters = request_.parameters;
    request.parameters(forcing_at_) = forcing;
    request.parameter = frequency_at_;
    request.lower = lower;
    request.upper = upper;
    const ResponseDiagram diagram = response_diagram(field_, request);
    const VectorField reduced = field_.reduced(diagram.scale, request.parameters);
    std::vector<DwellCandidate> found;
    for (const ResponseBranch& branch : diagram.branches) {
      if (branch.at_rest) continue;
      for (std::size_t i = 1; i < branch.points.size(); ++i) {
        const ResponsePoint &a = branch.points[i - 1], &b = branch.points[i];
        if (a.at_rest || b.at_rest || a.unstable > 0 || b.unstable > 0) continue;
        for (const double w : frequencies) {
          if ((w - a.parameter) * (w - b.parameter) > 0 || a.parameter == b.parameter) continue;
          const double share = (w - a.parameter) / (b.parameter - a.parameter);
          auto candidate = polished(reduced, request.parameters, w, a.state + share * (b.state - a.state));
          if (candidate && !is_known(found, *candidate)) found.push_back(std::move(*candidate));
        }
      }
    }
    return found;
  }

  bool reach(DwellCandidate& candidate) const {
    for (const double multiple : releases) {
      VectorXd start = VectorXd::Zero(static_cast<Index>(field_.model().modes()));
      for (const std::size_t k : field_.active())
        start(static_cast<Index>(k)) = multiple * 2 * std::abs(candidate.state.amplitude[k]);
      const double time = settling_from(start, candidate);
      if (time > request_.settle_limit) continue;
      candidate.start = start;
      candidate.settle_s = std::max(candidate.settle_s, time);
      return true;
    }
    return false;
  }

 private:
  std::optional<DwellCandidate> polished(const VectorField& reduced, VectorXd parameters, double frequency,
                                         VectorXd x) const {
    parameters(frequency_at_) = frequency;
    for (int iteration = 0; iteration < 20; ++iteration) {
      const VectorXd step = reduced.jacobian(x, parameters).fullPivLu().solve(reduced.rate(x, parameters));
      if (!step.allFinite()) return {};
      x -= step;
      if (step.cwiseQuotient(reduced.typical_state()).norm() < 1e-12) break;
      if (iteration == 19) return {};
    }
    const Spectrum spectrum = spectrum_of(reduced.jacobian(x, parameters));
    if (spectrum.unstable > 0) return {};
    DwellCandidate candidate;
    const ModeAmplitudes modes = field_.amplitudes(parameters, x);
    candidate.state = {frequency, parameters(forcing_at_), modes.amplitude, modes.frequency_shift};
    candidate.slowest = spectrum.eigenvalues.real().maxCoeff();
    candidate.settle_s = std::log(request_.settled) / candidate.slowest;
    if (!(candidate.settle_s <= request_.settle_limit) || !(total(candidate.state) > 0)) return {};
    return candidate;
  }

  // Solutions that differ by a phase alone are one measurement.
  static bool is_known(const std::vector<DwellCandidate>& known, const DwellCandidate& candidate) {
    return std::any_of(known.begin(), known.end(), [&](const DwellCandidate& other) {
      if (other.state.frequency != candidate.state.frequency) return false;
      double difference = 0;
      for (std::size_t k = 0; k < candidate.state.amplitude.size(); ++k)
        difference += std::abs(std::abs(other.state.amplitude[k]) - std::abs(candidate.state.amplitude[k]));
      return difference < 1e-6 * total(candidate.state);
    });
  }

  // Time after which the modulation equations, released from rest, stay within `settled` of the response; beyond
  // the limit where they go elsewhere.
  double settling_from(const VectorXd& start, const DwellCandidate& candidate) const {
    VectorXd parameters = request_.parameters;
    parameters(frequency_at_) = candidate.state.frequency;
    parameters(forcing_at_) = candidate.state.forcing;
    const auto modes = static_cast<Index>(field_.active().size());
    VectorXcd b(modes);
    VectorXd goal(modes);
    for (Index k = 0; k < modes; ++k) {
      const std::size_t mode = field_.active()[static_cast<std::size_t>(k)];
      b(k) = 0.5 * start(static_cast<Index>(mode));
      goal(k) = std::abs(candidate.state.amplitude[mode]);
    }
    // Steps well below the equations' own times.
    const VectorXcd there = Eigen::Map<const VectorXcd>(candidate.state.amplitude.data(), modes);
    double fastest = std::abs(candidate.slowest);
    for (Index k = 0; k < modes; ++k) {
      VectorXcd bent = modes == static_cast<Index>(field_.model().modes()) ? there : b;
      bent(k) *= 1.5;
      fastest = std::max(fastest, field_.modulation(parameters, bent).norm() / bent.norm() * 4);
    }
    const double step = std::min(0.2 / fastest, request_.settle_limit / 100);
    const auto rate = [&](const VectorXcd& x) { return field_.modulation(parameters, x); };
    double settled_since = -1;
    for (double time = 0; time <= request_.settle_limit; time += step) {
      const VectorXcd k1 = rate(b), k2 = rate(b + 0.5 * step * k1), k3 = rate(b + 0.5 * step * k2),
                      k4 = rate(b + step * k3);
      b += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      if (!b.allFinite()) return 2 * request_.settle_limit;
      const bool close = (b.cwiseAbs() - goal).norm() < 2 * request_.settled * goal.norm();
      if (!close) settled_since = -1;
      if (close && settled_since < 0) settled_since = time;
      // Close for as long as the slowest decay takes by a factor e: no passage.
      if (close && time - settled_since > 2 / std::abs(candidate.slowest)) return settled_since;
    }
    return 2 * request_.settle_limit;
  }

  const ResponseField& field_;
  const CandidateRequest& request_;
  Index frequency_at_ = 0, forcing_at_ = 0;
};

}  // namespace

std::vector<DwellCandidate> response_candidates(const ResponseField& field, const CandidateRequest& request) {
  if (request.frequencies.size() < 2 || request.forcings.empty())
    throw std::invalid_argument("candidates need two or more frequencies and a level");
  const Candidates candidates(field, request);
  std::vector<DwellCandidate> result;
  for (std::size_t level = 0; level < request.forcings.size(); ++level) {
    const auto tell = [&](std::size_t done) {
      if (request.progress) request.progress(done, request.forcings.size());
    };
    tell(level);
    for (DwellCandidate& candidate : candidates.at(request.frequencies, request.forcings[level],
                                                   request.frequencies.front(), request.frequencies.back())) {
      tell(level);
      if (!request.reached || candidates.reach(candidate)) result.push_back(std::move(candidate));
    }
    tell(level + 1);
  }
  return result;
}

}  // namespace secular
