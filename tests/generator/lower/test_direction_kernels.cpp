// Second derivatives along a direction: what directions share, and what is computed for each.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/lower/direction_kernels.hpp"
#include "generator/lower/system.hpp"
#include "tests/generator/lower/evaluate.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

System system_of_text(const std::string& text) {
    return system_of(unrolled(scene_from_toml(Source{"scene.toml", text})));
}

constexpr const char* kepler_text = R"toml(
hamiltonian = "(px^2 + py^2)/2 - mu/sqrt(x^2 + y^2)"
coordinates = ["x", "y"]
momenta = ["px", "py"]
[parameters]
mu = 3
[initial]
x = 1
y = 0
px = 0
py = 1
)toml";

constexpr const char* charged_text = R"toml(
hamiltonian = "(px - y*exp(x))^2/(2*m) + py^2*cos(x*y)/m"
coordinates = ["x", "y"]
momenta = ["px", "py"]
[parameters]
m = 2
[initial]
x = 1
y = 0
px = 0
py = 1
)toml";

/// Values by the names of inputs, of which those in the place of what is kept are computed.
Values with_kept(const System& system, const DirectionKernel& kernel, Values at) {
    for (std::size_t k = 0; k < kernel.kept.size(); ++k) {
        at[system.graph.at(kernel.kept[k]).name] = value(system.graph, kernel.point.results[k], at);
    }
    return at;
}

}  // namespace

TEST_CASE("rows of second derivatives times a direction are what their entries say") {
    for (const char* text : {kepler_text, charged_text}) {
        System system = system_of_text(text);
        const DirectionKernels kernels = direction_kernels(system);
        Values at{{"x", 0.5L}, {"y", -0.75L}, {"px", 2}, {"py", 0.25L}, {"mu", 3}, {"m", 2}};
        const std::vector<Real> d{1, -2, 0.5L, 3};
        for (std::size_t k = 0; k < 2; ++k) {
            at[system.graph.at(kernels.dq[k]).name] = d[k];
            at[system.graph.at(kernels.dp[k]).name] = d[2 + k];
        }
        at = with_kept(system, kernels.both, at);
        const Hessian& second = hessian_of(system);
        const auto entry = [&](const Scaled& x) { return value(system.graph, x, at); };
        for (std::size_t i = 0; i < 2; ++i) {
            Real by_q = 0, by_p = 0;
            for (std::size_t j = 0; j < 2; ++j) {
                by_q += entry(second.qq[i][j]) * d[j] + entry(second.mixed[i][j]) * d[2 + j];
                by_p +=
                    entry(second.mixed[j][i]) * d[j] + entry(second.conjugates[i][j]) * d[2 + j];
            }
            CHECK(std::abs(entry(kernels.both.along.results[i]) - by_q) < 1e-15L);
            CHECK(std::abs(entry(kernels.both.along.results[2 + i]) - by_p) < 1e-15L);
        }
    }
}

TEST_CASE("each direction takes products with what is kept, and sums") {
    System system = system_of_text(kepler_text);
    const DirectionKernels kernels = direction_kernels(system);
    // mu/r^3 d - 3 mu/r^5 (x . d) x, where (x . d) and its product with x_k take six products.
    CHECK(kernels.by_q.along.counts == OperationCounts{3, 6, 0, 0, 0});
    CHECK(kernels.by_q.point.counts.square_roots == 1);
    for (const Node node : kernels.by_q.along.given) {
        const Computation& given = system.graph.at(node);
        CHECK(given.operation == Operation::input);
        CHECK(given.name != "x");
    }
    // T is quadratic: there is nothing to keep.
    CHECK(kernels.by_p.kept.empty());
    CHECK(kernels.by_p.along.counts == OperationCounts{});
}
