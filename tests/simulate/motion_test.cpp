#include "motion/simulate/motion.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <numbers>

#include "input/numerical_failure.hpp"
#include "motion/simulate/dormand_prince_87.hpp"

namespace secular {
namespace {

// Hand-written models: nothing of the generator is involved.
constexpr std::string_view coordinates[] = {"x"};
constexpr std::string_view excitations[] = {"F"};

CompiledModel model_of(void (*acceleration)(const double*, const ExcitationSample*, const double*, const double*,
                                            double*)) {
  CompiledModel model;
  model.name = "hand_written";
  model.coordinates = coordinates;
  model.excitations = excitations;
  model.acceleration = acceleration;
  return model;
}

const ExcitationSignal silent = [](double, ExcitationSample* s) { s[0] = {}; };

TEST(Motion, ForcedLinearOscillatorReachesItsClosedForm) {
  const CompiledModel model =
      model_of([](const double* p, const ExcitationSample* u, const double* x, const double* v, double* a) {
        a[0] = u[0].value - 2 * p[1] * v[0] - p[0] * p[0] * x[0];
      });
  const double parameters[] = {10, 0.5}, omega = 7;
  const ExcitationSignal wave = [&](double t, ExcitationSample* s) {
    s[0] = {std::cos(omega * t), -omega * std::sin(omega * t), -omega * omega * std::cos(omega * t)};
  };
  for (const Integrator method :
       {Integrator::dormand_prince, Integrator::bulirsch_stoer, Integrator::dormand_prince_87}) {
    MotionSettings settings;
    settings.method = method;
    MotionState state{{0}, {0}};
    double worst = 0;
    integrate_motion({model, parameters, wave}, {0, 80, 0.01, 500}, settings, state, [&](const MotionSample& s) {
      const std::complex<double> response =
          std::polar(1.0, omega * s.time) / std::complex<double>(100 - omega * omega, omega);
      worst = std::max(
          {worst, std::abs(s.displacement[0] - response.real()) / std::abs(response),
           std::abs(s.acceleration[0] + omega * omega * response.real()) / (omega * omega * std::abs(response))});
    });
    EXPECT_LT(worst, 1e-7) << static_cast<int>(method);
  }
}

// Of order 8 with samples a tenth of a period apart: a fraction of the evaluations of order 5, and no larger error.
TEST(Motion, HighOrderNeedsFewerEvaluationsForTheSameTolerance) {
  const auto run = [](Integrator method, long& calls) {
    CompiledModel model = model_of(nullptr);
    model.acceleration = {
        [](const void* count, const double*, const ExcitationSample*, const double* x, const double*, double* a) {
          ++*static_cast<long*>(const_cast<void*>(count));
          a[0] = -std::sin(x[0]);
        },
        &calls};
    MotionSettings settings;
    settings.method = method;
    MotionState state{{2}, {0}};
    double last = 0;
    const double period = 4 * boost::math::ellint_1(std::sin(1.0));
    integrate_motion({model, nullptr, silent}, {0, 0, period / 10, 501}, settings, state,
                     [&](const MotionSample& s) { last = s.velocity[0]; });
    return std::abs(last);  // at rest after whole periods
  };
  long fifth = 0, eighth = 0;
  const double error_of_fifth = run(Integrator::dormand_prince, fifth),
               error_of_eighth = run(Integrator::dormand_prince_87, eighth);
  EXPECT_LT(2 * eighth, fifth);
  EXPECT_LT(error_of_eighth, error_of_fifth);
}

TEST(Motion, PendulumPeriodIsTheEllipticIntegralAndEnergyStays) {
  const CompiledModel model = model_of([](const double*, const ExcitationSample*, const double* x, const double*,
                                          double* a) { a[0] = -std::sin(x[0]); });
  const double angle = 2;
  const double period = 4 * boost::math::ellint_1(std::sin(angle / 2));
  MotionState state{{angle}, {0}};
  double energy_change = 0;
  const double energy = 1 - std::cos(angle);
  integrate_motion({model, nullptr, silent}, {0, 0, period, 51}, {}, state, [&](const MotionSample& s) {
    EXPECT_NEAR(s.displacement[0], angle, 1e-7);
    energy_change = std::max(
        energy_change, std::abs(0.5 * s.velocity[0] * s.velocity[0] + 1 - std::cos(s.displacement[0]) - energy));
  });
  EXPECT_LT(energy_change, 1e-7);
}

TEST(Motion, DryFrictionDecaysByEqualStepsAndComesToRest) {
  // x'' + w^2 x = -fc sgn(x'): the amplitude falls by 4 fc/w^2 a cycle and the motion stops inside |x| <= fc/w^2.
  const CompiledModel model =
      model_of([](const double* p, const ExcitationSample*, const double* x, const double* v, double* a) {
        a[0] = -p[0] * p[0] * x[0] - p[1] * (static_cast<double>(v[0] > 0) - static_cast<double>(v[0] < 0));
      });
  const double parameters[] = {2, 0.1};
  const double period = std::numbers::pi, step = 4 * 0.1 / 4;
  MotionState state{{1}, {0}};
  int cycle = 0;
  integrate_motion({model, parameters, silent}, {0, 0, period, 9}, {}, state, [&](const MotionSample& s) {
    EXPECT_NEAR(s.displacement[0], 1 - cycle * step, 1e-6) << cycle;
    ++cycle;
  });
  state = {{1}, {0}};
  integrate_motion({model, parameters, silent}, {0, 100, 1, 3}, {}, state, [&](const MotionSample& s) {
    EXPECT_EQ(s.velocity[0], 0);
    EXPECT_EQ(s.acceleration[0], 0);
    EXPECT_LE(std::abs(s.displacement[0]), 0.1 / 4 + 1e-9);
  });
}

// The last swings of a decay with viscous damping, drag and dry friction, for many strengths of the friction: the
// motion meets zero velocity under all angles, the flattest just before it sticks. It comes to rest inside the dead
// band, where restoring force and friction balance, and loses energy all the way.
TEST(Motion, DecaysUnderDryFrictionComeToRestWhateverTheTolerance) {
  const CompiledModel model =
      model_of([](const double* p, const ExcitationSample*, const double* x, const double* v, double* a) {
        a[0] = -p[0] * p[0] * x[0] - 0.0036 * v[0] - 0.0105 * std::abs(v[0]) * v[0] -
               p[1] * (static_cast<double>(v[0] > 0) - static_cast<double>(v[0] < 0));
      });
  for (const double tolerance : {1e-6, 1e-9})
    for (int variant = 0; variant < 20; ++variant) {
      const double parameters[] = {5.77, 0.03 + 2e-3 * variant};
      MotionSettings settings;
      settings.relative_tolerance = tolerance;
      MotionState state{{0.02}, {0}};
      double energy = INFINITY, last_velocity = 1;
      ASSERT_NO_THROW(integrate_motion({model, parameters, silent}, {100, 100, 0.01, 1500}, settings, state,
                                       [&](const MotionSample& s) {
                                         const double now = s.velocity[0] * s.velocity[0] +
                                                            5.77 * 5.77 * s.displacement[0] * s.displacement[0];
                                         EXPECT_LE(now, energy + 1e-9);
                                         energy = now;
                                         last_velocity = s.velocity[0];
                                       }))
          << tolerance << " " << variant;
      EXPECT_EQ(last_velocity, 0) << variant;
      EXPECT_LE(std::abs(state.displacement[0]), parameters[1] / (5.77 * 5.77) + 1e-9) << variant;
    }
}

// Conditions of order: stages lie where their rows say; quadrature is exact up to the order, and no further.
TEST(DormandPrince87, CoefficientsFulfilTheConditionsOfOrder) {
  using Pair = DormandPrince87;
  for (std::size_t i = 0; i < Pair::stages; ++i) {
    double sum = 0;
    for (const double a : Pair::stage[i]) sum += a;
    EXPECT_NEAR(sum, Pair::time[i], 1e-15 * 50) << i;
  }
  const auto moment = [](const Pair::Row& weights, int power) {
    double sum = 0;
    for (std::size_t i = 0; i < Pair::stages; ++i) sum += weights[i] * std::pow(Pair::time[i], power);
    return sum * (power + 1) - 1;
  };
  for (int power = 0; power < 8; ++power) EXPECT_NEAR(moment(Pair::order_8, power), 0, 1e-14) << power;
  for (int power = 0; power < 7; ++power) EXPECT_NEAR(moment(Pair::order_7, power), 0, 1e-14) << power;
  EXPECT_GT(std::abs(moment(Pair::order_7, 7)), 1e-6);  // so that the error estimate sees an excitation
}

TEST(Motion, GrowthBeyondBoundsIsReportedWithItsTime) {
  const CompiledModel model = model_of([](const double*, const ExcitationSample*, const double* x, const double*,
                                          double* a) { a[0] = x[0] * x[0] * x[0]; });
  MotionState state{{1}, {0}};
  try {
    integrate_motion({model, nullptr, silent}, {0, 0, 0.01, 10000}, {}, state, [](const MotionSample&) {});
    FAIL() << "no complaint";
  } catch (const NumericalFailure& failure) {
    EXPECT_EQ(failure.ending(), Ending::ran_away);
    EXPECT_NE(std::string(failure.what()).find("t = "), std::string::npos) << failure.what();
  }
}

// Out of a potential well, and to where the inertia vanishes: steps become smaller than the clock can count while
// the numbers are still finite. A stiffness that jumps there is no escape.
TEST(Motion, AnEscapeIsToldFromAStall) {
  const auto ending = [](void (*acceleration)(const double*, const ExcitationSample*, const double*, const double*,
                                              double*),
                         Integrator method) {
    const CompiledModel model = model_of(acceleration);
    const ExcitationSignal growing = [](double t, ExcitationSample* s) { s[0] = {1e-3 * t * std::cos(t), 0, 0}; };
    MotionSettings settings;
    settings.method = method;
    MotionState state{{0.01}, {0}};
    try {
      integrate_motion({model, nullptr, growing}, {0, 0, 0.1, 100000}, settings, state, [](const MotionSample&) {});
    } catch (const NumericalFailure& failure) {
      return std::pair(failure.ending(), std::string(failure.what()));
    }
    return std::pair(Ending::out_of_range, std::string("no failure"));
  };
  for (const Integrator method :
       {Integrator::dormand_prince, Integrator::bulirsch_stoer, Integrator::dormand_prince_87}) {
    const auto well = ending([](const double*, const ExcitationSample* u, const double* x, const double*,
                                double* a) { a[0] = u[0].value - x[0] - x[0] * x[0]; },
                             method);
    EXPECT_EQ(well.first, Ending::ran_away) << well.second;
    const auto inertia =
        ending([](const double*, const ExcitationSample* u, const double* x, const double* v,
                  double* a) { a[0] = (u[0].value - x[0] - x[0] * x[0] - 0.05 * v[0] * v[0]) / (1 + 0.1 * x[0]); },
               method);
    EXPECT_EQ(inertia.first, Ending::ran_away) << inertia.second;
    EXPECT_NE(inertia.second.find("coordinate 1 is at "), std::string::npos) << inertia.second;
  }
}

}  // namespace
}  // namespace secular
