// Runs kernels, translated from their text for a card, and compares bits with those of the host.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

#include "kernels_to_run.hpp"

#define HVI_DECLARED(name, Stepper) extern "C" void name(void** arguments);
HVI_KERNELS_TO_RUN(HVI_DECLARED)
HVI_ROWS_TO_RUN(HVI_DECLARED)

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

/// Rows with parameters, sizes and numbers of steps of their own.
template <class Stepper>
struct Rows {
    static constexpr std::size_t count = 60;

    Rows() {
        for (const double h : {0.05, -0.03, 1e10}) { sizes.emplace_back(h); }
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t size = i == 7 ? 2 : i % 2;
            starts.push_back({typename Stepper::Parameters{}, 4 * std::int64_t(i), size});
            which.push_back((i + 11) % count);
            auto x = Stepper::initial(starts[i].parameters);
            x.p[0] += 0.01 * i;
            states.push_back(x);
            energies.push_back({Stepper(starts[i].parameters).energy(x)});
        }
    }

    hvi::device::AdvanceRow<Stepper> further(std::int64_t most) {
        return {{starts.data(), sizes.data(), states.data(), energies.data()}, which.data(), most};
    }

    std::vector<hvi::device::RowStart<Stepper>> starts;
    std::vector<typename Stepper::Steps> sizes;
    std::vector<typename Stepper::State> states;
    std::vector<hvi::device::LargestDeparture> energies;
    std::vector<std::uint32_t> which;
};

template <class Stepper>
bool rows_end_alike(const char* name, void (*kernel)(void**)) {
    Rows<Stepper> on_host, on_card;
    for (const std::int64_t most : {100, 1000}) {
        auto host = on_host.further(most), card = on_card.further(most);
        for (std::size_t i = 0; i < Rows<Stepper>::count; ++i) {
            host(i);
            void* arguments[] = {&card, &i};
            kernel(arguments);
        }
    }
    int different = 0;
    std::int64_t taken = 0;
    for (std::size_t i = 0; i < Rows<Stepper>::count; ++i) {
        const double energies[] = {on_host.energies[i].largest, on_card.energies[i].largest};
        const bool is_same = same(on_host.states[i], on_card.states[i]) &&
                             std::memcmp(&energies[0], &energies[1], sizeof energies[0]) == 0;
        different += is_same ? 0 : 1;
        taken += on_card.states[i].steps;
    }
    std::printf("%s: %d of 60 rows differ, of %lld steps\n", name, different,
                static_cast<long long>(taken));
    return different == 0 && taken > 5000;
}

}  // namespace

int main() {
    bool are_alike = true;
#define HVI_COMPARED(name, Stepper) are_alike &= ends_alike<Stepper>(#name, name);
    HVI_KERNELS_TO_RUN(HVI_COMPARED)
#define HVI_ROWS_COMPARED(name, Stepper) are_alike &= rows_end_alike<Stepper>(#name, name);
    HVI_ROWS_TO_RUN(HVI_ROWS_COMPARED)
    return are_alike ? 0 : 1;
}
