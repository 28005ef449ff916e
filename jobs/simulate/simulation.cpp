#include "jobs/simulate/simulation.hpp"

#include "jobs/shared/shipped_models.hpp"
#include "jobs/simulate/experiment_loading.hpp"
#include "motion/simulate/virtual_test.hpp"

namespace secular {

Campaign simulate(const SimulationRequest& request, const RecordSink& sink) {
  const auto [model, experiment] =
      load_experiment(resolve_model(request.experiment), request.interpret, request.note);
  return run_virtual_test(experiment, *model, request.seed, request.threads, sink, request.progress);
}

}  // namespace secular
