// The derivatives of H that steppers evaluate, by the rules of the graph and by functions.def,
// against those of GiNaC, which has rules of its own.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/expr/functions.hpp"
#include "generator/graph/written.hpp"
#include "generator/hamiltonian/gradient.hpp"
#include "generator/lower/system.hpp"
#include "generator/read/parse.hpp"
#include "generator/read/written_out_scene.hpp"
#include "generator/scene/value_at.hpp"
#include "tests/generator/hamiltonian/hamiltonians.hpp"
#include "tests/generator/read/refusal.hpp"
#include "tests/generator/read/small_scene.hpp"

using namespace hvi::gen;

namespace {

constexpr Precision bits = 256;

/// Values of all nodes of a graph, each once, as enclosures of some 75 digits.
class Values {
public:
    Values(const Graph& graph, const SymbolValues& inputs) {
        for (Node node = 0; node < graph.size(); ++node) {
            nodes_.push_back(value(graph.at(node), inputs));
        }
    }

    [[nodiscard]] Ball operator()(const Scaled& a) const {
        Ball result = nodes_.at(a.node);
        arb_mul_si(result.get(), result.get(), a.factor.above, bits);
        arb_div_si(result.get(), result.get(), a.factor.below, bits);
        return result;
    }

private:
    [[nodiscard]] Ball value(const Computation& computation, const SymbolValues& inputs) const {
        if (computation.operation == Operation::constant) {
            return value_at(computation.constant, {}, nullptr);
        }
        if (computation.operation == Operation::input) {
            // NOTE: the inputs of directions, which no gradient has, are in no Hamiltonian.
            const auto found = inputs.find(computation.name);
            return found == inputs.end() ? Ball() : found->second;
        }
        SymbolValues operands;
        std::vector<Expression> names;
        const auto add = [&](Ball operand) {
            names.push_back(Expression::symbol("x" + std::to_string(names.size())));
            operands[names.back().name] = std::move(operand);
        };
        for (const Scaled& term : computation.terms) { add((*this)(term)); }
        for (const Node argument : computation.arguments) { add(nodes_.at(argument)); }
        return value_at(of_operation(computation, names), operands, nullptr);
    }

    std::vector<Ball> nodes_;
};

/// Returns different coordinates and momenta in (0, 1), and parameters unless H gives them values.
SymbolValues point(const Hamiltonian& H, int trial) {
    SymbolValues values;
    int number = 11 + 37 * trial;
    const auto add = [&](const std::string& name) {
        values[name] =
            ball_of_rational(std::to_string(number = number * 11 % 1009) + "/1013", bits);
    };
    for (const std::string& name : variables(H)) { add(name); }
    for (const std::string& name : parameter_names(H)) { add(name); }
    for (const Parameter& known : H.parameters) {
        values[known.name] = value_at(known.value, {}, nullptr);
    }
    add("t");
    return values;
}

bool agree(const Ball& a, const Ball& b) {
    constexpr slong digits = 50;
    const bool are_narrow = arb_rel_accuracy_bits(a.get()) > digits * 10 / 3 || a.sign() == 0;
    return arb_is_finite(a.get()) != 0 && are_narrow && arb_overlaps(a.get(), b.get()) != 0 &&
           mag_cmp_2exp_si(arb_radref(a.get()), -150) < 0 &&
           mag_cmp_2exp_si(arb_radref(b.get()), -150) < 0;
}

std::vector<Scaled> both(const std::vector<Scaled>& by_q, const std::vector<Scaled>& by_p) {
    std::vector<Scaled> result = by_q;
    result.insert(result.end(), by_p.begin(), by_p.end());
    return result;
}

std::vector<Expression> both(const Gradient& gradient) {
    std::vector<Expression> result = gradient.by_coordinates;
    result.insert(result.end(), gradient.by_momenta.begin(), gradient.by_momenta.end());
    return result;
}

void check_values(const Hamiltonian& H, const Graph& graph, const std::vector<Scaled>& found,
                  const std::vector<Expression>& expected) {
    REQUIRE(found.size() == expected.size());
    for (int trial = 0; trial < 3; ++trial) {
        const SymbolValues at = point(H, trial);
        const Values values(graph, at);
        for (std::size_t i = 0; i < found.size(); ++i) {
            CAPTURE(to_text(H.expression), i, to_text(expected[i]), trial);
            CHECK(agree(values(found[i]), value_at(expected[i], at, nullptr)));
        }
    }
}

void check_first(const Hamiltonian& H) {
    const System system = system_of(H, parameter_names(H));
    check_values(H, system.graph, both(by_coordinates(system), by_conjugates(system)),
                 both(gradient(H)));
}

/// Second derivatives: GiNaC's of its first ones.
void check_second(const Hamiltonian& H) {
    const System system = system_of(H, parameter_names(H));
    const Hessian& found = hessian_of(system);
    const Gradient first = gradient(H);
    const auto again = [&](const Expression& derivative) {
        Hamiltonian slope = H;
        slope.expression = derivative;
        return gradient(slope);
    };
    for (std::size_t i = 0; i < H.degrees_of_freedom(); ++i) {
        check_values(H, system.graph, both(found.qq[i], found.mixed[i]),
                     both(again(first.by_coordinates[i])));
        check_values(H, system.graph, found.conjugates[i], again(first.by_momenta[i]).by_momenta);
    }
}

/// Whether all first derivatives are proved to be equal in a field in which all symbols are free. A
/// proved difference fails the test.
bool are_proved_same(const Hamiltonian& H) {
    const System system = system_of(H, parameter_names(H));
    const std::vector<Scaled> found = both(by_coordinates(system), by_conjugates(system));
    const std::vector<Expression> expected = both(gradient(H));
    bool all = true;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Expression difference = Expression::sum(
            {written(system.graph, found[i]).value(), Expression::negation(expected[i])});
        CAPTURE(to_text(difference));
        try {
            const bool is_zero = on_new_ground([&](const Ground& ground) {
                const Number rest = evaluate_number(difference, nullptr, ground);
                if (is_exact(rest)) { CHECK(rest.is_zero()); }
                return is_exact(rest) && rest.is_zero();
            });
            all = all && is_zero;
        } catch (const Error&) { all = false; }
    }
    return all;
}

bool is_analytic_of_one(const Function& function) {
    return function.nature == Nature::analytic && function.arguments == 1 &&
           !is_hidden(function.name);
}

Hamiltonian hamiltonian_of_text(const std::string& text) {
    return hamiltonian_from_text(source(text));
}

}  // namespace

// NOTE: the graph makes half powers of roots, and has no use for the row of sqrt.
TEST_CASE("the derivative that each function has in the table is that of GiNaC") {
    for (const Function& function : functions()) {
        if (!is_analytic_of_one(function)) { continue; }
        const std::string f(function.name);
        const bool is_from_one = function.domain == RealDomain::from_one;
        const Hamiltonian H = hamiltonian_of_text(f + (is_from_one ? "(1+q)+p" : "(q)+p"));
        const Expression in_table = parse_expression(source(std::string(function.derivative)));
        const Expression expected = gradient(H).by_coordinates.at(0);
        for (int trial = 0; trial < 3; ++trial) {
            SymbolValues at = point(H, trial);
            at["x"] = value_at(parse_expression(source(is_from_one ? "1+q" : "q")), at, nullptr);
            at["y"] = value_at(Expression::call(f, {Expression::symbol("x")}), at, nullptr);
            CAPTURE(f, to_text(in_table), to_text(expected), trial);
            CHECK(agree(value_at(in_table, at, nullptr), value_at(expected, at, nullptr)));
        }
    }
}

TEST_CASE("both derivatives of each function agree, and the second ones") {
    std::size_t count = 0;
    for (const Function& function : functions()) {
        if (!is_analytic_of_one(function)) { continue; }
        const std::string f(function.name);
        const std::string x = function.domain == RealDomain::from_one ? "1+" : "";
        for (const std::string& H :
             {f + "(" + x + "q/2+p/3)*p", f + "(" + x + "a*q*p)^2+" + f + "(" + x + "p/2)",
              "p^2/(2+" + f + "(" + x + "q*p))", "1/" + f + "(" + x + "q)^3+p*q"}) {
            check_first(hamiltonian_of_text(H));
            check_second(hamiltonian_of_text(H));
        }
        ++count;
    }
    CHECK(count == 19);
}

TEST_CASE("both derivatives of many Hamiltonians agree, most of them by proof") {
    std::size_t proved = 0, all = 0;
    const auto check = [&](const char* text) {
        check_first(hamiltonian_of_text(text));
        proved += are_proved_same(hamiltonian_of_text(text)) ? 1U : 0U;
        ++all;
    };
    for (const char* const text : hamiltonians) { check(text); }
    for (const char* const text :
         {"(p^2+q^2)^(-1/2)+1/(p^2+q^2)^(3/2)", "p^2*(1+t^2)/2 + q*sin(w*t)", "(q^4-1)/(q^2-1)+p^2",
          "(sin(q)^2+cos(q)^2)*p^2/2"}) {
        check(text);
    }
    CHECK(all == 34);
    CHECK(proved >= 21);
}

TEST_CASE("both derivatives of the scenes that come with the program agree") {
    for (const SceneEntry& entry : scenes()) {
        const WrittenOutScene scene = small_scene(entry);
        const auto* H = std::get_if<Hamiltonian>(&scene.mechanics);
        if (H == nullptr || !H->rotations.empty()) { continue; }
        check_first(*H);
        if (H->degrees_of_freedom() <= 4) { check_second(*H); }
    }
}

TEST_CASE("functions of several arguments, and those with kinks") {
    for (const char* text : {"atan2(q,p)+atan2(-q,p-2)", "abs(q-1/2)*p^2", "sign(p-1/2)*q^3",
                             "min(q,p)^2+max(q*p,1/3)", "if(q<p,q^3,p^2*q)",
                             "if(q<=1/2,sqrt(q),p)*q", "if(q<0,q^2,p^3)+max(sqrt(p),q)"}) {
        const Hamiltonian H = hamiltonian_of_text(text);
        check_first(H);
        check_second(H);
    }
}
