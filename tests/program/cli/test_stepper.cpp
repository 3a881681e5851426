// Headers that `hvi-gen stepper` writes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/results.hpp"

using namespace hvi::test;

TEST_CASE("no option of stepper swallows the scene behind it") {
    const std::vector<std::vector<std::string>> lines = {
        {"--param", "mu=2"},     {"--energy"},
        {"--invariants"},        {"--dense"},
        {"--float128"},          {"--solver", "newton"},
        {"--explain"},           {"--name", "K"},
        {"--method", "gauss:4"}, {"--compose", "yoshida:4"},
        {"--lanes", "none"},     {"--action"},
        {"--tangent"},           {"--sweeps", "3"}};
    for (const auto& options : lines) {
        const Outcome outcome = hvi_gen(with(with({"stepper"}, options), {"kepler"}));
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        const std::string name = options.front() == "--name"      ? "K"
                                 : options.front() == "--compose" ? "KeplerGauss4Yoshida4"
                                                                  : "KeplerGauss4";
        CHECK(outcome.out.find("\nusing " + name + " = Basic" + name + "<double>;\n") !=
              std::string::npos);
    }
}

TEST_CASE("stages stand side by side where they can") {
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const auto header = [&](const std::string& method, const std::string& scene,
                            const std::vector<std::string>& options) {
        return hvi_gen(with({"stepper", "--method", method, scene}, options));
    };
    const std::string lanes =
        same_every_time({"stepper", "--method", "gauss:3", "kepler", "--lanes", "stages"});
    CHECK(has(lanes, "hvi::detail::VelocityLanes<Vector, 3> s_;"));
    CHECK(has(lanes, "hvi-gen stepper --method gauss:3 kepler --lanes stages\n"));
    CHECK(has(header("gauss:3", "kepler", {}).out, "VelocityLanes"));
    CHECK(
        has(header("gauss:2", "point-vortices", {}).out, "hvi::detail::StageLanes<Vector, 2> s_;"));
    CHECK_FALSE(has(header("gauss:3", "kepler", {"--lanes", "none"}).out, "Lanes"));
    const std::vector<std::pair<std::vector<std::string>, std::string>> obstacles = {
        {{"stormer-verlet", "kepler"}, "each stage of an explicit method needs the one before"},
        {{"gauss:2", "harmonic-oscillator"}, "a step is one linear map"},
        {{"midpoint", "kepler"}, "there is one stage"},
        {{"lobatto:3", "kepler"}, "the stages are not solved for all at once"},
        {{"gauss:2", "kepler", "--solver", "newton"}, "they are built for fixed points"},
        {{"midpoint", "kepler", "--compose", "yoshida:4"}, "not solved for all at once"}};
    for (const auto& [words, obstacle] : obstacles) {
        const std::vector<std::string> options(words.begin() + 2, words.end());
        INFO(obstacle);
        CHECK_FALSE(has(header(words[0], words[1], options).out, "Lanes"));
        const Outcome refused = header(words[0], words[1], with(options, {"--lanes", "stages"}));
        CHECK(refused.status == 2);
        CHECK(has(refused.err, obstacle));
        CHECK(has(refused.err, "^~~~~~"));
        CHECK(refused.out.empty());
    }
    const std::string composed = header("gauss:2", "kepler", {"--compose", "yoshida:4"}).out;
    CHECK(has(composed, "hvi::detail::VelocityLanes<Vector, 2> s_;"));
    CHECK(has(composed, "weights_of_step(h, gamma)"));
    // The adjoint, which is another method, would want other tables.
    const std::vector<std::string> one_sided = {"stepper",           "--basis",  "1, tau",
                                                "--nodes",           "1/4, 3/5", "--hamiltonian",
                                                "(q^2+1)*(p^2+1)/2", "--lanes",  "stages"};
    CHECK(hvi_gen(one_sided).status == 0);
    const Outcome with_adjoint = hvi_gen(with(one_sided, {"--compose", "blanes-moan:6"}));
    CHECK(with_adjoint.status == 2);
    CHECK(has(with_adjoint.err, "not solved for all at once"));
    const Outcome unknown = header("gauss:2", "kepler", {"--lanes", "stage"});
    CHECK(unknown.status == 2);
    CHECK(has(unknown.err, "stages"));
    const Outcome of_user = hvi_gen({"stepper", "--method", "gauss:2", "--lanes", "stages"});
    CHECK(of_user.status == 2);
    CHECK(has(of_user.err, "--lanes needs a scene or --hamiltonian"));
}

TEST_CASE("a stepper of a scene has what was asked for and no more") {
    const std::vector<std::string> words = {"stepper", "--method", "gauss:2", "kepler"};
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const std::string plain = hvi_gen(words).out;
    CHECK(has(plain, "struct Parameters"));
    CHECK(has(plain, "static constexpr State initial("));
    CHECK_FALSE(has(plain, "energy("));
    CHECK_FALSE(has(plain, "angular_momentum("));
    CHECK(has(plain, "using Solver = hvi::AutomaticOfLanes<hvi::NewtonOfPositionLanes>;"));
    CHECK_FALSE(has(plain, "Vector position("));
    CHECK_FALSE(has(plain, "curve"));
    CHECK_FALSE(has(plain, "action"));
    const std::string all =
        hvi_gen(with(words, {"--energy", "--invariants", "--solver", "newton"})).out;
    CHECK(has(all, "Scalar energy(const State& x) const"));
    CHECK(has(all, "Scalar angular_momentum(const State& x) const"));
    CHECK(has(all, "using Solver = hvi::NewtonOfPositions;"));
    CHECK_FALSE(has(all, "Vector position("));
    const std::string fixed = same_every_time(with(words, {"--solver", "fixed-point"}));
    CHECK(has(fixed, "using Solver = hvi::FixedPoint;"));
    CHECK_FALSE(has(fixed, "d2Hdq2"));
    CHECK_FALSE(has(fixed, "Modes"));
    const std::string dense = same_every_time(with(words, {"--dense"}));
    CHECK(has(dense, "Vector position(Scalar tau) const"));
    CHECK(has(dense, "it is O(h^3) away"));
    CHECK(has(dense, "hvi-gen stepper --method gauss:2 kepler --dense\n"));
    const std::string action = same_every_time(with(words, {"--action"}));
    CHECK(has(action, "Scalar generating_function() const"));
    CHECK(has(action, "Scalar action() const"));
    CHECK(has(action, "hvi-gen stepper --method gauss:2 kepler --action\n"));
    CHECK_FALSE(has(action, "energy(const State& x)"));
    const std::string both = same_every_time(with(words, {"--dense", "--action"}));
    CHECK(has(both, "Vector position(Scalar tau) const"));
    CHECK(has(both, "Scalar action() const"));
    for (const std::string scene : {"kepler", "harmonic-oscillator"}) {
        const std::string alone = hvi_gen({"stepper", "--method", "stormer-verlet", scene}).out;
        CHECK(has(alone, "#ifndef HVI_STATE"));
        CHECK_FALSE(has(alone, "#include <hvi/"));
    }
    const Outcome explained = hvi_gen(with(words, {"--explain"}));
    CHECK(has(explained.err, "T is quadratic with a constant matrix"));
    CHECK(has(explained.err, "4 unknowns are solved for in a step"));
    CHECK(
        has(explained.err, "dH/dq once: 1 addition, 5 multiplications, 1 division, 1 square root"));
    CHECK(explained.out == plain);
    // Counted by hand in the straight-line code.
    CHECK(has(explained.err, "where Newton's method is needed: 3 additions, 14 "));
    const Outcome taylor = hvi_gen(with(words, {"--solver", "newton-taylor", "--explain"}));
    CHECK(
        has(taylor.err, "d2H/dq2 times a vector, after dH/dq: 3 additions, 11 multiplications\n"));
    CHECK(has(taylor.out, "using Solver = hvi::NewtonTaylor;"));
}

TEST_CASE("--float128 changes whose functions are called, and nothing without it") {
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const std::vector<std::string> pendulum = {"stepper",  "--method", "gauss:2",
                                               "pendulum", "--lanes",  "none"};
    const std::string plain = hvi_gen(pendulum).out;
    CHECK(has(plain, "std::sin("));
    CHECK(has(plain, "is_standard<Number>"));
    CHECK_FALSE(has(plain, "hvi::math"));
    CHECK_FALSE(has(plain, "hvi/math"));
    const std::string wide = same_every_time(with(pendulum, {"--float128"}));
    CHECK(has(wide, "hvi::math::sin("));
    CHECK(has(wide, "#include <hvi/detail/numbers/math.hpp>"));
    CHECK(has(wide, "hvi::math::computes_in<Number>"));
    CHECK(has(wide, "hvi-gen stepper --method gauss:2 pendulum --lanes none --float128\n"));
    CHECK_FALSE(has(wide, "std::sin("));
    const std::string linear =
        hvi_gen({"stepper", "--method", "gauss:2", "harmonic-oscillator", "--float128"}).out;
    CHECK(has(linear, "!hvi::math::islessgreater("));
    CHECK_FALSE(has(linear, "std::numeric_limits"));
    const std::string alone =
        hvi_gen({"stepper", "--method", "stormer-verlet", "pendulum", "--float128"}).out;
    CHECK(has(alone, "#ifndef HVI_MATH_HPP"));
    CHECK_FALSE(has(alone, "#include <hvi/"));
    const std::string curve =
        hvi_gen({"stepper", "--method", "trig3", "pendulum", "--dense", "--float128"}).out;
    CHECK(has(curve, "hvi::math::sin(curve_rates["));
    CHECK_FALSE(has(curve, "std::cos("));
}

TEST_CASE("--explain says how the map of a quadratic H is computed") {
    const auto explained = [](const std::string& H) {
        return hvi_gen({"stepper", "--method", "gauss:2", "--hamiltonian", H, "--explain"}).err;
    };
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const std::string coupled = explained("p1^2/2+p2^2+(q1-q2)^2");
    CHECK(has(coupled, "a step: 12 multiplications and 12 additions\n"));
    CHECK(has(coupled, "no solver: H is quadratic"));
    CHECK(has(explained("p^2/2+q^2/2+q"), "a step: 3 multiplications and 5 additions\n"));
    const std::string mixed = explained("p1^2/2+p2^2/2+q1*p2");
    CHECK(has(mixed, "no solver: H is quadratic: a step is a product with a matrix"));
    CHECK(has(mixed, "products of q and p leave no symmetric shears"));
    CHECK(has(mixed, "a step: 48 multiplications and 200 additions\n"));
}

TEST_CASE("every scene gives a header, the same every time, below 100 kB") {
    for (const std::string scene :
         {"double-pendulum", "fpu", "harmonic-oscillator", "henon-heiles", "kepler", "nonseparable",
          "outer-solar-system", "pendulum", "point-vortices", "qp"}) {
        const std::string header = same_every_time({"stepper", scene, "--energy", "--invariants"});
        CHECK(header.size() < 100'000);
        CHECK(header.find("hvi-gen stepper --method") != std::string::npos);
    }
}

TEST_CASE("--explain speaks on standard error") {
    const Outcome outcome = hvi_gen({"stepper", "--method", "gauss:2", "--explain"});
    CHECK(outcome.status == 0);
    CHECK(!outcome.err.empty());
    CHECK((outcome.out == hvi_gen({"stepper", "--method", "gauss:2"}).out));
}

TEST_CASE("--dump prints a record on the way to a header") {
    const auto record = [](const char* stage, const std::vector<std::string>& scene) {
        return same_every_time(with({"stepper", "--method", "gauss:2", "--dump", stage}, scene));
    };
    const auto says = [](const std::string& text, const char* line) {
        CAPTURE(text);
        CHECK(("\n" + text).find("\n" + std::string(line) + "\n") != std::string::npos);
    };
    for (const std::vector<std::string>& scene : {std::vector<std::string>{}, {"pendulum"}}) {
        says(record("method", scene), "node: gauss:2");
        says(record("tableau", scene), "A: 1/4 1/4-sqrt(3)/6");
        says(record("tableau", scene), "A_psi: 1/2-sqrt(3)/6 1/6-sqrt(3)/12");  // c and c^2/2
        CHECK(record("step", scene).find("\nsolve Q_1 ") != std::string::npos);
    }
    says(record("step", {}), "slopes: dH/dq(q, p), dH/dp(q, p)");
    says(record("step", {"pendulum"}), "slopes: dH/dq(q), dH/dp(p)");
    // H = p^2/2 - cos(q)
    says(record("system", {"pendulum"}), "#4: cos #1");
    says(record("system", {"pendulum"}), "d2H/dq dq: #4");

    const Outcome outcome = hvi_gen({"stepper", "--method", "gauss:2", "--dump", "system"});
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find("without a scene there is no system") != std::string::npos);
    CHECK(hvi_gen({"stepper", "--method", "gauss:2", "--dump", "header"}).status == 2);
    CHECK(hvi_gen({"stepper", "--method", "gauss:2", "--dump", "step", "--explain"}).status == 2);
}

TEST_CASE("compositions") {
    const std::vector<std::string> verlet = {"stepper", "--method", "stormer-verlet", "kepler"};
    const std::string header = same_every_time(with(verlet, {"--compose", "yoshida:6"}));
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    CHECK(has(header, "using KeplerStormerVerletYoshida6 ="));
    CHECK(has(header, "stepper --method stormer-verlet kepler --compose yoshida:6\n"));
    CHECK(has(header, "7 steps in a row: they make a method of order 6: yoshida:6"));
    CHECK_FALSE(has(header, "#include <hvi/"));
    const Outcome separable =
        hvi_gen({"stepper", "--method", "stormer-verlet", "--separable", "--compose", "suzuki:4"});
    CHECK(separable.status == 0);
    CHECK(has(separable.out, "class StormerVerletSuzuki4"));

    const Outcome unknown = hvi_gen(with(verlet, {"--compose", "yosida:6"}));
    CHECK(unknown.status == 2);
    CHECK(has(unknown.err, "did you mean `yoshida:6`"));
    const Outcome euler =
        hvi_gen({"stepper", "--method", "symplectic-euler", "kepler", "--compose", "yoshida:4"});
    CHECK(euler.status == 1);
    CHECK(euler.out.empty());
    CHECK(has(euler.err, "not its own adjoint"));
    CHECK(hvi_gen(with(verlet, {"--compose", "yoshida:4", "--dense"})).status == 2);
    // Nodes without a closed form, and more stages than one plans for.
    CHECK(hvi_gen({"stepper", "--method", "gauss:8", "kepler", "--compose", "yoshida:4"}).status ==
          0);
    const Outcome large =
        hvi_gen({"stepper", "--method", "gauss:16", "kepler", "--compose", "kahan-li:8"});
    CHECK(large.status == 2);
    CHECK(has(large.err, "at most 8 stages"));
    CHECK(hvi_gen({"stepper", "--basis", "1, cos(w*tau), sin(w*tau)", "--nodes", "0, 1/2, 1",
                   "kepler", "--compose", "yoshida:4"})
              .status == 2);
}

TEST_CASE("--lanes ensemble writes a stepper of trajectories side by side") {
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const std::vector<std::string> words{"stepper", "--method", "gauss:4",
                                         "kepler",  "--lanes",  "ensemble"};
    const std::string implicit = same_every_time(with(words, {"--energy", "--invariants"}));
    CHECK(has(implicit, "using State = hvi::Trajectories<"));
    CHECK(has(implicit, "Scalar energy(const Trajectory& x) const"));
    CHECK(has(implicit, "static constexpr Trajectory initial("));
    CHECK(has(implicit, "hvi-gen stepper --method gauss:4 kepler --lanes ensemble"));
    CHECK_FALSE(has(implicit, "hvi::Automatic"));
    const std::string kicks =
        same_every_time({"stepper", "--method", "stormer-verlet", "kepler", "--lanes", "ensemble"});
    CHECK(has(kicks, "hvi::detail::SlopeCarried"));
    CHECK_FALSE(has(kicks, "LaneSweeps"));
    CHECK_FALSE(has(kicks, "TrajectorySums"));
    CHECK(has(same_every_time({"stepper", "--method", "stormer-verlet", "kepler", "--lanes",
                               "ensemble", "--compose", "kahan-li:8"}),
              "hvi::detail::TrajectorySums<State> sums_;"));
    const Outcome explained = hvi_gen(with(words, {"--explain"}));
    CHECK(has(explained.err, "eight trajectories are computed side by side"));
    CHECK_FALSE(has(
        hvi_gen({"stepper", "--method", "gauss:2", "harmonic-oscillator", "--lanes", "ensemble"})
            .out,
        "LinearMap"));
}

TEST_CASE("ensembles of splittings have flows of their own in each lane") {
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const std::string shears = same_every_time({"stepper", "--method", "strang", "henon-heiles",
                                                "--split", "auto", "--lanes", "ensemble"});
    CHECK(has(shears, "using LaneFlow1 = Flow1Of<hvi::detail::TrajectoryRow<Scalar>>;"));
    CHECK(has(shears, "hvi::detail::TrajectoryPath<State> path(x);"));
    CHECK(has(shears, "side by side: one flow of a part"));
    CHECK_FALSE(has(shears, "advance()"));
    CHECK_FALSE(has(shears, "LongTrajectoryPath"));
    const std::string matrix =
        same_every_time({"stepper", "--method", "strang", "--hamiltonian",
                         "(p1^2 + p2^2)/2 + q1*p2 - q2*p1 + q1^4", "--lanes", "ensemble"});
    CHECK(has(matrix, "hvi::detail::LongTrajectoryPath<State> path(x);"));
    CHECK(has(matrix, "hvi::detail::FormFlow<Scalar, 2, Constant> form_1_;"));
    const std::string orbits = same_every_time(
        {"stepper", "--method", "strang", "kepler", "--split", "auto", "--lanes", "ensemble"});
    CHECK(has(orbits, "#include <hvi/detail/trajectories/trajectory_orbits.hpp>"));
    CHECK(has(orbits, "hvi::detail::orbit_values<1>(std::array<Lane, 5>{"));
    const std::string top = same_every_time(
        {"stepper", "--method", "strang", "lagrange-top", "--lanes", "ensemble", "--energy"});
    CHECK(has(top, "#include <hvi/detail/lanes/lane_turns.hpp>"));
    CHECK(has(top, "using Trajectory = Bodies;"));
    CHECK(has(top, "using State = hvi::Trajectories<hvi::detail::BodyVectors<Space, "));
    CHECK(has(top, "hvi::detail::turn_about_momentum(std::array<Lane, 13>{"));
    CHECK(has(top, "hvi::detail::small_or_any(are_small, small, others);"));
}

TEST_CASE("ensembles of H that depends on the time have one each") {
    const auto written = [](const std::string& method, const std::string& hamiltonian) {
        return same_every_time(
            {"stepper", "--method", method, "--hamiltonian", hamiltonian, "--lanes", "ensemble"});
    };
    for (const std::string& text :
         {written("stormer-verlet", "p^2/2-q*cos(t)"), written("gauss:2", "p^2/2-q*cos(t)"),
          written("gauss:2", "(1+t)*q^2*p^2/2")}) {
        CHECK(text.find("using Trajectory = hvi::TimedState<Vector>;") != std::string::npos);
        CHECK(text.find("clock.at(c[") != std::string::npos);
    }
}

TEST_CASE("what ensembles are not built for is refused, and why") {
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const auto refusal = [&](const std::vector<std::string>& words) {
        const Outcome outcome = hvi_gen(with(words, {"--lanes", "ensemble"}));
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        CHECK(has(outcome.err, "help: "));
        return outcome.err;
    };
    CHECK(has(refusal({"stepper", "--method", "lobatto:3", "kepler"}),
              "the stages are not solved for all at once"));
    CHECK(has(refusal({"stepper", "--method", "midpoint", "kepler", "--compose", "yoshida:4"}),
              "the stages are not solved for all at once"));
    CHECK(has(refusal({"stepper", "--method", "symplectic-euler", "nonseparable"}),
              "the stages are not solved for all at once"));
    CHECK(has(refusal({"stepper", "--basis", "1, cos(w*tau), sin(w*tau)", "--nodes", "0, 1/2, 1",
                       "--hamiltonian", "p^2/2-q*cos(t)"}),
              "the coefficients depend on a parameter"));
    CHECK(has(refusal({"stepper", "--method", "lobatto:3", "--hamiltonian", "p^2/2-q*cos(t)"}),
              "the stages are not solved for all at once"));
    CHECK(has(refusal({"stepper", "--method", "gauss:2", "kepler", "--solver", "newton"}),
              "they are iterated by fixed points"));
    CHECK(has(refusal({"stepper", "--method", "gauss:2", "heavy-top"}),
              "charts of rotations are built for one trajectory alone"));
    CHECK(has(refusal({"stepper", "--method", "strang", "--hamiltonian", "(p^2+q^2)^2/2-q*cos(t)"}),
              "flows beside a time are built for one trajectory alone"));
    for (const std::string flag : {"--dense", "--action", "--float128", "--evaluations"}) {
        CHECK(has(refusal({"stepper", "--method", "gauss:2", "kepler", flag}),
                  flag + " is not built for ensembles"));
    }
}

TEST_CASE("--tangent writes a stepper that carries directions along") {
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const std::string gauss =
        same_every_time({"stepper", "--method", "gauss:2", "kepler", "--tangent", "--energy"});
    CHECK(has(gauss, "hvi-gen stepper --method gauss:2 kepler --energy --tangent\n"));
    CHECK(has(gauss, "hvi::PullBack::step_back"));
    CHECK(has(gauss, "#include <hvi/directions.hpp>"));
    CHECK(has(gauss, "using Along = hvi::detail::StagesAlong<"));
    // A method that is not its own adjoint pulls covectors back by columns.
    const std::string euler =
        hvi_gen({"stepper", "--method", "symplectic-euler", "henon-heiles", "--tangent"}).out;
    CHECK(has(euler, "using Along = hvi::detail::MovesAlong<"));
    CHECK(has(euler, "hvi::PullBack::columns"));
    // Directions of a Lagrangian have a stepper apart.
    const std::string bead =
        hvi_gen({"stepper", "--method", "gauss:2", "bead-on-hoop", "--tangent"}).out;
    CHECK_FALSE(has(bead, "Along"));
    CHECK(has(bead, "class BasicBeadOnHoopGauss2Directions"));
    // Flows of parts of H.
    const std::string flows =
        hvi_gen({"stepper", "--method", "strang", "henon-heiles", "--split", "auto", "--tangent"})
            .out;
    CHECK(has(flows, "using Along = hvi::detail::FlowsAlong<"));
    CHECK(has(flows, "hvi::PullBack::step_back"));
    std::istringstream text(gauss + euler + bead + flows);
    for (std::string line; std::getline(text, line);) CHECK(line.size() <= 100);
}

TEST_CASE("directions that are not built are refused, and why") {
    const auto refused = [](const std::vector<std::string>& words, const std::string& reason) {
        const Outcome outcome = hvi_gen(with({"stepper", "--tangent"}, words));
        INFO(outcome.err);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.find(reason) != std::string::npos);
        CHECK(outcome.err.find('^') != std::string::npos);
    };
    refused({"--method", "stormer-verlet", "kepler", "--lanes", "ensemble"},
            "--tangent is not built for ensembles");
    refused({"--method", "stormer-verlet", "kepler", "--lanes", "gpu"},
            "--tangent is not built for --lanes gpu");
    refused({"--method", "gauss:2", "heavy-top"},
            "--tangent is not built for scenes with rotations");
    refused({"--method", "strang", "heavy-top"},
            "--tangent is not built for scenes with rotations");
    refused({"--method", "strang", "--split", "auto", "henon-heiles", "--lanes", "ensemble"},
            "--tangent is not built for ensembles");
    refused({"--method", "gauss:2"}, "--tangent");
}
