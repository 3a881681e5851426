// Integrators of other libraries, which get scenes as steppers do.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/program/builds.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

struct Peer {
    std::string name;                ///< the name in its library, and for the driver
    int order = 0;                   ///< 0 where the order varies
    bool takes_equal_steps = false;  ///< else a tolerance determines them
    bool needs_separable = false;    ///< needs a separable H without explicit time
};

struct PeerLibrary {
    std::string name;
    std::string title;  ///< for people
    std::string probe;  ///< a program that prints the version
    Driver driver;
    std::vector<Peer> peers;
};

[[nodiscard]] const std::vector<PeerLibrary>& peer_libraries();

/// Returns the version of a library; empty where the compiler does not find it. Throws
/// Interruption.
[[nodiscard]] std::optional<std::string> installed_version(Builds& builds,
                                                           const PeerLibrary& library);

[[nodiscard]] bool applies(const Peer& peer, const System& system);

/// Returns a stepper with the functions of a scene that peers evaluate. Throws as scene_stepper()
/// does.
[[nodiscard]] SceneStepper stepper_for_peers(const LoweredScene& scene);

/// A run of a peer. For adaptive peers, `tolerance` is their error tolerance, and until/steps the
/// first step size.
struct PeerRun {
    double until = 0;
    std::int64_t steps = 1;
    double tolerance = 0;
};

/// Runs a program that is made with the library's driver, as measure() does.
[[nodiscard]] Measurement measure_peer(const std::filesystem::path& program, const Peer& peer,
                                       const PeerRun& run, double seconds);

/// Samples departures of a peer, as sample_departures() does.
[[nodiscard]] DepartureSamples sample_departures_of_peer(const std::filesystem::path& program,
                                                         const Peer& peer, const PeerRun& run,
                                                         std::int64_t samples);

}  // namespace hvi::gen
