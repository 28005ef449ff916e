#include "measure/signal/pole_equations.hpp"

#include <limits>
#include <utility>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Gram::Gram(const MatrixXd& gram) {
  scale = gram.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
  factor.compute(MatrixXd(scale.asDiagonal() * gram * scale.asDiagonal()));
  rcond = factor.info() == Eigen::Success ? factor.rcond() : 0;
}

MatrixXd Gram::solve(const MatrixXd& right) const {
  MatrixXd solution = scale.asDiagonal() * right;
  factor.solveInPlace(solution);
  return scale.asDiagonal() * solution;
}

PoleMoments::PoleMoments(Gram factored, const TimedMoments& moments) : gram(std::move(factored)) {
  if (!(gram.rcond > 1e-15)) return;
  drag = gram.solve(moments.first);
  free = moments.second;
  if (free.size() > 0) free.noalias() -= moments.first.transpose() * drag;
  usable = true;
}

PoleTurns::PoleTurns(std::span<const Pole> poles, const MatrixXd& of) : functions_(of.rows()) {
  Index rows = 0;
  for (const Pole& pole : poles) rows += parameter_count(pole) * function_count(pole);
  amplitudes.resize(rows, of.cols());
  Index row = 0, first = 0;
  for (const Pole& pole : poles) {
    const Index size = function_count(pole);
    for (Index i = 0; i < parameter_count(pole); ++i, ++unknowns_) {
      const PoleMatrix turn = generator(pole, i);
      for (Index c = 0; c < of.cols(); ++c)
        for (Index k = 0; k < size; ++k) {
          double sum = 0;
          for (Index l = 0; l < size; ++l) sum += turn(k, l) * of(first + l, c);
          amplitudes(row + k, c) = sum;
        }
      for (Index k = 0; k < size; ++k) {
        unknown.push_back(unknowns_);
        function.push_back(first + k);
      }
      row += size;
    }
    first += size;
  }
}

MatrixXd PoleTurns::hessian(const PoleMoments& m, const VectorXd& weight) const {
  MatrixXd result = MatrixXd::Zero(unknowns_, unknowns_);
  const auto rows = static_cast<std::size_t>(amplitudes.rows());
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < rows; ++i) {
      double together = 0;
      for (Index c = 0; c < amplitudes.cols(); ++c)
        together += weight(c) * amplitudes(static_cast<Index>(i), c) * amplitudes(static_cast<Index>(j), c);
      result(unknown[i], unknown[j]) += together * m.free(function[i], function[j]);
    }
  return result;
}

VectorXd PoleTurns::slope(const MatrixXd& timed, const VectorXd& weight) const {
  VectorXd result = VectorXd::Zero(unknowns_);
  for (Index c = 0; c < amplitudes.cols(); ++c)
    for (std::size_t i = 0; i < unknown.size(); ++i)
      result(unknown[i]) -= weight(c) * amplitudes(static_cast<Index>(i), c) * timed(function[i], c);
  return result;
}

MatrixXd PoleTurns::dragged(const PoleMoments& m, const VectorXd& step) const {
  MatrixXd turned = MatrixXd::Zero(functions_, amplitudes.cols());
  for (Index c = 0; c < amplitudes.cols(); ++c)
    for (std::size_t i = 0; i < unknown.size(); ++i)
      turned(function[i], c) += amplitudes(static_cast<Index>(i), c) * step(unknown[i]);
  return -m.drag * turned;
}

MatrixXd PoleTurns::drag(const PoleMoments& m, Index channel) const {
  MatrixXd result = MatrixXd::Zero(functions_, unknowns_);
  for (std::size_t i = 0; i < unknown.size(); ++i)
    result.col(unknown[i]) += amplitudes(static_cast<Index>(i), channel) * m.drag.col(function[i]);
  return result;
}

std::vector<Pole> moved(std::vector<Pole> poles, const VectorXd& step, double half) {
  Index i = 0;
  for (Pole& pole : poles) {
    if (parameter_count(pole) == 0) continue;
    if (pole.family == PoleFamily::circular || pole.family == PoleFamily::product)
      pole.frequency += step(i++) / half;
    if (pole.family != PoleFamily::circular) pole.rate += step(i++) / half;
  }
  return poles;
}

}  // namespace secular
