#include "estimator/identification/phase_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "estimator/identification/equation_data.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Phases of the grid over a period: the force enters as exp(i*psi), its square under hard excitation.
constexpr std::size_t grid = 48;

/// Starts of the search with phases at random, beside the common ones of the grid.
constexpr int random_starts = 48;

/// Each lowers the sum of squares on a finite set: a limit that is hardly ever reached.
constexpr int most_alternations = 100;

/// Minima of the grid that are followed, the lowest: which of them are minima is decided at the noise
/// (phase_fit.cpp).
constexpr std::size_t most_minima = 8;

/// Phases of all records nearer than this (radians) belong to one minimum: searches from either side of it end no
/// farther from it than a step of the grid, two from each other, and half a one for rounding.
constexpr double same_on_grid = 2.5 * 2 * std::numbers::pi / static_cast<double>(grid);

/// Mean equations of each record at each phase of the grid, over the size of the motion: nothing of the
/// coefficients is needed to weigh them.
class PhaseGrid {
 public:
  PhaseGrid(const PhaseProblem& problem, const CaseFit& together) : rows_(problem.records.size()) {
    for (std::size_t k = 0; k < grid; ++k) {
      const ObservationSet set = turned(problem, std::vector<double>(rows_.size(), angle(k)));
      EquationData data(set, problem.blocks, EquationData::Errors::none);
      data.evaluate(problem.known.natural_frequency);
      for (std::size_t r = 0; r < rows_.size(); ++r)
        rows_[r].push_back(mean_equations(data, problem, problem.records[r], together));
    }
  }

  static double angle(std::size_t k) { return 2 * std::numbers::pi * static_cast<double>(k) / grid; }
  static std::vector<double> angles(const std::vector<std::size_t>& phase) {
    std::vector<double> result;
    for (const std::size_t k : phase) result.push_back(angle(k));
    return result;
  }

  struct Minimum {
    std::vector<std::size_t> phase;  // by record
    Solution solution;
  };

  // Coefficients by phases and phases by coefficients, in turn.
  Minimum from(std::vector<std::size_t> phase) const {
    Minimum result{std::move(phase), {}};
    for (int round = 0; round < most_alternations; ++round) {
      result.solution = at(result.phase);
      std::vector<std::size_t> next;
      for (const std::vector<Equations>& record : rows_) next.push_back(nearest(record, result.solution.values));
      if (next == result.phase) break;
      result.phase = std::move(next);
    }
    return result;
  }

  Solution at(const std::vector<std::size_t>& phase) const {
    std::vector<const Equations*> parts;
    for (std::size_t r = 0; r < rows_.size(); ++r) parts.push_back(&rows_[r][phase[r]]);
    return least_squares(stacked(parts));
  }

  // The lowest minima first.
  GridMinima minima() const {
    std::map<std::vector<std::size_t>, Solution> found;
    const auto consider = [&](std::vector<std::size_t> start) {
      Minimum minimum = from(std::move(start));
      found.emplace(std::move(minimum.phase), std::move(minimum.solution));
    };
    for (std::size_t k = 0; k < grid; ++k) consider(std::vector<std::size_t>(rows_.size(), k));
    std::mt19937_64 random(1);
    for (int s = 0; s < random_starts; ++s) {
      std::vector<std::size_t> start;
      for (std::size_t r = 0; r < rows_.size(); ++r) start.push_back(random() % grid);
      consider(std::move(start));
    }
    std::vector<Minimum> all;
    std::vector<std::vector<double>> low;
    for (auto& [phase, solution] : found) all.push_back({phase, std::move(solution)});
    std::stable_sort(all.begin(), all.end(), [](const Minimum& a, const Minimum& b) {
      return a.solution.sum_of_squares < b.solution.sum_of_squares;
    });
    for (const Minimum& minimum : all) {
      if (low.size() == most_minima) break;
      const bool known = std::any_of(low.begin(), low.end(), [&](const std::vector<double>& other) {
        return agree(other, angles(minimum.phase), same_on_grid);
      });
      if (!known) low.push_back(angles(minimum.phase));
    }
    return {std::move(low), p_value(all.front())};
  }

 private:
  // What the grid adds makes it larger than it is.
  double p_value(const Minimum& lowest) const {
    const Solution measured = at(std::vector<std::size_t>(rows_.size(), 0));
    double rows = 0;
    for (const std::vector<Equations>& record : rows_) rows += static_cast<double>(record.front().response.size());
    const auto phases = static_cast<double>(rows_.size());
    const double left = rows - phases - static_cast<double>(lowest.solution.rank);
    if (left < 1 || !(lowest.solution.sum_of_squares > 0)) return 1;
    const double f = (measured.sum_of_squares - lowest.solution.sum_of_squares) / phases /
                     (lowest.solution.sum_of_squares / left);
    return f_upper_tail(std::max(0.0, f), phases, left);
  }

  static Equations mean_equations(const EquationData& data, const PhaseProblem& problem,
                                  const RecordMembers& record, const CaseFit& together) {
    Equations mean;
    for (const std::size_t i : record.observations) {
      const EquationData::Rows rows =
          data.rows(i, together.columns, together.state.at, problem.known.natural_frequency);
      VectorXd weight(rows.response.size());
      for (Index r = 0; r < weight.size(); ++r)
        weight(r) = 1 / data.first_scale(i, rows.block[static_cast<std::size_t>(r)]);
      add_to(mean, 1 / std::sqrt(static_cast<double>(record.observations.size())),
             {weight.asDiagonal() * rows.design, weight.cwiseProduct(rows.response)});
    }
    return mean;
  }

  static std::size_t nearest(const std::vector<Equations>& record, const VectorXd& values) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < record.size(); ++k) {
      const double squares = (record[k].response - record[k].design * values).squaredNorm();
      if (squares >= least) continue;
      least = squares;
      best = k;
    }
    return best;
  }

  std::vector<std::vector<Equations>> rows_;  // [record][phase]
};

}  // namespace

GridMinima minima_on_grid(const PhaseProblem& problem, const CaseFit& together) {
  return PhaseGrid(problem, together).minima();
}

}  // namespace secular
