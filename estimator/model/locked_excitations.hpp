#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// Excitation frequencies that the relations of a case tie to others, as Omega2 = 2*Omega: relations without a
/// natural frequency. Steady motion there is only where they hold exactly: the last frequency of such a relation
/// follows those before it.
class LockedExcitations {
 public:
  LockedExcitations(const CompiledModel& model, const CompiledCase& resonance);

  bool follows(std::size_t excitation) const;
  /// Share of the frequency of `leader` in that of `excitation`, which follows it; of one that follows nothing 1 in
  /// its own and 0 in others.
  Ratio share(std::size_t excitation, std::size_t leader) const;
  /// "Omega2 = 2*Omega".
  std::string text(std::size_t excitation) const;
  /// Sets the frequencies that follow; those need not be numbers before. frequency: [excitation], rad/s.
  void follow(double* frequency) const;

 private:
  struct Follower {
    std::size_t excitation = 0;
    std::vector<Ratio> shares;  // [excitation]
  };
  const Follower* follower(std::size_t excitation) const;

  std::vector<std::string> names_;
  std::vector<Follower> followers_;
};

}  // namespace secular
