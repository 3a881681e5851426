// Steps that solve for positions and momenta, of a Hamiltonian that is not separable.
// SPDX-License-Identifier: MIT
#include <drift/nonseparable_gauss_4.hpp>
#include <drift/nonseparable_gauss_4_ensemble.hpp>
#include <drift/nonseparable_gauss_4_stages.hpp>
#include <drift/nonseparable_gauss_8.hpp>
#include <drift/nonseparable_gauss_8_ensemble.hpp>
#include <drift/nonseparable_gauss_8_stages.hpp>
#include <drift/rows_gauss_4.hpp>

#include "bench/drift/measure.hpp"

namespace drift {

using namespace hvi::generated;

void add_pairs(std::vector<Row>& rows) {
    const auto sizes = {0.1, 1.0 / 7, 0.2, 0.0937, 0.21};
    add<NonseparableGauss4, BasicNonseparableGauss4<long double>>(
        rows, {"pairs", "nonseparable", "gauss:4", "one"}, sizes);
    add<NonseparableGauss4Stages, BasicNonseparableGauss4Stages<long double>>(
        rows, {"pairs", "nonseparable", "gauss:4", "stages"}, sizes);
    add<NonseparableGauss4Ensemble, BasicNonseparableGauss4Ensemble<long double>>(
        rows, {"pairs", "nonseparable", "gauss:4", "ensemble"}, sizes);
    add<NonseparableGauss8, BasicNonseparableGauss8<long double>>(
        rows, {"pairs", "nonseparable", "gauss:8", "one"}, sizes);
    add<NonseparableGauss8Stages, BasicNonseparableGauss8Stages<long double>>(
        rows, {"pairs", "nonseparable", "gauss:8", "stages"}, sizes);
    add<NonseparableGauss8Ensemble, BasicNonseparableGauss8Ensemble<long double>>(
        rows, {"pairs", "nonseparable", "gauss:8", "ensemble"}, sizes);
    add<RowsGauss4, BasicRowsGauss4<long double>>(rows, {"pairs", "rows N=72", "gauss:4", "loops"},
                                                  {0.1, 1.0 / 14, 0.0937}, 0.1);
}

}  // namespace drift
