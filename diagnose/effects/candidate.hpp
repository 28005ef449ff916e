#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "diagnose/evidence/condition.hpp"
#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/evidence/segment.hpp"
#include "diagnose/evidence/sensor_model.hpp"

namespace secular {

/// An effect of the catalogue that is a term of the augmented model's equations of motion.
struct EquationEffect {
  std::string effect;  ///< its name in the catalogue
  std::size_t mode = 0;
  std::string subject;              ///< coordinate, or coordinates of a coupling, for people
  std::size_t strength = 0;         ///< symbol; zero without the effect
  std::vector<std::size_t> shapes;  ///< symbols that shape it
  std::size_t form = 0;             ///< which of the effect's terms
};

/// One explanation of a gap: unknowns that are zero without it.
struct Candidate {
  std::string effect, subject;
  EffectComponent component = EffectComponent::measurement;
  std::size_t mode = 0;
  bool equation = false;                      ///< a term of the equations of motion
  std::vector<std::size_t> strengths;         ///< indices of unknowns
  std::vector<std::size_t> shapes;            ///< unknowns that matter only with a strength
  std::vector<Eigen::VectorXd> shape_starts;  ///< values to begin with; one empty entry where there is no shape
  bool passive = false;                       ///< a force that can only oppose or give way: no negative strength
  double least_strength = 0;                  ///< a strength that must begin away from zero (saturation)
  /// Whether unknowns make sense as this explanation; empty: always.
  std::function<bool(const Eigen::VectorXd& unknowns)> plausible;
  bool open_law = false;              ///< stands for a law outside of the catalogue: no cause by itself
  std::string in_words;               ///< Effect::in_words
  std::vector<std::string> contains;  ///< Effect::contains
  /// Of a law that is the power of displacement/scale or velocity/scale, times scale, with the first shape as its
  /// exponent; 0: it is none.
  double power_scale = 0;
  /// Of sliders, the slip being the first shape: StateForce::stiffness_scale(); 0: it is none.
  double slip_scale = 0;

  /// Strength as the catalogue's term has it, and its slopes by strength and first shape.
  struct Strength {
    double value = 0, by_strength = 1, by_shape = 0;
  };
  Strength strength_of_term(const Eigen::VectorXd& unknowns) const;
  /// Of a slip the size counts alone: -1 where the catalogue's is the unknown's negative, else 1.
  double sign_of_shapes(const Eigen::VectorXd& unknowns) const;
};

/// How far the modes move, by mode.
struct LargestMotions {
  Eigen::VectorXd displacement, speed;
  Eigen::VectorXd frequency;  ///< natural ones, rad/s
};

/// Names of all effects that a campaign can be tried with, in alphabetical order; open laws are not among them.
std::vector<std::string> effect_names(const EffectCatalogue& catalogue);

/// Largest displacement (peak) and speed of every mode over conditions and segments.
LargestMotions largest_motions(const std::vector<Condition>& conditions, const std::vector<Segment>& segments,
                               const SensorModel& sensors, const std::vector<double>& natural_frequency);

/// What candidates are about: a model, the sensors that see its motion, and what they have seen.
struct CandidateData {
  const CompiledModel& model;
  const SensorModel& sensors;
  const FaultTable& faults;
  const std::vector<Condition>& conditions;
  const std::vector<Segment>& segments;
  const LargestMotions& largest;
};

/// Every explanation in the catalogue that the campaign can speak of at all.
std::vector<Candidate> candidates_of(const EffectCatalogue& catalogue, const std::vector<EquationEffect>& effects,
                                     const CandidateData& data);

}  // namespace secular
