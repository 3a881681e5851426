// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/starting_values.hpp"

#include <algorithm>
#include <cmath>

#include "generator/plan/equal.hpp"

namespace hvi::gen {

namespace {

bool are_distinct(const NumberVector& c) {
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (!differ(c[i], c[j])) { return false; }
        }
    }
    return true;
}

/// The polynomial through the slopes f_j at c_j, one step later:
/// f(1 + c_i) = sum_j l_j(1 + c_i) f_j, so N_ij = (b_i/b_j) l_j(1 + c_i) for L_j = h b_j f_j.
NumberMatrix extrapolation(const Tableau& tableau) {
    const std::size_t s = tableau.stages();
    const NumberVector& c = tableau.c;
    NumberMatrix N(s, NumberVector(s));
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            Number value = tableau.b[i] / tableau.b[j];
            for (std::size_t k = 0; k < s; ++k) {
                if (k != j) { value = value * ((Number(1) + c[i] - c[k]) / (c[j] - c[k])); }
            }
            N[i][j] = value;
        }
    }
    return N;
}

/// How much the extrapolation may magnify rounding: the largest sum_j |N_ij|. In doubles, since for
/// many stages the exact N is costly and then of no use.
double magnification(const Tableau& tableau) {
    const std::size_t s = tableau.stages();
    std::vector<double> b, c;
    for (std::size_t i = 0; i < s; ++i) {
        b.push_back(tableau.b[i].nearest_double());
        c.push_back(tableau.c[i].nearest_double());
    }
    double largest = 0.0;
    for (std::size_t i = 0; i < s; ++i) {
        double sum = 0.0;
        for (std::size_t j = 0; j < s; ++j) {
            double value = b[i] / b[j];
            for (std::size_t k = 0; k < s; ++k) {
                if (k != j) { value *= (1.0 + c[i] - c[k]) / (c[j] - c[k]); }
            }
            sum += std::abs(value);
        }
        largest = std::max(largest, sum);
    }
    return largest;
}

}  // namespace

void set_extrapolation(Scheme& scheme, const Tableau& tableau) {
    constexpr double most = 1e8;  // so that rounding of the slopes stays below half the digits
    if (scheme.is_explicit()) { return; }
    if (scheme.from_parameter) {
        scheme.decisions.push_back(
            {"slopes at the start of the step are the starting values of the iteration",
             "extrapolation would need coefficients for each value of the parameter"});
        return;
    }
    const bool merged = scheme.positions.size() != tableau.stages() ||
                        (!scheme.velocity_form && scheme.momenta.size() != tableau.stages());
    if (merged || !are_distinct(tableau.c)) {
        scheme.decisions.push_back(
            {"slopes at the start of the step are the starting values of the iteration",
             "no polynomial interpolates slopes at equal nodes"});
        return;
    }
    if (magnification(tableau) > most) {
        scheme.decisions.push_back(
            {"slopes at the start of the step are the starting values of the iteration",
             "extrapolating the last step's slopes would magnify their rounding too much"});
        return;
    }
    scheme.decisions.push_back(
        {"the last step's slopes, extrapolated, are the starting values of the iteration",
         "they are good to the order of the interpolation and cost no evaluation"});
    scheme.extrapolation = extrapolation(tableau);
}

}  // namespace hvi::gen
