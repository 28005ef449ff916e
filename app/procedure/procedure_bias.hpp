#pragma once

#include <functional>
#include <vector>

#include "app/procedure/thesis_procedures.hpp"
#include "jobs/identify/identification.hpp"

namespace secular::app {

/// What the methods make of observations whose structure has these parameters: rows hold them as their truth.
using MethodsOn =
    std::function<std::vector<ProcedureSection>(const ObservationSet& seen, const Eigen::VectorXd& parameters)>;

/// The bias of every row that has one (ProcedureBias): the methods are run on the steady motions that the full
/// equations of motion make of the identified parameters at the dwells of `run`, with noise as measured, and again
/// with the parameters moved along what the campaign leaves open of them. Where there are no such motions a warning
/// says so.
void add_bias(ProcedureRun& run, const MethodsOn& methods, const Estimate& identified, unsigned threads);

}  // namespace secular::app
