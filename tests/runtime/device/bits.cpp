// Prints the bits of some trajectories. It is compiled with several options: bits are the same.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "tests/runtime/device/steppers.hpp"

namespace {

using namespace device_test;

void print(const char* name, double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    std::printf("%s %016llx\n", name, static_cast<unsigned long long>(bits));
}

template <class Stepper>
void print_run(const char* name) {
    using Number = typename Stepper::Scalar;
    // NOTE: what is compiled with several options is no part of the starts.
    std::vector<typename Stepper::State> x(8, Stepper::initial());
    for (std::size_t i = 0; i < x.size(); ++i) { x[i].q[0] += static_cast<Number>(i) / 32; }
    const auto same = parameters<Stepper>(x.size());
    hvi::device::advance<Stepper>(x.data(), same.data(), x.size(), Number(0.03), 300);
    for (const auto& each : x) {
        for (std::size_t k = 0; k < each.q.size(); ++k) {
            print(name, static_cast<double>(each.q[k]));
            print(name, static_cast<double>(each.p[k]));
        }
    }
}

}  // namespace

int main() {
    print_run<made::BasicVerletFunctionsThreads<double>>("functions");
    print_run<made::BasicVerletFunctionsThreads<float>>("functions in float");
    print_run<made::BasicKahanLiKeplerThreads<double>>("kepler");
    print_run<made::BasicKahanLiKeplerThreads<float>>("kepler in float");
    print_run<made::BasicVerletSwingThreads<double>>("swing");
    print_run<made::BasicGauss2DoublePendulumThreads<double>>("double pendulum");
    print_run<made::BasicGauss3NonseparableThreads<double>>("nonseparable");
    print_run<made::BasicGauss3NonseparableThreads<float>>("nonseparable in float");
    return 0;
}
