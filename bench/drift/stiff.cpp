// Steps on which plain fixed points are slow.
// SPDX-License-Identifier: MIT
#include <drift/fpu_automatic.hpp>
#include <drift/fpu_fixed_point.hpp>
#include <drift/fpu_newton.hpp>
#include <drift/springs_gauss_4.hpp>

#include "bench/drift/measure.hpp"

namespace drift {

using namespace hvi::generated;

void add_stiff(std::vector<Row>& rows) {
    // The frequency of the stiff springs is 50.
    const auto of_fpu = {0.042, 0.0413};
    add<FpuFixedPoint, BasicFpuFixedPoint<long double>>(
        rows, {"stiff", "fpu", "gauss:8 fixed-point", "stages"}, of_fpu);
    add<FpuAutomatic, BasicFpuAutomatic<long double>>(
        rows, {"stiff", "fpu", "gauss:8 auto", "stages"}, of_fpu);
    add<FpuNewton, BasicFpuNewton<long double>>(rows, {"stiff", "fpu", "gauss:8 newton", "one"},
                                                of_fpu, 0.1);
    // Four masses; the largest frequency is 1.9.
    add<SpringsGauss4, BasicSpringsGauss4<long double>>(
        rows, {"stiff", "springs", "gauss:4 newton", "one"}, {10.5, 10.37});
}

}  // namespace drift
