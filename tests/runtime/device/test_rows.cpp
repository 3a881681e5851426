// Rows of an ensemble that a device takes at once, against steppers one by one.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>
#include <hvi/detail/device/rows.hpp>

#include "steppers.hpp"

using namespace device_test;

namespace {

using hvi::detail::DrivenAnswer;
using hvi::detail::EnsembleRows;
using hvi::detail::RowFunctions;

/// A scene that a module could have, with one function of it as an invariant.
template <class Threads>
struct Module {
    using Stepper = Threads;
    using Parameters = typename Stepper::Parameters;

    static Parameters parameters(const char*) { return {}; }
    static constexpr std::size_t invariant_count = 1;
    static void values(const Stepper&, const typename Stepper::State& x, double* out) {
        *out = 3 * x.q[0];
    }
};

struct KeplerModule : Module<made::VerletKeplerThreads> {
    static void set(Parameters& parameters, hvi::detail::ParameterReader& reader) {
        reader.number(parameters.mu);
        reader.number(parameters.ecc);
    }
};

struct StagesModule : Module<made::Gauss4KeplerThreads> {
    static void set(Parameters& parameters, hvi::detail::ParameterReader& reader) {
        reader.number(parameters.mu);
        reader.number(parameters.ecc);
    }
};

/// H depends on the time, and has no parameter.
struct SwingModule : Module<made::VerletSwingThreads> {
    static void set(Parameters&, hvi::detail::ParameterReader&) {}
};

/// Rows of numbers, and their ends.
class Rows {
public:
    std::vector<double> parameters, h;
    std::vector<std::int64_t> steps;
    bool looks = true;  ///< at the energy and at what is conserved
    bool (*is_stopped)() = [] { return false; };

    std::vector<double> states, energy_errors, conserved;
    std::vector<std::int64_t> taken;
    std::vector<int> statuses;
    std::string message;

    DrivenAnswer take(const RowFunctions& call) {
        const std::size_t count = h.size();
        const hvi::detail::DrivenSizes& sizes = call.sizes;
        states.assign(count * (sizes.coordinates + sizes.momenta + (sizes.has_time ? 1 : 0)), -1);
        taken.assign(count, -1);
        statuses.assign(count, -1);
        energy_errors.assign(count, -1);
        conserved.assign(count * (sizes.invariants + (sizes.has_time ? 0 : 1)), -1);
        const EnsembleRows rows{count,
                                parameters.data(),
                                h.data(),
                                steps.data(),
                                states.data(),
                                taken.data(),
                                statuses.data(),
                                looks ? energy_errors.data() : nullptr,
                                looks ? conserved.data() : nullptr,
                                is_stopped};
        char text[200] = "";
        const DrivenAnswer answer =
            call.take(".", count == 0 ? 0 : parameters.size() / count, rows, text, sizeof text);
        message = text;
        return answer;
    }
};

/// A stepper that takes steps one by one.
template <class Problem>
struct Alone {
    using Stepper = typename Problem::Stepper;

    Alone(const Rows& rows, std::size_t i) {
        typename Stepper::Parameters parameters;
        const std::size_t size = rows.parameters.size() / rows.h.size();
        hvi::detail::ParameterReader reader(rows.parameters.data() + i * size, size);
        Problem::set(parameters, reader);
        const Stepper stepper(parameters);
        x = Stepper::initial(parameters);
        const double energy = stepper.energy(x);
        const typename Stepper::Steps by(rows.h[i]);
        for (std::int64_t step = 0; step < rows.steps[i]; ++step) {
            stepper.step(x, by);
            energy_error = std::fmax(energy_error, std::fabs(stepper.energy(x) - energy));
        }
        if (!has_time) { conserved.push_back(stepper.energy(x)); }
        conserved.push_back(3 * x.q[0]);
    }

    static constexpr bool has_time = HasTime<typename Stepper::State>::value;

    typename Stepper::State x;
    double energy_error = 0;
    std::vector<double> conserved;
};

bool same_numbers(const double* x, const double* y, std::size_t count) {
    return std::memcmp(x, y, count * sizeof(double)) == 0;
}

/// Checks row i against its stepper.
template <class Problem>
void check_row(const Rows& rows, std::size_t i) {
    const Alone<Problem> alone(rows, i);
    const std::size_t n = alone.x.q.size(), size = rows.states.size() / rows.h.size();
    const double* const state = rows.states.data() + i * size;
    INFO("row " << i);
    CHECK(rows.statuses[i] == 0);
    CHECK(rows.taken[i] == rows.steps[i]);
    CHECK(same_numbers(state, &alone.x.q[0], n));
    CHECK(same_numbers(state + n, &alone.x.p[0], n));
    const std::size_t values = alone.conserved.size();
    CHECK(same_numbers(rows.conserved.data() + values * i, alone.conserved.data(), values));
    if constexpr (HasTime<decltype(alone.x)>::value) {
        CHECK(size == 2 * n + 1);
        CHECK(same_numbers(state + 2 * n, &alone.x.t, 1));
        CHECK(rows.energy_errors[i] == 0);
    } else {
        CHECK(size == 2 * n);
        CHECK(rows.energy_errors[i] == alone.energy_error);
        CHECK((rows.energy_errors[i] > 0) == (rows.steps[i] > 0));
    }
}

/// Rows with steps of several sizes, from none of them to more than are taken between two looks.
Rows rows_of(std::size_t count, bool have_parameters) {
    Rows rows;
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = static_cast<double>(i);
        if (have_parameters) {
            rows.parameters.insert(rows.parameters.end(), {1 + number / 8, 0.3});
        }
        rows.h.push_back((i % 3 == 2 ? -1.0 : 1.0) / (64 << i % 4));
        rows.steps.push_back(i % 5 == 4 ? 9000 + std::int64_t(i) : 37 * std::int64_t(i));
    }
    return rows;
}

// ---- devices other than the host ----

/// A device with room for a few numbers, which counts arrays that it had no room for.
struct SmallDevice : hvi::device::Host {
    static inline std::size_t room = 0;
    static inline int refused = 0;

    template <class T>
    class Array : public Host::Array<T> {
    public:
        explicit Array(std::size_t count) : Host::Array<T>(checked(count)) {}
        explicit Array(const std::vector<T>& items) : Host::Array<T>(items) {
            static_cast<void>(checked(items.size()));
        }

    private:
        static std::size_t checked(std::size_t count) {
            if (count * sizeof(T) <= room) { return count; }
            ++refused;
            throw std::bad_alloc();
        }
    };
};

struct MissingDevice : hvi::device::Host {
    static void check() { throw std::runtime_error("no device was found"); }
};

}  // namespace

TEMPLATE_TEST_CASE("rows with steps of their own have the bits of steppers", "", KeplerModule,
                   StagesModule) {
    Rows rows = rows_of(23, true);
    REQUIRE(rows.take(hvi::device::DeviceRows<TestType>::functions()) == DrivenAnswer::ok);
    for (std::size_t i = 0; i < rows.h.size(); ++i) { check_row<TestType>(rows, i); }
    CHECK(*std::max_element(rows.taken.begin(), rows.taken.end()) > 8192);
}

TEST_CASE("rows whose H depends on the time end with it") {
    constexpr RowFunctions call = hvi::device::DeviceRows<SwingModule>::functions();
    CHECK(call.version == hvi::detail::rows_version);
    CHECK(call.sizes.has_time);
    Rows rows = rows_of(9, false);
    REQUIRE(rows.take(call) == DrivenAnswer::ok);
    for (std::size_t i = 0; i < rows.h.size(); ++i) { check_row<SwingModule>(rows, i); }
    // NOTE: the size of steps is a power of 2, so that the time is a product.
    CHECK(rows.states[4 * 3 + 2] == 9004 * rows.h[4]);
}

TEST_CASE("rows that fail end by themselves") {
    Rows rows = rows_of(6, true);
    rows.parameters[2 * 2 + 1] = 1.5;  // it begins with the root of a negative number
    rows.h[3] = 1e200;
    rows.steps[3] = rows.steps[4];
    REQUIRE(rows.take(hvi::device::DeviceRows<KeplerModule>::functions()) == DrivenAnswer::ok);
    const std::size_t others[] = {0, 1, 4, 5};
    for (const std::size_t i : others) { check_row<KeplerModule>(rows, i); }
    const int not_finite = static_cast<int>(hvi::Status::Code::not_finite);
    CHECK(rows.statuses[2] == not_finite);
    CHECK(rows.taken[2] == 0);
    CHECK(std::isnan(rows.states[2 * 4 + 3]));
    CHECK(rows.statuses[3] == not_finite);
    CHECK(rows.taken[3] < 9000);
    CHECK(std::isfinite(rows.states[3 * 4]));
}

TEST_CASE("energies and conserved values are left out where nobody asks for them") {
    Rows rows = rows_of(6, true), plain = rows;
    plain.looks = false;
    constexpr RowFunctions call = hvi::device::DeviceRows<KeplerModule>::functions();
    REQUIRE(rows.take(call) == DrivenAnswer::ok);
    REQUIRE(plain.take(call) == DrivenAnswer::ok);
    CHECK(same_numbers(rows.states.data(), plain.states.data(), rows.states.size()));
    CHECK(plain.taken == rows.taken);
    CHECK(plain.energy_errors == std::vector<double>(6, -1));
    CHECK(plain.conserved == std::vector<double>(12, -1));
}

TEST_CASE("rows stop on the way where somebody asks for the end") {
    static int looks = 0;
    looks = 0;
    Rows rows = rows_of(10, true), whole = rows;
    rows.is_stopped = [] { return ++looks > 1; };
    constexpr RowFunctions call = hvi::device::DeviceRows<KeplerModule>::functions();
    REQUIRE(rows.take(call) == DrivenAnswer::ok);
    CHECK(looks == 2);
    for (std::size_t i = 0; i < rows.h.size(); ++i) {
        INFO("row " << i);
        if (i % 5 != 4) {
            check_row<KeplerModule>(rows, i);
            continue;
        }
        CHECK(rows.statuses[i] == hvi::detail::row_not_finished);
        CHECK(rows.taken[i] > 0);
        CHECK(rows.taken[i] < rows.steps[i]);
    }
}

TEST_CASE("rows that a device has no room for are taken in parts") {
    using Small = hvi::device::DeviceRows<KeplerModule, SmallDevice>;
    Rows rows = rows_of(23, true);
    SmallDevice::room = 5 * sizeof(KeplerModule::Stepper::State);
    SmallDevice::refused = 0;
    REQUIRE(rows.take(Small::functions()) == DrivenAnswer::ok);
    for (std::size_t i = 0; i < rows.h.size(); ++i) { check_row<KeplerModule>(rows, i); }
    CHECK(SmallDevice::refused >= 3);

    SmallDevice::room = 1;
    CHECK(rows.take(Small::functions()) == DrivenAnswer::out_of_memory);
}

TEST_CASE("what is wrong with parameters or a device is said") {
    Rows rows = rows_of(3, true);
    rows.parameters.insert(rows.parameters.end(), {1, 1, 1});
    constexpr RowFunctions call = hvi::device::DeviceRows<KeplerModule>::functions();
    CHECK(rows.take(call) == DrivenAnswer::failed);
    CHECK(rows.message == "these are not the parameters of the scene");
    rows = rows_of(3, true);
    rows.parameters[3] = HUGE_VAL;
    CHECK(rows.take(call) == DrivenAnswer::failed);
    rows = rows_of(3, true);
    CHECK(rows.take(hvi::device::DeviceRows<KeplerModule, MissingDevice>::functions()) ==
          DrivenAnswer::failed);
    CHECK(rows.message == "no device was found");
    Rows none;
    CHECK(none.take(call) == DrivenAnswer::ok);
}
