// Measures the cost of a tableau as the number of stages S grows.
// SPDX-License-Identifier: GPL-2.0-or-later
//
// Nodes without a closed form (gauss:6 and up): M^-1 is S^2 polynomials in one node each, from
// Q[x]/(P), and A is S^2 sums of S products of enclosures. Powers of tau cancel more and more, so
// the digits to work with grow like S as well, and the whole like S^3 products of O(S) digits.
//
// Exact nodes: the number of terms of an entry is what counts, not S: a normal form has up to as
// many as the degree of the field, which doubles with every independent square root or sine.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "generator/exact/methods/galerkin.hpp"
#include "generator/read/method.hpp"

namespace {

using namespace hvi::gen;

Method named(const std::string& name) {
    return named_method(std::make_shared<const Source>(Source{"--method", name}));
}

/// To 50 correctly rounded digits.
void digits_of(benchmark::State& state, const char* family) {
    const std::string name = std::string(family) + ":" + std::to_string(state.range(0));
    for (auto _ : state) {
        const Tableau tableau = derive(named(name));
        for (const NumberVector& row : tableau.A) {
            for (const Number& entry : row) { benchmark::DoNotOptimize(entry.decimal(50)); }
        }
    }
    state.SetComplexityN(state.range(0));
}

BENCHMARK_CAPTURE(digits_of, gauss, "gauss")->RangeMultiplier(2)->Range(4, 64)->Complexity();
BENCHMARK_CAPTURE(digits_of, newton_cotes, "newton-cotes")
    ->RangeMultiplier(2)
    ->Range(4, 64)
    ->Complexity();

}  // namespace

BENCHMARK_MAIN();
