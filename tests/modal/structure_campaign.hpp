#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "tests/modal/pole_of.hpp"
#include "tests/modal/two_mass_structure.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular::testing_support {

/// Three degrees of freedom like the structure of chapter 2, its matrices and what they imply.
struct ThreeMassStructure {
  Eigen::Matrix3d mass, damping, stiffness, shapes;  ///< shapes mass-normalised, largest entry positive
  Eigen::Vector3cd poles;
};

inline ThreeMassStructure three_mass_structure() {
  ThreeMassStructure s;
  s.mass << 0.5421, -0.0048, 0.0543, -0.0048, 0.5444, 0.0330, 0.0543, 0.0330, 0.5230;
  s.stiffness << 9533, -9191, 3387, -9191, 18192, 1899, 3387, 1899, 31893;
  s.damping = 0.5 * s.mass + 1e-5 * s.stiffness;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> eigen(s.stiffness, s.mass);
  s.shapes = eigen.eigenvectors();
  for (int r = 0; r < 3; ++r) {
    const double omega = std::sqrt(eigen.eigenvalues()(r));
    s.poles(r) = pole_of(omega, (0.5 + 1e-5 * omega * omega) / (2 * omega));
    Eigen::Index largest = 0;
    s.shapes.col(r).cwiseAbs().maxCoeff(&largest);
    if (s.shapes(largest, r) < 0) s.shapes.col(r) *= -1;
  }
  return s;
}

inline Campaign empty_campaign(double rate, bool force) {
  Campaign campaign;
  campaign.name = "two-mass structure";
  campaign.sample_rate_hz = rate;
  if (force) campaign.channels.push_back({"hammer", ChannelRole::excitation, Quantity::force, "N"});
  for (const char* name : {"uprx+", "lorx+", "upry+"})
    campaign.channels.push_back({name, ChannelRole::response, Quantity::acceleration, "m/s^2"});
  return campaign;
}

struct CampaignData {
  Campaign campaign;
  std::vector<Record> samples;
};

/// Hammer impacts, `hits` at each of three points (the second and third degree of freedom, and against the first):
/// classical Runge-Kutta integration with 20 steps a sample; noise in m/s^2 and N.
inline CampaignData impact_campaign(int hits, double noise, std::uint64_t seed) {
  const ThreeMassStructure s = three_mass_structure();
  constexpr double rate = 512;
  constexpr int count = 2048, fine = 20;
  const Eigen::Matrix3d inverse = s.mass.inverse();
  Gaussian gaussian(seed);
  CampaignData data{empty_campaign(rate, true), {}};
  for (int point = 0; point < 3; ++point)
    for (int hit = 0; hit < hits; ++hit) {
      const double size = 80 + 10 * hit, sign = point == 0 ? -1 : 1, width = 0.004, centre = 0.05;
      // The hammer's cell sees a push, whatever its direction.
      const auto push = [&](double t) { return size * std::exp(-0.5 * std::pow((t - centre) / width, 2)); };
      const auto acceleration = [&](double t, const Eigen::Vector3d& x, const Eigen::Vector3d& v) {
        const Eigen::Vector3d force =
            sign * push(t) * Eigen::Vector3d::Unit(point) - s.damping * v - s.stiffness * x;
        return Eigen::Vector3d(inverse * force);
      };
      Eigen::Vector3d x = Eigen::Vector3d::Zero(), v = x;
      Record record;
      record.sample_rate_hz = rate;
      record.channels.assign(4, {});
      const double h = 1 / (rate * fine);
      for (int i = 0; i < count; ++i) {
        const double now = i / rate;
        const Eigen::Vector3d a = acceleration(now, x, v);
        record.channels[0].push_back(push(now) + 0.1 * noise * gaussian());
        for (int c = 0; c < 3; ++c)
          record.channels[static_cast<std::size_t>(c) + 1].push_back(a(c) + noise * gaussian());
        for (int k = 0; k < fine; ++k) {
          const double t = now + k * h;
          const Eigen::Vector3d a1 = acceleration(t, x, v), v2 = v + h / 2 * a1;
          const Eigen::Vector3d a2 = acceleration(t + h / 2, x + h / 2 * v, v2), v3 = v + h / 2 * a2;
          const Eigen::Vector3d a3 = acceleration(t + h / 2, x + h / 2 * v2, v3), v4 = v + h * a3;
          const Eigen::Vector3d a4 = acceleration(t + h, x + h * v3, v4);
          x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
          v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        }
      }
      RecordEntry entry;
      entry.kind = RecordKind::impact;
      entry.file = "records/" + std::to_string(point) + "_" + std::to_string(hit) + ".csv";
      entry.group = std::vector<std::string>{"uplx-", "lorx+", "upry+"}[static_cast<std::size_t>(point)];
      data.campaign.records.push_back(entry);
      data.samples.push_back(std::move(record));
    }
  return data;
}

/// Straight lines of Table 2.4: slopes of damped natural frequency and damping factor, Hz s^2/m.
inline const Eigen::Vector3d frequency_slopes(-0.0199, -0.0089, -0.0139);
inline const Eigen::Vector3d damping_slopes(-0.0104, -0.0037, -0.0052);

/// Free decays of three modes whose frequency and damping follow Table 2.4 exactly, with the shapes of Table 2.5,
/// at the thesis' sample rate; channel noise in m/s^2.
inline CampaignData decay_campaign(int decays, double noise, std::uint64_t seed, double seconds = 8) {
  const TwoMassTables t = two_mass_tables();
  constexpr double rate = 256;
  constexpr int fine = 16;
  Gaussian gaussian(seed);
  CampaignData data{empty_campaign(rate, false), {}};
  for (int d = 0; d < decays; ++d) {
    Eigen::Vector3d amplitude(9 + 0.5 * d, 8 - 0.3 * d, 7 + 0.2 * d), phase(0.4 * d, 1 + 0.9 * d, 2 - 0.7 * d);
    Record record;
    record.sample_rate_hz = rate;
    record.channels.assign(3, {});
    for (int i = 0; i < static_cast<int>(seconds * rate); ++i) {
      const Eigen::Vector3d motion = t.shapes * amplitude.cwiseProduct(phase.array().cos().matrix());
      for (int c = 0; c < 3; ++c)
        record.channels[static_cast<std::size_t>(c)].push_back(motion(c) + noise * gaussian());
      for (int k = 0; k < fine; ++k) {  // midpoint rule
        constexpr double h = 2 * std::numbers::pi / (rate * fine);
        const auto growth = [&](const Eigen::Vector3d& a) {
          return Eigen::Vector3d(a.cwiseProduct(t.damping_factor_hz + damping_slopes.cwiseProduct(a)));
        };
        const Eigen::Vector3d middle = amplitude + h / 2 * growth(amplitude);
        amplitude += h * growth(middle);
        phase += h * (t.frequency_hz + frequency_slopes.cwiseProduct(middle));
      }
    }
    RecordEntry entry;
    entry.kind = RecordKind::free_decay;
    entry.file = "records/" + std::to_string(d) + ".csv";
    data.campaign.records.push_back(entry);
    data.samples.push_back(std::move(record));
  }
  return data;
}

}  // namespace secular::testing_support
