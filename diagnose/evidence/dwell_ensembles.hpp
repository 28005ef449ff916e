#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <complex>
#include <memory>
#include <numbers>
#include <vector>

#include "diagnose/evidence/record_part.hpp"
#include "diagnose/evidence/resonant_lines.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// The lines that a dwell is read at, on the torus of a layout.
struct DwellLines {
  LineLayout layout;
  std::shared_ptr<const Torus> torus;
  std::array<double, 2> base = {};  // rad/s
  Eigen::Index fundamental = 0;
  std::vector<Eigen::Index> own_line;  ///< Condition::own_line
  std::vector<Eigen::Index> observed, excitation;

  double frequency(Eigen::Index line) const {
    return torus->phase(line)[0] * base[0] + torus->phase(line)[1] * base[1];
  }
  bool observes(Eigen::Index line) const {
    return std::find(observed.begin(), observed.end(), line) != observed.end();
  }
  Eigen::Index column(Eigen::Index line) const {
    return std::find(observed.begin(), observed.end(), line) - observed.begin();
  }
  Eigen::Index excitation_column(Eigen::Index line) const {
    return std::find(excitation.begin(), excitation.end(), line) - excitation.begin();
  }
};

/// Of a motion whose lines are multiples of 1/divisor of the excitation's frequency. An odd number of points over
/// a turn: the corners of a force that is odd in the motion fall on twice as many places, and alias half as far
/// from the lines that are looked at.
std::shared_ptr<const Torus> torus_of_turns(int divisor);

/// What one ensemble of a dwell shows.
struct LineEnsemble {
  Eigen::MatrixXcd response;    ///< channel x observed line
  Eigen::MatrixXcd excitation;  ///< channel x excitation line
  Eigen::VectorXd noise;        ///< of a sample: responses, then excitations
};

/// A dwell's samples, responses first, cut into ensembles of `length` samples. Keeps a reference to the samples.
class DwellReader {
 public:
  DwellReader(const RecordPart& part, double rate, std::size_t responses, Eigen::Index length)
      : part_(part), rate_(rate), responses_(static_cast<Eigen::Index>(responses)), length_(length) {}

  Eigen::Index ensembles() const { return part_.samples.rows() / length_; }
  Eigen::Index length() const { return length_; }
  double duration_s() const { return static_cast<double>(length_) / rate_; }  ///< of an ensemble
  double resolution() const { return 2 * std::numbers::pi * rate_ / static_cast<double>(length_); }  ///< rad/s

  /// Lines of a torus that an ensemble can tell apart, the mean first.
  std::vector<Eigen::Index> observable(const DwellLines& on, const Window& window) const;

  /// Every ensemble's lines, phases at the dwell's first sample.
  std::vector<LineEnsemble> read(const DwellLines& lines) const;

  /// For every ensemble the channels' amplitudes on a line, by the clock, and at frequencies beside it that no line
  /// is near: channel x (1 + frequencies). `lines`: frequencies of all, rad/s.
  std::vector<Eigen::MatrixXcd> read_about(double line, const std::vector<double>& lines) const;

 private:
  const RecordPart& part_;
  double rate_;
  Eigen::Index responses_, length_;
};

/// Takes the responses' mean, the first line, away.
void leave_mean_out(std::vector<LineEnsemble>& ensembles, DwellLines& lines);

/// Brings every ensemble to the same phases: the excitation's fundamental real and positive, and where that leaves
/// a choice, as close to the first ensemble as it can be.
void align(std::vector<LineEnsemble>& ensembles, const DwellLines& lines);

/// Means of aligned ensembles and how single ones scatter.
struct EnsembleStatistics {
  Eigen::MatrixXcd response, excitation;
  /// Standard deviation of one ensemble's real part about the mean: channel x line.
  Eigen::MatrixXd response_scatter, excitation_scatter;
  /// The same about a straight line in time, with one degree of freedom less.
  Eigen::MatrixXd response_about_line, excitation_about_line;
  Eigen::VectorXd noise;  ///< of a sample: responses, then excitations
};

/// Of two ensembles or more.
EnsembleStatistics statistics_of(const std::vector<LineEnsemble>& ensembles, const DwellLines& lines);

}  // namespace secular
