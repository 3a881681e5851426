// Integrators of other libraries on a scene, measured as steppers are.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp. A Peer is made of PeerWishes, and has members
//
//     Outcome run(watch);    runs from the start to the end; watch(q, p, t) sees each state, by
//                            pointers to the coordinates and to the momenta
//     takes_equal_steps      whether steps have the size until / steps; else the tolerance decides
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/cost.hpp>
#include <driver/departure.hpp>
#include <driver/departures.hpp>
#include <driver/equations.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

struct PeerWishes {
    double until = 0;
    std::int64_t steps = 1;  ///< number of steps; adaptive peers begin with the size until / steps
    double tolerance = 0;    ///< of the error in a step, absolute and relative

    [[nodiscard]] double step() const { return until / static_cast<double>(steps); }
};

/// Limit on the number of steps, more than anybody waits for.
constexpr std::int64_t most_steps_of_peers = 100'000'000;

inline constexpr const char* no_step_is_small_enough = "no step is small enough for the tolerance";

[[nodiscard]] inline const char* not_finite() { return Status(Status::Code::not_finite).message(); }

/// Writes how fast the state moves at the end.
template <class Problem, class State>
void tell_velocity_of_peer(const State& x, double t) {
    typename Equations<Problem>::Values y{}, velocity{};
    std::copy(x.q.begin(), x.q.end(), y.begin());
    std::copy(x.p.begin(), x.p.end(), y.begin() + Equations<Problem>::n);
    Equations<Problem>().slope(y.data(), velocity.data(), t);
    for (const double value : velocity) { say("velocity", value); }
}

/// A run from the start, with its invariants.
template <class Problem, class Peer>
class WatchedRun {
public:
    /// Runs, and calls `see(t, invariants)` at each state that the peer shows.
    template <class See>
    Outcome run(const PeerWishes& wishes, See see) {
        return Peer(wishes).run([&](const double* q, const double* p, double t) {
            std::copy(q, q + x_.q.size(), x_.q.begin());
            std::copy(p, p + x_.p.size(), x_.p.begin());
            if constexpr (Problem::depends_on_time) { x_.t = t; }
            invariants_.see(stepper_, x_);
            see(t, invariants_);
        });
    }

    [[nodiscard]] const auto& state() const { return x_; }
    [[nodiscard]] const Invariants<Problem>& invariants() const { return invariants_; }

private:
    typename Problem::Stepper stepper_ = Problem::stepper();
    typename Problem::Stepper::State x_ = Problem::initial();
    Invariants<Problem> invariants_{stepper_, x_};
};

/// Writes the same answers as departures().
template <class Problem, class Peer>
void departures_of_peer(const PeerWishes& wishes, std::int64_t samples) {
    DepartureSamples<Problem> all(wishes.until, samples);
    static_cast<void>(WatchedRun<Problem, Peer>().run(
        wishes, [&](double t, const auto& invariants) { all.see(t, invariants); }));
}

/// Writes the same answers as measure(). The velocity is written only for a run of equal steps,
/// which may miss the end by the rounding of their sum.
template <class Problem, class Peer>
void measure_peer(const PeerWishes& wishes, double seconds) {
    WatchedRun<Problem, Peer> watched;
    const Outcome outcome = watched.run(wishes, [](double, const auto&) {});
    tell(outcome, watched.invariants(), watched.state());
    if constexpr (Peer::takes_equal_steps) {
        tell_velocity_of_peer<Problem>(watched.state(), wishes.until);
    }
    if (!outcome.ok() || seconds <= 0) { return; }
    tell_time(seconds, [&] {
        return [peer = Peer(wishes)]() mutable {
            return peer.run([](const double*, const double*, double) {}).ok();
        };
    });
}

/// Name of an integrator, and the functions that measure it.
struct NamedPeer {
    std::string_view name;
    void (*measure)(const PeerWishes& wishes, double seconds);
    void (*departures)(const PeerWishes& wishes, std::int64_t samples);
};

template <class Problem, class Peer>
[[nodiscard]] NamedPeer named(std::string_view name) {
    return {name, measure_peer<Problem, Peer>, departures_of_peer<Problem, Peer>};
}

/// The main() of a program that is called as `program measure NAME UNTIL STEPS TOLERANCE SECONDS`
/// or as `program departures NAME UNTIL STEPS TOLERANCE SAMPLES`.
inline int main_of_peers(int argc, char** argv, const std::vector<NamedPeer>& peers) {
    const std::vector<std::string_view> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    PeerWishes wishes;
    double seconds = 0;
    std::int64_t samples = 1;
    const bool measures = !words.empty() && words[0] == "measure",
               samples_departures = !words.empty() && words[0] == "departures";
    const bool is_right = words.size() == 6 && read(words[2], wishes.until) &&
                          read(words[3], wishes.steps) && read(words[4], wishes.tolerance) &&
                          wishes.steps >= 1 &&
                          ((measures && read(words[5], seconds)) ||
                           (samples_departures && read(words[5], samples) && samples >= 1));
    for (const NamedPeer& peer : peers) {
        if (!is_right || peer.name != words[1]) { continue; }
        measures ? peer.measure(wishes, seconds) : peer.departures(wishes, samples);
        return 0;
    }
    std::fprintf(stderr, "usage: measure NAME UNTIL STEPS TOLERANCE SECONDS\n"
                         "       departures NAME UNTIL STEPS TOLERANCE SAMPLES\n"
                         "where NAME is one of\n");
    for (const NamedPeer& peer : peers) {
        std::fprintf(stderr, "       %.*s\n", static_cast<int>(peer.name.size()), peer.name.data());
    }
    return 2;
}

}  // namespace hvi::driver
