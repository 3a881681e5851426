// Directions that the steps of a module carry along as parts of dual numbers.
// SPDX-License-Identifier: MIT
//
// NOTE: <driver/dual.hpp> is to be included before the header of the stepper, and this behind it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <vector>

#include <driver/dual.hpp>
#include <driver/turns.hpp>
#include <hvi/detail/module/driven.hpp>
#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/detail/trajectories/has_time.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// Space of the coordinates of a stepper: numbers alone, unless it names another.
template <class Stepper, class = void>
struct SpaceOf {
    struct Type {
        static constexpr std::size_t coordinates = std::tuple_size_v<decltype(Stepper::State::q)>;
        static constexpr std::size_t rotations = 0, degrees_of_freedom = coordinates;
    };
};
template <class Stepper>
struct SpaceOf<Stepper, std::void_t<typename Stepper::Space>> {
    using Type = typename Stepper::Space;
};

/// Directions of a stepper, with rotations or flows of parts of H, that is computed in dual
/// numbers, as many at a time as these have parts. A direction of a rotation R is the theta of R
/// exp(hat theta), and one of its angular momentum L in the body is dL.
///
/// NOTE: a stepper remembers what its last step left behind, as long as it goes on from where that
/// ended, derivatives included. So states are kept, and made anew only where directions, or the
/// state, are others than those that the last step ended with.
template <class Stepper>
class CarriedInDuals {
public:
    using State = typename Stepper::State;
    using Scalar = typename Stepper::Scalar;

    /// Advances x by a step of size h, and so many directions along with it: their numbers stand
    /// one after the other, those of coordinates and of turns before those of momenta. Unless the
    /// status is ok, all have kept their bits. `idle`: a stepper with the parameters.
    [[nodiscard]] Status step(const Stepper& idle, State& x, double* numbers, std::size_t count,
                              double h) {
        if (!goes_on(x, numbers, count)) { begin(idle, x, numbers, count); }
        last_.clear();
        int iterations = 0;
        for (Group& group : groups_) {
            const Status status = group.stepper.step(group.x, static_cast<Scalar>(h));
            iterations += status.iterations;
            if (!status.ok()) { return Status(status.code(), iterations); }
        }
        x = groups_.front().x;
        for (Group& group : groups_) { take_values(group.x, x); }
        last_.resize(count * size);
        for (std::size_t k = 0; k < count; ++k) { give(k, last_.data() + k * size); }
        std::copy(last_.begin(), last_.end(), numbers);
        return Status(Status::Code::ok, iterations);
    }

    void forget() {
        groups_.clear();
        last_.clear();
    }

private:
    using Space = typename SpaceOf<Stepper>::Type;
    static constexpr std::size_t parts = parts_of<Scalar>;
    static constexpr std::size_t degrees = Space::degrees_of_freedom;
    static constexpr std::size_t size = 2 * degrees;

    /// Some directions, and the motion along which they go.
    struct Group {
        Stepper stepper;
        State x;
    };

    /// Whether the last step ended with these.
    [[nodiscard]] bool goes_on(const State& x, const double* numbers, std::size_t count) const {
        if (last_.size() != count * size || last_.empty()) { return false; }
        return has_values(groups_.front().x, x) && std::equal(last_.begin(), last_.end(), numbers);
    }

    void begin(const Stepper& idle, const State& x, const double* numbers, std::size_t count) {
        groups_.resize((count + parts - 1) / parts, Group{idle, x});
        for (Group& group : groups_) { group.x = x; }
        for (std::size_t k = 0; k < count; ++k) { take(k, numbers + k * size); }
    }

    /// Begins with direction k.
    void take(std::size_t k, const double* d) {
        State& x = groups_[k / parts].x;
        const std::size_t i = k % parts;
        auto at = detail::flat<Stepper>(x);
        for (std::size_t l = 0; l < Space::coordinates; ++l) { at.q[l].by[i] = d[l]; }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const double* const theta = d + Space::coordinates + 3 * r;
            set_turn(&at.q[entries_of(r)], i, {theta[0], theta[1], theta[2]});
        }
        for (std::size_t l = 0; l < degrees; ++l) { at.p[l].by[i] = d[degrees + l]; }
        detail::set_flat<Stepper>(x, at);
    }

    /// Writes direction k.
    void give(std::size_t k, double* d) const {
        const std::size_t i = k % parts;
        const auto& at = detail::flat<Stepper>(groups_[k / parts].x);
        for (std::size_t l = 0; l < Space::coordinates; ++l) { d[l] = at.q[l].by[i]; }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const std::array<double, 3> theta = turn_of(&at.q[entries_of(r)], i);
            std::copy(theta.begin(), theta.end(), d + Space::coordinates + 3 * r);
        }
        for (std::size_t l = 0; l < degrees; ++l) { d[degrees + l] = at.p[l].by[i]; }
    }

    /// Place of the nine entries of rotation r.
    [[nodiscard]] static constexpr std::size_t entries_of(std::size_t r) {
        return Space::coordinates + 9 * r;
    }

    /// Puts a state back on the motion of another one, of which rounding may have made another: so
    /// all directions are those of one motion.
    static void take_values(State& x, const State& y) {
        auto at = detail::flat<Stepper>(x);
        const auto& from = detail::flat<Stepper>(y);
        for (std::size_t k = 0; k < at.q.size(); ++k) { at.q[k].value = from.q[k].value; }
        for (std::size_t k = 0; k < at.p.size(); ++k) { at.p[k].value = from.p[k].value; }
        detail::set_flat<Stepper>(x, at);
    }

    [[nodiscard]] static bool has_values(const State& x, const State& y) {
        if constexpr (detail::HasTime<State>::value) {
            if (x.t.value != y.t.value) { return false; }
        }
        return detail::numbers<Stepper>(x) == detail::numbers<Stepper>(y);
    }

    std::vector<Group> groups_;
    std::vector<double> last_;  ///< the directions that the last step ended with
};

}  // namespace hvi::driver

namespace hvi::detail {

/// An instance whose steps are computed in dual numbers.
template <class Problem>
class DrivenInstance<Problem,
                     std::enable_if_t<(driver::parts_of<typename Problem::Stepper::Scalar> > 0)>>
    : public Instance<Problem> {
public:
    static constexpr bool carries_directions = true;
    using Instance<Problem>::Instance;

    /// See CarriedInDuals.
    Run carry(double* directions, std::size_t count, double h) {
        return this->step_by([&](auto& stepper, auto& x) {
            return carried_.step(stepper, x, directions, count, h);
        });
    }

    void reset() {
        Instance<Problem>::reset();
        carried_.forget();
    }

private:
    driver::CarriedInDuals<typename Problem::Stepper> carried_;
};

}  // namespace hvi::detail
