#include "diagnose/prior_evidence.hpp"

namespace secular {

PriorEvidence::PriorEvidence(std::vector<Entry> entries) : entries_(std::move(entries)) {
  for (const Entry& entry : entries_) {
    RowLabel label;
    label.fold = -1;
    label.place = entry.name;
    label.harmonic = "given value";
    labels_.push_back(std::move(label));
  }
}

void PriorEvidence::evaluate(const Eigen::VectorXd& unknowns, Eigen::Ref<Eigen::VectorXd> rows) const {
  for (std::size_t i = 0; i < entries_.size(); ++i)
    rows(static_cast<Eigen::Index>(i)) =
        (unknowns(static_cast<Eigen::Index>(entries_[i].unknown)) - entries_[i].value) / entries_[i].sd;
}

}  // namespace secular
