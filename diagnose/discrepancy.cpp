#include "diagnose/discrepancy.hpp"

namespace secular {

using Eigen::Index;

std::string to_string(GapComponent component) {
  switch (component) {
    case GapComponent::conservative:
      return "conservative";
    case GapComponent::dissipative:
      return "dissipative";
    case GapComponent::direct_excitation:
      return "direct_excitation";
    case GapComponent::parametric_excitation:
      return "parametric_excitation";
    case GapComponent::coupling:
      return "coupling";
    case GapComponent::measurement:
      break;
  }
  return "measurement";
}

void Discrepancy::add(std::unique_ptr<Evidence> evidence) {
  parts_.push_back(std::move(evidence));
}

Index Discrepancy::size() const {
  Index sum = 0;
  for (const auto& part : parts_) sum += part->size();
  return sum;
}

Index Discrepancy::freedom() const {
  Index sum = 0;
  for (const auto& part : parts_) sum += part->freedom();
  return sum;
}

std::vector<RowLabel> Discrepancy::labels() const {
  std::vector<RowLabel> all;
  for (const auto& part : parts_) all.insert(all.end(), part->labels().begin(), part->labels().end());
  return all;
}

void Discrepancy::freeze(const Eigen::VectorXd& unknowns, double coarse) {
  for (const auto& part : parts_) part->freeze(unknowns, coarse);
}

Eigen::VectorXd Discrepancy::operator()(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd rows(size());
  Index first = 0;
  for (const auto& part : parts_) {
    part->evaluate(unknowns, rows.segment(first, part->size()));
    first += part->size();
  }
  return rows;
}

Eigen::VectorXd Discrepancy::unmixed(const Eigen::VectorXd& rows) const {
  Eigen::VectorXd all(rows.size());
  Index first = 0;
  for (const auto& part : parts_) {
    all.segment(first, part->size()) = part->unmixed(rows.segment(first, part->size()));
    first += part->size();
  }
  return all;
}

}  // namespace secular
