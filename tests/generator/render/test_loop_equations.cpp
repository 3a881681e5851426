// Equations with indices, as they are printed, against derivatives of what is written out.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "generator/read/method.hpp"
#include "generator/read/scene.hpp"
#include "generator/read/unroll.hpp"
#include "generator/render/equations.hpp"
#include "tests/generator/hamiltonian/dual.hpp"
#include "tests/generator/read/refusal.hpp"
#include "tests/generator/render/output.hpp"

using namespace hvi::gen;

namespace {

using ReadJson = nlohmann::ordered_json;

Scene scene_of_chain(const std::string& hamiltonian, const std::string& variables,
                     const std::string& momenta, const std::string& parameters = "") {
    const auto listed = [](const std::string& names) {
        std::string text = "[";
        for (const char c : names) text += c == ';' ? std::string("\", \"") : std::string(1, c);
        return text.insert(1, "\"") + "\"]";
    };
    std::string toml = "coordinates = " + listed(variables) + "\nmomenta = " + listed(momenta) +
                       "\nhamiltonian = \"" + hamiltonian + "\"\n[parameters]\nN = 5\n" +
                       parameters + "[initial]\n";
    for (const std::string& names : {variables, momenta}) {
        std::string rest = names + ";";
        while (!rest.empty()) {
            const std::string name = rest.substr(0, rest.find(';'));
            rest.erase(0, name.size() + 1);
            const std::string stem = name.substr(0, name.find('['));
            const bool has_two = name.find(',') != std::string::npos;
            toml += "\"" + stem + (stem == name ? "" : has_two ? "[i,j]" : "[i]") + "\" = 1\n";
        }
    }
    return scene_from_toml({"chain.toml", toml});
}

Scene named_scene(const std::string& name) {
    return find_scene(source(name, "SCENE"), {parse_parameter(source("N=5", "--param"))});
}

/// A scene with its sums written out, at a point.
class WrittenOut {
public:
    explicit WrittenOut(const Scene& scene) : scene_(unrolled(scene)) {
        Real value = 0.3L;
        const auto next = [&] { return Dual{value = 1.7L - 1.13L * value}; };
        for (const std::string& name : variables(scene_)) point[name] = next();
        for (const Parameter& parameter : scene_.parameters) point[parameter.name] = next();
        point["t"] = next();
        point["h"] = {0.1L};
    }

    [[nodiscard]] const Hamiltonian& H() const { return std::get<Hamiltonian>(scene_.mechanics); }
    [[nodiscard]] Real derivative(const std::string& variable, Point at) const {
        at.at(variable).slope = 1;
        return evaluate(H().expression, at).slope;
    }

    Point point;

private:
    WrittenOutScene scene_;
};

/// A printed text with these values of its indices and sizes.
Expression at_indices(const std::string& printed, const WholeNumbers& known) {
    return unrolled(parse_indexed_expression(source(printed)), known);
}

long whole_value_of(const std::string& printed, const WholeNumbers& known) {
    return std::lround(evaluate(at_indices("0+" + printed, known), {}).value);
}

/// Whether the indices are in a range such as `k=2..N`, or `k=1`.
bool is_within(const std::string& range, const WholeNumbers& known) {
    const std::string index = range.substr(0, range.find('='));
    const std::string bounds = range.substr(index.size() + 1);
    const std::size_t dots = bounds.find("..");
    const long k = known.at(index);
    const std::string last = dots == std::string::npos ? bounds : bounds.substr(dots + 2);
    return whole_value_of(bounds.substr(0, dots), known) <= k && k <= whole_value_of(last, known);
}

/// The sum of the printed terms of a derivative.
Real value_of_slope(const ReadJson& terms, const WholeNumbers& known, const Point& point) {
    Real sum = 0;
    for (const ReadJson& term : terms) {
        bool counts = true;
        for (const ReadJson& range : term.at("where"))
            counts = counts && is_within(range.get<std::string>(), known);
        if (!counts) continue;
        sum += evaluate(at_indices(term.at("value").get<std::string>(), known), point).value;
    }
    return sum;
}

/// The index of `x[3]` or `u[2,3]`.
std::vector<long> index_of(const std::string& variable) {
    std::vector<long> result;
    for (std::size_t k = variable.find('['); k < variable.size(); k = variable.find(',', k + 1))
        result.push_back(std::stol(variable.substr(k + 1)));
    return result;
}

std::string stem_of(const std::string& variable) { return variable.substr(0, variable.find('[')); }

/// All derivatives of the scene as it is printed, at each of its variables.
void check_derivatives(const Scene& scene, const std::string& method = "midpoint") {
    const LoopEquations step = loop_equations(named_method(source(method, "--method")), scene, {});
    const ReadJson json = ReadJson::parse(render_json(step));
    CHECK(json.at("schema") == "hvi-scheme-loops/1");
    const WrittenOut expected(scene);
    WholeNumbers known;
    for (const auto& [name, value] : json.at("values").items())
        known[name] = std::stol(value.get<std::string>());
    for (const std::string& variable : variables(expected.H())) {
        const std::vector<long> index = index_of(variable);
        std::string name = "dH_d" + stem_of(variable);
        for (std::size_t d = 0; d < index.size(); ++d) {
            const std::string letter = json.at("indices").at(d);
            known[letter] = index[d];
            name += (d == 0 ? "[" : ",") + letter;
        }
        if (!index.empty()) name += "]";
        const ReadJson terms = json.at("derivatives").value(name, ReadJson::array());
        const Real found = value_of_slope(terms, known, expected.point);
        const Real right = expected.derivative(variable, expected.point);
        CAPTURE(variable, name, terms.dump(1));
        CHECK(std::abs(found - right) < 1e-15L * (1 + std::abs(right)));
    }
}

}  // namespace

TEST_CASE("printed derivatives of scenes are those of what is written out") {
    for (const char* name : {"fpu-chain", "phi4-chain", "phi4-plane", "ring-of-bodies", "toda-ring",
                             "sine-gordon-plane", "plummer", "lennard-jones-38", "droplet"}) {
        CAPTURE(name);
        check_derivatives(named_scene(name));
    }
}

TEST_CASE("printed derivatives of sums of all kinds are those of what is written out") {
    const std::string T = "sum(i=1..N, p[i]^2/(2+i))";
    for (const std::string U :
         {"sum(i=1..N-1, p[i]^2*x[i+1]^2*sin(x[i]) + i*p[i+1]*p[i]*x[i+1])",  // nonseparable
          "sum(i=1..N, sum(j=1..N, sin(x[i]*x[j]+i*j)))",
          "sum(i=2..N, sum(j=1..i-1, i*exp(x[i]-2*x[j])))",
          "sum(i=1..N-2, sum(j=i+1..i+2, (x[i]-x[j])^4/i))",  // which of two bounds depends on k
          "sum(i=1..N-2, sum(j=i+1..i+2, sum(l=j..N, cos(x[i]+2*x[j]-x[l]*j))))",
          "sum(i=1..N, x[i]^2*x[N+1-i])", "sum(i=1..N, x[mod(N-i,N)+1]*exp(x[i]/3))",
          "sum(i=0..N-1, sin(x[mod(i+N-2,N)+1]-x[i+1])*x[mod(i+1,N)+1])",
          "sum(i=1..N, sum(j=1..N, x[j]*cos(x[mod(i+1,N)+1])))", "x[1]*x[2]^3*x[N]^2 + x[3]^4",
          "sum(i=1..N, cos(t)*m[i]*x[i]^3*m[N+1-i])*a", "sum(i=1..3, sum(j=4..N, x[i]^2*x[j]))",
          "sum(i=1..2, sum(j=1..2, sin(x[i+j])*x[i]))", "sum(k=1..N, sum(l=1..k, x[k]*x[l]^3))"}) {
        CAPTURE(U);
        check_derivatives(
            scene_of_chain(T + " + " + U, "x[1..N]", "p[1..N]", "a = 2\nm = [1, 2, 3, 4, 5]\n"));
    }
}

TEST_CASE("printed derivatives of several families are those of what is written out") {
    check_derivatives(
        scene_of_chain("sum(i=1..N, p[i]^2/2 + r[N+i]^2/3 + x[i]^2*z[N+i]*s^2) + ps^2*s + z[N+2]^3",
                       "x[1..N];z[N+1..2*N];s", "p[1..N];r[N+1..2*N];ps"));
    check_derivatives(scene_of_chain(
        "sum(i=1..N, j=1..3, v[i,j]^2/2 + u[i,j]^4*i/j) + sum(i=1..3, u[i,i]^3 + u[N,i]^2)"
        " + sum(i=1..N-1, j=1..2, cos(u[i,j+1]-u[i+1,j]))"
        " + sum(i=1..3, j=i..3, u[j,i]*u[i,j]^2 + u[j,j-i+1]^3)",
        "u[1..N,1..3]", "v[1..N,1..3]"));
}

namespace {

/// Right sides of equations for an index k, where values in stages are any.
class AtIndex {
public:
    AtIndex(const WrittenOut& scene, const Point& stages, long k)
        : scene_(scene), point_(scene.point), index_("[" + std::to_string(k) + "]") {
        for (const auto& [name, value] : stages) point_[name] = value;
    }

    [[nodiscard]] std::string element(const std::string& name) const {
        const std::size_t begin = name.find("[k]");
        return begin == std::string::npos ? name : name.substr(0, begin) + index_;
    }

    [[nodiscard]] Real operator()(const Expression& right) {
        return evaluate(with_numbers(right), point_).value;
    }

private:
    /// The slopes `dH_dx[k](X_1)` become symbols that have a value.
    [[nodiscard]] Expression with_numbers(Expression expression) {
        using Kind = Expression::Kind;
        if (expression.kind == Kind::symbol) return Expression::symbol(element(expression.name));
        if (expression.kind == Kind::call && expression.name.starts_with("dH_d")) {
            const std::string name = to_text(expression) + index_;
            point_[name] = {slope(element(expression.name.substr(4)), expression.arguments)};
            return Expression::symbol(name);
        }
        for (Expression& argument : expression.arguments)
            argument = with_numbers(std::move(argument));
        return expression;
    }

    /// Returns the derivative by a variable, where the families have the values `X_1[1]`, `X_1[2]`,
    /// ...
    [[nodiscard]] Real slope(const std::string& variable, const std::vector<Expression>& stages) {
        Point at = scene_.point;
        for (const Expression& stage : stages) {
            const auto family = static_cast<char>(stage.name[0] - 'A' + 'a');
            for (auto& [name, value] : at) {
                if (name[0] == family) value = point_.at(stage.name + name.substr(1));
            }
        }
        return scene_.derivative(variable, at);
    }

    const WrittenOut& scene_;
    Point point_;
    std::string index_;
};

/// Checks that the values in stages and at the end, for any values in stages, equal those by the
/// equations of the written-out scene.
void check_stages(const std::string& method, const Scene& scene) {
    const Method read = named_method(source(method, "--method"));
    const LoopEquations step = loop_equations(read, scene, {});
    const WrittenOut written(scene);
    const StepEquations expected = step_equations(read, written.H(), false);
    REQUIRE(expected.stages);
    CHECK(step.stages.is_explicit == expected.stages->is_explicit);
    Point stages;
    Real value = 0.4L;
    for (int stage = 1; stage <= 4; ++stage) {
        stages["T_" + std::to_string(stage)] = {value = 1.6L - 1.07L * value};
        for (const std::string& name : variables(written.H())) {
            std::string in_stage(1, static_cast<char>(name[0] - 'a' + 'A'));
            in_stage += "_" + std::to_string(stage) + name.substr(1);
            stages[in_stage] = {value = 1.6L - 1.07L * value};
        }
    }
    Point found, all = written.point;
    all.insert(stages.begin(), stages.end());
    for (long k = 1; k <= 5; ++k) {
        AtIndex at_index(written, stages, k);
        for (const auto* equations : {&step.stages.stages, &step.stages.update})
            for (const Equation& equation : *equations)
                found[at_index.element(equation.left)] = {at_index(equation.right)};
    }
    for (const auto* equations : {&expected.stages->stages, &expected.stages->update})
        for (const Equation& equation : *equations) {
            const Real right = evaluate(equation.right, all).value;
            CAPTURE(method, equation.left, to_text(equation.right));
            REQUIRE(found.count(equation.left) != 0);
            CHECK(std::abs(found.at(equation.left).value - right) < 1e-15L * (1 + std::abs(right)));
        }
}

}  // namespace

TEST_CASE("stages with indices are those of what is written out") {
    for (const char* method : {"midpoint", "stormer-verlet", "gauss:2", "gauss:4", "lobatto:3"}) {
        check_stages(method, named_scene("fpu-chain"));
        check_stages(method, named_scene("phi4-chain"));
        check_stages(method, scene_of_chain("sum(i=1..N, p[i]^2*(1+cos(t)*q[i]^2))"
                                            " + sum(i=1..N-1, p[i]*q[i+1]^3)",
                                            "q[1..N]", "p[1..N]"));
    }
}

TEST_CASE("a chain's step fits on a page, whatever its length") {
    const auto lines = [](const std::string& text) {
        return std::count(text.begin(), text.end(), '\n');
    };
    const Scene scene =
        find_scene(source("fpu-chain", "SCENE"), {parse_parameter(source("N=1000000", "--param"))});
    for (const char* method : {"midpoint", "stormer-verlet", "gauss:2", "gauss:3"}) {
        const LoopEquations step =
            loop_equations(named_method(source(method, "--method")), scene, {});
        CAPTURE(method, render_text(step));
        CHECK(lines(render_text(step)) < 60);
        CHECK(lines(render_latex(step)) < 60);
    }
}

TEST_CASE("equations with indices for people, programs and papers") {
    const Scene scene = scene_of_chain("sum(i=1..N, p[i]^2/2) + sum(i=1..N-1, cos(q[i+1]-q[i])/a)",
                                       "q[1..N]", "p[1..N]", "a = 3\n");
    const LoopEquations step =
        loop_equations(named_method(source("midpoint", "--method")), scene, {});
    CHECK(render_text(step) == R"(midpoint

hamiltonian   sum(i=1..N,p[i]^2/2)+sum(i=1..N-1,cos(q[i+1]-q[i])/a)
coordinates   q[1..N]
momenta       p[1..N]
parameters    a
values        N = 5

stages for all k, to be solved together:

 Q_1[k] = q[k]+h*dH_dp[k](P_1)/2
 P_1[k] = p[k]-h*dH_dq[k](Q_1)/2

and with them:

 q[k]' = q[k]+h*dH_dp[k](P_1)
 p[k]' = p[k]-h*dH_dq[k](Q_1)

derivatives of H, of which the stages have those at their values:

 dH_dp[k] = p[k]
 dH_dq[k] = -sin(q[k]-q[k-1])/a  for k=2..N
            +sin(q[k+1]-q[k])/a  for k=1..N-1
)");
    const ReadJson json = ReadJson::parse(render_json(step));
    CHECK(json.at("coordinates") == ReadJson({"q[1..N]"}));
    CHECK(json.at("momenta") == ReadJson({"p[1..N]"}));
    CHECK(json.at("indices") == ReadJson({"k"}));
    CHECK(json.at("parameters") == ReadJson({"a"}));
    CHECK(json.at("explicit") == false);
    CHECK(json.at("exact") == true);
    CHECK(json.at("stages").at(3) == "p[k]' = p[k]-h*dH_dq[k](Q_1)");
    const std::string latex = render_latex(step);
    for (const char* part :
         {"Q_{k,1} &= q_{k,n} + \\frac{h\\partial_{p_{k}} H(P_{1})}{2}, \\\\\n",
          "\\partial_{q_{k}} H &= -\\frac{\\sin\\left(q_{k} - q_{k - 1}\\right)}{a} \\quad "
          "\\text{for } 2 \\le k \\le N \\\\\n"})
        CHECK(contains(latex, part));
    const std::string ring = render_latex(
        loop_equations(named_method(source("midpoint", "--method")), named_scene("toda-ring"), {}));
    CHECK(contains(ring, "q_{\\left(k \\bmod N\\right) + 1}"));
    const std::string bodies = render_latex(loop_equations(
        named_method(source("midpoint", "--method")), named_scene("ring-of-bodies"), {}));
    CHECK(contains(bodies, "\\sum_{j=k + 1}^{N} \\frac{\\left(x_{k} - x_{j}\\right)m^{2}}{"));
}

TEST_CASE("indices keep away from all names, and values stand in formulas") {
    Scene scene = scene_of_chain("sum(i=1..N, p[i]^2/2 + k*q[i]^4 + l*q[i]^3)", "q[1..N]",
                                 "p[1..N]", "k = 3\nl = 2\n");
    const Parameter given = parse_parameter(source("k=7", "--param"));
    REQUIRE(assign(scene, given));
    const Method cos_of_m = method_from_text(source("1, cos(m*tau)"), source("0, 1"));
    const LoopEquations step = loop_equations(cos_of_m, scene, {given});
    CHECK(step.gradient.indices == std::vector<std::string>{"n"});
    CHECK(step.parameters == std::vector<std::string>{"l", "m"});
    CHECK(contains(render_text(step), "\nvalues        N = 5, k = 7\n"));
    // dH/dq = 28 q^3 + 3 l q^2.
    CHECK(contains(render_text(step), "q[n]^2*(28*q[n]+3*l)"));
}

TEST_CASE("what has no equations with indices is refused") {
    const auto refused = [](const Scene& scene, const std::string& nodes = "gauss:2") {
        const Refusal error = refusal([&] {
            return loop_equations(method_from_text(source("1, tau"), source(nodes)), scene, {});
        });
        CHECK(error.status == 2);
        CHECK(error.helps("--unroll yes"));
        return error;
    };
    const std::string T = "sum(i=1..N, p[i]^2/2) + ";
    const auto chain = [&](const std::string& U) {
        return scene_of_chain(T + U, "q[1..N]", "p[1..N]");
    };
    CHECK(refused(chain("sum(i=1..2, q[2*i]^4)")).says("the index 2*i "));
    CHECK(refused(chain("sum(i=1..N-1, q[mod(i,N)+1]^4)")).says("the index mod(i,N)+1 "));
    CHECK(refused(chain("sum(i=1..N, i*q[mod(i,N)+1]^4)")).says("the index mod("));
    CHECK(refused(chain("sum(i=1..N, q[i]^4)"), "gauss:3").says("as many nodes as functions"));
}
