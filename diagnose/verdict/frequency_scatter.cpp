#include "diagnose/verdict/frequency_scatter.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/thresholds.hpp"
#include "estimator/identification/setting_functions.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// That frequencies of one structure differ by chance.
constexpr auto& scatter_alarm = diagnose_thresholds().scatter_alarm;

/// A standard deviation of as few values as there are records is not known better.
constexpr auto& same_size = diagnose_thresholds().same_size;

// What laws may depend on, most often first, as functions of a record's labels: whether it is driven, amplitude,
// level and frequency of a dwell, time. (How large a decay is says nothing of its mean frequency: it dies out.)
// Level and frequency together make the amplitude, by way of the record's own natural frequency: functions of all
// three would follow whatever that is.
using Settings = VectorXd (*)(const RowLabel&);

VectorXd amplitude_and_level(const RowLabel& label) {
  const double level = label.level, a = level > 0 ? label.amplitude : 0;
  return VectorXd{{1, level > 0 ? 1.0 : 0.0, a * a, level * level, label.time_s, a, level}};
}

VectorXd level_and_frequency(const RowLabel& label) {
  const double level = label.level, w = label.frequency;
  return VectorXd{{1, level > 0 ? 1.0 : 0.0, level * level, label.time_s, w, level, level * w, w * w}};
}

MatrixXd functions_of(const std::vector<OwnFrequency>& own, const std::map<std::size_t, RowLabel>& labels,
                      Settings settings) {
  std::vector<VectorXd> of_records;
  for (const OwnFrequency& o : own) of_records.push_back(settings(labels.at(o.record)));
  return independent_functions(of_records);
}

}  // namespace

FrequencyScatter scatter_about(const Discrepancy& discrepancy, const VectorXd& unknowns, std::size_t modes) {
  FrequencyScatter result;
  result.sd = VectorXd::Zero(static_cast<Index>(modes));
  std::map<std::size_t, RowLabel> labels;  // of its largest row, by record
  for (const RowLabel& label : discrepancy.labels())
    if (!labels.contains(label.record) || label.amplitude > labels[label.record].amplitude)
      labels[label.record] = label;
  const std::vector<OwnFrequency> all = discrepancy.own_frequencies(unknowns);
  for (std::size_t k = 0; k < modes; ++k) {
    std::vector<OwnFrequency> own;
    for (const OwnFrequency& o : all)
      if (o.mode == k) own.push_back(o);
    if (own.size() < 2) continue;
    VectorXd offset(static_cast<Index>(own.size())), variance(offset.size());
    for (Index r = 0; r < offset.size(); ++r) {
      offset(r) = own[static_cast<std::size_t>(r)].offset;
      variance(r) = own[static_cast<std::size_t>(r)].variance;
    }
    const double total = (offset.array() - offset.mean()).square().sum() / static_cast<double>(own.size() - 1);
    Between least;
    double freedom = 0;
    bool follow = false, differ = true;
    for (const Settings settings : {amplitude_and_level, level_and_frequency}) {
      const MatrixXd functions = functions_of(own, labels, settings);
      const Between between = between_records(offset, variance, functions);
      if (least.sd == 0 || between.sd < least.sd) {
        least = between;
        freedom = static_cast<double>(own.size()) - static_cast<double>(functions.cols());
      }
      differ = differ && between.p_value < scatter_alarm;
      const VectorXd weight = (variance.array() + between.sd * between.sd).rsqrt();
      follow = follow || follows_settings(weight.cwiseProduct(offset), weight.asDiagonal() * functions) !=
                             Following::at_random;
    }
    if (!differ) continue;
    result.sd(static_cast<Index>(k)) = least.sd;
    result.freedom = std::min(result.freedom, freedom);
    result.at_random = std::max(result.at_random, least.sd * least.sd / total);
    result.follows_settings = result.follows_settings || follow;
    result.records.insert(result.records.end(), own.begin(), own.end());
  }
  return result;
}

VectorXd admitted(const FrequencyScatter& scatter) {
  return scatter.sd.cwiseMax(no_scatter);
}

bool is_as_large(const VectorXd& admitted, const VectorXd& before) {
  return ((admitted - before).array().abs() <= same_size * before.array().max(no_scatter)).all();
}

}  // namespace secular
