#include "diagnose/verdict/next_record.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

struct RecordAtLevel {
  std::size_t record = 0;
  double level = 1;
};

// Around the least, the middle and the largest record of those that are driven, and of those that are not.
std::vector<RecordAtLevel> records_around(std::vector<SegmentEvidence::RecordSize> records, double highest_level) {
  std::vector<RecordAtLevel> tests;
  std::stable_sort(records.begin(), records.end(), [](const auto& a, const auto& b) { return a.size < b.size; });
  for (const bool driven : {false, true}) {
    std::vector<SegmentEvidence::RecordSize> alike;
    for (const SegmentEvidence::RecordSize& r : records)
      if (r.driven == driven && r.size > 0) alike.push_back(r);
    if (alike.empty()) continue;
    const double least = lowest_test_level * alike.front().size;
    std::vector<std::size_t> from = {0, alike.size() / 2, alike.size() - 1};
    from.erase(std::unique(from.begin(), from.end()), from.end());
    for (const std::size_t i : from)
      for (const double level : test_levels)
        if (level <= highest_level && level * alike[i].size >= least * (1 - 1e-9))
          tests.push_back({alike[i].record, level});
  }
  return tests;
}

PossibleTest possible_record(const SegmentEvidence& measured, const RecordAtLevel& test,
                             const std::vector<Hypothesis>& hypotheses) {
  std::vector<std::vector<Segment>> records;  // under each hypothesis
  for (const Hypothesis& truth : hypotheses) {
    records.push_back(measured.predicted(test.record, truth.explanation->fit.unknowns, test.level));
    if (records.back().empty()) return {};
  }
  PossibleTest result;
  result.proposed.like = test.record;
  result.proposed.level = test.level;
  result.rows = [&measured, records = std::move(records)](std::size_t truth, const Eigen::VectorXd& /*unknowns*/,
                                                          double length) {
    std::vector<Segment> record = records[truth];
    for (Segment& segment : record) {  // errors of the mean of so many
      segment.noise_sd /= std::sqrt(length);
      segment.excitation_noise_sd /= std::sqrt(length);
    }
    Discrepancy rows;
    rows.add(std::make_unique<SegmentEvidence>(measured.of_known_noise(std::move(record))));
    return rows;
  };
  return result;
}

}  // namespace

ProposedTest next_record(const SegmentEvidence& measured, const std::vector<Hypothesis>& hypotheses,
                         const ProposalOptions& options) {
  if (hypotheses.size() < 2) return {};
  const std::vector<RecordAtLevel> tests = records_around(measured.record_sizes(), options.highest_level);
  std::vector<PossibleTest> all(tests.size());
  in_parallel(tests.size(), options.threads,
              [&](std::size_t t) { all[t] = possible_record(measured, tests[t], hypotheses); });
  return best_test(all, hypotheses, options);
}

}  // namespace secular
