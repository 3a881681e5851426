// Steps that solve for the positions of the stages alone, in each of their layouts.
// SPDX-License-Identifier: MIT
#include <drift/chain_gauss_4.hpp>
#include <drift/kepler_gauss_12.hpp>
#include <drift/kepler_gauss_12_ensemble.hpp>
#include <drift/kepler_gauss_12_stages.hpp>
#include <drift/kepler_gauss_4.hpp>
#include <drift/kepler_gauss_4_ensemble.hpp>
#include <drift/kepler_gauss_4_stages.hpp>

#include "bench/drift/measure.hpp"

namespace drift {

using namespace hvi::generated;

void add_positions(std::vector<Row>& rows) {
    const auto coarse = {0.1, 1.0 / 7, 0.2, 0.0937, 0.21};
    add<KeplerGauss12, BasicKeplerGauss12<long double>>(
        rows, {"positions", "kepler", "gauss:12", "one"}, coarse);
    add<KeplerGauss12Stages, BasicKeplerGauss12Stages<long double>>(
        rows, {"positions", "kepler", "gauss:12", "stages"}, coarse);
    add<KeplerGauss12Ensemble, BasicKeplerGauss12Ensemble<long double>>(
        rows, {"positions", "kepler", "gauss:12", "ensemble"}, coarse);
    const auto fine = {0.05, 1.0 / 21, 0.0469};
    add<KeplerGauss4, BasicKeplerGauss4<long double>>(
        rows, {"positions", "kepler", "gauss:4", "one"}, fine);
    add<KeplerGauss4Stages, BasicKeplerGauss4Stages<long double>>(
        rows, {"positions", "kepler", "gauss:4", "stages"}, fine);
    add<KeplerGauss4Ensemble, BasicKeplerGauss4Ensemble<long double>>(
        rows, {"positions", "kepler", "gauss:4", "ensemble"}, fine);
    add<ChainGauss4, BasicChainGauss4<long double>>(
        rows, {"positions", "fpu-chain N=72", "gauss:4", "loops"}, fine, 0.1);
}

}  // namespace drift
