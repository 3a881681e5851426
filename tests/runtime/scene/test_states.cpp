// The contents of the states of scenes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <scene/auto_double_pendulum.hpp>
#include <scene/auto_kepler.hpp>
#include <scene/dense_stormer-verlet_pendulum.hpp>
#include <scene/newton_double_pendulum.hpp>
#include <scene/newton_kepler.hpp>
#include <scene/taylor_kepler.hpp>
#include <scene/trig3_oscillator.hpp>
#include <scene/verlet_kepler.hpp>

using namespace hvi::generated;

namespace {

/// Compares steps whose states are held in different types.
template <class Stepper, class OfEigen>
void compare(double h) {
    Stepper stepper;
    OfEigen other;
    typename Stepper::State x;
    typename OfEigen::State y;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        y.q[i] = x.q[k] = 1.0 / static_cast<double>(k + 1);
        y.p[i] = x.p[k] = 0.3 * static_cast<double>(k + 1);
    }
    for (int step = 0; step < 100; ++step) {
        REQUIRE(stepper.step(x, h).ok());
        REQUIRE(other.step(y, h).ok());
    }
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        CHECK(x.q[k] == y.q[static_cast<Eigen::Index>(k)]);
        CHECK(x.p[k] == y.p[static_cast<Eigen::Index>(k)]);
    }
}

}  // namespace

TEST_CASE("states of scenes hold arrays or Eigen's vectors of fixed size") {
    using One = Eigen::Matrix<double, 1, 1>;
    compare<AutoKepler, BasicAutoKepler<double, Eigen::Vector2d>>(0.05);
    compare<NewtonKepler, BasicNewtonKepler<double, Eigen::Vector2d>>(0.05);
    compare<TaylorKepler, BasicTaylorKepler<double, Eigen::Vector2d>>(0.05);
    compare<AutoDoublePendulum, BasicAutoDoublePendulum<double, Eigen::Vector2d>>(0.05);
    compare<NewtonDoublePendulum, BasicNewtonDoublePendulum<double, Eigen::Vector2d>>(0.05);
    compare<VerletKepler, BasicVerletKepler<double, Eigen::Vector2d>>(0.05);
    compare<Trig3Oscillator, BasicTrig3Oscillator<double, One>>(0.05);
    compare<DensePendulumVerlet, BasicDensePendulumVerlet<double, One>>(0.05);
    STATIC_REQUIRE(hvi::detail::fixed_size<Eigen::VectorXd>() == 0);
    STATIC_REQUIRE_FALSE(hvi::detail::is_fixed_vector<Eigen::VectorXd, double, 2>());
    STATIC_REQUIRE_FALSE(hvi::detail::is_fixed_vector<Eigen::Vector2f, double, 2>());
    STATIC_REQUIRE_FALSE(hvi::detail::is_fixed_vector<std::array<double, 3>, double, 2>());
}
