#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "measure/modal/eigensystem_realization.hpp"
#include "measure/modal/modal_survey.hpp"
#include "measure/modal/pole_support.hpp"

namespace secular {

/// The diagram of these responses, by the survey's band and largest order. `rate`: samples per second.
StabilisationDiagram diagram_of(const ModalSurvey& survey, const ResponseSequence& responses, double rate,
                                bool feedthrough);

/// Each record a reference of its own.
ResponseSequence as_references(const FreeMotions& motions);

/// The strongest `count` of the modes of all diagrams stay, the rest goes to the others of each; zero: all stay.
void keep_strongest(const std::vector<StabilisationDiagram*>& diagrams, int count);

/// Takes the poles that the free motions do not support out of the diagram, with the reason to `dropped`.
void keep_supported(ModalSurvey& survey, const FreeMotions& motions);

/// Heads of records side by side, as long as the shortest; those at another rate than the first are left out.
class MotionsBeside {
 public:
  void add(const Eigen::MatrixXd& head, double rate, const std::string& group, bool grows) {
    if (!heads_.empty() && rate != motions_.sample_rate_hz) return;
    motions_.sample_rate_hz = rate;
    motions_.channels = head.cols();
    motions_.groups.push_back(group);
    heads_.push_back({&head, grows});
  }

  std::size_t count() const { return heads_.size(); }

  /// The first rows, or the last ones of motions that grow.
  FreeMotions motions(Eigen::Index most_rows = std::numeric_limits<Eigen::Index>::max()) const {
    FreeMotions result = motions_;
    Eigen::Index rows = most_rows, column = 0;
    for (const Head& head : heads_) rows = std::min(rows, head.samples->rows());
    const Eigen::Index p = result.channels;
    result.samples.resize(rows, p * static_cast<Eigen::Index>(heads_.size()));
    for (const Head& head : heads_) {
      result.samples.middleCols(column, p) =
          head.grows ? head.samples->bottomRows(rows) : head.samples->topRows(rows);
      column += p;
    }
    return result;
  }

 private:
  struct Head {
    const Eigen::MatrixXd* samples;
    bool grows;
  };
  FreeMotions motions_;
  std::vector<Head> heads_;
};

/// By what the free motions support, or where they do not by what stood in the diagram.
SurveyMode begin_mode(const StableMode& stable);

}  // namespace secular
