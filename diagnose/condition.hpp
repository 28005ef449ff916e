#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <memory>
#include <string>
#include <vector>

#include "diagnose/motion_balance.hpp"
#include "estimator/campaign/campaign.hpp"

namespace secular {

/// One test condition as measured lines: the mean over the ensembles of a dwell, or one window of a decay.
/// Amplitudes are half of the peak, in channel units. Every line's error is that of its real and imaginary part.
struct Condition {
  std::string name;        ///< for people: file and place
  std::size_t record = 0;  ///< index into Campaign::records
  int fold = 0;            ///< what is left out together when a prediction is checked
  RecordKind kind = RecordKind::dwell;
  double time_s = 0;  ///< of its middle, since the campaign began
  std::shared_ptr<const Torus> torus;
  std::array<std::complex<double>, 2> rate;
  std::array<double, 2> growth_sd{}, frequency_sd{};  ///< of decays; a dwell's clock is exact
  std::vector<MasterLine> masters;
  /// By master: (dB/dt)/B of a dwell that was still creeping, and the error of its real and imaginary part.
  std::vector<std::complex<double>> creep;
  std::vector<double> creep_sd;
  Eigen::Index fundamental = 0;     ///< line of the excitation's fundamental; 0: no excitation
  std::vector<Eigen::Index> lines;  ///< observed lines; the zero line first where it is observed
  Eigen::MatrixXcd response;        ///< response channel x observed line
  Eigen::MatrixXd response_sd;
  std::vector<Eigen::Index> excitation_lines;  ///< 0, fundamental, 2*, 3*; empty without excitation
  Eigen::MatrixXcd excitation;                 ///< excitation channel x excitation line
  Eigen::MatrixXd excitation_sd;
};

}  // namespace secular
