#pragma once

#include <set>
#include <span>
#include <string>

#include "estimator/identification/case_regression.hpp"
#include "estimator/identification/estimate.hpp"

namespace secular {

/// Cases of which an equation does not hold (lack_of_fit).
std::set<std::string> cases_with_lack_of_fit(const Estimate& estimate);

/// Cases whose error bars come from the scatter of repeats, for want of conditions.
std::set<std::string> cases_of_few_conditions(const Estimate& estimate);

/// Takes out all numbers that these cases alone tell, for the reason `why` (in words), and says which.
void take_out(Estimate& estimate, const std::set<std::string>& cases, const std::string& why);

/// docs/inference.md, "No number". What an equation lacks differs from condition to condition, and error bars by
/// the scatter between conditions know something of it. Those by the scatter of repeats know nothing: where
/// equations of such a case do not hold, or lumps contradict one another, there is no number. Nor is there one
/// where it leaves lumps of its own open and parameters stay open, too: then the truncation is taken out at
/// parameters of which nothing is known.
void take_out_unsupported(Estimate& estimate, std::span<const CaseFit> fits);

/// A motion that an excitation keeps up has a coefficient of it. Where none of a case differs from zero, nothing
/// satisfies the balance of damping and force (docs/inference.md, "Phases that do not hold"): every value that such
/// cases alone tell is doubtful, with a warning.
void doubt_without_force(Estimate& estimate, std::span<const CaseFit> fits);

/// Values are doubtful that differ from those of `other`, an estimate of the same under fewer assumptions, by more
/// than two standard deviations of the difference at least (J. A. Hausman, Econometrica 46, 1978), or that this one
/// does not have; `why`: what the other one assumes, as a reason.
void doubt_what_differs(Estimate& estimate, const Estimate& other, const std::string& why);

/// Nothing that was estimated can be relied upon.
void doubt_all(Estimate& estimate, const std::string& why);

}  // namespace secular
