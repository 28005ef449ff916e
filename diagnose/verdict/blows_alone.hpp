#pragma once

#include <cstddef>
#include <vector>

#include "diagnose/inference/refit.hpp"
#include "diagnose/verdict/campaign_and_model.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "diagnose/verdict/gap_detection.hpp"

namespace secular {

/// What one impact says of a symbol that what follows blows does not tell, in the symbol's unit.
struct BlowStrength {
  std::size_t record = 0;
  double value = 0, variance = 0;
};

/// A symbol by which excitations act, told by every impact for itself.
struct BlowStrengths {
  std::size_t symbol = 0;
  std::vector<BlowStrength> records;  ///< two at least
  double mean = 0, sd = 0;            ///< over records, and between them beyond what each leaves open
  double p_value = 1;                 ///< that one value is that of all
  const BlowStrength* of(std::size_t record) const;
};

/// Impacts, each fitted with strengths of its own to a structure that is known (docs/inference.md (41)).
struct BlowsAlone {
  std::vector<std::size_t> records;
  std::vector<BlowStrengths> strengths;
  RowsLeft left;  ///< by all of them
  /// What is between their samples: its standard deviation next to what blows do, and the squares that it makes of
  /// the rows (42).
  double between_samples = 0, squares_between_samples = 0;
  /// Strengths differ beyond chance, or more than noise is left at whatever strength, or what is between the
  /// samples would make more than noise: blows do not do what their excitation says.
  bool do_not_fit() const;
  /// By the symbol whose strengths differ most beyond chance; null: there is none.
  const BlowStrengths* most_different() const;
};

/// By record: impacts that the window takes.
std::vector<bool> chosen_impacts(const Campaign& campaign, const Window& window);

/// A structure that is known by what follows the blows.
struct KnownStructure {
  const Refit& fit;
  const std::vector<StateForce>& forces;  ///< with the scales that its strengths are of
};

/// The numbers of `known` are held as if they were exact, and of the model's own symbols those that move none of
/// its rows are fitted to every impact that its excitation drives. The window holds an impact.
BlowsAlone fit_blows_alone(const CampaignAndModel& sides, DiagnosisOptions options, const KnownStructure& known);

}  // namespace secular
