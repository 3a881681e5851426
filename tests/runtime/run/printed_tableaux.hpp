// Tableaux typed from the paper, for the table-driven stepper.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>

#include <hvi/generic_stepper.hpp>

// NOTE: not inline, since some are made of others: those are initialised in this order.
namespace printed {

const double pi = std::acos(-1.0);

// The tableaux as the paper prints them, Example 4.5 as ERRATA corrects it.
const hvi::Coefficients<double> euler{{1}, {{0}}, {{1}}};
const hvi::Coefficients<double> adjoint_euler{{1}, {{1}}, {{0}}};
const hvi::Coefficients<double> verlet{{0.5, 0.5}, {{0, 0}, {0.5, 0.5}}, {{0.5, 0}, {0.5, 0}}};
const hvi::Coefficients<double> gauss{
    {0.5, 0.5},
    {{0.25, 0.25 - std::sqrt(3.0) / 6}, {0.25 + std::sqrt(3.0) / 6, 0.25}},
    {{0.25, 0.25 - std::sqrt(3.0) / 6}, {0.25 + std::sqrt(3.0) / 6, 0.25}}};
const hvi::Coefficients<double> lobatto{
    {1.0 / 6, 2.0 / 3, 1.0 / 6},
    {{0, 0, 0}, {5.0 / 24, 1.0 / 3, -1.0 / 24}, {1.0 / 6, 2.0 / 3, 1.0 / 6}},
    {{1.0 / 6, -1.0 / 6, 0}, {1.0 / 6, 1.0 / 3, 0}, {1.0 / 6, 5.0 / 6, 0}}};
const double r2 = std::sqrt(2.0);
const hvi::Coefficients<double> cheby{
    {1.0 / 3, 1.0 / 3, 1.0 / 3},
    {{1.0 / 6 + r2 / 48, 1.0 / 6 - r2 / 6, 1.0 / 6 - 5 * r2 / 48},
     {1.0 / 6 + r2 / 8, 1.0 / 6, 1.0 / 6 - r2 / 8},
     {1.0 / 6 + 5 * r2 / 48, 1.0 / 6 + r2 / 6, 1.0 / 6 - r2 / 48}},
    {{1.0 / 6 - r2 / 48, 1.0 / 6 - r2 / 8, 1.0 / 6 - 5 * r2 / 48},
     {1.0 / 6 + r2 / 6, 1.0 / 6, 1.0 / 6 - r2 / 6},
     {1.0 / 6 + 5 * r2 / 48, 1.0 / 6 + r2 / 8, 1.0 / 6 + r2 / 48}}};
const double outer = (pi - 2) / (2 * pi);
const hvi::Coefficients<double> trig{
    {outer, 2 / pi, outer},
    {{0, 0, 0}, {0.25, 1 / pi, (pi - 4) / (4 * pi)}, {outer, 2 / pi, outer}},
    {{outer, (pi - 4) / (pi * pi - 2 * pi), 0}, {outer, 1 / pi, 0}, {outer, 1 / (pi - 2), 0}}};

}  // namespace printed
