#include "blind/programme.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <memory>
#include <utility>

#include "blind/motion.hpp"

namespace secular::blind {
namespace {

// Six to an integration step of four a sample: stages of the integrator fall on them.
constexpr std::size_t course_points = 24;  // of a sample
constexpr double course_step = 1 / (sample_rate_hz * static_cast<double>(course_points));
constexpr std::size_t short_record = 4096, long_record = 16384;

/// Standard deviation of a blow's shape in time, s: at twice the sampling theorem's limit nothing of it is left.
constexpr double blow_s = 0.008;

Drive driven(std::size_t samples, double level, const std::function<double(double t)>& value) {
  auto course = std::make_shared<Course>();
  course->step = course_step;
  for (std::size_t i = 0; i <= samples * course_points; ++i)
    course->values.push_back(value(static_cast<double>(i) * course_step));
  Drive drive;
  drive.amplitude = level;
  drive.course = std::move(course);
  return drive;
}

Stretch rested(const std::string& kind, std::size_t samples, Drive drive) {
  Stretch stretch;
  stretch.kind = kind;
  stretch.drive = std::move(drive);
  stretch.samples = samples;
  return stretch;
}

// Rises and falls within a second at either end.
double faded(double t, double duration) {
  const double edge = std::clamp(std::min(t, duration - t), 0.0, 1.0);
  return 0.5 - 0.5 * std::cos(0.5 * two_pi * edge);
}

// From 15 % below the natural frequency to 15 % above, or back.
Stretch sweep(double omega, double level, bool upwards) {
  const double duration = static_cast<double>(long_record) / sample_rate_hz;
  const double from = omega * (upwards ? 0.85 : 1.15), to = omega * (upwards ? 1.15 : 0.85);
  return rested("sweep", long_record, driven(long_record, level, [&](double t) {
                  const double phase = from * t + 0.5 * (to - from) * t * t / duration;
                  return level * faded(t, duration) * std::cos(phase);
                }));
}

// Lines of equal amplitude and random phase from half to one and a half times the natural frequency, as near to one
// another as one record resolves.
Stretch noise(double omega, double rms, Random& random) {
  const double duration = static_cast<double>(long_record) / sample_rate_hz, spacing = two_pi / duration;
  const auto first = static_cast<std::size_t>(0.5 * omega / spacing),
             last = static_cast<std::size_t>(1.5 * omega / spacing);
  const double amplitude = rms * std::sqrt(2.0 / static_cast<double>(last - first + 1));
  std::vector<double> sum(long_record * course_points + 1);
  for (std::size_t k = first; k <= last; ++k) {
    std::complex<double> line = std::polar(amplitude, random.uniform(0, two_pi));
    const std::complex<double> turn = std::polar(1.0, static_cast<double>(k) * spacing * course_step);
    for (double& value : sum) {
      value += line.real();
      line *= turn;
    }
  }
  return rested("broadband", long_record, driven(long_record, rms, [&](double t) {
                  return faded(t, duration) * sum[static_cast<std::size_t>(std::llround(t / course_step))];
                }));
}

// A blow after three quarters of a second.
Stretch blow(double impulse) {
  const double peak = impulse / (blow_s * std::sqrt(two_pi));
  return rested("impact", short_record, driven(short_record, std::abs(peak), [&](double t) {
                  const double from_middle = (t - 0.75) / blow_s;
                  return peak * std::exp(-0.5 * from_middle * from_middle);
                }));
}

const std::vector<std::string> written_names = {"dwells", "decays", "one_decay", "sweeps", "broadband", "impacts"};

}  // namespace

const std::string& name_of(Programme programme) {
  return written_names.at(static_cast<std::size_t>(programme));
}

bool is_programme(const std::string& name) {
  return std::find(written_names.begin(), written_names.end(), name) != written_names.end();
}

Programme programme_named(const std::string& name) {
  return static_cast<Programme>(std::find(written_names.begin(), written_names.end(), name) -
                                written_names.begin());
}

const std::vector<std::string>& programme_names() {
  return written_names;
}

std::vector<std::string> families_of(Programme programme) {
  if (programme == Programme::dwells) return {"primary", "principal_parametric", "asymmetric", "two_modes"};
  return {"primary", "asymmetric"};
}

Stretch decay_from(double initial, std::size_t samples) {
  Stretch decay;
  decay.kind = "free_decay";
  decay.samples = samples;
  displacement(decay.state, 0) = initial;
  return decay;
}

std::vector<Stretch> draw_stretches(Programme programme, const ModeTerms& mode, double decay_rate, const Size& size,
                                    Random& random) {
  std::vector<Stretch> stretches;
  const double omega = mode.omega;
  switch (programme) {
    case Programme::dwells:
      break;
    case Programme::decays:
      for (const double part : {1.4, 1.1, 0.8, 0.5})
        stretches.push_back(decay_from(part * random.uniform(0.9, 1.1) * size.amplitude, short_record));
      break;
    case Programme::one_decay:
      stretches.push_back(decay_from(random.uniform(0.9, 1.6) * size.amplitude, short_record));
      break;
    case Programme::sweeps:
      for (const double level : {0.5, 0.9, 1.4}) stretches.push_back(sweep(omega, level * size.drive, true));
      stretches.push_back(sweep(omega, 1.4 * size.drive, false));
      break;
    case Programme::broadband: {
      // A force of the one-sided density S makes a variance S/(8 mu omega^2) of q'' + 2 mu q' + omega^2 q = f; its
      // band is omega/(2 pi) wide.
      const double response = 0.45 * size.amplitude, density = 8 * decay_rate * omega * omega * response * response,
                   rms = std::sqrt(density * omega / two_pi) / std::abs(mode.direct);
      for (const double level : {0.5, 0.9, 1.4}) stretches.push_back(noise(omega, level * rms, random));
      break;
    }
    case Programme::impacts: {
      const double shape = std::exp(-0.5 * omega * omega * blow_s * blow_s),  // of its spectrum, at resonance
          impulse = omega * size.amplitude / (std::abs(mode.direct) * shape);
      for (const double part : {0.4, 0.7, 1.0, 1.3, 1.6})
        stretches.push_back(blow(part * random.uniform(0.9, 1.1) * impulse));
      break;
    }
  }
  return stretches;
}

}  // namespace secular::blind
