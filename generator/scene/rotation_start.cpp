// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/scene/rotation_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace hvi::gen {

namespace {

using Entries = std::array<const Ball*, 9>;

/// Returns the sum of a_k b_k.
Ball dot(const Entries& R, const std::array<std::size_t, 3>& a,
         const std::array<std::size_t, 3>& b) {
    Ball sum;
    for (std::size_t k = 0; k < 3; ++k)
        arb_addmul(sum.get(), R[a[k]]->get(), R[b[k]]->get(), first_precision);
    return sum;
}

/// Returns by how much the columns are provably not orthonormal: a lower bound of the largest entry
/// of R^T R - 1.
double defect(const Entries& R) {
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            Ball entry = dot(R, {i, 3 + i, 6 + i}, {j, 3 + j, 6 + j});
            if (i == j) arb_sub_ui(entry.get(), entry.get(), 1, first_precision);
            arf_t least;
            arf_init(least);
            arb_get_abs_lbound_arf(least, entry.get(), first_precision);
            largest = std::max(largest, arf_get_d(least, ARF_RND_DOWN));
            arf_clear(least);
        }
    }
    return largest;
}

Ball determinant(const Entries& R) {
    Ball sum;
    for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
        Ball minor;
        arb_mul(minor.get(), R[3 + k]->get(), R[6 + l]->get(), first_precision);
        arb_submul(minor.get(), R[3 + l]->get(), R[6 + k]->get(), first_precision);
        arb_addmul(sum.get(), R[j]->get(), minor.get(), first_precision);
    }
    return sum;
}

Place place_of(const WrittenOutScene& scene, const std::string& entry) {
    for (const NamedExpression& initial : scene.initial)
        if (initial.name == entry) return initial.place;
    return whole(function_of(scene).source);
}

}  // namespace

void check_rotations(const WrittenOutScene& scene, const SymbolValues& start) {
    constexpr double most = 1.0 / (1 << 27);
    for (const RotationNames& names : function_of(scene).rotations) {
        const std::vector<std::string> entries = entries_of(names.rotation);
        Entries R{};
        for (std::size_t k = 0; k < R.size(); ++k) R[k] = &start.at(entries[k]);
        const double off = defect(R);
        const bool is_reflection = determinant(R).sign() < 0;
        if (off <= most && !is_reflection) continue;
        const std::string& name = names.rotation;
        throw MathError(
            off > most ? fmt::format("`{}` begins with no rotation: entries of {}^T {} differ "
                                     "by {:.2g} from those of the unit matrix",
                                     name, name, name, off)
                       : fmt::format("`{}` begins with no rotation: its determinant is -1", name),
            place_of(scene, entries.front()),
            "write \"identity\", {axis = [0, 0, 1], angle = \"pi/3\"} or {quaternion = "
            "[1, 0, 0, 0]}, or nine numbers to eight digits or more");
    }
}

}  // namespace hvi::gen
