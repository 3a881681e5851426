// Series of discrete Hamiltonians and their values in numbers, for the tests of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/generator/equations/systems.hpp"

namespace hvi::gen {

inline DiscreteSeries series(const Method& method, const std::string& H, int terms) {
    return *step_equations(method, hamiltonian(H), false, terms).series;
}

inline DiscreteSeries series(const std::string& name, const std::string& H, int terms) {
    return series(method(name), H, terms);
}

/// Returns q p plus the terms of a series, with slopes by the symbols that have them in the point.
inline Dual sum(const std::vector<DiscreteSeries::Coefficient>& terms, const Hamiltonian& H,
                const Point& point, Dual h) {
    Dual result;
    for (std::size_t d = 0; d < H.degrees_of_freedom(); ++d)
        result = result + point.at(H.coordinates[d]) * point.at(H.momenta[d]);
    Dual power{1};
    for (const auto& term : terms) {
        power = power * h;
        result = result + power * evaluate(*term, point);
    }
    return result;
}

inline Point start(const Hamiltonian& H) {
    Point point = some_point(H);
    point["t"] = {0.4L};
    return point;
}

/// `1, tau | 0, 1/2, 1`, and weights behind another bar.
inline Method rule(const std::string& given) {
    const std::size_t bar = given.find('|'), weights = given.find('|', bar + 1);
    return method_from_text(
        source(given.substr(0, bar)), source(given.substr(bar + 1, weights - bar - 1)),
        weights == std::string::npos ? nullptr : source(given.substr(weights + 1)));
}

}  // namespace hvi::gen
