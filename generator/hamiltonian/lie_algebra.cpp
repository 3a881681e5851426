// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/lie_algebra.hpp"

#include <algorithm>
#include <utility>

namespace hvi::gen {

namespace {

using GiNaC::numeric;
using Row = std::vector<numeric>;
using Rows = std::vector<Row>;

/// Independent rows with the same span.
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

/// How many squares of each sign a form has.
struct Inertia {
    std::size_t positive = 0, negative = 0, zero = 0;

    friend bool operator==(const Inertia&, const Inertia&) = default;
};

/// Lagrange's method.
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

/// What does not depend on the basis.
struct Invariants {
    std::size_t dimension = 0, derived = 0, centre = 0;
    Inertia killing;
    bool splits = false;        ///< into what brackets span and what commutes with all
    bool is_unimodular = true;  ///< all ad x have trace 0
};

Rows brackets(const StructureConstants& c) {
    Rows rows;
    for (const auto& of_i : c)
        for (const Row& bracket : of_i) rows.push_back(bracket);
    return rows;
}

/// Of the matrices ad x: x is in the centre where all [x, e_j] vanish.
std::size_t dimension_of_centre(const StructureConstants& c) {
    Rows rows;  // of x, all its brackets
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

/// Whether no element of what brackets span commutes with all: then their sum is direct.
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

/// Beside a part that commutes with all.
std::string beside(const std::string& name, std::size_t commuting) {
    if (commuting == 0) return name;
    return name + (commuting == 1 ? "+R" : "+R^" + std::to_string(commuting));
}

/// Of what brackets span, where brackets of these span it again. NOTE: a compact algebra has a
/// negative form, that of a vector space none; and so(3) acts on three dimensions as on vectors,
/// or not at all.
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

/// Two dimensions that do not commute with a third one.
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
