// hvi-gen stepper --lanes gpu: what it writes, and what it refuses.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"

using namespace hvi::test;

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Outcome of_threads(std::vector<std::string> words) {
    words.insert(words.begin(), {"stepper", "--lanes", "gpu", "--method"});
    return hvi_gen(words);
}

/// Returns the header.
std::string written(const std::vector<std::string>& words) {
    const Outcome outcome = of_threads(words);
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.out == of_threads(words).out);
    return outcome.out;
}

/// Returns the message of a refusal, which helps.
std::string refused(const std::vector<std::string>& words) {
    const Outcome outcome = of_threads(words);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(has(outcome.err, "help: "));
    CHECK(has(outcome.err, "^"));
    return outcome.err;
}

}  // namespace

TEST_CASE("--lanes gpu writes scalar code for a device") {
    const std::string kicks = written({"stormer-verlet", "kepler", "--energy"});
    CHECK(has(kicks, "HVI_DEVICE void step(State& x, const Steps& by) const {"));
    CHECK(has(kicks, "HVI_DEVICE void dHdq(const Vector& q, Vector& out) const {"));
    CHECK(has(kicks, "hvi::device::sqrt(t1)"));
    CHECK(has(kicks, "HVI_DEVICE Number energy(const State& x) const {"));
    CHECK(has(kicks, "a trajectory is a thread of a GPU"));
    CHECK(has(kicks, "slope{};  // the first of the next step"));
    CHECK_FALSE(has(kicks, "remainder_q"));
    CHECK_FALSE(has(kicks, "std::sqrt"));
    CHECK_FALSE(has(kicks, "std::array"));
    CHECK(has(written({"stormer-verlet", "kepler", "--compose", "kahan-li:8"}), "remainder_q"));
    const std::string timed = written({"gauss:2", "--hamiltonian", "p^2/2+p^4-q*cos(t)"});
    CHECK(has(timed, "Number t = 0;"));
    CHECK(has(timed, "hvi::device::time_at(x, by.t[i])"));
    const std::string stages = written({"gauss:4", "kepler"});
    CHECK(has(stages, "hvi::device::solve(coupled, x.iterations)"));
    CHECK(has(stages, "the stages keep their momenta: on a GPU one form serves any H"));
    CHECK_FALSE(has(written({"gauss:2", "harmonic-oscillator"}), "LinearMap"));
}

TEST_CASE("what threads of a GPU are not built for is refused, and why") {
    CHECK(has(refused({"lobatto:3", "kepler"}), "the stages are not solved for all at once"));
    CHECK(has(refused({"symplectic-euler", "nonseparable"}),
              "the stages are not solved for all at once"));
    CHECK(has(refused({"gauss:2", "kepler", "--solver", "newton"}),
              "they are iterated by fixed points"));
    CHECK(has(refused({"gauss:3", "free-rigid-body"}), "rotations"));
    CHECK(has(refused({"gauss:2", "double-pendulum", "--compose", "yoshida:4"}), "--lanes gpu"));
    for (const std::string flag : {"--dense", "--action", "--float128", "--evaluations"}) {
        CHECK(has(refused({"gauss:2", "kepler", flag}), flag + " is not built for --lanes gpu"));
    }
    CHECK(has(refused({"stormer-verlet", "--hamiltonian", "p^2/2+atan(q)^2"}),
              "--lanes gpu has not the function `atan`"));
    CHECK(has(refused({"stormer-verlet", "--hamiltonian", "p^2/2+erf(q)^2"}), "`erf`"));
    CHECK(has(refused({"stormer-verlet", "--hamiltonian", "p^2/2+abs(q)^1.3"}),
              "a power with such an exponent"));
    // Derivatives of these are there, and the energy is only where it is wished for.
    CHECK(has(written({"stormer-verlet", "--hamiltonian", "p^2/2+atan(q)"}), "/ (Scalar(1.0)"));
    CHECK(has(refused({"stormer-verlet", "--hamiltonian", "p^2/2+atan(q)", "--energy"}), "`atan`"));
}
