// Steps of a Lagrangian.
// SPDX-License-Identifier: MIT
#include <drift/spherical_gauss_4.hpp>
#include <drift/spherical_gauss_8.hpp>

#include "bench/drift/measure.hpp"

namespace drift {

using namespace hvi::generated;

void add_lagrangian(std::vector<Row>& rows) {
    add<SphericalGauss4, BasicSphericalGauss4<long double>>(
        rows, {"lagrangian", "spherical-pendulum", "gauss:4", "one"}, {0.05, 1.0 / 21, 0.0469});
    add<SphericalGauss8, BasicSphericalGauss8<long double>>(
        rows, {"lagrangian", "spherical-pendulum", "gauss:8", "one"}, {0.1, 1.0 / 7, 0.0937});
}

}  // namespace drift
