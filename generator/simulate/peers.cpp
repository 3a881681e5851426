// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/peers.hpp"

#include <fmt/format.h>

#include <memory>

#include "generator/read/method.hpp"
#include "generator/support/child.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* probe_of_odeint = R"(#if !__has_include(<boost/numeric/odeint.hpp>)
#error Boost.Odeint is not installed
#endif
#include <boost/version.hpp>
#include <cstdio>
int main() {
    std::printf("%d.%d\n", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000);
    return 0;
}
)";

// NOTE: the probe is linked as the driver is, and started: headers alone do not make a library.
constexpr const char* probe_of_gsl = R"(#include <cstdio>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_version.h>
int main() {
    std::printf("%s\n", gsl_version);
    return gsl_odeiv2_step_rk8pd == nullptr ? 1 : 0;
}
)";

std::vector<std::string> words(const std::string& command, const Peer& peer, const PeerRun& run,
                               const std::string& last) {
    return {command,
            peer.name,
            fmt::format("{}", run.until),
            std::to_string(run.steps),
            fmt::format("{}", run.tolerance),
            last};
}

}  // namespace

const std::vector<PeerLibrary>& peer_libraries() {
    static const std::vector<PeerLibrary> libraries{
        {"odeint",
         "Boost.Odeint",
         probe_of_odeint,
         {"peers_odeint", "odeint::main", {}},
         {{"bulirsch-stoer", 0}, {"rkf78", 8}, {"sb3a", 4, true, true}}},
        {"gsl",
         "the GNU Scientific Library",
         probe_of_gsl,
         {"peers_gsl", "gsl::main", {"gsl", "gslcblas"}},
         {{"rk4imp", 4, true}, {"rk8pd", 8}}}};
    return libraries;
}

std::optional<std::string> installed_version(Builds& builds, const PeerLibrary& library) {
    try {
        const auto program = built(builds.order({library.probe, {}, library.driver.libraries}));
        const ChildResult answer = run_child({program.string()}, ".");
        std::string version = answer.output.substr(0, answer.output.find('\n'));
        if (answer.ok() && version.find_first_of("0123456789") == 0) return version;
    } catch (const EnvironmentError&) {}
    return {};
}

bool applies(const Peer& peer, const System& system) {
    return !peer.needs_separable || (system.structure.is_separable && !system.time);
}

SceneStepper stepper_for_peers(const LoweredScene& scene) {
    // NOTE: the method has equations to solve, so that Newton's method wants second derivatives.
    const auto name = std::make_shared<const Source>(Source{"--method", "gauss:2"});
    return scene_stepper(named_method(name), scene, simulation_wishes(Solver::newton));
}

Measurement measure_peer(const std::filesystem::path& program, const Peer& peer, const PeerRun& run,
                         double seconds) {
    return measurement(
        ask(Program{program}, words("measure", peer, run, fmt::format("{}", seconds))));
}

DepartureSamples sample_departures_of_peer(const std::filesystem::path& program, const Peer& peer,
                                           const PeerRun& run, std::int64_t samples) {
    return departure_samples(
        ask(Program{program}, words("departures", peer, run, std::to_string(samples))));
}

}  // namespace hvi::gen
