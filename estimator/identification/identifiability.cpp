#include "estimator/identification/identifiability.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "estimator/model/zero_frequency.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double rank_tolerance = 1e-10;

/// Below this a component of the projection on the null space is rounding.
constexpr double null_component = 1e-8;

/// Generic points at which the ratios of a null direction are compared.
constexpr int ratio_points = 3;

RowMajor lump_jacobian(const CompiledCase& resonance, const VectorXd& point) {
  RowMajor jacobian(static_cast<Index>(resonance.lumps.size()), point.size());
  if (jacobian.size() > 0) resonance.evaluate_lumps_jacobian(point.data(), jacobian.data());
  return jacobian;
}

VectorXd column_scale(const MatrixXd& jacobian) {
  VectorXd scale = jacobian.colwise().norm().transpose();
  for (Index c = 0; c < scale.size(); ++c) scale(c) = scale(c) > 0 ? 1 / scale(c) : 1;
  return scale;
}

// Orthonormal null space of the scaled columns, scaled back.
MatrixXd null_space(const MatrixXd& jacobian) {
  if (jacobian.rows() == 0) return MatrixXd::Identity(jacobian.cols(), jacobian.cols());
  const VectorXd scale = column_scale(jacobian);
  const Eigen::BDCSVD<MatrixXd> svd(jacobian * scale.asDiagonal(), Eigen::ComputeFullV);
  Index rank = 0;
  while (rank < svd.singularValues().size() &&
         svd.singularValues()(rank) > rank_tolerance * svd.singularValues()(0))
    ++rank;
  return svd.matrixV().rightCols(jacobian.cols() - rank);
}

// Columns of a null space reduced so that column d has 1 in row pivot[d] and 0 in the other pivots. `pivots` empty:
// chosen here, from the last parameter back, so that the higher-order coefficients are expressed first.
MatrixXd reduced(MatrixXd null, const VectorXd& scale, std::vector<Index>& pivots) {
  null = scale.asDiagonal() * null;
  const bool choose = pivots.empty();
  for (Index d = 0; d < null.cols(); ++d) {
    Index pivot = -1;
    if (choose) {
      const double largest = null.rightCols(null.cols() - d).cwiseAbs().maxCoeff();
      for (Index row = null.rows() - 1; row >= 0 && pivot < 0; --row)
        if (std::find(pivots.begin(), pivots.end(), row) == pivots.end() &&
            null.row(row).rightCols(null.cols() - d).cwiseAbs().maxCoeff() > 1e-6 * largest)
          pivot = row;
      if (pivot < 0) break;
      pivots.push_back(pivot);
    } else {
      pivot = pivots[static_cast<std::size_t>(d)];
    }
    Index best = d;
    null.row(pivot).rightCols(null.cols() - d).cwiseAbs().maxCoeff(&best);
    null.col(d).swap(null.col(d + best));
    null.col(d) /= null(pivot, d);
    for (Index other = 0; other < null.cols(); ++other)
      if (other != d) null.col(other) -= null(pivot, other) * null.col(d);
  }
  for (Index i = 0; i < null.size(); ++i)
    if (std::abs(null.data()[i]) < 1e-9) null.data()[i] = 0;
  return null;
}

// A ratio that is a rational number times powers of natural frequencies at every point, as text.
std::optional<std::string> monomial_text(const std::vector<double>& ratios, const std::vector<VectorXd>& points,
                                         const CompiledModel& model) {
  const auto modes = static_cast<Index>(model.modes());
  std::vector<int> exponent(model.modes(), 0), best;
  std::optional<std::pair<long, long>> best_fraction;
  const auto fraction_of = [](double value) -> std::optional<std::pair<long, long>> {
    for (long denominator = 1; denominator <= 60; ++denominator) {
      const double numerator = value * static_cast<double>(denominator);
      if (std::abs(numerator - std::round(numerator)) < 1e-7 * std::max(1.0, std::abs(numerator)) &&
          std::abs(numerator) < 1000 && std::round(numerator) != 0)
        return std::pair{std::lround(numerator), denominator};
    }
    return {};
  };
  int best_size = 100;
  const std::function<void(Index)> search = [&](Index mode) {
    if (mode < modes) {
      for (int e = -4; e <= 4; ++e) {
        exponent[static_cast<std::size_t>(mode)] = e;
        search(mode + 1);
      }
      return;
    }
    int size = 0;
    for (const int e : exponent) size += std::abs(e);
    if (size >= best_size) return;
    double first = 0;
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      double value = ratios[i];
      for (Index k = 0; k < modes; ++k) value /= std::pow(points[i](k), exponent[static_cast<std::size_t>(k)]);
      if (i == 0) first = value;
      if (std::abs(value - first) > 1e-7 * std::abs(first)) return;
    }
    if (const auto fraction = fraction_of(first)) {
      best_fraction = fraction;
      best = exponent;
      best_size = size;
    }
  };
  if (modes <= 3) search(0);
  if (!best_fraction) return {};
  const auto [numerator, denominator] = *best_fraction;
  std::string text = denominator == 1 ? fmt::format("{}", std::abs(numerator))
                                      : fmt::format("{}/{}", std::abs(numerator), denominator);
  for (std::size_t k = 0; k < best.size(); ++k)
    if (best[k] != 0)
      text += (best[k] > 0 ? "*" : "/") + std::string(model.symbols[k].name) +
              (std::abs(best[k]) > 1 ? "^" + std::to_string(std::abs(best[k])) : "");
  return (numerator < 0 ? "-" : "+") + text;
}

// Jacobian rows that a further test would bring, by name.
struct FurtherTest {
  std::string name;
  MatrixXd rows;
};

std::vector<FurtherTest> further_tests(const CampaignKnowledge& known, const VectorXd& point) {
  std::vector<FurtherTest> tests;
  const auto rows_of = [&](const RowMajor& jacobian, const std::vector<int>& lumps) {
    MatrixXd rows(static_cast<Index>(lumps.size()), point.size());
    for (std::size_t i = 0; i < lumps.size(); ++i) rows.row(static_cast<Index>(i)) = jacobian.row(lumps[i]);
    return rows;
  };
  for (const CompiledCase& resonance : known.model->cases) {
    const RowMajor jacobian = lump_jacobian(resonance, point);
    const bool used = std::any_of(known.cases.begin(), known.cases.end(),
                                  [&](const KnownLumps& c) { return c.resonance == &resonance; });
    if (!used) {
      std::vector<int> lumps;
      for (const RegressorBlock& block : resonance.blocks)
        if (block.kind == BlockKind::modulation) lumps.insert(lumps.end(), block.lumps.begin(), block.lumps.end());
      tests.push_back({fmt::format("case {}", resonance.name), rows_of(jacobian, lumps)});
    }
    for (const RegressorBlock& block : resonance.blocks)
      if (block.kind == BlockKind::harmonic && block.order <= 1)
        tests.push_back(
            {is_zero_frequency(block)
                 ? fmt::format("zero-frequency component of {} in case {} (measured as displacement)",
                               known.model->coordinates[static_cast<std::size_t>(block.mode)], resonance.name)
                 : fmt::format("{} in case {}", block.name, resonance.name),
             rows_of(jacobian, {block.lumps.begin(), block.lumps.end()})});
  }
  return tests;
}

}  // namespace

VectorXd generic_point(Index size, int which) {
  VectorXd point(size);
  for (Index p = 0; p < size; ++p)
    point(p) = 1 + std::fmod(0.6180339887498949 * static_cast<double>(p + 1) + 0.2371 * which, 1.0);
  return point;
}

MatrixXd known_jacobian(const CampaignKnowledge& known, const VectorXd& point) {
  std::vector<Eigen::RowVectorXd> rows;
  for (const KnownLumps& part : known.cases) {
    const RowMajor jacobian = lump_jacobian(*part.resonance, point);
    for (std::size_t l = 0; l < part.lumps.size(); ++l)
      if (part.lumps[l]) rows.emplace_back(jacobian.row(static_cast<Index>(l)));
  }
  for (std::size_t p = 0; p < known.parameters.size(); ++p)
    if (known.parameters[p]) {
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(point.size());
      row(static_cast<Index>(p)) = 1;
      rows.push_back(row);
    }
  MatrixXd all(static_cast<Index>(rows.size()), point.size());
  for (std::size_t r = 0; r < rows.size(); ++r) all.row(static_cast<Index>(r)) = rows[r];
  return all;
}

Index scaled_rank(const MatrixXd& jacobian) {
  return jacobian.cols() - null_space(jacobian).cols();
}

Identifiability identifiability(const CampaignKnowledge& known) {
  const auto count = static_cast<Index>(known.model->symbols.size());
  const MatrixXd null = null_space(known_jacobian(known, generic_point(count)));
  const MatrixXd projection = null * null.transpose();
  Identifiability result;
  result.entangled_with.resize(static_cast<std::size_t>(count));
  for (Index p = 0; p < count; ++p) {
    result.determined.push_back(projection(p, p) < 1e-10);
    for (Index q = 0; q < count; ++q)
      if (q != p && !result.determined.back() && std::abs(projection(p, q)) > null_component)
        result.entangled_with[static_cast<std::size_t>(p)].push_back(static_cast<int>(q));
  }
  return result;
}

std::vector<NullDirection> null_directions(const CampaignKnowledge& known) {
  const CompiledModel& model = *known.model;
  const auto count = static_cast<Index>(model.symbols.size());
  std::vector<VectorXd> points;
  std::vector<MatrixXd> nulls;
  std::vector<Index> pivots;
  for (int i = 0; i < ratio_points; ++i) {
    points.push_back(generic_point(count, i));
    const MatrixXd jacobian = known_jacobian(known, points.back());
    const MatrixXd null = null_space(jacobian);
    if (null.cols() == 0) return {};
    nulls.push_back(reduced(null, jacobian.rows() > 0 ? column_scale(jacobian) : VectorXd::Ones(count), pivots));
  }
  const MatrixXd base = known_jacobian(known, points.front());
  const std::vector<FurtherTest> tests = further_tests(known, points.front());
  std::vector<NullDirection> result;
  for (Index d = 0; d < nulls.front().cols(); ++d) {
    NullDirection direction;
    const VectorXd vector = nulls.front().col(d);
    std::string changes;
    for (Index p = 0; p < count; ++p) {
      if (vector(p) == 0) continue;
      const std::string name(model.symbols[static_cast<std::size_t>(p)].name);
      direction.parameters.push_back(name);
      if (p == pivots[static_cast<std::size_t>(d)]) continue;
      std::vector<double> ratios;
      for (const MatrixXd& null : nulls) ratios.push_back(null(p, d));
      const auto exact = monomial_text(ratios, points, model);
      changes += (changes.empty() ? "" : ", ") +
                 (exact ? fmt::format("{} by {}", name, *exact) : fmt::format("{} in proportion", name));
    }
    const std::string pivot(model.symbols[static_cast<std::size_t>(pivots[static_cast<std::size_t>(d)])].name);
    direction.text =
        changes.empty()
            ? fmt::format("{} is not seen at all", pivot)
            : fmt::format("nothing is seen where {} changes by 1 and {} (each times the same small number)", pivot,
                          changes);
    for (const FurtherTest& test : tests) {
      MatrixXd product = test.rows * vector;
      const double size = (test.rows.cwiseAbs() * vector.cwiseAbs()).cwiseMax(1e-300).maxCoeff();
      if (test.rows.rows() == 0 || product.cwiseAbs().maxCoeff() < 1e-8 * size) continue;
      // Notices it, and not merely together with unknowns of its own.
      MatrixXd both(base.rows() + test.rows.rows(), count);
      both << base, test.rows;
      if (scaled_rank(both) <= scaled_rank(base)) continue;
      direction.parted_by.push_back(test.name);
    }
    result.push_back(std::move(direction));
  }
  return result;
}

}  // namespace secular
