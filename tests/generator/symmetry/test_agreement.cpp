// Statements on methods, against steps with all coefficients, in long double.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>

#include <catch2/catch.hpp>

#include "generator/exact/methods/number_stages.hpp"
#include "generator/symmetry/statements.hpp"
#include "tests/generator/hamiltonian/dual.hpp"
#include "tests/generator/symmetry/found.hpp"
#include "tests/generator/symmetry/planted.hpp"

using namespace hvi::gen;

namespace {

using Vector = std::vector<Real>;

Real real(const Number& number) { return std::stold(number.decimal(25)); }

/// The methods that a statement is compared with.
struct Tested {
    std::string name;
    KeepingFacts facts;
    std::vector<Vector> A, A_tilde;
    Vector b, b_tilde;
};

Tested tested(std::string name, const Method& method) {
    const DerivedMethod derived = derive_any(method);
    const PartitionedMethod pair =
        std::visit([](const auto& of) { return partitioned_method(of); }, derived);
    Tested result{std::move(name), keeping_facts(derived), {}, {}, {}, {}};
    const auto numbers = [](const NumberVector& of) {
        Vector values;
        for (const Number& number : of) values.push_back(real(number));
        return values;
    };
    for (const NumberVector& row : pair.A) result.A.push_back(numbers(row));
    for (const NumberVector& row : pair.A_tilde) result.A_tilde.push_back(numbers(row));
    result.b = numbers(pair.b);
    result.b_tilde = numbers(pair.b_tilde);
    return result;
}

const std::vector<Tested>& all_methods() {
    static const std::vector<Tested> methods = [] {
        std::vector<Tested> result;
        for (const char* name : {"midpoint", "gauss:2", "stormer-verlet", "lobatto:3",
                                 "chebyshev:3", "symplectic-euler"})
            result.push_back(tested(name, named_method(given("--method", name))));
        const auto general = [&](const char* basis, const char* nodes) {
            result.push_back(
                tested(std::string(basis) + " at " + nodes,
                       method_from_text(given("--basis", basis), given("--nodes", nodes))));
        };
        general("1, tau", "0, 1/2, 1");
        general("1, tau, tau^2", "gauss:4");
        return result;
    }();
    return methods;
}

struct Phase {
    Vector q, p;
};

/// H and the scene's parameters, to be stepped.
class Motion {
public:
    Motion(const Hamiltonian& hamiltonian, Point parameters)
        : hamiltonian_(hamiltonian), point_(std::move(parameters)) {}

    [[nodiscard]] Real value(const Expression& expression, const Phase& x) const {
        return evaluate(expression, at(x)).value;
    }

    /// Takes a step by iterations of the stages.
    [[nodiscard]] Phase step(const Tested& method, const Phase& x, Real h) const {
        const std::size_t s = method.b.size(), n = x.q.size();
        std::vector<Vector> V(s, Vector(n)), G(s, Vector(n));
        Real change = 1;
        for (int round = 0; round < 200 && change > 0; ++round) {
            change = 0;
            const std::vector<Vector> before_V = V, before_G = G;
            for (std::size_t i = 0; i < s; ++i) {
                Phase stage = x;
                for (std::size_t j = 0; j < s; ++j)
                    for (std::size_t k = 0; k < n; ++k) {
                        stage.q[k] += h * method.A[i][j] * before_V[j][k];
                        stage.p[k] -= h * method.A_tilde[i][j] * before_G[j][k];
                    }
                set_slopes(stage, V[i], G[i]);
                for (std::size_t k = 0; k < n; ++k)
                    change = std::max({change, std::abs(V[i][k] - before_V[i][k]),
                                       std::abs(G[i][k] - before_G[i][k])});
            }
            if (change < 1e-18L) break;
        }
        Phase next = x;
        for (std::size_t j = 0; j < s; ++j)
            for (std::size_t k = 0; k < n; ++k) {
                next.q[k] += h * method.b[j] * V[j][k];
                next.p[k] -= h * method.b_tilde[j] * G[j][k];
            }
        return next;
    }

private:
    [[nodiscard]] Point at(const Phase& x) const {
        Point point = point_;
        for (std::size_t k = 0; k < x.q.size(); ++k) {
            point[hamiltonian_.coordinates[k]] = {x.q[k]};
            point[hamiltonian_.momenta[k]] = {x.p[k]};
        }
        return point;
    }

    void set_slopes(const Phase& x, Vector& by_p, Vector& by_q) const {
        Point point = at(x);
        const auto slope = [&](const std::string& name) {
            Dual& variable = point[name];
            variable.slope = 1;
            const Real result = evaluate(hamiltonian_.expression, point).slope;
            variable.slope = 0;
            return result;
        };
        for (std::size_t k = 0; k < x.q.size(); ++k) {
            by_p[k] = slope(hamiltonian_.momenta[k]);
            by_q[k] = slope(hamiltonian_.coordinates[k]);
        }
    }

    const Hamiltonian& hamiltonian_;
    Point point_;
};

/// How often a statement was compared.
struct Count {
    std::size_t kept = 0, seen_to_depart = 0;
};

void compare(const WrittenOutScene& scene, const SceneSymmetries& found, const Point& parameters,
             const Phase& start, Real h, bool is_general_form_stepped, Count& count) {
    const auto& hamiltonian = std::get<Hamiltonian>(scene.mechanics);
    const Motion motion(hamiltonian, parameters);
    for (const Tested& method : all_methods()) {
        if (method.facts.is_general_form && !is_general_form_stepped) continue;
        Phase end = start;
        for (int step = 0; step < 10; ++step) end = motion.step(method, end, h);
        for (const Statement& statement : statements(found, method.facts)) {
            const Real before = motion.value(statement.expression, start);
            const Real drift = std::abs(motion.value(statement.expression, end) - before);
            INFO(found.name << "\n"
                            << method.name << ": " << statement.name << " = "
                            << to_text(statement.expression) << ", " << statement.reason);
            REQUIRE(std::isfinite(drift));
            if (statement.keeping == Keeping::kept) {
                CHECK(drift < 1e-15L * (1 + std::abs(before)));
                ++count.kept;
            } else if (drift > 1e-12L) {
                ++count.seen_to_depart;
            }
        }
    }
}

/// Products and sums of momentum maps, and their squares, as invariants of the scene.
void add_invariants(WrittenOutScene& scene, const SceneSymmetries& found) {
    const auto add = [&](Expression expression) {
        const auto source = std::make_shared<const Source>(Source{"I", to_text(expression)});
        const std::string name = "I" + std::to_string(scene.invariants.size());
        scene.invariants.push_back({name, std::move(expression), whole(source)});
    };
    const auto& basis = found.affine.basis;
    for (std::size_t i = 0; i < basis.size() && i < 2; ++i)
        add(Expression::product({basis[i].momentum_map, basis.back().momentum_map}));
    add(function_of(scene).expression);
}

}  // namespace

TEST_CASE("Statements agree with steps, on Hamiltonians with planted symmetries") {
    std::mt19937 random(20261125);
    Count count;
    std::size_t made = 0;
    while (made < 50)
        for (const Plan& plan : plans) {
            WrittenOutScene scene;
            scene.mechanics = hamiltonian_from_text(
                given("--hamiltonian", hidden(plan.hamiltonian, random_change(random))),
                given("--coordinates", "q1, q2, q3"), given("--momenta", "p1, p2, p3"));
            add_invariants(scene, symmetries_of(scene));
            const auto value = [&] { return Real(random() % 1000 + 200) / 2500; };
            const Phase start{{value(), value(), value()}, {value(), value(), value()}};
            compare(scene, symmetries_of(scene), {}, start, 1 / Real(100), plan.is_free, count);
            ++made;
        }
    CHECK(count.kept > 500);
    CHECK(count.seen_to_depart > 100);
}

TEST_CASE("Statements agree with steps, on the scenes that come with the program") {
    Count count;
    for (const char* name :
         {"kepler", "qp", "harmonic-oscillator", "henon-heiles", "nonseparable", "pendulum", "fpu",
          "double-pendulum", "point-vortices", "outer-solar-system"}) {
        const WrittenOutScene scene = unrolled(find_scene(given("scene", name)));
        Point parameters;
        for (const Parameter& parameter : scene.parameters)
            parameters[parameter.name] = evaluate(parameter.value, {});
        Phase start;
        const std::size_t n = function_of(scene).degrees_of_freedom();
        for (std::size_t i = 0; i < 2 * n; ++i)
            (i < n ? start.q : start.p)
                .push_back(evaluate(scene.initial[i].expression, parameters).value);
        const bool is_large = std::string(name) == "outer-solar-system";
        const bool is_free = std::string(name) != "qp" && std::string(name) != "nonseparable" &&
                             std::string(name) != "double-pendulum" &&
                             std::string(name) != "point-vortices";
        compare(scene, symmetries_of(scene), parameters, start, is_large ? 50 : 1 / Real(100),
                is_free, count);
    }
    CHECK(count.kept > 100);
    CHECK(count.seen_to_depart > 20);
}
