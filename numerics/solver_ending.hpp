#pragma once

namespace secular {

/// How an iterative solver ended. A computation that cannot go on without its result throws NumericalFailure, with
/// the same words.
enum class SolverEnding {
  converged,  ///< only this gives a result that can be relied on
  stalled,    ///< no further progress, or as many iterations as allowed
  ran_away    ///< a step that is not finite, or one that grows from one to the next
};

}  // namespace secular
