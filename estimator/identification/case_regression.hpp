#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "estimator/identification/lump_key.hpp"
#include "estimator/identification/scatter_between_records.hpp"
#include "estimator/regression/linear_fit.hpp"
#include "measure/observe/mode_frequencies.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// An unknown of one case's regression.
struct CaseColumn {
  enum class Kind {
    lump,               ///< index into CompiledCase::lumps
    natural_frequency,  ///< of mode `index`
    sensor_offset,      ///< of mode `index`: what the sensors add to its zero-frequency component
  };
  Kind kind = Kind::lump;
  std::size_t index = 0;
};

/// Of a complex equation in the frame of the motion (motion_frame). Of a modulation equation: the balance of
/// energy, and that of frequency.
enum class EquationPart { in_phase, in_quadrature };

inline double part_of(std::complex<double> equation, EquationPart part) {
  return part == EquationPart::in_phase ? equation.real() : equation.imag();
}

/// Whitened rows of one case: every observation's equations, real and imaginary parts, decorrelated by the joint
/// covariance of everything measured in them.
struct WhitenedSystem {
  Eigen::MatrixXd design;
  Eigen::VectorXd response;
  std::vector<int> condition;            ///< by row
  std::vector<std::size_t> observation;  ///< by row
  std::vector<std::size_t> block;        ///< by row: index into CompiledCase::blocks
  std::vector<EquationPart> part;        ///< by row
  std::vector<double> noise_sd;          ///< by row: of the equation, as the noise of what was measured makes it
  /// By observation with rows, in their order, lower triangular: whitened rows back to equations in units of their
  /// own noise.
  std::vector<Eigen::MatrixXd> colouring;
  /// By observation with rows, where the excitations' phase is unknown (else empty): the direction of whitened rows
  /// along which it moves them, of length 1. Rows and columns have no part along it (docs/inference.md (16)).
  std::vector<Eigen::VectorXd> by_phase;
  ColumnErrors errors;  ///< of whitened columns
};

/// Coefficients of a case's equations, by lump and by mode.
struct EquationPoint {
  std::vector<double> lump, natural_frequency;
};

/// Where a regression of the same equations at the same observations may start: what another one ended with.
struct RegressionState {
  EquationPoint at;
  std::vector<double> offset;                 ///< by mode
  std::map<std::size_t, double> block_scale;  ///< by block: residual over noise that it counts with
  std::vector<double> weight, distance;       ///< by observation
  std::optional<Eigen::Index> noisy;          ///< LinearFit::noisy
};

/// What a regression's rows say, beside its coefficients, of how far parameters are along the directions of
/// ObservationSet::truncation_change from where the truncation was taken out: what such a change does to the rows
/// and no coefficient can do. design*null_coordinate = target but for errors of unit variance, as independent of
/// the coefficients' as residuals are.
struct ResidualInformation {
  Eigen::MatrixXd design;  ///< rows x directions; no rows: nothing
  Eigen::VectorXd target;
};

/// Windows of a decay share noise where they overlap: docs/inference.md (44), (45). With the correlations Omega
/// that this leaves between whitened rows and Q, which takes the mean of each equation out of each condition:
struct WindowOverlap {
  Eigen::MatrixXd gram;                     ///< U' Omega U, of LinearFit::orthonormal; empty: no windows
  double repeats = 0, repeats_squared = 0;  ///< trace of Q Omega, and of its square
  double left = 0, left_squared = 0;        ///< the same with I - UU' in place of Q
};

/// Linear regression of one case's equations on its lumps and natural frequencies.
struct CaseFit {
  const ObservationSet* set = nullptr;
  std::vector<std::size_t> blocks;  ///< regressed
  std::vector<CaseColumn> columns;
  WhitenedSystem system;      ///< of the last pass, robust weights applied
  Eigen::VectorXd reference;  ///< by column: what the system's unknown is counted from (natural frequencies)
  LinearFit fit;              ///< coefficients include `reference`
  Eigen::VectorXd residual;   ///< by row: of each equation alone over its own noise, as measured noise explains it
  /// Columns x directions: how coefficients change with ObservationSet::truncation_change.
  Eigen::MatrixXd truncation_effect, moves_effect;  ///< the second with ObservationSet::truncation_of_moves
  ResidualInformation residual_information;
  WindowOverlap overlap;                              ///< of a decay's windows
  std::vector<ScatterBetweenRecords> record_scatter;  ///< of natural frequencies that several records tell
  Eigen::MatrixXd record_moves;                       ///< RecordScatter::moves; part of the fit's covariance
  double record_freedom = INFINITY;                   ///< of that part
  /// docs/inference.md (55): instrument_relevance() of dwells whose columns have instruments; else infinite.
  double instrument_relevance = INFINITY;
  std::map<std::size_t, double> block_residual;  ///< by block: residual over what noise explains, unscaled
  std::vector<double> weight;                    ///< by observation: 1, less where it is an outlier
  std::vector<double> distance;  ///< by observation: deviation from its condition over what is usual; 0 if unknown
  RegressionState state;
};

/// What a case's regression takes as given.
struct CaseKnowledge {
  std::vector<double> natural_frequency;  ///< by mode: start, and value where the case does not estimate it
  std::set<std::size_t> fixed_frequency;  ///< modes whose natural frequency is given
  LumpValues fixed;                       ///< lumps that are given
  /// Maximum likelihood with errors in everything measured: amplitudes, phases, forces and frequencies are adjusted
  /// to the equations (Gauss-Helmert), which takes out the bias that noise in the regression's columns makes.
  bool errors_in_variables = false;
};

/// How weights are found.
struct Reweighting {
  const RegressionState* start = nullptr;  ///< null: from equal weights
  /// With a start: weights are those that its coefficients make, in one linear regression. Right where only what is
  /// subtracted for the truncation has changed a little.
  bool keep = false;
  /// For a regression that another one goes on from: until no coefficient moves by more than its standard
  /// deviation, all ensembles with equal weight, nothing adjusted.
  bool rough = false;
  unsigned threads = 1;  ///< the result does not depend on it
};

/// Regression of `blocks` together (docs/inference.md (3) to (6)): iteratively reweighted, every equation by the
/// joint noise of amplitudes, forces, frequencies, rates and harmonics; an equation that fits worse than its noise
/// explains counts accordingly less against the others; ensembles of a dwell that stand out from the others of
/// their condition are down-weighted (weight (c/d)^2 beyond a distance c that one clean campaign in a hundred
/// reaches).
CaseFit fit_case(const ObservationSet& set, const std::vector<std::size_t>& blocks, const CaseKnowledge& known,
                 const Reweighting& reweighting = {});

}  // namespace secular
