#pragma once

#include <complex>
#include <vector>

#include "estimator/model/compiled_model.hpp"

/// Residuals of a case at measured amplitudes and derivatives by physical parameters. They follow from the tables
/// of a CompiledModel alone: rows are linear in lumps,
///   residual = observed - columns * lumps(parameters)             harmonic
///   residual = observed - i*omega_k*B_k - columns * lumps          modulation of mode k, observed = rate * B_k
/// with columns that depend on the natural frequencies, so that
///   d residual/d lump_j      = -column_j,
///   d residual/d parameter_p = -columns * d lumps/d p  - [p is omega_m] d columns/d omega_m * lumps
///                              - [modulation and p is omega_k] i*B_k.
/// They are therefore written once, here, and not emitted for every case: one function for compiled and interpreted
/// models. Observations are handled in blocks that stay in the cache. The functions take plain arrays one by one,
/// as those of CompiledCase do, which is why they have up to seven parameters.
namespace secular {

/// residual[observation] of one block; `parameters` in the order of CompiledModel::symbols (their first modes()
/// entries are the natural frequencies; data.natural_frequency is not read), observed[observation].
void block_residual(const CompiledModel& model, const CompiledCase& resonance, const RegressorBlock& block,
                    const double* parameters, const ObservationBatch& data, const std::complex<double>* observed,
                    std::complex<double>* residual);

/// jacobian[symbol][observation] = d residual/d parameter, symbol by symbol, contiguous.
void block_residual_by_parameters(const CompiledModel& model, const CompiledCase& resonance,
                                  const RegressorBlock& block, const double* parameters,
                                  const ObservationBatch& data, std::complex<double>* jacobian);

/// Derivative of CompiledCase::modulation by the parameters at one point: with z = (Re B_0, Im B_0, ...),
/// dz/dt = f(z, parameters), jacobian[i * symbols + p] = d f_i/d parameter_p; 2*modes rows.
void modulation_by_parameters(const CompiledModel& model, const CompiledCase& resonance, const double* parameters,
                              const double* excitation_frequency, const std::complex<double>* amplitude,
                              const std::complex<double>* forcing, double* jacobian);

}  // namespace secular
