// Ensembles against steppers of one trajectory of the same method.
// SPDX-License-Identifier: MIT
//
// On one thread, the same starts and steps. Before anything is timed, both end in the same states.
// And ensembles with parameters of their own against those that share them.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <hvi/ensemble.hpp>

#include "ensemble/blanes_moan_henon_heiles.hpp"
#include "ensemble/blanes_moan_pendulum.hpp"
#include "ensemble/gauss_4_henon_heiles.hpp"
#include "ensemble/gauss_4_kepler.hpp"
#include "ensemble/gauss_4_pendulum.hpp"
#include "ensemble/gauss_8_henon_heiles.hpp"
#include "ensemble/gauss_8_pendulum.hpp"
#include "ensemble/kahan_li_henon_heiles.hpp"
#include "ensemble/kahan_li_kepler.hpp"
#include "ensemble/kahan_li_pendulum.hpp"
#include "ensemble/one/blanes_moan_henon_heiles.hpp"
#include "ensemble/one/blanes_moan_pendulum.hpp"
#include "ensemble/one/gauss_4_henon_heiles.hpp"
#include "ensemble/one/gauss_4_pendulum.hpp"
#include "ensemble/one/gauss_8_henon_heiles.hpp"
#include "ensemble/one/gauss_8_pendulum.hpp"
#include "ensemble/one/kahan_li_henon_heiles.hpp"
#include "ensemble/one/kahan_li_pendulum.hpp"
#include "ensemble/one/verlet_henon_heiles.hpp"
#include "ensemble/one/verlet_pendulum.hpp"
#include "ensemble/verlet_henon_heiles.hpp"
#include "ensemble/verlet_pendulum.hpp"
#include "report.hpp"

namespace {

using namespace hvi::generated;

constexpr int steps = 100;
constexpr std::size_t size = 1024;

/// From half of where the scene begins to all of it.
template <class Trajectory>
std::vector<Trajectory> starts(const Trajectory& initial) {
    std::vector<Trajectory> result(size, initial);
    for (std::size_t i = 0; i < size; ++i) {
        const double part = 0.5 + 0.5 * static_cast<double>(i) / size;
        for (double& q : result[i].q) { q *= part; }
        for (double& p : result[i].p) { p *= part; }
    }
    return result;
}

/// Returns whether all steps went well.
template <class Stepper, class State>
bool advance(State& x, double h) {
    Stepper stepper;
    for (int i = 0; i < steps; ++i) {
        if (!stepper.step(x, h).ok()) { return false; }
    }
    return true;
}

/// One by one.
template <class One, class Trajectory>
bool advance_all(std::vector<Trajectory>& x, double h) {
    bool ok = true;
    for (Trajectory& each : x) { ok &= advance<One>(each, h); }
    return ok;
}

template <class One, class Many>
void add_timings(const std::string& name, double step_size) {
    const auto from = starts(Many::initial());
    benchmark::RegisterBenchmark((name + "_one").c_str(), [=](benchmark::State& state) {
        volatile double h = step_size;  // so that no compiler folds it
        for (auto _ : state) {
            auto x = from;
            if (!advance_all<One>(x, h)) { state.SkipWithError("a step failed"); }
            benchmark::DoNotOptimize(x.data());
        }
    });
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        volatile double h = step_size;
        for (auto _ : state) {
            hvi::Ensemble<Many> ensemble(from);
            ensemble.advance(h, steps, 1);
            if (!ensemble.ok()) { state.SkipWithError("a step failed"); }
        }
    });
}

template <class One, class Many>
bool agree(const std::string& name, double h) {
    auto x = starts(Many::initial());
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(h, steps, 1);
    bool ok = advance_all<One>(x, h) && ensemble.ok();
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t k = 0; k < x[i].q.size(); ++k) {
            ok &= std::abs(x[i].q[k] - ensemble.state(i).q[k]) < 1e-11;
        }
    }
    if (!ok) { std::fprintf(stderr, "error: %s: not the same states\n", name.c_str()); }
    return ok;
}

/// Times planets, each around a sun of its own mass, and planets around equal suns.
template <class Many>
void add_parameters(const std::string& name, double step_size) {
    std::vector<typename Many::Parameters> suns(size);
    std::vector<typename Many::Trajectory> from;
    for (std::size_t i = 0; i < size; ++i) {
        suns[i].mu += 1e-9 * static_cast<double>(i);
        from.push_back(Many::initial(suns[i]));
    }
    const auto time = [=](const std::string& which, auto ensemble_of) {
        benchmark::RegisterBenchmark((name + which).c_str(), [=](benchmark::State& state) {
            volatile double h = step_size;
            for (auto _ : state) {
                auto ensemble = ensemble_of();
                ensemble.advance(h, steps, 1);
                if (!ensemble.ok()) { state.SkipWithError("a step failed"); }
            }
        });
    };
    time("_own", [=] { return hvi::Ensemble<Many>(from, suns); });
    time("_shared", [=] { return hvi::Ensemble<Many>(from); });
}

struct Comparison {
    std::vector<bench::Ratio> ratios;
    bool all_agree = true;

    template <class Many>
    void add_own(const std::string& name, double h) {
        add_parameters<Many>(name, h);
        ratios.push_back({name + "_own", name + "_shared", "at most 1.1"});
    }

    template <class One, class Many>
    void add(const std::string& name, double h, const char* wanted) {
        all_agree &= agree<One, Many>(name, h);
        add_timings<One, Many>(name, h);
        ratios.push_back({name + "_one", name, wanted});
    }
};

}  // namespace

int main(int argc, char** argv) {
    const char* solves_nothing = "at least 4";
    const char* had_lanes = "at least 1: the stages of one are side by side as well";
    Comparison all;
    all.add<VerletPendulum, VerletPendulums>("verlet_pendulum", 0.05, solves_nothing);
    all.add<VerletHenonHeiles, VerletHenonHeileses>("verlet_henon_heiles", 0.05, solves_nothing);
    all.add<BlanesMoanPendulum, BlanesMoanPendulums>("blanes_moan_pendulum", 0.1, solves_nothing);
    all.add<BlanesMoanHenonHeiles, BlanesMoanHenonHeileses>("blanes_moan_henon_heiles", 0.1,
                                                            solves_nothing);
    all.add<KahanLiPendulum, KahanLiPendulums>("kahan_li_pendulum", 0.1, solves_nothing);
    all.add<KahanLiHenonHeiles, KahanLiHenonHeileses>("kahan_li_henon_heiles", 0.1, solves_nothing);
    all.add<Gauss4Pendulum, Gauss4Pendulums>("gauss_4_pendulum", 0.1, had_lanes);
    all.add<Gauss4HenonHeiles, Gauss4HenonHeileses>("gauss_4_henon_heiles", 0.1, had_lanes);
    all.add<Gauss8Pendulum, Gauss8Pendulums>("gauss_8_pendulum", 0.2, had_lanes);
    all.add<Gauss8HenonHeiles, Gauss8HenonHeileses>("gauss_8_henon_heiles", 0.2, had_lanes);
    all.add_own<KahanLiKeplers>("kahan_li_kepler", 0.02);
    all.add_own<Gauss4Keplers>("gauss_4_kepler", 0.02);
    return all.all_agree ? bench::time_all(argc, argv, all.ratios) : 1;
}
