#pragma once

#include <string>

#include "jobs/predict/prediction.hpp"

namespace secular {

/// prediction.json: every branch with its points, stability, special points and how it ends; curves, backbones and
/// simulated sweeps. Amplitudes are peak values, in the coordinates' units; frequencies in rad/s, with "hz" beside.
/// "outside_expansion" at a point: outside of ExpansionRange, the full equations need not have such a motion.
std::string prediction_json(const Prediction& prediction);

/// The same points as a table, one line each.
std::string prediction_csv(const Prediction& prediction);

/// "parameter_bound", ... of an end.
std::string name_of(TraceStatus status);
std::string name_of(CurveKind kind);
/// "saddle-nodes", ...: what a curve of that kind consists of, for people.
std::string in_words(CurveKind kind);

/// What a special point is called, for people: its kind, or "threshold" on the trivial solution.
std::string special_name(const ResponseSpecial& special);

}  // namespace secular
