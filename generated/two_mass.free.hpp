// Model two_mass: generated code, never edited by hand.
// Holds rows of the case free. Made by: secular generate two_mass.
// free vibration, multiple scales to eps^2. Valid near that resonance for small amplitudes; what is left out is
// of order eps^3.
#pragma once

#include "two_mass.primary_1.hpp"
#include "two_mass.primary_2.hpp"
#include "two_mass.principal_parametric_1.hpp"
#include "two_mass.principal_parametric_2.hpp"
#include "two_mass.hpp"

namespace secular::generated::two_mass {

namespace free {

inline constexpr BlockFunctions blocks[26] = {modulation_functions<Model, principal_parametric_2::modulation_of_v1>(),
    modulation_functions<Model, principal_parametric_1::modulation_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_0_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega2_of_v1>(),
    harmonic_functions<Model, primary_1::harmonic_2_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, primary_2::harmonic_2_omega1_of_v1>(),
    harmonic_functions<Model, principal_parametric_2::harmonic_minus_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_2_omega2_of_v1>(),
    harmonic_functions<Model, primary_1::harmonic_3_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega1_plus_2_omega2_of_v1>(),
    harmonic_functions<Model, principal_parametric_2::harmonic_2_omega1_plus_omega2_of_v1>(),
    harmonic_functions<Model, primary_2::harmonic_3_omega1_of_v1>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_0_of_v2>(),
    harmonic_functions<Model, primary_1::harmonic_2_omega2_of_v2>(),
    harmonic_functions<Model, principal_parametric_2::harmonic_omega1_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, primary_2::harmonic_2_omega1_of_v2>(),
    harmonic_functions<Model, principal_parametric_2::harmonic_minus_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_minus_omega1_plus_2_omega2_of_v2>(),
    harmonic_functions<Model, primary_1::harmonic_3_omega2_of_v2>(),
    harmonic_functions<Model, principal_parametric_1::harmonic_omega1_plus_2_omega2_of_v2>(),
    harmonic_functions<Model, principal_parametric_2::harmonic_2_omega1_plus_omega2_of_v2>(),
    harmonic_functions<Model, primary_2::harmonic_3_omega1_of_v2>()};

}  // namespace free
}  // namespace secular::generated::two_mass
