#include "estimator/model/locked_excitations.hpp"

#include <algorithm>
#include <boost/rational.hpp>
#include <utility>

#include "numerics/row_reduction.hpp"

namespace secular {
namespace {

using Fraction = boost::rational<long long>;

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
      rows.emplace_back(row.rbegin(), row.rend() - static_cast<std::ptrdiff_t>(modes));
  }
  // Columns run backwards: a row is solved for the last frequency in it.
  for (const Pivot& pivot : reduce_rows(rows, 0, excitations)) {
    Follower follower{excitations - 1 - pivot.column, std::vector<Ratio>(excitations)};
    for (std::size_t j = 0; j < excitations; ++j) {
      const Fraction share = j == follower.excitation ? Fraction(0) : -rows[pivot.row][excitations - 1 - j];
      follower.shares[j] = {static_cast<int>(share.numerator()), static_cast<int>(share.denominator())};
    }
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
