#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "blind/disturbances.hpp"
#include "blind/effect.hpp"
#include "blind/specimen.hpp"

namespace secular::blind {

enum class SetSize { short_set, full_set };

/// What a blind set is made with. Here a campaign is a sealed one (docs/glossary.md): it comes with its model
/// file and its label.
struct SetOptions {
  std::size_t campaigns = 60;
  std::uint64_t seed = 1;
  SetSize size = SetSize::short_set;
  bool disturbed = false;         ///< records bear disturbances drawn by lot
  bool nothing_withheld = false;  ///< every model is its structure's own: what numbers are held to
  Programme programme = Programme::dwells;
  unsigned threads = 1;  ///< campaigns at once; the set does not depend on it
};

/// What a campaign is to be, before anything is drawn for it.
struct CampaignPlan {
  std::size_t number = 1;
  std::string kind;  ///< single | none | pair | outside | parameters
  std::vector<std::string> effects;
  std::string family;
  double snr_db = 30;
  std::size_t dwells = 20;
  bool disturbed = false;  ///< records bear disturbances drawn by lot
  Programme programme = Programme::dwells;
};

/// The plans of a set: every effect as often as any other, every noise level, in an order that the seed fixes.
/// The same seed gives the same structures and effects, `disturbed` or not.
std::vector<CampaignPlan> draw_plans(const SetOptions& set);

/// One thing that the model does not know, with how strongly the data show it. Strengths are those of Signatures.
struct Truth {
  Withheld withheld;
  double raw_sigma = 0;              ///< of the change itself
  double sigma = 0;                  ///< of what the model's own parameters cannot imitate
  double relative = 0;               ///< of the change, relative to the amplitudes
  std::vector<std::string> same_as;  ///< effects (or "no_gap") that these data cannot tell from it
};

struct SealedCampaign {
  CampaignPlan plan;
  Specimen specimen;
  std::vector<Truth> truths;
  Reality reality;
  std::vector<double> noise_sd;  ///< by channel
  std::vector<double> quantum;   ///< by channel; 0: none
  Disturbances disturbances;
  std::map<std::string, double> parameters;  ///< for parameters.json; empty: none
  std::vector<std::string> moved;            ///< symbols whose numbers in it are off
  std::vector<Motion> motions;               ///< of each dwell's record
  std::vector<Motion> of_stretches;          ///< after the dwells
};

/// The settled motion of a dwell, through all of the campaign's record number `record`, which is `length` times as
/// long as those of the programme.
Motion dwell_motion(const SealedCampaign& sealed, const Dwell& dwell, std::size_t record, std::size_t length = 1);

/// The true value of every symbol of the model file, in its units.
std::map<std::string, double> numbers_of(const Specimen& specimen);

/// Draws everything of a campaign. Depends on the seed and the plan alone. Throws NumericalFailure where every
/// attempt grows beyond bounds.
SealedCampaign draw_campaign(const CampaignPlan& plan, std::uint64_t seed);

/// Of a campaign with one effect: effects of the catalogue but this one that explain these data as well, "no_gap"
/// where nothing needs an explanation. Depends on the seed and the campaign alone.
std::vector<std::string> rest_that_explains(const SealedCampaign& sealed, std::uint64_t seed);

}  // namespace secular::blind
