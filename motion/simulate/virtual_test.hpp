#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "estimator/model/compiled_model.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/campaign_writer.hpp"
#include "motion/simulate/experiment.hpp"

namespace secular {

/// Called from any thread after every finished record with how many of how many are done.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

/// Runs the experiment on the full equations of motion of `model`. Records are computed by `threads` threads;
/// dwells that carry their state on follow one another in one thread. `sink` takes every record as soon as it is
/// computed, from any thread and in any order. Every record has a random stream of its own, from the seed and its
/// number: the same seed gives the same bytes whatever the number of threads. Throws InputError where a motion
/// grows beyond bounds, NumericalFailure where its integration makes no progress.
Campaign run_virtual_test(const Experiment& experiment, const CompiledModel& model, std::uint64_t seed,
                          unsigned threads, const RecordSink& sink, const Progress& progress);

}  // namespace secular
