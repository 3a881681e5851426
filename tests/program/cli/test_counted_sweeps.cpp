// Counted sweeps: what headers say of them, and where there are none.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/program/cli/refusals.hpp"

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
