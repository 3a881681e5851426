// Steps of the general Galerkin form: more nodes than functions.
// SPDX-License-Identifier: MIT
#include <drift/kepler_galerkin.hpp>
#include <drift/kepler_galerkin_stages.hpp>
#include <drift/nonseparable_galerkin.hpp>

#include "bench/drift/measure.hpp"

namespace drift {

using namespace hvi::generated;

void add_galerkin(std::vector<Row>& rows) {
    add<KeplerGalerkin, BasicKeplerGalerkin<long double>>(
        rows, {"galerkin", "kepler", "tau^0..4, gauss:6", "one"}, {0.05, 1.0 / 21, 0.0469});
    add<KeplerGalerkinStages, BasicKeplerGalerkinStages<long double>>(
        rows, {"galerkin", "kepler", "tau^0..4, gauss:6", "stages"}, {0.05, 1.0 / 21, 0.0469});
    add<NonseparableGalerkin, BasicNonseparableGalerkin<long double>>(
        rows, {"galerkin", "nonseparable", "tau^0..4, gauss:6", "one"}, {0.1, 1.0 / 7, 0.0937});
}

}  // namespace drift
