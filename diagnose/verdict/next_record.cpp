#include "diagnose/verdict/next_record.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
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

// A test's record under each hypothesis; empty where a motion runs away under one of them.
using Predicted = std::vector<std::vector<Segment>>;

Predicted predicted_record(const SegmentEvidence& measured, const RecordAtLevel& test,
                           const std::vector<Hypothesis>& hypotheses) {
  Predicted records;
  for (const Hypothesis& truth : hypotheses) {
    records.push_back(measured.predicted(test.record, truth.explanation->fit.unknowns, test.level));
    if (records.back().empty()) return {};
  }
  return records;
}

// So many such records: errors of their mean.
std::optional<TestOutcome> record_outcome(const SegmentEvidence& measured, Predicted records,
                                          const std::vector<Hypothesis>& hypotheses, double length,
                                          double dispersion) {
  if (records.empty()) return std::nullopt;
  for (std::vector<Segment>& record : records)
    for (Segment& segment : record) {
      segment.noise_sd /= std::sqrt(length);
      segment.excitation_noise_sd /= std::sqrt(length);
    }
  return expected_outcome(hypotheses, [&](std::size_t truth, const Refit& judge) {
    Discrepancy discrepancy;
    discrepancy.add(std::make_unique<SegmentEvidence>(measured.of_known_noise(records[truth])));
    return judged(discrepancy, judge, dispersion);
  });
}

}  // namespace

ProposedTest next_record(const SegmentEvidence& measured, const std::vector<Hypothesis>& hypotheses,
                         const ProposalOptions& options) {
  if (hypotheses.size() < 2) return {};
  const std::vector<RecordAtLevel> tests = records_around(measured.record_sizes(), options.highest_level);
  std::vector<Predicted> records(tests.size());
  in_parallel(tests.size(), options.threads,
              [&](std::size_t t) { records[t] = predicted_record(measured, tests[t], hypotheses); });
  return as_long_as_it_takes(hypotheses, [&](double length) {
    std::vector<std::optional<TestOutcome>> outcomes(tests.size());
    in_parallel(tests.size(), options.threads, [&](std::size_t t) {
      outcomes[t] = record_outcome(measured, records[t], hypotheses, length, options.dispersion);
    });
    const std::optional<std::size_t> chosen = safest(outcomes);
    if (!chosen) return ProposedTest{};
    ProposedTest test;
    test.like = tests[*chosen].record;
    test.level = tests[*chosen].level;
    return with_outcome(std::move(test), outcomes, *chosen, length);
  });
}

}  // namespace secular
