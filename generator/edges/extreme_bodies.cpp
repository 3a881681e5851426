// Two bodies of very different masses, and a meeting of three.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/edges/extreme.hpp"
#include "generator/edges/passage.hpp"

namespace hvi::gen {

namespace {

constexpr const char* two_bodies = R"toml(name = "two-bodies"
coordinates = ["x1", "y1", "x2", "y2"]
momenta = ["px1", "py1", "px2", "py2"]
hamiltonian = """
    (px1^2 + py1^2)/(2*m1) + (px2^2 + py2^2)/(2*m2) - m1*m2/sqrt((x1 - x2)^2 + (y1 - y2)^2)"""
[parameters]
m1 = 1
m2 = 1
[initial]
x1 = 1
y1 = 0
x2 = 0
y2 = 0
px1 = 0
py1 = 0
px2 = 0
py2 = 0
)toml";

/// Burrau's problem: bodies at rest at the corners of a triangle with sides 3, 4, 5, each opposite
/// to the side of its mass.
constexpr const char* three_bodies = R"toml(name = "pythagorean"
coordinates = ["x1", "y1", "x2", "y2", "x3", "y3"]
momenta = ["px1", "py1", "px2", "py2", "px3", "py3"]
hamiltonian = """
    (px1^2 + py1^2)/6 + (px2^2 + py2^2)/8 + (px3^2 + py3^2)/10
    - 12/sqrt((x1 - x2)^2 + (y1 - y2)^2) - 15/sqrt((x1 - x3)^2 + (y1 - y3)^2)
    - 20/sqrt((x2 - x3)^2 + (y2 - y3)^2)"""
[initial]
x1 = 1
y1 = 3
x2 = -2
y2 = -1
x3 = 1
y3 = -1
px1 = 0
py1 = 0
px2 = 0
py2 = 0
px3 = 0
py3 = 0
)toml";

double largest(std::vector<double>::const_iterator from, std::size_t n) {
    return *std::max_element(from, from + static_cast<std::ptrdiff_t>(n));
}

/// Errors of the total momentum and of the total angular momentum, which are 0 and `angular` at the
/// start. Their unit is eps times the largest numbers, for each step of a method of `parts`.
/// Rounding makes both at most 8: they are sums of n products of numbers, each of which has an
/// error of a few eps/2 after a step.
struct Momenta {
    double total, angular;

    [[nodiscard]] bool are_conserved() const { return total <= 8 && angular <= 8; }
    [[nodiscard]] std::string text() const {
        return fmt::format("momenta off by {:.2g} and {:.2g}", total, angular);
    }
};

Momenta momenta(const Heard& heard, std::size_t parts, double angular) {
    const std::vector<double> x = heard.answers.numbers("end"),
                              most = heard.answers.numbers("largest");
    const std::size_t half = x.size() / 2;
    double px = 0, py = 0, off = -angular;
    for (std::size_t i = 0; i < half; i += 2) {
        px += x[half + i];
        py += x[half + i + 1];
        off += x[i] * x[half + i + 1] - x[i + 1] * x[half + i];
    }
    const auto p = most.begin() + static_cast<std::ptrdiff_t>(half);
    const double eps = std::numeric_limits<double>::epsilon() *
                       static_cast<double>(std::max(1L, heard.answers.integer("steps"))) *
                       static_cast<double>(parts);
    const double unit = eps * largest(p, half);
    return {std::max(std::abs(px), std::abs(py)) / unit,
            std::abs(off) / (unit * largest(most.begin(), half))};
}

constexpr const char* conserved = "momenta off by at most 8 eps a step";

/// The passage of two bodies with the masses m and 1 - m. The product of the masses takes the place
/// of G: see the scene.
struct Pair {
    double heavy, light;

    /// Returns the state of both around their centre of mass, which is at rest.
    [[nodiscard]] std::vector<double> state(const std::vector<double>& r) const {
        const double m = heavy * light;
        return {-light * r[0], -light * r[1], heavy * r[0], heavy * r[1],
                -m * r[2],     -m * r[3],     m * r[2],     m * r[3]};
    }
    [[nodiscard]] std::vector<double> relative(const std::vector<double>& x) const {
        return {x[2] - x[0], x[3] - x[1], x[6] / light - x[4] / heavy, x[7] / light - x[5] / heavy};
    }
};

void add_pair(const ExtremeMethod& method, EdgeChapter& chapter) {
    const Scene scene = scene_of(two_bodies);
    const EdgeProgram& program = method.two_bodies;
    const Passage passage(0.5);
    for (const double light : {0.5, 1e-12}) {
        const Pair pair{1 - light, light};
        const std::string masses = fmt::format("masses 1 - {} and {}", light, light);
        const std::vector<double> start = pair.state(passage.begin());
        const Refinement refinement =
            refined(passage, program, method.parts, start, {pair.heavy, pair.light},
                    [&](const auto& end) { return pair.relative(end); });
        chapter.checks.push_back(order_check(method.name, method.order, scene.name,
                                             masses + ", e = 0.5: past the pericentre",
                                             refinement));
        const Heard heard = program.ask("advance", 0.01, 5000, start, {pair.heavy, pair.light});
        EdgeCheck check{method.name,
                        scene.name,
                        masses + ": 5000 steps of 0.01",
                        "ok, " + std::string(conserved),
                        end_text(heard),
                        false};
        if (check.seen == "ok") {
            const double l = 0.75, angular = pair.heavy * pair.light * std::sqrt(l);
            const Momenta seen = momenta(heard, method.parts, angular);
            check.seen += ", " + seen.text();
            check.agrees = seen.are_conserved();
        }
        chapter.checks.push_back(std::move(check));
    }
}

void add_three(const ExtremeMethod& method, EdgeChapter& chapter) {
    const Scene scene = scene_of(three_bodies);
    const EdgeProgram& program = method.three_bodies;
    const std::vector<double> start =
        program.ask({"start"}).answers.numbers("start", variables(unrolled(scene)).size());
    for (const long parts : {16, 256, 4096}) {
        const Heard heard =
            program.ask("advance", 1 / static_cast<double>(parts), 10 * parts, start);
        EdgeCheck check{method.name,
                        scene.name,
                        fmt::format("{} steps to t = 10", 10 * parts),
                        fmt::format("{}; {}", ends_well, conserved),
                        end_text(heard),
                        false};
        if (is_whole(heard)) {
            const Momenta seen = momenta(heard, method.parts, 0);
            check.seen += ", " + seen.text();
            check.agrees = seen.are_conserved();
        }
        chapter.checks.push_back(std::move(check));
    }
}

}  // namespace

EdgeProgram two_bodies_program(Builds& builds, const ComposedMethod& method) {
    return {builds, method, scene_of(two_bodies)};
}

EdgeProgram three_bodies_program(Builds& builds, const ComposedMethod& method) {
    return {builds, method, scene_of(three_bodies)};
}

void add_bodies(const ExtremeMethod& method, EdgeChapter& chapter) {
    add_pair(method, chapter);
    add_three(method, chapter);
}

}  // namespace hvi::gen
