// Rows on a card that is pretended: functions of CUDA on the host, where a card's memory is memory
// that copies alone may touch. The bits are those of the loop on the host.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <device/gauss_4_kepler.hpp>
#include <hvi/detail/device/rows.hpp>

#include "pretended_card.hpp"

namespace {

namespace device = hvi::device;
using hvi::detail::DrivenAnswer;
using Stepper = hvi::generated::Gauss4KeplerThreads;

struct Problem {
    using Stepper = ::Stepper;
    using Parameters = Stepper::Parameters;

    static Parameters parameters(const char*) { return {}; }
    static void set(Parameters& parameters, hvi::detail::ParameterReader& reader) {
        reader.number(parameters.mu);
        reader.number(parameters.ecc);
    }
    static constexpr std::size_t invariant_count = 0;
    static void values(const Stepper&, const Stepper::State&, double*) {}
};

/// Has the card know a kernel. NOTE: it takes rows in another order than the loop of the host.
template <template <class> class Body>
void know() {
    pretended_card.kernels[reinterpret_cast<const void*>(&device::body_kernel<Body<Stepper>>)] =
        [](void** arguments) {
            const std::size_t count = *static_cast<const std::size_t*>(arguments[0]);
            const auto& body = *static_cast<const Body<Stepper>*>(arguments[1]);
            for (std::size_t i = count; i-- > 0;) { body(i); }
        };
}

constexpr std::size_t count = 200;

/// The ends of rows, of which one begins with no number, and one takes too large steps.
struct Ends {
    DrivenAnswer answer;
    std::vector<double> states, energy_errors, conserved;
    std::vector<std::int64_t> taken;
    std::vector<int> statuses;
    std::string message;

    friend bool operator==(const Ends& x, const Ends& y) {
        // NOTE: as bytes, since a state may be NaN.
        return x.answer == y.answer && x.taken == y.taken && x.statuses == y.statuses &&
               x.energy_errors == y.energy_errors && x.message == y.message &&
               std::memcmp(x.states.data(), y.states.data(), 4 * count * sizeof(double)) == 0 &&
               std::memcmp(x.conserved.data(), y.conserved.data(), count * sizeof(double)) == 0;
    }
};

Ends ends_by(const hvi::detail::RowFunctions& call) {
    std::vector<double> parameters, h;
    std::vector<std::int64_t> steps;
    for (std::size_t i = 0; i < count; ++i) {
        const double ecc = i == 30 ? 2 : 0.3;
        parameters.insert(parameters.end(), {1 + static_cast<double>(i) / 100, ecc});
        h.push_back(i == 40 ? 1e300 : (i % 2 == 0 ? 0.01 : -0.02));
        steps.push_back(i % 50 == 3 ? 5000 : static_cast<std::int64_t>(i));
    }
    Ends ends{{},
              std::vector<double>(4 * count),
              std::vector<double>(count),
              std::vector<double>(count),
              std::vector<std::int64_t>(count),
              std::vector<int>(count),
              {}};
    char message[200] = "";
    ends.answer = call.take(".", 2,
                            {count, parameters.data(), h.data(), steps.data(), ends.states.data(),
                             ends.taken.data(), ends.statuses.data(), ends.energy_errors.data(),
                             ends.conserved.data(), [] { return false; }},
                            message, sizeof message);
    ends.message = message;
    return ends;
}

int faults = 0;

void demand(bool is_so, const char* what) {
    if (is_so) { return; }
    std::printf("wrong: %s\n", what);
    ++faults;
}

}  // namespace

int main() {
    know<device::BeginRow>();
    know<device::ListRow>();
    know<device::AdvanceRow>();
    const auto on_host = device::DeviceRows<Problem, device::Host>::functions(),
               on_card = device::DeviceRows<Problem>::functions();
    const Ends expected = ends_by(on_host);
    demand(expected.answer == DrivenAnswer::ok, "the host takes rows");
    demand(expected.taken[3] == 5000 && expected.taken[30] == 0, "rows end where they should");

    pretended_card.room = std::size_t{1} << 20;
    demand(ends_by(on_card) == expected, "a card takes rows to the same bits");
    // 5000 steps are two launches, each after one that lists rows, as is the end.
    demand(pretended_card.launches == 1 + 3 + 2, "a card is called as often as needed");

    pretended_card.room = 50 * sizeof(Stepper::State);
    demand(ends_by(on_card) == expected, "a card with little room takes them in parts");
    demand(pretended_card.refused == 2, "parts are halved");

    pretended_card.room = 1;
    demand(ends_by(on_card).answer == DrivenAnswer::out_of_memory, "a card without room says so");
    demand(pretended_card.arrays == 0, "all room is given back");

    pretended_card.room = std::size_t{1} << 20;
    pretended_card.kernels.clear();
    demand(ends_by(on_card).message == "the CUDA device failed: it is broken", "a fault is told");
    pretended_card.count = 0;
    demand(ends_by(on_card).message == "no CUDA device was found: none is there",
           "without a card that is told");
    return faults == 0 ? 0 : 1;
}
