// Steppers of scenes against loops written by hand for one method and one system.
// SPDX-License-Identifier: MIT
//
// Before anything is timed, both go the same way: they end in the same state, and iterate as often.

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <hvi/state.hpp>

#include "by_hand_scenes.hpp"
#include "report.hpp"
#include "scene/gauss_2_henon_heiles.hpp"
#include "scene/gauss_2_kepler.hpp"
#include "scene/gauss_2_pendulum.hpp"
#include "scene/gauss_3_henon_heiles.hpp"
#include "scene/gauss_3_kepler.hpp"
#include "scene/gauss_3_pendulum.hpp"
#include "scene/gauss_4_chain.hpp"
#include "scene/gauss_4_henon_heiles.hpp"
#include "scene/gauss_4_kepler.hpp"
#include "scene/gauss_4_oscillator.hpp"
#include "scene/gauss_4_pendulum.hpp"
#include "scene/gauss_8_henon_heiles.hpp"
#include "scene/gauss_8_kepler.hpp"
#include "scene/gauss_8_pendulum.hpp"
#include "scene/verlet_henon_heiles.hpp"
#include "scene/verlet_kepler.hpp"
#include "scene/verlet_solar_system.hpp"

namespace {

using namespace hvi::generated;

constexpr int steps = 1000;

/// A generated stepper and its state, with the members of those by hand.
template <class Stepper>
struct Generated {
    Stepper stepper;
    typename Stepper::State x = Stepper::initial();

    [[nodiscard]] double q(std::size_t k) const { return x.q[k]; }
    [[nodiscard]] double p(std::size_t k) const { return x.p[k]; }
};

/// How often the steps iterated, in all, or `failed`. NOTE: on copies, and apart from the
/// benchmark's own calls, which would keep g++ from holding the state in registers.
template <class ByHand>
long advance(ByHand& given, double h) {
    ByHand stepper = given;
    long iterations = 0;
    for (int i = 0; i < steps; ++i) {
        const int more = stepper.step(h);
        if (more == bench::failed) { return bench::failed; }
        iterations += more;
    }
    given = stepper;
    return iterations;
}

/// Takes steps in a loop like a user's, whose state is a variable of its own.
template <class Stepper>
long advance(Generated<Stepper>& given, double h) {
    Stepper stepper = given.stepper;
    typename Stepper::State x = given.x;
    long iterations = 0;
    for (int i = 0; i < steps; ++i) {
        const hvi::Status status = stepper.step(x, h);
        if (!status.ok()) { return bench::failed; }
        iterations += status.iterations;
    }
    given.stepper = stepper;
    given.x = x;
    return iterations;
}

template <class Stepper>
void add_timing(const std::string& name, const Stepper& fresh, double step_size) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        volatile double h = step_size;  // so that no compiler folds it
        Stepper stepper = fresh;
        long iterations = 0;
        for (auto _ : state) {
            const long more = advance(stepper, h);
            if (more == bench::failed) { state.SkipWithError("a step failed"); }
            iterations += more;
            benchmark::DoNotOptimize(stepper.q(0) + stepper.p(0));
        }
        const auto taken = static_cast<double>(state.iterations()) * steps;
        state.counters["iterations"] = static_cast<double>(iterations) / taken;
    });
}

/// After so many steps: the state to 1e-11, and iterations, where both iterate, to 2 %.
template <class Made, class ByHand>
bool agree(const std::string& name, Made made, ByHand by_hand, std::size_t dimension, double h) {
    const auto often = static_cast<double>(advance(made, h));
    const auto often_by_hand = static_cast<double>(advance(by_hand, h));
    double distance = 0.0;
    for (std::size_t k = 0; k < dimension; ++k) {
        distance = std::fmax(distance, std::abs(made.q(k) - by_hand.q(k)));
        distance = std::fmax(distance, std::abs(made.p(k) - by_hand.p(k)));
    }
    const bool same_work = often_by_hand == 0 || std::abs(often / often_by_hand - 1.0) <= 0.02;
    if (distance <= 1e-11 && same_work) { return true; }
    std::fprintf(stderr, "error: %s: after %d steps %.1e apart, %.0f and %.0f iterations\n",
                 name.c_str(), steps, distance, often, often_by_hand);
    return false;
}

/// The comparisons so far.
struct Comparison {
    std::vector<bench::Ratio> ratios;
    bool all_agree = true;

    template <class Stepper, class ByHand>
    void add(const std::string& name, double h, const char* wanted) {
        const Generated<Stepper> made;
        const ByHand by_hand(made.x);
        all_agree &= agree(name, made, by_hand, made.x.q.size(), h);
        add_timing(name, made, h);
        add_timing(name + "_by_hand", by_hand, h);
        ratios.push_back({name, name + "_by_hand", wanted});
    }

    template <class Stepper, class Problem>
    void add_verlet(const std::string& scene, double h) {
        add<Stepper, bench::VerletByHand<Problem>>("verlet_" + scene, h, "at most 1.05");
    }

    template <class Stepper, std::size_t S, class Problem>
    void add_gauss(const std::string& scene, double h) {
        const std::string name = "gauss_" + std::to_string(S) + "_" + scene;
        add<Stepper, bench::GaussByHand<S, Problem>>(name, h, "at most 1.1");
    }

    template <class Problem, class Gauss2, class Gauss3, class Gauss4, class Gauss8>
    void add_gauss_family(const std::string& scene, double h) {
        add_gauss<Gauss2, 2, Problem>(scene, h);
        add_gauss<Gauss3, 3, Problem>(scene, h);
        add_gauss<Gauss4, 4, Problem>(scene, h);
        add_gauss<Gauss8, 8, Problem>(scene, h);
    }
};

}  // namespace

int main(int argc, char** argv) {
    Comparison all;
    all.add_verlet<VerletKepler, bench::KeplerByHand>("kepler", 0.01);
    all.add_verlet<VerletHenonHeiles, bench::HenonHeilesByHand>("henon_heiles", 0.05);
    all.add_verlet<VerletSolarSystem, bench::SolarSystemByHand>("solar_system", 50.0);
    all.add_gauss_family<bench::PendulumByHand, Gauss2Pendulum, Gauss3Pendulum, Gauss4Pendulum,
                         Gauss8Pendulum>("pendulum", 0.1);
    all.add_gauss_family<bench::HenonHeilesByHand, Gauss2HenonHeiles, Gauss3HenonHeiles,
                         Gauss4HenonHeiles, Gauss8HenonHeiles>("henon_heiles", 0.1);
    all.add_gauss_family<bench::KeplerByHand, Gauss2Kepler, Gauss3Kepler, Gauss4Kepler,
                         Gauss8Kepler>("kepler", 0.05);
    all.add<Gauss4Oscillator, bench::RotationByHand>("gauss_4_oscillator", 0.1, "at most 1.2");
    all.add<Gauss4Chain, bench::ChainByHand>("gauss_4_chain", 0.1, "at most 1.2");
    return all.all_agree ? bench::time_all(argc, argv, all.ratios) : 1;
}
