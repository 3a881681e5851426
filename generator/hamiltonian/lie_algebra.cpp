// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/lie_algebra.hpp"

#include <algorithm>
#include <utility>

namespace hvi::gen {

namespace {

using GiNaC::numeric;
using Row = std::vector<numeric>;
using Rows = std::vector<Row>;

/// Returns independent rows with an equal span.
Rows echelon(Rows rows) {
    std::size_t rank = 0;
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    for (std::size_t column = 0; column < columns && rank < rows.size(); ++column) {
        std::size_t pivot = rank;
        while (pivot < rows.size() && rows[pivot][column].is_zero()) ++pivot;
        if (pivot == rows.size()) continue;
        std::swap(rows[rank], rows[pivot]);
        for (std::size_t i = rank + 1; i < rows.size(); ++i) {
            if (rows[i][column].is_zero()) continue;
            const numeric factor = rows[i][column] / rows[rank][column];
            for (std::size_t j = column; j < columns; ++j)
                rows[i][j] = rows[i][j] - factor * rows[rank][j];
        }
        ++rank;
    }
    rows.resize(rank);
    return rows;
}

/// The number of squares of each sign in a quadratic form.
struct Inertia {
    std::size_t positive = 0, negative = 0, zero = 0;

    friend bool operator==(const Inertia&, const Inertia&) = default;
};

/// Counts squares by Lagrange's method.
Inertia inertia(Rows form) {
    Inertia found;
    while (!form.empty()) {
        const std::size_t n = form.size();
        std::size_t k = 0;
        while (k < n && form[k][k].is_zero()) ++k;
        if (k == n) {  // x y is a difference of squares
            std::size_t i = 0, j = 0;
            for (std::size_t at = 0; at < n * n; ++at)
                if (!form[at / n][at % n].is_zero()) i = at / n, j = at % n;
            if (i == j) {
                found.zero += n;
                return found;
            }
            for (std::size_t column = 0; column < n; ++column) form[i][column] += form[j][column];
            for (std::size_t row = 0; row < n; ++row) form[row][i] += form[row][j];
            continue;
        }
        const numeric pivot = form[k][k];
        ++(pivot.is_positive() ? found.positive : found.negative);
        Rows rest;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            Row& row = rest.emplace_back();
            for (std::size_t j = 0; j < n; ++j)
                if (j != k) row.push_back(form[i][j] - form[i][k] * form[k][j] / pivot);
        }
        form = std::move(rest);
    }
    return found;
}

/// Numbers that do not depend on the basis of an algebra.
struct Invariants {
    std::size_t dimension = 0, derived = 0, centre = 0;
    Inertia killing;
    bool splits = false;        ///< into its derived algebra and its centre
    bool is_unimodular = true;  ///< all ad x have trace 0
};

Rows brackets(const StructureConstants& c) {
    Rows rows;
    for (const auto& of_i : c)
        for (const Row& bracket : of_i) rows.push_back(bracket);
    return rows;
}

/// Returns the dimension of the centre: x is in it where all [x, e_j] vanish.
std::size_t dimension_of_centre(const StructureConstants& c) {
    Rows rows;  // equations for x from all its brackets
    for (const auto& of_i : c) {
        Row& row = rows.emplace_back();
        for (const Row& bracket : of_i) row.insert(row.end(), bracket.begin(), bracket.end());
    }
    return c.size() - echelon(rows).size();
}

Rows killing_form(const StructureConstants& c) {
    const std::size_t n = c.size();
    Rows form(n, Row(n));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t l = 0; l < n; ++l) form[i][j] += c[i][k][l] * c[j][l][k];
            form[j][i] = form[i][j];
        }
    return form;
}

bool is_unimodular(const StructureConstants& c) {
    return std::all_of(c.begin(), c.end(), [](const auto& ad) {
        numeric trace = 0;
        for (std::size_t j = 0; j < ad.size(); ++j) trace += ad[j][j];
        return trace.is_zero();
    });
}

/// Whether the derived algebra and the centre have only 0 in common, and their sum is the algebra.
bool splits(const StructureConstants& c, const Rows& derived, std::size_t centre) {
    if (derived.size() + centre != c.size()) return false;
    Rows all;
    for (const Row& x : derived) {
        Row& row = all.emplace_back();
        for (std::size_t j = 0; j < c.size(); ++j)
            for (std::size_t k = 0; k < c.size(); ++k) {
                numeric sum = 0;
                for (std::size_t i = 0; i < c.size(); ++i) sum += x[i] * c[i][j][k];
                row.push_back(sum);
            }
    }
    return echelon(all).size() == derived.size();
}

Invariants invariants(const StructureConstants& c) {
    const Rows derived = echelon(brackets(c));
    Invariants result{c.size(), derived.size(), dimension_of_centre(c), inertia(killing_form(c))};
    result.splits = splits(c, derived, result.centre);
    result.is_unimodular = is_unimodular(c);
    return result;
}

/// Adds a commuting part to a name.
std::string beside(const std::string& name, std::size_t commuting) {
    if (commuting == 0) return name;
    return name + (commuting == 1 ? "+R" : "+R^" + std::to_string(commuting));
}

/// Names an algebra whose derived algebra is perfect. NOTE: a compact algebra has a negative form,
/// the algebra of a vector space a zero form; and so(3) acts on three dimensions as on vectors, or
/// not at all.
std::string perfect(const Invariants& all) {
    const Inertia form{all.killing.positive, all.killing.negative, all.killing.zero - all.centre};
    if (form == Inertia{0, 3, 0}) return "so(3)";
    if (form == Inertia{2, 1, 0}) return "sl(2,R)";
    if (form == Inertia{0, 6, 0}) return "so(4)";
    if (form == Inertia{3, 3, 0}) return "so(3,1)";
    if (form == Inertia{0, 3, 3}) return "se(3)";
    if (form == Inertia{0, 10, 0}) return "so(5)";
    if (form == Inertia{0, 6, 3}) return "se(3)+so(3)";
    return "";
}

/// Names an algebra of two dimensions that do not commute with a third one.
std::string planar(const Invariants& all) {
    if (all.derived != 2 || !all.is_unimodular || all.killing.zero + 1 != all.dimension) return "";
    return beside(all.killing.negative == 1 ? "se(2)" : "e(1,1)", all.centre);
}

}  // namespace

std::string name_of_algebra(const StructureConstants& constants) {
    if (constants.empty()) return "";
    const Invariants all = invariants(constants);
    const std::size_t n = all.dimension;
    if (all.derived == 0) return n == 1 ? "R" : "R^" + std::to_string(n);
    if (all.derived == 1 && all.centre + 2 == n)
        return all.is_unimodular ? beside("heis(3)", n - 3) : beside("aff(1)", n - 2);
    if (all.derived == 2 && all.centre + 3 == n) return planar(all);
    if (!all.splits) return "";
    const std::string name = perfect(all);
    return name.empty() ? "" : beside(name, all.centre);
}

}  // namespace hvi::gen
