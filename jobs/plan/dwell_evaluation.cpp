#include "jobs/plan/dwell_evaluation.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

}  // namespace

DwellEvaluation::DwellEvaluation(const PlanRequest& request, const PlanResult& plan)
    : request_(request), plan_(plan), field_(*plan.model, *plan.resonance) {}

CandidateRequest DwellEvaluation::grid() const {
  CandidateRequest request;
  request.parameters.resize(plan_.parameters.size() + 2);
  request.parameters << plan_.parameters, 0, 0;
  // Values that a file shows in full: 0.1 mHz and four digits.
  for (int i = 0; i < request_.frequencies; ++i) {
    const double hz =
        request_.lowest_hz + (request_.highest_hz - request_.lowest_hz) * i / std::max(1, request_.frequencies - 1);
    request.frequencies.push_back(std::round(hz * 1e4) / 1e4 / to_hz);
  }
  const double digit = std::pow(10.0, std::floor(std::log10(request_.highest_amplitude)) - 3);
  for (int l = 0; l < request_.levels; ++l) {
    const double level = request_.lowest_amplitude + (request_.highest_amplitude - request_.lowest_amplitude) * l /
                                                         std::max(1, request_.levels - 1);
    request.forcings.push_back(std::round(level / digit) * digit);
  }
  request.settled = request_.settled;
  request.settle_limit = request_.settle_limit_s;
  return request;
}

// Symmetry directions over all modes.
MatrixXd DwellEvaluation::symmetry() const {
  const MatrixXd& rows = field_.symmetries();
  MatrixXd all = MatrixXd::Zero(rows.rows(), static_cast<Index>(plan_.model->modes()));
  for (Index r = 0; r < rows.rows(); ++r)
    for (Index k = 0; k < rows.cols(); ++k)
      all(r, static_cast<Index>(field_.active()[static_cast<std::size_t>(k)])) = rows(r, k);
  return all;
}

MatrixXd DwellEvaluation::information(const DwellState& state, int ensembles) const {
  return dwell_information({*plan_.model, *plan_.resonance, plan_.parameters, plan_.unknowns, plan_.noise}, state,
                           symmetry(), ensembles);
}

void DwellEvaluation::finish(Programme& programme) const {
  MatrixXd sum = MatrixXd::Zero(plan_.unknowns.values.size(), plan_.unknowns.values.size());
  for (const PlannedDwell& dwell : programme.dwells) {
    const double recorded = dwell.ensembles * plan_.noise.ensemble_s;
    programme.time_s += dwell.settle_s + recorded;
    programme.settled_time_s += (dwell.responds ? dwell.needed_s : dwell.settle_s) + recorded;
    if (dwell.responds) sum += information(dwell.candidate.state, dwell.ensembles);
  }
  programme.sd = standard_deviations(sum);
}

}  // namespace secular
