// Hamiltonians that are made of invariants of a group, hidden by linear changes of the variables.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <random>
#include <string>

namespace hvi::gen {

/// A function of invariants of a group in three coordinates, and the dimension of the group.
struct Plan {
    const char* hamiltonian;
    std::size_t dimension;
    const char* algebra;
    bool is_free = true;  ///< whether the part that is quadratic in p has no q in it
};

/// Plans. u, v, w are linear forms of the coordinates, and pu, pv, pw are the linear forms of their
/// momenta.
inline constexpr Plan plans[] = {
    {"(pu^2+pv^2+pw^2)/2 + (u^2+v^2+w^2)^2", 3, "so(3)"},
    {"(pu^2+pv^2+pw^2)/2 + (u^2+v^2)^2 + w^4", 1, "so(2)"},
    {"(pu^2+pv^2+pw^2)/2 + (u-v)^4 + w^4", 1, "R"},
    {"(pu^2+pv^2+pw^2)/2 + w^4", 3, "se(2)"},
    {"(pu^2+pv^2+pw^2)/2 - 1/sqrt(u^2+v^2+w^2)", 3, "so(3)"},
    {"(pu^2+pv^2+pw^2)/2 + exp(u-v) + cos(w)", 1, "R"},
    {"(pu^2+pv^2-pw^2)/2 + (u^2+v^2-w^2)^2", 3, "sl(2,R)"},
    {"(u*pu)^2 + v*pv + (pw^2+w^2)/2", 2, "R^2", false},
    {"pu^2/2 + u^2*pv^2 + w*pw", 2, "R^2", false},
    {"(pu^2+pv^2+pw^2)*(1+u^2+v^2+w^2)", 3, "so(3)", false},
    {"(pu^2+pv^2)/2 + u^4 + v^6 + pw^2/2 + w^4", 0, ""},
};

/// A matrix of small whole numbers with determinant 1, and the transposed inverse.
struct Change {
    int A[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    int B[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
};

inline Change random_change(std::mt19937& random) {
    Change change;
    for (int round = 0; round < 3; ++round) {
        const auto i = random() % 3, j = (i + 1 + random() % 2) % 3;
        const int k = int(random() % 5) - 2;
        for (int column = 0; column < 3; ++column) {
            change.A[i][column] += k * change.A[j][column];
            change.B[j][column] -= k * change.B[i][column];
        }
    }
    return change;
}

inline std::string form(const int (&row)[3], const char* letter) {
    std::string text = "(0";
    for (int i = 0; i < 3; ++i)
        text += "+(" + std::to_string(row[i]) + ")*" + letter + std::to_string(i + 1);
    return text + ")";
}

inline std::string hidden(std::string text, const Change& change) {
    const char* const letters = "uvw";
    std::string result;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool is_momentum = text[at] == 'p' && std::string("uvw").find(text[at + 1]) < 3;
        const std::size_t which = std::string(letters).find(is_momentum ? text[at + 1] : text[at]);
        if (which > 2) {
            result += text[at];
            continue;
        }
        result += is_momentum ? form(change.B[which], "p") : form(change.A[which], "q");
        if (is_momentum) ++at;
    }
    return result;
}

}  // namespace hvi::gen
