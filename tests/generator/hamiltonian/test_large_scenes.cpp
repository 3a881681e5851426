// The scenes of large systems, at small sizes, against the equations of motion as textbooks have
// them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/read/embedded.hpp"
#include "generator/read/put_in.hpp"
#include "generator/read/scene.hpp"
#include "generator/read/unroll.hpp"
#include "generator/read/written_out_scene.hpp"
#include "tests/generator/hamiltonian/dual.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

using Vector = std::vector<Real>;

const Real pi = std::acos(Real(-1));

/// A scene of a size, at some point.
class SmallScene {
public:
    SmallScene(const std::string& name, std::size_t size)
        : scene_(unrolled(
              find_scene(source(name, "SCENE"),
                         {parse_parameter(source("N=" + std::to_string(size), "--param"))}))) {
        for (const Parameter& parameter : scene_.parameters) {
            point_[parameter.name] = evaluate(parameter.value, {});
        }
    }

    void go_to_start() {
        const Point parameters = point_;
        for (const NamedExpression& value : scene_.initial) {
            point_[value.name] = evaluate(value.expression, parameters);
        }
    }

    void go_anywhere() {
        Real value = 0.3L;
        for (const std::string& name : variables(scene_)) {
            point_[name] = {value = 1.7L - 1.13L * value};
        }
    }

    [[nodiscard]] const Hamiltonian& H() const { return hamiltonian_of(scene_); }
    [[nodiscard]] Real energy() const { return evaluate(H().expression, point_).value; }
    [[nodiscard]] Real operator()(const std::string& name) const { return point_.at(name).value; }
    [[nodiscard]] Vector q() const { return values(H().coordinates); }
    [[nodiscard]] Vector p() const { return values(H().momenta); }

    /// p' = -dH/dq, and q' = p/mass.
    void check_motion(const Vector& forces, Real mass = 1) {
        const std::size_t n = H().degrees_of_freedom();
        REQUIRE(forces.size() == n);
        for (std::size_t k = 0; k < n; ++k) {
            CAPTURE(scene_.name, n, H().coordinates[k]);
            CHECK(std::abs(derivative(H().coordinates[k]) + forces[k]) <
                  1e-15L * (1 + std::abs(forces[k])));
            CHECK(std::abs(derivative(H().momenta[k]) - p()[k] / mass) <
                  1e-15L * (1 + std::abs(p()[k] / mass)));
        }
    }

private:
    [[nodiscard]] Vector values(const std::vector<std::string>& names) const {
        Vector result;
        for (const std::string& name : names) { result.push_back(point_.at(name).value); }
        return result;
    }

    [[nodiscard]] Real derivative(const std::string& name) const {
        Point point = point_;
        point.at(name).slope = 1;
        return evaluate(H().expression, point).slope;
    }

    WrittenOutScene scene_;
    Point point_;
};

/// Forces on a ring by the values at a site's left, at itself and at its right.
Vector on_ring(const Vector& u, const std::function<Real(Real, Real, Real)>& force) {
    const std::size_t n = u.size();
    Vector forces;
    for (std::size_t i = 0; i < n; ++i) {
        forces.push_back(force(u[(i + n - 1) % n], u[i], u[(i + 1) % n]));
    }
    return forces;
}

/// Forces between bodies, `slope` being twice the derivative of their potential by the square of
/// their distance; `q` are all x, then all y, and so on.
Vector pair_forces(const Vector& q, std::size_t bodies,
                   const std::function<Real(Real square)>& slope) {
    Vector forces(q.size());
    for (std::size_t i = 0; i < bodies; ++i) {
        for (std::size_t j = 0; j < bodies; ++j) {
            if (i == j) { continue; }
            Real square = 0;
            for (std::size_t k = 0; k < q.size(); k += bodies) {
                square += (q[k + i] - q[k + j]) * (q[k + i] - q[k + j]);
            }
            for (std::size_t k = 0; k < q.size(); k += bodies) {
                forces[k + i] += slope(square) * (q[k + j] - q[k + i]);
            }
        }
    }
    return forces;
}

/// Between bodies of mass m each.
Vector gravity(const Vector& q, std::size_t bodies, Real m, Real eps) {
    return pair_forces(q, bodies, [&](Real square) {
        const Real softened = square + eps * eps;
        return m * m / (softened * std::sqrt(softened));
    });
}

}  // namespace

TEST_CASE("a chain between fixed ends") {
    for (const std::size_t n : {1U, 2U, 5U}) {
        SmallScene scene("fpu-chain", n);
        scene.go_anywhere();
        Vector q = scene.q(), forces;
        q.insert(q.begin(), 0);
        q.push_back(0);
        const auto tension = [](Real r) { return r + r * r / 4; };  // alpha = 1/4, beta = 0
        for (std::size_t i = 1; i <= n; ++i) {
            forces.push_back(tension(q[i + 1] - q[i]) - tension(q[i] - q[i - 1]));
        }
        scene.check_motion(forces);
    }
}

TEST_CASE("a chain begins in its lowest mode") {
    SmallScene scene("fpu-chain", 31);  // as in the report of 1955
    scene.go_to_start();
    for (std::size_t i = 1; i <= 31; ++i) {
        CHECK(std::abs(scene("q[" + std::to_string(i) + "]") -
                       std::sin(pi * static_cast<Real>(i) / 32)) < 1e-17L);
    }
}

TEST_CASE("rings") {
    for (const std::size_t n : {3U, 8U}) {
        SmallScene toda("toda-ring", n);
        toda.go_anywhere();
        toda.check_motion(on_ring(toda.q(), [](Real left, Real q, Real right) {
            return std::exp(left - q) - std::exp(q - right);
        }));
        for (const char* name : {"sine-gordon", "phi4-chain"}) {
            SmallScene field(name, n);
            field.go_anywhere();
            const Real a = 40 / static_cast<Real>(n);
            const bool is_sine = std::string(name) == "sine-gordon";
            field.check_motion(on_ring(field.q(), [&](Real left, Real u, Real right) {
                return (left - 2 * u + right) / (a * a) + (is_sine ? -std::sin(u) : u - u * u * u);
            }));
        }
    }
}

TEST_CASE("fields on a torus") {
    constexpr std::size_t n = 4;
    for (const char* name : {"phi4-plane", "sine-gordon-plane"}) {
        SmallScene scene(name, n);
        scene.go_anywhere();
        const Vector u = scene.q();
        const auto at = [&](std::size_t i, std::size_t j) { return u[i % n * n + j % n]; };
        const bool is_sine = std::string(name) == "sine-gordon-plane";
        const Real a = 8;
        Vector forces;
        for (std::size_t i = n; i < 2 * n; ++i) {
            for (std::size_t j = n; j < 2 * n; ++j) {
                const Real here = at(i, j);
                const Real around = at(i - 1, j) + at(i + 1, j) + at(i, j - 1) + at(i, j + 1);
                forces.push_back((around - 4 * here) / (a * a) +
                                 (is_sine ? -std::sin(here) : here - here * here * here));
            }
        }
        scene.check_motion(forces);
    }
}

TEST_CASE("bodies") {
    SmallScene stars("plummer", 5);
    stars.go_anywhere();
    stars.check_motion(gravity(stars.q(), 5, 0.2L, 0.02L), 0.2L);

    SmallScene ring("ring-of-bodies", 6);
    ring.go_anywhere();
    const Real m = 1 / Real(216);
    const Vector q = ring.q();
    Vector forces = gravity(q, 6, m, 0);
    for (std::size_t i = 0; i < 6; ++i) {
        const Real r = std::hypot(q[i], q[6 + i]);
        forces[i] -= m * q[i] / (r * r * r);
        forces[6 + i] -= m * q[6 + i] / (r * r * r);
    }
    ring.check_motion(forces, m);
}

TEST_CASE("atoms") {
    const auto slope = [](Real s) { return 4 * (3 * std::pow(s, -4) - 6 * std::pow(s, -7)); };
    SmallScene cluster("lennard-jones-38", 5);
    cluster.go_anywhere();
    cluster.check_motion(
        pair_forces(cluster.q(), 5, [&](Real square) { return 2 * slope(square); }));

    const Real cut = 6.25L, curvature = 4 * (42 * std::pow(cut, -8) - 12 * std::pow(cut, -5));
    std::size_t near = 0, far = 0;
    SmallScene droplet("droplet", 6);
    droplet.go_anywhere();
    droplet.check_motion(pair_forces(droplet.q(), 6, [&](Real square) {
        ++(square < cut ? near : far);
        return square < cut ? 2 * (slope(square) - slope(cut) - curvature * (square - cut)) : 0;
    }));
    CHECK(near > 0);
    CHECK(far > 0);
}

TEST_CASE("Maxwell's ring turns as a whole") {
    // Towards the middle there are 1 of the planet, and m/(4 sin(pi k/N)) of the k-th neighbour.
    constexpr std::size_t n = 7;
    SmallScene ring("ring-of-bodies", n);
    ring.go_to_start();
    const Real m = 1 / Real(n * n * n);
    Real square = 1;
    for (std::size_t k = 1; k < n; ++k) { square += m / 4 / std::sin(pi * Real(k) / n); }
    Vector forces;
    for (const Real q : ring.q()) { forces.push_back(-m * square * q); }
    ring.check_motion(forces, m);
    for (std::size_t k = 0; k < n; ++k) {
        CHECK(std::abs(ring.p()[k] + m * std::sqrt(square) * ring.q()[n + k]) < 1e-18L);
        CHECK(std::abs(ring.p()[n + k] - m * std::sqrt(square) * ring.q()[k]) < 1e-18L);
    }
}

TEST_CASE("energies at the start") {
    SmallScene toda("toda-ring", 20);
    toda.go_to_start();
    CHECK(std::abs(toda.energy() - 5) < 1e-17L);  // of sin^2/2
    // The breather has the energy 16 eta. That a sum takes the place of an integral of 8
    // eta^2/cosh^2 is, by Poisson's formula, an error of 16 pi k/sinh(pi k/(2 eta)) with k = 2
    // pi/a: 1.2e-5.
    SmallScene breather("sine-gordon", 64);
    breather.go_to_start();
    CHECK(std::abs(40 / Real(64) * breather.energy() - 16 * std::sqrt(0.75L)) < 2e-5L);
    // Two kinks of mass 2 sqrt(2)/3 with the velocity 3/10. Differences make it an error of a^2.
    SmallScene kinks("phi4-chain", 64);
    kinks.go_to_start();
    const Real mass = 2 * std::sqrt(Real(2)) / 3 / std::sqrt(0.91L);
    CHECK(std::abs(40 / Real(64) * kinks.energy() / (2 * mass) - 1) < 0.05L);
}

// NOTE: the rules for initial values need no scene of a thousand stars that is written out.
TEST_CASE("Plummer's sphere is in equilibrium") {
    constexpr long n = 1000;
    const auto initial = [] {
        for (const EmbeddedFile& file : embedded_scenes()) {
            if (file.name == "plummer.toml") {
                return scene_from_toml({"plummer.toml", std::string(file.text)});
            }
        }
        throw std::runtime_error("no such scene");
    }();
    Definitions definitions;
    for (const Definition& definition : initial.definitions) { definitions.add(definition); }
    std::array<Vector, 6> all;  // x, y, z, and momenta
    for (std::size_t k = 0; k < 6; ++k) {
        const auto& rule = std::get<ValueRule>(initial.initial->values.at(k).value);
        const IndexedExpression whole = definitions.put_in(rule.value);
        for (long i = 1; i <= n; ++i) {
            const Expression value = unrolled(whole, {{"i", i}, {"N", n}});
            all[k].push_back(evaluate(value, {{"m", {1 / Real(n)}}}).value);
        }
    }
    const auto square = [&](std::size_t from, std::size_t i) {
        return all[from][i] * all[from][i] + all[from + 1][i] * all[from + 1][i] +
               all[from + 2][i] * all[from + 2][i];
    };
    Real kinetic = 0, potential = 0, mean_radius_of_half = 0;
    Vector escaping, momentum(3);
    for (std::size_t i = 0; i < n; ++i) {
        kinetic += n * square(3, i) / 2;
        for (std::size_t k = 0; k < 3; ++k) { momentum[k] += all[3 + k][i]; }
        const Real escape = 2 / std::sqrt(1 + square(0, i));
        if (n * n * square(3, i) >= escape) { escaping.push_back(escape); }
        if (i == n / 2) { mean_radius_of_half = std::sqrt(square(0, i)); }
        for (std::size_t j = 0; j < i; ++j) {
            Real distance = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                distance += (all[k][i] - all[k][j]) * (all[k][i] - all[k][j]);
            }
            potential -= 1 / std::sqrt(distance) / (n * n);
        }
    }
    CHECK(std::abs(kinetic / (3 * pi / 64) - 1) < 0.05L);
    CHECK(std::abs(potential / (-3 * pi / 32) - 1) < 0.05L);
    CHECK(std::abs(mean_radius_of_half - 1.3048L) < 0.01L);  // 1/sqrt(2^(2/3) - 1)
    CHECK(escaping.empty());
    // At random it would be 0.01 in each direction.
    for (const Real part : momentum) { CHECK(std::abs(part) < 0.01L); }
}
