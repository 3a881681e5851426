// Integrators of other libraries on a scene, measured as steppers are.
// SPDX-License-Identifier: MIT
//
// For `Problem` see main.hpp. A Peer is made of PeerWishes, and has members
//
//     Outcome run(watch);    from the start to the end; watch(q, p, t) sees where it comes to, with
//                            pointers to the coordinates and to the momenta
//     takes_equal_steps      of the size until / steps; else it chooses sizes by the tolerance
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
#include <driver/equations.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

struct PeerWishes {
    double until = 0;
    std::int64_t steps = 1;  ///< how many are taken; where sizes are chosen, of which size the
                             ///< first one is
    double tolerance = 0;    ///< of the error in a step, absolute and relative

    [[nodiscard]] double step() const { return until / static_cast<double>(steps); }
};

/// More steps than anybody waits for.
constexpr std::int64_t most_steps_of_peers = 100'000'000;

inline constexpr const char* no_step_is_small_enough = "no step is small enough for the tolerance";

[[nodiscard]] inline const char* not_finite() { return Status(Status::Code::not_finite).message(); }

/// Says how fast the state moves at the end.
template <class Problem, class State>
void tell_velocity_of_peer(const State& x, double t) {
    typename Equations<Problem>::Values y{}, velocity{};
    std::copy(x.q.begin(), x.q.end(), y.begin());
    std::copy(x.p.begin(), x.p.end(), y.begin() + Equations<Problem>::n);
    Equations<Problem>().slope(y.data(), velocity.data(), t);
    for (const double value : velocity) { say("velocity", value); }
}

/// Says what measure() does; the velocity only where a run of equal steps may miss the end by what
/// their sum is rounded.
template <class Problem, class Peer>
void measure_peer(const PeerWishes& wishes, double seconds) {
    auto x = Problem::initial();
    const auto stepper = Problem::stepper();
    Invariants<Problem> invariants(stepper, x);
    const Outcome outcome = Peer(wishes).run([&](const double* q, const double* p, double t) {
        std::copy(q, q + x.q.size(), x.q.begin());
        std::copy(p, p + x.p.size(), x.p.begin());
        if constexpr (Problem::depends_on_time) { x.t = t; }
        static_cast<void>(t);
        invariants.see(stepper, x);
    });
    tell(outcome, invariants, x);
    if constexpr (Peer::takes_equal_steps) { tell_velocity_of_peer<Problem>(x, wishes.until); }
    if (!outcome.ok() || seconds <= 0) { return; }
    tell_time(seconds, [&] {
        return [peer = Peer(wishes)]() mutable {
            return peer.run([](const double*, const double*, double) {}).ok();
        };
    });
}

/// A name and what measures the integrator that it is of.
struct NamedPeer {
    std::string_view name;
    void (*measure)(const PeerWishes& wishes, double seconds);
};

/// The main() of a program that is called as `program NAME UNTIL STEPS TOLERANCE SECONDS`.
inline int main_of_peers(int argc, char** argv, const std::vector<NamedPeer>& peers) {
    const std::vector<std::string_view> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    PeerWishes wishes;
    double seconds = 0;
    const bool is_right = words.size() == 5 && read(words[1], wishes.until) &&
                          read(words[2], wishes.steps) && read(words[3], wishes.tolerance) &&
                          read(words[4], seconds) && wishes.steps >= 1;
    for (const NamedPeer& peer : peers) {
        if (!is_right || peer.name != words[0]) { continue; }
        peer.measure(wishes, seconds);
        return 0;
    }
    std::fprintf(stderr, "usage: NAME UNTIL STEPS TOLERANCE SECONDS, where NAME is one of\n");
    for (const NamedPeer& peer : peers) {
        std::fprintf(stderr, "       %.*s\n", static_cast<int>(peer.name.size()), peer.name.data());
    }
    return 2;
}

}  // namespace hvi::driver
