#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <memory>
#include <vector>

#include "motion/balance/motion_balance.hpp"

namespace secular {

/// One test condition as measured lines: the mean over the ensembles of a dwell.
/// Amplitudes are half of the peak, in channel units. Every line's error is that of its real and imaginary part.
struct Condition {
  std::size_t record = 0;  ///< index into Campaign::records
  int fold = 0;            ///< what is left out together when a prediction is checked
  double time_s = 0;       ///< of its middle, of record_times
  /// By mode, relative: the record's natural frequencies next to those of all. Empty: none differs.
  Eigen::VectorXd frequency_offset;
  Eigen::Index samples = 0;  ///< of all ensembles
  std::shared_ptr<const Torus> torus;
  std::array<std::complex<double>, 2> rate;
  std::vector<MasterLine> masters;
  std::vector<MasterLine> resting;  ///< MotionSetting::resting
  /// By master: (dB/dt)/B of a dwell whose amplitude was still drifting, and the error of its real and imaginary
  /// part.
  std::vector<std::complex<double>> amplitude_drift_rate;
  std::vector<double> amplitude_drift_rate_sd;
  /// Growth + i*frequency at which a line's phase turns: sum |n_j| growth_j + i sum n_j frequency_j.
  std::complex<double> line_rate(Eigen::Index line) const { return secular::line_rate(*torus, rate, line); }

  Eigen::Index fundamental = 0;        ///< line of the excitation's fundamental; 0: no excitation
  std::vector<Eigen::Index> own_line;  ///< [excitation channel] line of its tone; empty: the fundamental of all
  /// Line at which an excitation channel is as measured; at others it shows what its shaker distorts.
  Eigen::Index tone_of(Eigen::Index channel) const {
    return own_line.empty() ? fundamental : own_line[static_cast<std::size_t>(channel)];
  }
  std::vector<Eigen::Index> lines;  ///< observed lines; the zero line first where it is observed
  Eigen::MatrixXcd response;        ///< response channel x observed line
  Eigen::MatrixXd response_sd;
  std::vector<Eigen::Index> excitation_lines;  ///< 0, fundamental, 2*, 3*; empty without excitation
  Eigen::MatrixXcd excitation;                 ///< excitation channel x excitation line
  Eigen::MatrixXd excitation_sd;
  /// By channel: sd of the noise of a sample, as it comes into a channel that may saturate. Empty: none.
  Eigen::VectorXd response_noise, excitation_noise;

  /// How late the responses count as, s: the excitation was put later by as much, so that the two are in step.
  double late_s = 0;
  void count_as_late(double seconds) {
    for (std::size_t l = 0; l < excitation_lines.size(); ++l)
      excitation.col(static_cast<Eigen::Index>(l)) *= std::exp((late_s - seconds) * line_rate(excitation_lines[l]));
    late_s = seconds;
  }

  /// Amplitude of the excitation's fundamental in its first channel, half of the peak; 0 without excitation.
  double excitation_level() const {
    for (std::size_t l = 0; l < excitation_lines.size(); ++l)
      if (fundamental != 0 && excitation_lines[l] == fundamental)
        return std::abs(excitation(0, static_cast<Eigen::Index>(l)));
    return 0;
  }
  double excitation_frequency() const { return line_rate(fundamental).imag(); }  ///< rad/s; 0 without excitation
};

}  // namespace secular
