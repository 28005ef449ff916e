#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "jobs/predict/prediction.hpp"

namespace secular {

/// "24.556(12)", or with `digits` of its own where nothing says how uncertain it is.
std::string uncertain_number(double value, std::optional<double> sd, int digits);

/// The varied parameter at a special point, as it is printed, without its unit.
std::string special_place(const Prediction& prediction, const ResponseSpecial& special);

/// Peak amplitude of a mode on a response; 0 where the branch meets the state of rest.
std::string special_amplitude(const Prediction& prediction, const ResponseSpecial& special, std::size_t mode);

/// Peak amplitude, and frequency in Hz, of limit cycle `cycle` below backbone `k`.
std::string cycle_amplitude(const Prediction& prediction, std::size_t k, std::size_t cycle);
std::string cycle_frequency(const Prediction& prediction, std::size_t k, std::size_t cycle);

/// Whether error bars of a mode's amplitude are known at the varied parameter's value, and two of them do not exceed
/// it: beyond that first order says nothing.
bool first_order_holds(const ResponsePoint& point, std::size_t mode);

/// Standard deviation of a mode's peak amplitude at the varied parameter's value. Nothing where it is zero, and where
/// first order does not hold.
std::optional<double> amplitude_sd(const ResponsePoint& point, std::size_t mode);

}  // namespace secular
