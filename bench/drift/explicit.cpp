// Steps that solve nothing.
// SPDX-License-Identifier: MIT
#include <drift/kepler_kahan_li.hpp>
#include <drift/kepler_kahan_li_ensemble.hpp>
#include <drift/kepler_yoshida.hpp>

#include "bench/drift/measure.hpp"

namespace drift {

using namespace hvi::generated;

void add_explicit(std::vector<Row>& rows) {
    const auto sizes = {0.05, 1.0 / 21, 0.0469};
    add<KeplerKahanLi, BasicKeplerKahanLi<long double>>(
        rows, {"explicit", "kepler", "stormer-verlet kahan-li:8", "one"}, sizes);
    add<KeplerKahanLiEnsemble, BasicKeplerKahanLiEnsemble<long double>>(
        rows, {"explicit", "kepler", "stormer-verlet kahan-li:8", "ensemble"}, sizes);
    add<KeplerYoshida, BasicKeplerYoshida<long double>>(
        rows, {"explicit", "kepler", "stormer-verlet yoshida:8", "one"}, sizes);
}

}  // namespace drift
