// Trajectories of one scene as threads of a GPU, and the same loop on the host.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <hvi/detail/device/device.hpp>
#include <hvi/detail/device/real.hpp>
#include <hvi/state.hpp>

namespace hvi::device {

/// Takes one trajectory `steps` steps further, or up to the first that fails.
template <class Stepper>
HVI_DEVICE void advance_one(typename Stepper::State& state,
                            const typename Stepper::Parameters& parameters,
                            const typename Stepper::Steps& by, std::int64_t steps) {
    const Stepper stepper(parameters);
    typename Stepper::State x = state;
    for (std::int64_t step = 0; step < steps && x.status == Status::Code::ok; ++step) {
        stepper.step(x, by);
    }
    state = x;
}

/// Adds trajectory i to the list if its steps go on.
template <class State>
HVI_DEVICE void list_one(const State* states, std::size_t i, std::uint32_t* which,
                         std::uint32_t* found) {
    if (states[i].status == Status::Code::ok) { which[counted(found)] = std::uint32_t(i); }
}

/// `Stepper` is a class that `hvi-gen stepper --lanes gpu` has written. The host takes each of
/// `count` trajectories `steps` steps of size h further, one after the other. A trajectory ends
/// with the bits that it ends with on a GPU, whatever the others are, wherever it stands among
/// them, and however its steps are parted into calls. A trajectory whose step fails keeps the state
/// before that step.
/// # Use
/// `states` and `parameters` are arrays of `count`: each trajectory has parameters of its own. A
/// State is made of plain numbers, and so is copied to a GPU and back as bytes. There
/// advance_kernel<Stepper> is the kernel; docs/gpu.md shows how it is started. With the header of
///
///     hvi-gen stepper --method stormer-verlet pendulum --lanes gpu -o pendulum_threads.hpp
///
/// this is a program, to be compiled by any compiler of C++17:
/// ```cpp
/// #include <cmath>
/// #include <cstddef>
/// #include <vector>
///
/// #include <hvi/device.hpp>
/// #include <pendulum_threads.hpp>
///
/// using Pendulum = hvi::generated::PendulumStormerVerlet;  // H = p^2/2 - cos(q)
///
/// double energy(const Pendulum::State& x) { return x.p[0] * x.p[0] / 2 - std::cos(x.q[0]); }
///
/// int main() {
///     std::vector<Pendulum::State> starts(20), swings;
///     double angle = 0;
///     for (Pendulum::State& x : starts) { x.q[0] = angle += 0.1; }
///     starts[7].p[0] = std::nan("");
///     swings = starts;
///     const std::vector<Pendulum::Parameters> parameters(swings.size());
///     const double h = 0.05;
///     hvi::device::advance<Pendulum>(swings.data(), parameters.data(), swings.size(), h, 1000);
///
///     for (std::size_t i = 0; i < swings.size(); ++i) {
///         if (i == 7) { continue; }
///         // The method conserves H + h^2 (p^2 cos(q)/12 - sin(q)^2/24) up to h^4, and |p| <= 2.
///         const double error = energy(swings[i]) - energy(starts[i]);
///         if (swings[i].steps != 1000 || std::abs(error) > h * h) { return 1; }
///     }
///     const bool has_stopped = swings[7].status == hvi::Status::Code::not_finite;
///     return has_stopped && swings[7].steps == 0 ? 0 : 1;
/// }
/// ```
template <class Stepper>
void advance(typename Stepper::State* states, const typename Stepper::Parameters* parameters,
             std::size_t count, typename Stepper::Scalar h, std::int64_t steps) {
    const typename Stepper::Steps by(h);
    for (std::size_t i = 0; i < count; ++i) {
        advance_one<Stepper>(states[i], parameters[i], by, steps);
    }
}

/// Lists the trajectories whose steps go on: their numbers come to `which`, which has room for
/// `count`, and the function returns how many there are.
template <class State>
[[nodiscard]] std::size_t list_going(const State* states, std::size_t count, std::uint32_t* which) {
    std::uint32_t found = 0;
    for (std::size_t i = 0; i < count; ++i) { list_one(states, i, which, &found); }
    return found;
}

/// Takes the trajectories of a list further.
template <class Stepper>
void advance_listed(typename Stepper::State* states, const typename Stepper::Parameters* parameters,
                    const std::uint32_t* which, std::size_t count, typename Stepper::Scalar h,
                    std::int64_t steps) {
    const typename Stepper::Steps by(h);
    for (std::size_t i = 0; i < count; ++i) {
        advance_one<Stepper>(states[which[i]], parameters[which[i]], by, steps);
    }
}

#if defined(HVI_KERNEL)
// Kernels that do so on a GPU. All arrays are those of the device. Any number of threads takes any
// number of trajectories.

template <class Stepper>
HVI_KERNEL void advance_kernel(typename Stepper::State* states,
                               const typename Stepper::Parameters* parameters, std::size_t count,
                               typename Stepper::Steps by, std::int64_t steps) {
    for (std::size_t i = thread_number(); i < count; i += thread_count()) {
        advance_one<Stepper>(states[i], parameters[i], by, steps);
    }
}

/// NOTE: `found`, one number, is to be 0 before. The order of the list is any, and no bit of a
/// trajectory depends on it.
template <class State>
HVI_KERNEL void list_going_kernel(const State* states, std::size_t count, std::uint32_t* which,
                                  std::uint32_t* found) {
    for (std::size_t i = thread_number(); i < count; i += thread_count()) {
        list_one(states, i, which, found);
    }
}

template <class Stepper>
HVI_KERNEL void advance_listed_kernel(typename Stepper::State* states,
                                      const typename Stepper::Parameters* parameters,
                                      const std::uint32_t* which, std::size_t count,
                                      typename Stepper::Steps by, std::int64_t steps) {
    for (std::size_t i = thread_number(); i < count; i += thread_count()) {
        advance_one<Stepper>(states[which[i]], parameters[which[i]], by, steps);
    }
}
#endif

}  // namespace hvi::device
