#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "measure/data/campaign.hpp"
#include "motion/simulate/anti_alias_filter.hpp"
#include "motion/simulate/experiment_effects.hpp"
#include "motion/simulate/motion.hpp"

namespace secular {

/// A sensor of the virtual test.
struct SimulatedChannel {
  Channel channel;
  double noise_sd = 0;        ///< white Gaussian, channel units
  double high_pass_hz = 0;    ///< corner of the AC coupling; 0: none
  double quantisation = 0;    ///< step, 0: none
  std::string coordinate;     ///< measures this coordinate directly; empty with mode shapes or for the excitation
  std::vector<double> shape;  ///< of a response: what it sees of every mode, those that effects add included
  double base = 0;            ///< of an acceleration: what it sees of the base acceleration
};

/// Steady sinusoidal excitation at every combination of frequencies and amplitudes, in the order listed.
struct DwellProgramme {
  std::vector<std::vector<double>> frequencies_hz, amplitudes;  ///< [setting][excitation]
  std::vector<double> phases;  ///< [excitation] rad, at the dwell's beginning; empty: all zero
  int ensembles = 1;
  double ensemble_s = 4;
  double settle_s = 60;
  bool carry_state = false;  ///< goes on from the state in which the dwell before ended, as a laboratory sweep does
  std::vector<double> initial_displacement;  ///< by mode; a small kick lets a parametric resonance leave rest
  std::string group;
};

struct FreeDecayProgramme {
  std::vector<double> initial_displacement, initial_velocity;  ///< by mode
  double duration_s = 0;
  std::string group;
};

/// One record with an excitation that is not a steady sinusoid.
struct SignalProgramme {
  enum class Kind { sweep, impact, broadband };
  Kind kind = Kind::sweep;
  std::vector<double> amplitude;       ///< [excitation] sweep: of the sinusoid; impact: peak; broadband: rms
  std::vector<double> from_hz, to_hz;  ///< [excitation] sweep; may fall, or stand still
  double low_hz = 0, high_hz = 0;      ///< broadband: band
  double at_s = 0, width_s = 0;        ///< impact: start and length of the half-sine pulse
  std::size_t lines = 0;               ///< broadband
  std::uint64_t seed = 0;              ///< broadband: of the first excitation, one more for each further one
  double settle_s = 0;                 ///< sweep: at its first frequency; broadband: before recording
  double duration_s = 0;
  std::vector<double> initial_displacement;
  std::string group;
};

/// A fault of one channel.
struct SensorFault {
  ChannelFault kind = ChannelFault::gain;
  std::string channel;
  double strength = 0;
};

/// A virtual vibration test: model with numbers, sensors, programme.
struct Experiment {
  std::string file, name;
  std::string model;
  Eigen::VectorXd parameters;  ///< by CompiledModel::symbols
  double sample_rate_hz = 0;
  std::vector<SimulatedChannel> excitations;  ///< none, or one for each of the model's
  std::vector<SimulatedChannel> responses;
  std::optional<ModalBasis> modal_basis;  ///< what the campaign states, right or wrong
  std::optional<AntiAliasFilter> anti_alias;
  MotionSettings motion;  ///< integrator, armature, and what effects with memory need
  std::vector<DwellProgramme> dwells;
  std::vector<FreeDecayProgramme> free_decays;
  std::vector<SignalProgramme> signals;
  /// Of the first excitation in dwells and sweeps: amplitudes at 2, 3, ... times the frequency over that at it.
  std::vector<double> shaker_harmonics;
  std::vector<SensorFault> faults;
};

/// Name of the model that an experiment file asks for.
std::string experiment_model(const std::filesystem::path& path);

/// Parameters that a file may give in place of some of a model's symbols, and what makes those of them; `where` is
/// what messages call the values.
struct StatedParameters {
  std::vector<std::string> names;
  std::function<void(std::map<std::string, double>& values, const std::string& where)> take;
};

/// Reads an experiment file (schema 1, see docs/simulating.md for its keys) for `model`, which holds the file's
/// motion effects: `installed`, one for each in file order (see read_experiment_effects). Throws InputError with
/// line and key.
Experiment read_experiment(const std::filesystem::path& path, const CompiledModel& model,
                           std::span<const InstalledEffect> installed = {},
                           const EffectCatalogue& catalogue = effect_catalogue(),
                           const StatedParameters& stated = {});

}  // namespace secular
