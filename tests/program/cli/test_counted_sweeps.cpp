// Counted sweeps: what headers say of them, and where there are none.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/program/cli/refusals.hpp"
#include "tests/program/cli/results.hpp"

using namespace hvi::test;

TEST_CASE("a header of counted sweeps says that it is symplectic up to the last change alone") {
    const std::string text = same_every_time(
        {"stepper", "--method", "gauss:4", "double-pendulum", "--sweeps", "3", "--tangent"});
    const auto has = [&](const std::string& part) { return text.find(part) != std::string::npos; };
    CHECK(has("hvi-gen stepper --method gauss:4 double-pendulum --sweeps 3 --tangent\n"));
    CHECK(has("// Explicit: exactly 3 sweeps a step, from extrapolated slopes; symplectic, and "
              "conserving, up to\n// the last change alone.\n"));
    CHECK(has("using Solver = hvi::FixedSweeps<3>;"));
    const Outcome whole = hvi_gen({"stepper", "--method", "gauss:4", "double-pendulum"});
    CHECK(whole.out.find("weeps a step") == std::string::npos);
    CHECK(whole.out.find("FixedSweeps") == std::string::npos);
}

TEST_CASE("sweeps are not counted where nothing is iterated, or another solver is named") {
    const auto check = [](const std::string& place, const std::string& what,
                          const std::vector<std::string>& words) {
        check_refused({2, place, {}}, words);
        const std::string message = hvi_gen(words).err;
        INFO(message);
        CHECK(message.find(what) != std::string::npos);
    };
    const auto run = [](const std::vector<std::string>& more) {
        return with({"run", "--sweeps", "3"}, more);
    };
    check("3", "nothing is iterated, as the step is explicit",
          run({"kepler", "--method", "stormer-verlet"}));
    check("3", "nothing is iterated, as a step is one linear map", run({"harmonic-oscillator"}));
    check("3", "not built for rotations", run({"free-rigid-body", "--method", "gauss:2"}));
    check("3", "velocities of a curve", run({"bead-on-hoop", "--method", "gauss:2"}));
    check("--solver", "does not go with --solver", run({"pendulum", "--solver", "newton"}));
    check("--sweeps", "--accuracy chooses what --sweeps gives",
          run({"pendulum", "--accuracy", "1e-4"}));
    check("0", "from 1 to 100", {"run", "pendulum", "--sweeps", "0"});
    check("101", "from 1 to 100", {"run", "pendulum", "--sweeps", "101"});
    const auto stepper = [](const std::vector<std::string>& more) {
        return with({"stepper", "--method", "gauss:2", "--sweeps", "3"}, more);
    };
    check("--sweeps", "hvi::FixedSweeps<K>", stepper({}));
    check("3", "no generating function", stepper({"pendulum", "--action"}));
    check("gpu", "not counted", stepper({"nonseparable", "--lanes", "gpu"}));
}

TEST_CASE("check proves up to which power of h counted sweeps are symplectic") {
    const std::string text = same_every_time({"check", "--method", "gauss:4", "--sweeps", "3"});
    const auto has = [&](const std::string& part) {
        CAPTURE(part, text);
        CHECK(text.find(part) != std::string::npos);
    };
    has("gauss:4\n\nsweeps        3 in each step, from the slopes at its start\n");
    has("\norder         4: ");
    has("\nsymplectic    up to h^4\n  at once     up to h^4\n  separable   up to h^6\n"
        "  Nystrom     up to h^7\n");
    has("\nexplicit      for every H\n");
    // cos(z)^2 + sin(z)^2 up to z^8, where the step lacks a z^8/8! in one of the cosines.
    has("\nenergy        of the oscillator, times 1 - 0.0000248016*z^8 + ... in a step\n");
    has("All of it is proved.\n");
    const auto json = nlohmann::json::parse(
        hvi_gen({"check", "--method", "gauss:4", "--sweeps", "3", "--format", "json"}).out);
    CHECK(json.at("sweeps") == 3);
    CHECK(json.at("order") == 4);
    CHECK(json.at("order_separable") == 6);
    CHECK(json.at("order_nystrom") == 7);
    CHECK(json.at("symplectic") == false);
    CHECK(json.at("explicit").at("general") == true);
    CHECK(json.at("linear_stability").at("determinant_is_one") == false);
    const auto& sweeps = json.at("counted_sweeps");
    CHECK(sweeps.at("order_at_once") == 4);
    CHECK(sweeps.at("symplectic_up_to").at("general").at("power") == 4);
    CHECK(sweeps.at("agrees_up_to").at("nystrom").at("power") == 7);
    CHECK(sweeps.at("growth").at("power") == 8);
    // A polynomial of degree 6 goes through four stages of two steps; stages have order 4.
    CHECK(sweeps.at("extrapolated").at("steps") == 2);
    CHECK(sweeps.at("extrapolated").at("degree") == 6);
    CHECK(sweeps.at("extrapolated").at("error") == 5);
    CHECK(sweeps.at("extrapolated").at("symplectic_at_least_up_to").at("general") == 8);
    CHECK(sweeps.at("extrapolated").at("symplectic_at_least_up_to").at("separable") == 10);
    CHECK(sweeps.at("extrapolated").at("symplectic_at_least_up_to").at("nystrom") == 11);
}

TEST_CASE("what a method keeps of a scene counted sweeps keep but for their last change") {
    const std::string text =
        hvi_gen({"check", "--method", "gauss:2", "kepler", "--sweeps", "2"}).out;
    INFO(text);
    CHECK(text.find("x*py-y*px: conserved, but for the last change of each step\n") !=
          std::string::npos);
    const auto json = nlohmann::json::parse(
        hvi_gen({"check", "--method", "gauss:2", "kepler", "--sweeps", "2", "--format", "json"})
            .out);
    CHECK(json.at("momentum_maps")[0].at("momentum_map") == "x*py-y*px");
    CHECK(json.at("momentum_maps")[0].at("kept") == false);
}

TEST_CASE("families whose stages are not all iterated are not looked at") {
    const std::string text = hvi_gen({"check", "--method", "lobatto:3", "--sweeps", "2"}).out;
    INFO(text);
    CHECK(text.find("\norder         3: ") != std::string::npos);
    CHECK(text.find("  separable   not looked at: not all stages are iterated\n") !=
          std::string::npos);
    CHECK(text.find("\noscillator    not looked at: ") != std::string::npos);
}

TEST_CASE("check counts no sweeps where none are counted") {
    const auto check = [](const std::string& place, const std::string& what,
                          const std::vector<std::string>& more) {
        const std::vector<std::string> words = with({"check", "--sweeps", "3"}, more);
        check_refused({2, place, {}}, words);
        const std::string message = hvi_gen(words).err;
        INFO(message);
        CHECK(message.find(what) != std::string::npos);
    };
    check("3", "nothing is iterated", {"--method", "stormer-verlet"});
    check("3", "nothing is iterated by a splitting", {"--method", "strang"});
    check("3", "velocities of a curve", {"--basis", "1, tau", "--nodes", "0, 1/2, 1"});
    check("--tableau", "does not go with", {"--tableau", "t.json"});
    check_refused({2, "0", {}}, {"check", "--method", "gauss:2", "--sweeps", "0"});
    check_refused({2, "101", {}}, {"check", "--method", "gauss:2", "--sweeps", "101"});
}
