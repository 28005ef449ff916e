#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "app/diagnose/diagnosis_run.hpp"

namespace secular::app {

/// Dwells whose responses are out of step with their excitation.
struct Lateness {
  std::map<std::size_t, double> late_s;    ///< by record; empty: none is
  std::map<std::size_t, double> period_s;  ///< of its excitation
  std::set<std::size_t> sign_open;         ///< records of half a period more if the force has the other sign
  bool holds = false;                      ///< the model's equations hold when each record has a phase of its own
  /// By mode, relative: by how much decays say that natural frequencies differ from record to record (standard
  /// deviation); 0: they do not, empty: they say nothing.
  Eigen::VectorXd frequency_sd;
  std::string warning;  ///< where it could not be looked for
};

/// Whether a campaign and a model are such that records could be found late: dwells with one excitation.
bool can_be_late(const Campaign& campaign, const CompiledModel& model);

/// As `identify` finds them with the model as it is (docs/inference.md (16) to (22)). Nothing where it has no
/// answer, where phases of a case follow the amplitude, as a law that the model lacks makes them, or where lateness
/// follows level, frequency and order of the records and the equations do not hold well.
Lateness find_lateness(const DiagnosisRequest& request);

}  // namespace secular::app
