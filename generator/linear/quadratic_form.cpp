// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/linear/quadratic_form.hpp"

#include <algorithm>

namespace hvi::gen {

NumberMatrix bordered(const QuadraticForm& H) {
    NumberMatrix E = H.S;
    for (std::size_t i = 0; i < E.size(); ++i) { E[i].push_back(H.g[i]); }
    E.push_back(H.g);
    E.back().push_back(Number(2) * H.constant);
    return E;
}

QuadraticForm without_border(const NumberMatrix& E) {
    QuadraticForm H{E, E.back(), E.back().back() / Number(2)};
    H.S.pop_back();
    for (NumberVector& row : H.S) { row.pop_back(); }
    H.g.pop_back();
    return H;
}

std::vector<UncoupledPart> uncoupled_parts(const QuadraticForm& H) {
    const std::size_t n = H.degrees_of_freedom();
    const auto coupled = [&](std::size_t i, std::size_t j) {
        return !H.S[i][j].is_zero() || !H.S[i][n + j].is_zero() || !H.S[n + i][j].is_zero() ||
               !H.S[n + i][n + j].is_zero();
    };
    std::vector<UncoupledPart> parts;
    std::vector<bool> is_taken(n, false);
    for (std::size_t first = 0; first < n; ++first) {
        if (is_taken[first]) { continue; }
        is_taken[first] = true;
        UncoupledPart part{first};
        for (std::size_t next = 0; next < part.size(); ++next) {
            for (std::size_t j = 0; j < n; ++j) {
                if (is_taken[j] || !coupled(part[next], j)) { continue; }
                is_taken[j] = true;
                part.push_back(j);
            }
        }
        std::sort(part.begin(), part.end());
        const std::size_t count = part.size();
        for (std::size_t k = 0; k < count; ++k) { part.push_back(n + part[k]); }
        parts.push_back(std::move(part));
    }
    return parts;
}

QuadraticForm restricted(const QuadraticForm& H, const UncoupledPart& part) {
    QuadraticForm result;
    for (const std::size_t i : part) {
        NumberVector& row = result.S.emplace_back();
        for (const std::size_t j : part) { row.push_back(H.S[i][j]); }
        result.g.push_back(H.g[i]);
    }
    return result;
}

}  // namespace hvi::gen
