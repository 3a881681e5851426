// Memory of a stepper with rotations from one step to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/detail/groups/chart.hpp>
#include <hvi/detail/groups/chart_space.hpp>
#include <hvi/detail/groups/orthogonal.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/stages/moved.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// The start of the step, afterwards its end, and the remainders of the sums so far: of coordinates
/// and momenta, of the rotations, and of the angular momenta in space, R L.
///
/// NOTE: steps add to these sums. L = R^T (R L) is computed from them anew at the end of each step,
/// so that its rounding does not add up, and the R L of a free body keeps its bits. As in
/// StepMemory, a step from a state that is not, bit for bit, the end of the last one begins without
/// memory.
template <class Space>
class ChartMemory : public Space {
public:
    using Scalar = typename Space::Scalar;
    using Vector = typename Space::Vector;
    using Spins = typename Space::template PerRotation<Vector3<Scalar>>;

    ChartState<Space> at;         ///< with L in the body
    ChartState<Space> remainder;  ///< with the remainder of `spins` in place of L
    Spins spins{};                ///< R L, in space
    std::size_t n = Space::degrees_of_freedom;
    Scalar h = 0;
    Scalar h_before = 0;     ///< step size of the slopes; 0 when there are none
    bool side = false;       ///< changes with each step; see Sweeps
    bool continues = false;  ///< whether the step begins, bit for bit, where the last one ended
    bool goes_on = false;    ///< whether the last one also had this size

    /// Prepares a step of size h from x. Precondition: h != 0.
    template <class State>
    [[nodiscard]] Status begin(const State& x, Scalar step_size) {
        if (!sums_are_exact_) { return Status(Status::Code::unsafe_arithmetic); }
        if (!is_finite(step_size)) { return Status(Status::Code::not_finite); }
        continues = ended_ && same_bits(at.q, x.q) && same_bits(at.p, x.p);
        side = continues && !side;
        h_before = continues ? h : Scalar(0);
        goes_on = continues && h_before == step_size;
        h = step_size;
        ended_ = false;
        if (continues) { return {}; }
        if (!is_finite_state(x)) { return Status(Status::Code::not_finite); }
        take(x);
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const Matrix3<Scalar> R = Space::rotation(at.q, r);
            if (!is_rotation(R)) { return Status(Status::Code::not_a_rotation); }
            spins[r] = times(R, Space::part(at.p, r));
        }
        return {};
    }

    /// Returns the rotation R_0 exp(hat xi), its remainder included; of one xi, or of several side
    /// by side.
    template <class Value>
    HVI_INLINE_IN_SPACE [[nodiscard]] Matrix3<Value> rotated(std::size_t r,
                                                             const ChartPoint<Value>& xi) const {
        const Matrix3<Scalar> start = Space::rotation(at.q, r);
        const Matrix3<Scalar> rest = Space::rotation(remainder.q, r);
        Matrix3<Value> R{};
        for (std::size_t k = 0; k < 9; ++k) { R[k] = Value(start[k]); }
        const Matrix3<Value> change = product(R, xi.turn());
        for (std::size_t k = 0; k < 9; ++k) { R[k] = moved(R[k], Value(rest[k]) + change[k]); }
        return R;
    }

    /// Returns R exp(hat xi) for the rotation R at the start of the last step.
    [[nodiscard]] Matrix3<Scalar> rotated_from_start(std::size_t r,
                                                     const ChartPoint<Scalar>& xi) const {
        Matrix3<Scalar> R = start_[r];
        const Matrix3<Scalar> change = product(R, xi.turn());
        for (std::size_t k = 0; k < 9; ++k) { R[k] = moved(R[k], change[k]); }
        return R;
    }

    /// Adds the increments of coordinates and momenta.
    void advance_flat(std::size_t k, const Scalar& by_q, const Scalar& by_p) {
        move(at.q[k], remainder.q[k], by_q);
        move(at.p[k], remainder.p[k], by_p);
    }

    /// Turns the body by exp(hat xi), and adds `by_spin` to R L.
    void advance_rotation(std::size_t r, const ChartPoint<Scalar>& xi,
                          const Vector3<Scalar>& by_spin) {
        const std::size_t n_q = Space::coordinates;
        start_[r] = Space::rotation(at.q, r);
        const Matrix3<Scalar> change = product(start_[r], xi.turn());
        const Matrix3<Scalar> way = way_to_rotation(rotated(r, xi));
        for (std::size_t k = 0; k < 9; ++k) {
            const std::size_t i = n_q + 9 * r + k;
            move(at.q[i], remainder.q[i], change[k] + way[k]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            move(spins[r][k], remainder.p[n_q + 3 * r + k], by_spin[k]);
        }
        Space::set_part(at.p, r, transposed_times(Space::rotation(at.q, r), spins[r]));
    }

    /// Ends the step: sets x to `at`, unless `at` is not finite.
    template <class State>
    [[nodiscard]] Status end(State& x, int iterations) {
        if (!is_finite_state(at)) { return Status(Status::Code::not_finite, iterations); }
        x.q = at.q;
        x.p = at.p;
        ended_ = true;
        return Status(Status::Code::ok, iterations);
    }

    void forget() { ended_ = false; }

    /// Returns whether `at`, `h` and the slopes are those of a good step.
    [[nodiscard]] bool has_ended() const { return ended_; }

private:
    /// Takes x as the state, with no remainders.
    template <class State>
    void take(const State& x) {
        Space::fit(x);
        n = Space::degrees_of_freedom;
        at.q = x.q;
        at.p = x.p;
        remainder.q = Space::no_positions();
        Space::set_zero(remainder.p);
        if constexpr (!Space::has_fixed_size) {
            spins.resize(Space::rotations);
            start_.resize(Space::rotations);
        }
    }

    template <class State>
    [[nodiscard]] static bool is_finite_state(const State& x) {
        return finite(x.q, x.q) && finite(x.p, x.p);
    }

    typename Space::template PerRotation<Matrix3<Scalar>> start_{};  ///< start of the last step
    bool ended_ = false;  ///< whether `at` is the end of a good step
    bool sums_are_exact_ = sums_are_exact<Scalar>();
};

}  // namespace hvi::detail
