#include "jobs/simulate/simulation.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "jobs/shared/shipped_models.hpp"
#include "jobs/simulate/experiment_loading.hpp"
#include "motion/simulate/experiment.hpp"
#include "motion/simulate/virtual_test.hpp"

namespace secular {

ExperimentText experiment_text(const std::string& experiment) {
  const std::filesystem::path file = resolve_model(experiment);
  std::ifstream in(file, std::ios::binary);
  return {experiment_model(file), {std::istreambuf_iterator<char>(in), {}}};
}

Campaign simulate(const SimulationRequest& request, const RecordSink& sink) {
  const auto [model, experiment] =
      load_experiment(resolve_model(request.experiment), request.interpret, request.note);
  return run_virtual_test(experiment, *model, request.seed, request.threads, sink, request.progress);
}

}  // namespace secular
