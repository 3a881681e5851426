// Runs kernels, translated from their text for a card, and compares bits with those of the host.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>

#include "kernels_to_run.hpp"

#define HVI_DECLARED(name, Stepper) extern "C" void name(void** arguments);
HVI_KERNELS_TO_RUN(HVI_DECLARED)

namespace {

template <class State>
bool same(const State& x, const State& y) {
    return std::memcmp(&x.q, &y.q, sizeof x.q) == 0 && std::memcmp(&x.p, &y.p, sizeof x.p) == 0 &&
           x.steps == y.steps && x.status == y.status;
}

/// Returns whether 200 trajectories end alike, some of which fail.
template <class Stepper>
bool ends_alike(const char* name, void (*kernel)(void**)) {
    using Number = typename Stepper::Scalar;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> by_up_to(-0.3, 0.3);
    const typename Stepper::Parameters parameters;
    const typename Stepper::Steps by(Number(0.05));
    std::int64_t steps = 100, taken = 0;
    int different = 0;
    for (int i = 0; i < 200; ++i) {
        auto on_host = Stepper::initial(parameters);
        for (std::size_t k = 0; k < on_host.q.size(); ++k) {
            on_host.q[k] += static_cast<Number>(by_up_to(random));
            on_host.p[k] += static_cast<Number>(by_up_to(random));
        }
        if (i % 50 == 7) { on_host.q[0] = Number(1e30); }
        auto on_card = on_host;
        hvi::device::advance_one<Stepper>(on_host, parameters, by, steps);
        void *x = &on_card, *of_x = const_cast<typename Stepper::Parameters*>(&parameters);
        void* arguments[] = {&x, &of_x, const_cast<typename Stepper::Steps*>(&by), &steps};
        kernel(arguments);
        different += same(on_host, on_card) ? 0 : 1;
        taken += on_host.steps;
    }
    std::printf("%s: %d of 200 trajectories differ, of %lld steps\n", name, different,
                static_cast<long long>(taken));
    return different == 0 && taken > 10'000;
}

}  // namespace

int main() {
    bool are_alike = true;
#define HVI_COMPARED(name, Stepper) are_alike &= ends_alike<Stepper>(#name, name);
    HVI_KERNELS_TO_RUN(HVI_COMPARED)
    return are_alike ? 0 : 1;
}
