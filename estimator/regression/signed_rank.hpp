#pragma once

#include <span>

namespace secular {

/// Wilcoxon's signed-rank test, one-sided: probability, for differences whose signs are a coin's, of a sum of the
/// positive ones' ranks (by magnitude, ties shared) as large as this or larger. Zeros are left out; 1 where nothing
/// remains. Exact up to 60 differences, normal with continuity correction above. Throws std::invalid_argument for
/// NaN.
double signed_rank_p_value(std::span<const double> differences);

}  // namespace secular
