#include "diagnose/evidence/dwell_ensembles.hpp"

#include <cmath>

#include "measure/signal/tone_fit.hpp"
#include "numerics/hertz.hpp"

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

/// Noise beside a line is read at these distances from it, in frequency resolutions of an ensemble, on both sides.
constexpr double beside[] = {3.5, 4.5, 5.5, 6.5};

// Turns an ensemble's base phases by `angle`.
void turn_phases(LineEnsemble& ensemble, const DwellLines& lines, const std::array<double, 2>& angle) {
  const auto factor = [&](Index line) {
    return std::polar(1.0, lines.torus->phase(line)[0] * angle[0] + lines.torus->phase(line)[1] * angle[1]);
  };
  for (std::size_t i = 0; i < lines.observed.size(); ++i)
    ensemble.response.col(static_cast<Index>(i)) *= factor(lines.observed[i]);
  for (std::size_t i = 0; i < lines.excitation.size(); ++i)
    ensemble.excitation.col(static_cast<Index>(i)) *= factor(lines.excitation[i]);
}

// By which of its turns an ensemble of a subharmonic motion comes closest to the first one.
int likest_turn(const LineEnsemble& ensemble, const LineEnsemble& first, const DwellLines& lines) {
  const int divisor = lines.layout.divisor;
  int best = 0;
  double agreement = -INFINITY;
  for (int j = 0; j < divisor; ++j) {
    LineEnsemble turned = ensemble;
    turn_phases(turned, lines, {two_pi * j / divisor, 0});
    const double likeness = turned.response.conjugate().cwiseProduct(first.response).sum().real();
    if (likeness > agreement) {
      agreement = likeness;
      best = j;
    }
  }
  return best;
}

MatrixXcd mean_of(const std::vector<LineEnsemble>& ensembles, MatrixXcd LineEnsemble::*part) {
  MatrixXcd sum = ensembles.front().*part;
  for (std::size_t e = 1; e < ensembles.size(); ++e) sum += ensembles[e].*part;
  return sum / static_cast<double>(ensembles.size());
}

enum class About { mean, straight_line };

// One ensemble's standard deviation of a real part about the mean of all or about a straight line in time.
MatrixXd scatter_of(const std::vector<LineEnsemble>& ensembles, MatrixXcd LineEnsemble::*part,
                    const MatrixXcd& mean, About about, const std::vector<Index>& lines) {
  const auto count = static_cast<double>(ensembles.size());
  MatrixXcd slope = MatrixXcd::Zero(mean.rows(), mean.cols());
  const auto time = [&](std::size_t e) { return static_cast<double>(e) - 0.5 * (count - 1); };
  if (about == About::straight_line)
    for (std::size_t e = 0; e < ensembles.size(); ++e)
      slope += time(e) / (count * (count * count - 1) / 12) * (ensembles[e].*part);
  MatrixXd sum = MatrixXd::Zero(mean.rows(), mean.cols());
  for (std::size_t e = 0; e < ensembles.size(); ++e)
    sum += (ensembles[e].*part - mean - time(e) * slope).cwiseAbs2();
  sum /= count - (about == About::mean ? 1 : 2);
  for (std::size_t l = 0; l < lines.size(); ++l)
    if (lines[l] != 0) sum.col(static_cast<Index>(l)) /= 2;  // of a real part
  return sum.cwiseSqrt();
}

Eigen::VectorXd noise_of(const std::vector<LineEnsemble>& ensembles) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(ensembles.front().noise.size());
  for (const LineEnsemble& e : ensembles) squares += e.noise.cwiseAbs2();
  return (squares / static_cast<double>(ensembles.size())).cwiseSqrt();
}

}  // namespace

std::shared_ptr<const Torus> torus_of_turns(int divisor) {
  constexpr Index turn_points = 255;
  return std::make_shared<const Torus>(1, std::max(6, 4 * divisor), turn_points);
}

std::vector<Index> DwellReader::observable(const DwellLines& on, const Window& window) const {
  std::vector<Index> lines = {0};
  std::vector<double> taken = {0};
  // Low orders first: where two lines fall together the simpler one is meant.
  std::vector<Index> order;
  for (Index l = 1; l < on.torus->lines(); ++l) order.push_back(l);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    const auto size = [&](Index l) { return std::abs(on.torus->phase(l)[0]) + std::abs(on.torus->phase(l)[1]); };
    return size(a) < size(b);
  });
  const double resolution = this->resolution(), nyquist = std::numbers::pi * rate_;
  for (const Index l : order) {
    const double frequency = on.frequency(l);
    const bool separate = std::all_of(taken.begin(), taken.end(), [&](double other) {
      return std::abs(frequency - other) > 2 * resolution && std::abs(frequency + other) > 2 * resolution;
    });
    if (!separate || std::abs(frequency) > nyquist - 2 * resolution || !window.passes(std::abs(frequency)))
      continue;
    lines.push_back(l);
    taken.push_back(frequency);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

std::vector<MatrixXcd> DwellReader::read_about(double line, const std::vector<double>& lines) const {
  const double resolution = this->resolution();
  std::vector<double> frequencies = {line};
  for (const double other : lines)
    if (other != line) frequencies.push_back(other);
  const std::size_t known = frequencies.size();
  for (const double distance : beside)
    for (const int side : {-1, 1}) {
      const double w = line + side * distance * resolution;
      const bool free = std::all_of(lines.begin(), lines.end(),
                                    [&](double other) { return std::abs(w - other) > 2.5 * resolution; });
      if (free && w > 2.5 * resolution && w < std::numbers::pi * rate_ - 2.5 * resolution) frequencies.push_back(w);
    }
  const auto count = static_cast<Index>(frequencies.size() - known);
  std::vector<MatrixXcd> all;
  for (Index e = 0; e < ensembles(); ++e) {
    const KnownFrequencyFit fit =
        known_frequency_components(part_.samples.middleRows(e * length_, length_), rate_, frequencies, true);
    MatrixXcd about(part_.samples.cols(), 1 + count);
    about.col(0) =
        fit.amplitude.row(0).transpose() * std::polar(1.0, -line * static_cast<double>(e * length_) / rate_);
    about.rightCols(count) = fit.amplitude.bottomRows(count).transpose();
    all.push_back(std::move(about));
  }
  return all;
}

std::vector<LineEnsemble> DwellReader::read(const DwellLines& lines) const {
  const std::vector<Index>& observed = lines.observed;
  std::vector<double> frequencies;
  for (const Index l : observed)
    if (l != 0) frequencies.push_back(std::abs(lines.frequency(l)));
  std::vector<LineEnsemble> all;
  for (Index e = 0; e < ensembles(); ++e) {
    const KnownFrequencyFit fit =
        known_frequency_components(part_.samples.middleRows(e * length_, length_), rate_, frequencies, true);
    const double centre = (static_cast<double>(e * length_) + 0.5 * static_cast<double>(length_ - 1)) / rate_;
    MatrixXcd values(part_.samples.cols(), static_cast<Index>(observed.size()));
    Index next = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
      const auto column = static_cast<Index>(i);
      if (observed[i] == 0) {
        values.col(column) = fit.offset.cast<Complex>();
        continue;
      }
      const double w = lines.frequency(observed[i]);
      Eigen::VectorXcd amplitude = fit.amplitude.row(next++).transpose();
      if (w < 0) amplitude = amplitude.conjugate().eval();
      values.col(column) = amplitude * std::polar(1.0, -w * centre);
    }
    LineEnsemble ensemble;
    ensemble.noise = fit.noise_sd;
    ensemble.response = values.topRows(responses_);
    ensemble.excitation.resize(values.rows() - responses_, static_cast<Index>(lines.excitation.size()));
    for (std::size_t i = 0; i < lines.excitation.size(); ++i)
      ensemble.excitation.col(static_cast<Index>(i)) =
          values.col(lines.column(lines.excitation[i])).tail(ensemble.excitation.rows());
    all.push_back(std::move(ensemble));
  }
  return all;
}

void leave_mean_out(std::vector<LineEnsemble>& ensembles, DwellLines& lines) {
  lines.observed.erase(lines.observed.begin());
  for (LineEnsemble& ensemble : ensembles)
    ensemble.response = ensemble.response.rightCols(ensemble.response.cols() - 1).eval();
}

void align(std::vector<LineEnsemble>& ensembles, const DwellLines& lines) {
  const LineLayout& layout = lines.layout;
  const Index excitation_column = lines.excitation_column(lines.fundamental);
  for (LineEnsemble& ensemble : ensembles) {
    const double phase = ensemble.excitation.rows() > 0 ? std::arg(ensemble.excitation(0, excitation_column)) : 0;
    if (layout.dimensions == 1) {
      turn_phases(ensemble, lines, {-phase / layout.divisor, 0});
      if (layout.divisor > 1 && &ensemble != &ensembles.front())
        turn_phases(ensemble, lines,
                    {two_pi * likest_turn(ensemble, ensembles.front(), lines) / layout.divisor, 0});
      continue;
    }
    // The line {1,0} real on the channel that sees it most; {0,1} then follows from the excitation's phase.
    const Index column = lines.column(*lines.torus->find({1, 0}));
    Index channel = 0;
    ensembles.front().response.col(column).cwiseAbs().maxCoeff(&channel);
    const double first = -std::arg(ensemble.response(channel, column));
    turn_phases(ensemble, lines, {first, -phase - layout.excitation[0] * first});
  }
}

EnsembleStatistics statistics_of(const std::vector<LineEnsemble>& ensembles, const DwellLines& lines) {
  EnsembleStatistics s;
  s.response = mean_of(ensembles, &LineEnsemble::response);
  s.excitation = mean_of(ensembles, &LineEnsemble::excitation);
  const auto response = [&](About about) {
    return scatter_of(ensembles, &LineEnsemble::response, s.response, about, lines.observed);
  };
  const auto excitation = [&](About about) {
    return scatter_of(ensembles, &LineEnsemble::excitation, s.excitation, about, lines.excitation);
  };
  s.response_scatter = response(About::mean);
  s.excitation_scatter = excitation(About::mean);
  s.response_about_line = response(About::straight_line);
  s.excitation_about_line = excitation(About::straight_line);
  s.noise = noise_of(ensembles);
  return s;
}

}  // namespace secular
