// Modules beside the steppers that C++ programs include.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/trajectories/flat.hpp>

/// The functions of a module that its tests call, with one name for all modules.
template <class Handle>
struct Functions {
    int (*create)(const double*, std::size_t, Handle**);
    int (*destroy)(Handle*);
    int (*copy)(const Handle*, Handle**);
    int (*reset)(Handle*);
    std::size_t (*size)(const Handle*);
    int (*initial)(const Handle*, double*);
    int (*step)(Handle*, double*, double);
    int (*integrate)(Handle*, double*, double, double, std::size_t, std::size_t, const char*,
                     double*, std::size_t, std::size_t*);
    int (*energy)(const Handle*, const double*, double*);
    const char* (*status_text)(int);
};

#define FUNCTIONS_OF(name)                                                                         \
    Functions<name##_stepper> {                                                                    \
        name##_create, name##_destroy, name##_copy, name##_reset, name##_size, name##_initial,     \
            name##_step, name##_integrate, name##_energy, name##_status_text                       \
    }

/// A stepper of a module, destroyed at the end of its life.
template <class Handle>
class Module {
public:
    explicit Module(const Functions<Handle>& functions, const std::vector<double>& parameters = {})
        : call(functions) {
        REQUIRE(call.create(parameters.data(), parameters.size(), &handle) == 0);
    }
    ~Module() { CHECK(call.destroy(handle) == 0); }
    Module(const Module&) = delete;
    Module& operator=(const Module&) = delete;

    [[nodiscard]] std::vector<double> initial() const {
        std::vector<double> x(call.size(handle));
        REQUIRE(call.initial(handle, x.data()) == 0);
        return x;
    }

    /// Where steps one by one lead.
    [[nodiscard]] std::vector<double> after(int steps, double h) {
        std::vector<double> x = initial();
        for (int k = 0; k < steps; ++k) { REQUIRE(call.step(handle, x.data(), h) == 0); }
        return x;
    }

    Functions<Handle> call;
    Handle* handle = nullptr;
};

inline bool same_bits(const std::vector<double>& x, const std::vector<double>& y) {
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

/// Numbers of a state of a stepper in C++, with its time.
template <class Stepper>
std::vector<double> numbers_and_time(const typename Stepper::State& x) {
    std::vector<double> all = hvi::detail::numbers<Stepper>(x);
    if constexpr (requires { x.t; }) { all.push_back(x.t); }
    return all;
}

template <class Stepper>
std::vector<double> in_cpp_after(int steps, double h) {
    Stepper stepper;
    auto x = Stepper::initial();
    for (int k = 0; k < steps; ++k) { REQUIRE(stepper.step(x, h).ok()); }
    return numbers_and_time<Stepper>(x);
}
