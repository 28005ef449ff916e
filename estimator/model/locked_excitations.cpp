#include "estimator/model/locked_excitations.hpp"

#include <algorithm>
#include <boost/rational.hpp>

namespace secular {
namespace {

using Fraction = boost::rational<long long>;

// Gauss-Jordan from the last column on: every row is solved for the last frequency in it, whose column is returned.
std::vector<std::size_t> solve_for_last(std::vector<std::vector<Fraction>>& rows) {
  std::vector<std::size_t> solved(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto last = std::find_if(rows[r].rbegin(), rows[r].rend(), [](const Fraction& x) { return x.numerator() != 0; });
    const auto column = static_cast<std::size_t>(rows[r].rend() - last) - 1;
    const Fraction pivot = rows[r][column];
    for (Fraction& x : rows[r]) x /= pivot;
    for (std::size_t other = 0; other < rows.size(); ++other) {
      const Fraction factor = other == r ? Fraction(0) : rows[other][column];
      for (std::size_t c = 0; c < rows[r].size(); ++c) rows[other][c] -= factor * rows[r][c];
    }
    solved[r] = column;
  }
  return solved;
}

double value_of(Ratio share) {
  return static_cast<double>(share.numerator) / share.denominator;
}

}  // namespace

LockedExcitations::LockedExcitations(const CompiledModel& model, const CompiledCase& resonance) {
  const std::size_t modes = model.modes(), excitations = model.excitations.size(), columns = modes + excitations;
  names_.assign(model.excitation_frequencies.begin(), model.excitation_frequencies.end());
  std::vector<std::vector<Fraction>> rows;
  for (std::size_t r = 0; excitations > 1 && r + columns <= resonance.relations.size(); r += columns) {
    const auto row = resonance.relations.subspan(r, columns);
    if (std::all_of(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(modes), [](int m) { return m == 0; }))
      rows.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(modes), row.end());
  }
  const std::vector<std::size_t> solved = solve_for_last(rows);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    Follower follower{solved[r], std::vector<Ratio>(excitations)};
    for (std::size_t j = 0; j < excitations; ++j)
      if (j != solved[r])
        follower.shares[j] = {static_cast<int>(-rows[r][j].numerator()),
                              static_cast<int>(rows[r][j].denominator())};
    followers_.push_back(std::move(follower));
  }
}

const LockedExcitations::Follower* LockedExcitations::follower(std::size_t excitation) const {
  const auto found = std::find_if(followers_.begin(), followers_.end(),
                                  [&](const Follower& f) { return f.excitation == excitation; });
  return found == followers_.end() ? nullptr : &*found;
}

bool LockedExcitations::follows(std::size_t excitation) const {
  return follower(excitation) != nullptr;
}

Ratio LockedExcitations::share(std::size_t excitation, std::size_t leader) const {
  const Follower* const own = follower(excitation);
  return own ? own->shares[leader] : Ratio{excitation == leader ? 1 : 0, 1};
}

std::string LockedExcitations::text(std::size_t excitation) const {
  std::string sum;
  for (std::size_t j = 0; j < names_.size(); ++j) {
    const Ratio weight = share(excitation, j);
    if (weight.numerator == 0) continue;
    sum += sum.empty() ? "" : " + ";
    if (weight.denominator != 1)
      sum += std::to_string(weight.numerator) + "/" + std::to_string(weight.denominator) + "*";
    else if (weight.numerator != 1)
      sum += std::to_string(weight.numerator) + "*";
    sum += names_[j];
  }
  return names_[excitation] + " = " + sum;
}

void LockedExcitations::follow(double* frequency) const {
  for (const Follower& f : followers_) {
    double sum = 0;
    for (std::size_t j = 0; j < f.shares.size(); ++j)
      if (f.shares[j].numerator != 0) sum += value_of(f.shares[j]) * frequency[j];
    frequency[f.excitation] = sum;
  }
}

}  // namespace secular
