#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/parameter_file.hpp"
#include "measure/data/campaign.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/response/limit_cycles.hpp"
#include "motion/response/response_curve.hpp"
#include "motion/response/response_spread.hpp"
#include "motion/simulate/stepped_sweep.hpp"

namespace secular {

/// A parameter and the values it takes; rad/s where it is a frequency.
struct VariedParameter {
  std::string name;
  double from = 0, to = 0;
};

struct PredictionRequest {
  std::string model, resonance;          ///< as ModelSource takes them
  std::string parameters;                ///< as read_parameter_file takes it, or what messages call `given`
  std::optional<GivenParameters> given;  ///< in place of a file
  std::map<std::string, double> at;      ///< beside the parameter file, and stronger
  bool hz = false;                       ///< excitation frequencies among `at`, `vary` and `against` are in Hz
  std::optional<VariedParameter> vary, against;
  std::string curve;   ///< saddle_node, threshold, hopf, peak or empty
  double largest = 0;  ///< peak amplitude up to which responses are looked for; 0: chosen
  bool sweep_up = false, sweep_down = false;
  int sweep_steps = 60;
  std::string measured;  ///< campaign whose dwells are drawn on the response, or what messages call it; or empty
  std::optional<Campaign> campaign;  ///< that one, in place of a folder
  Window window;                     ///< of its records
  unsigned threads = 1;
  NoteSink note = {};  ///< of loading the model
};

/// A simulated sweep of the full equations over the varied parameter.
struct PredictedSweep {
  std::string direction;  ///< "up", "down"
  std::vector<double> parameter;
  std::vector<SweepPoint> points;
  struct Jump {
    double from = 0, to = 0;  ///< parameter before and after
    double amplitude_before = 0, amplitude_after = 0;
    std::size_t mode = 0;
  };
  std::vector<Jump> jumps;
};

/// One measured dwell on a response.
struct MeasuredPoint {
  std::string record, group;      ///< the record's file; its group in the campaign
  double parameter = 0;           ///< measured value of what is varied, rad/s where it is a frequency
  std::vector<double> amplitude;  ///< [mode] peak, mean over ensembles
  std::vector<double> spread;     ///< [mode] standard deviation between ensembles
};

/// What ends the rise of an amplitude at its largest value over what is varied.
enum class LargestAt {
  peak,           ///< the amplitude is level there
  range_end,      ///< of what is varied
  stability_end,  ///< a special point: beyond it the response is unstable
  search_end      ///< the expansion's range, or how far responses were looked for
};

/// The largest stable response of one mode within the expansion's range.
struct LargestResponse {
  std::size_t mode = 0;
  LargestAt kind = LargestAt::peak;
  double parameter = 0;                              ///< of what is varied
  double amplitude = 0;                              ///< peak
  std::optional<double> parameter_sd, amplitude_sd;  ///< one standard deviation; of `peak` both, of `range_end` the
                                                     ///< latter, where there are error bars and first order holds
};

/// Everything that a run of `predict` found, before it is written.
struct Prediction {
  std::shared_ptr<const CompiledModel> model;
  const CompiledCase* resonance = nullptr;
  std::vector<std::string> names;  ///< ResponseField::parameter_names
  std::vector<std::string> units;  ///< of `parameters`; empty where nothing says them
  std::string coordinate_unit;     ///< the same, of amplitudes
  Eigen::VectorXd parameters;
  std::optional<VariedParameter> vary, against;  ///< frequencies in rad/s
  double axis = 1, against_axis = 1;  ///< of a printed value to the parameter's: 2 pi where Hz is printed
  std::string axis_unit, against_unit;
  ResponseDiagram diagram;
  std::vector<LargestResponse> largest;  ///< by moving mode, those that have a stable response but rest
  std::vector<ResponseCurve> curves;
  std::vector<std::pair<std::string, std::vector<BackbonePoint>>> backbones;
  std::vector<std::vector<LimitCycle>> limit_cycles;  ///< by backbone
  std::vector<std::string> uncertain;  ///< parameters with error bars, which responses and backbones take over
  Eigen::MatrixXd directions;          ///< UncertainParameters::directions; where `uncertain` has names
  std::string no_spread_because;       ///< where it has none
  std::vector<std::vector<BackboneSpread>> backbone_spread;  ///< by backbone and its points, or empty
  std::vector<std::vector<std::optional<LimitCycleSpread>>>
      limit_cycle_spread;  ///< by backbone and cycle, or empty
  std::vector<PredictedSweep> sweeps;
  std::vector<MeasuredPoint> measured;
  std::vector<std::string> warnings;
};

/// Called after every dwell of the sweeps, from any thread.
using SweepProgress = std::function<void(std::size_t done, std::size_t total)>;

/// The job `predict`. Throws InputError for whatever in the request makes no sense.
Prediction predict(const PredictionRequest& request, const SweepProgress& progress = {});

}  // namespace secular
