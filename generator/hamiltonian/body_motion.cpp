// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/body_motion.hpp"

#include <array>
#include <string>

#include "generator/exact/numbers/rational.hpp"
#include "generator/hamiltonian/normal_form.hpp"
#include "generator/hamiltonian/relations.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using GiNaC::symbol;

constexpr slong bits = 512;

/// Computes n R of the quaternion w, x, y, z with n = w^2 + x^2 + y^2 + z^2, row by row, as a sum
/// of products: add(entry, factor, a, b) adds factor a b to an entry.
template <class Number, class Add>
void add_rotation(const std::array<Number, 4>& q, Add add) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t entry = 3 * i + j;
            if (i != j) {
                const std::size_t k = 3 - i - j;
                add(entry, 2, q[1 + i], q[1 + j]);
                add(entry, j == (i + 1) % 3 ? -2 : 2, q[0], q[1 + k]);
                continue;
            }
            for (std::size_t k = 0; k < 4; ++k)
                add(entry, k == 0 || k == 1 + i ? 1 : -1, q[k], q[k]);
        }
    }
}

/// Returns the next number in (0, 2).
Ball number(std::size_t& state) {
    state = (state * 16807) % 2147483647;
    return ball_of_rational(std::to_string(state % 997 + 1) + "/500", bits);
}

}  // namespace

BodyMotion::BodyMotion(const Hamiltonian& hamiltonian)
    : algebra_(Algebra::with_entries(hamiltonian)),
      n_(hamiltonian.coordinates.size() - rotations_of_space.point * hamiltonian.rotations.size()),
      m_(hamiltonian.rotations.size()) {}

BodyMotion::Triple BodyMotion::by_turns(const ex& function, std::size_t r) const {
    Triple result;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        ex sum;
        for (std::size_t i = 0; i < 3; ++i)
            sum += by(function, R(r, i, b)) * R(r, i, c) - by(function, R(r, i, c)) * R(r, i, b);
        result.push_back(sum);
    }
    return result;
}

BodyMotion::Triple BodyMotion::by_momentum(const ex& function, std::size_t r) const {
    return {by(function, L(r, 0)), by(function, L(r, 1)), by(function, L(r, 2))};
}

ex BodyMotion::bracket(const ex& I) const {
    const ex& H = algebra_.function();
    ex sum;
    for (std::size_t i = 0; i < n_; ++i)
        sum += by(I, q(i)) * by(H, p(i)) - by(I, p(i)) * by(H, q(i));
    for (std::size_t r = 0; r < m_; ++r) {
        const Triple turns_I = by_turns(I, r), turns_H = by_turns(H, r);
        const Triple slopes_I = by_momentum(I, r), slopes_H = by_momentum(H, r);
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
            const ex turned = L(r, b) * slopes_H[c] - L(r, c) * slopes_H[b];
            sum += turns_I[a] * slopes_H[a] + slopes_I[a] * (turned - turns_H[a]);
        }
    }
    return sum;
}

SymbolValues BodyMotion::with_rotations(SymbolValues point) const {
    for (std::size_t r = 0; r < m_; ++r) {
        std::array<Ball, 4> quaternion;
        for (std::size_t k = 0; k < 4; ++k) quaternion[k] = point.at(R(r, k / 3, k % 3).get_name());
        Ball norm;
        for (const Ball& part : quaternion) arb_addmul(norm.get(), part.get(), part.get(), bits);
        std::array<Ball, 9> entries;
        add_rotation(quaternion, [&](std::size_t entry, int factor, const Ball& a, const Ball& b) {
            Ball term;
            arb_mul(term.get(), a.get(), b.get(), bits);
            arb_mul_si(term.get(), term.get(), factor, bits);
            arb_add(entries[entry].get(), entries[entry].get(), term.get(), bits);
        });
        for (std::size_t k = 0; k < 9; ++k) {
            arb_div(entries[k].get(), entries[k].get(), norm.get(), bits);
            point[R(r, k / 3, k % 3).get_name()] = entries[k];
        }
    }
    return point;
}

bool BodyMotion::is_refuted(const ex& function) const {
    constexpr std::size_t points = 4;
    const Expression written = algebra_.written(function);
    std::size_t state = 20011;
    for (std::size_t tried = 0; tried < points; ++tried) {
        SymbolValues point;
        for (const auto* symbols : {&algebra_.parameters(), &algebra_.variables()})
            for (const symbol& each : *symbols) point[each.get_name()] = number(state);
        try {
            const Ball value = value_at(written, with_rotations(std::move(point)), nullptr);
            if (arb_is_finite(value.get()) != 0 && arb_contains_zero(value.get()) == 0) return true;
        } catch (const MathError&) {}  // it has no value there
    }
    return false;
}

ex BodyMotion::of_quaternions(const ex& function) const {
    GiNaC::exmap rotations;
    for (std::size_t r = 0; r < m_; ++r) {
        const std::array<ex, 4> quaternion{symbol(), symbol(), symbol(), symbol()};
        ex norm;
        for (const ex& part : quaternion) norm += part * part;
        std::array<ex, 9> entries;
        add_rotation(quaternion, [&](std::size_t entry, int factor, const ex& a, const ex& b) {
            entries[entry] += factor * a * b;
        });
        for (std::size_t k = 0; k < 9; ++k) rotations[R(r, k / 3, k % 3)] = entries[k] / norm;
    }
    return function.subs(rotations);
}

Vanishing BodyMotion::vanishes(const ex& function) const {
    constexpr std::size_t most_in_normal_form = 100;  // terms, and of one rotation
    if (function.is_zero() || multiplied_out(function).is_zero()) return Vanishing::proved;
    if (is_refuted(function)) return Vanishing::refuted;
    Monomials monomials(algebra_);
    if (auto sum = monomials.sum(function)) {
        std::vector<MonomialSum> one{*std::move(sum)};
        static_cast<void>(bring_to_common_powers(monomials, one));
        if (one.front().empty()) return Vanishing::proved;
        if (m_ > 1 || one.front().size() > most_in_normal_form) return Vanishing::unknown;
    }
    return normal_form(of_quaternions(function)).is_zero() ? Vanishing::proved : Vanishing::unknown;
}

}  // namespace hvi::gen
