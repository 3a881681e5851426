// Affine symmetries of sums over any number of elements, which move all elements alike.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// A summand as a function of symbols. Elements with one index each are independent inputs, as if
/// no two could be equal.
struct FamilySummand {
    /// An element of a family of coordinates, or of momenta; elements of different families with
    /// equal indices have one place.
    struct Element {
        std::string symbol;
        std::size_t family = 0;
        std::string place;
    };

    Expression function;  ///< places in it count for nothing
    std::vector<Element> coordinates, momenta;
    std::vector<std::string> others;  ///< indices, and what depends on them
    bool is_over_family = false;      ///< all elements of a family at one place, each once
};

/// The field q_f' = sum_g C_fg q_g + d_f, alike for all elements of the families f and g.
struct FamilyField {
    struct Entry {
        std::size_t row = 0;
        std::optional<std::size_t> column;  ///< empty for d
        Expression value;
    };
    std::vector<Entry> entries;
};

struct FamilySymmetries {
    std::vector<FamilyField> fields;
    /// The mass m of each family whose momenta occur in H only in the sum of p^2/(2 m) over all
    /// elements.
    std::vector<std::optional<Expression>> masses;
    std::string algebra;  ///< the algebra's name, with turned centres of mass; or empty
};

/// Finds the fields that leave each summand unchanged, by exact algebra, for all sizes. `shapes`
/// has a number for each family; families of one shape have equal indices. With `centres`, the
/// algebra includes the fields that turn the centre of mass of families f and g. Throws as Algebra
/// does, with `source`, in which the summands stand, for a place.
[[nodiscard]] FamilySymmetries family_symmetries(const std::vector<FamilySummand>& summands,
                                                 const std::vector<std::size_t>& shapes,
                                                 const std::shared_ptr<const Source>& source);

/// Whether the first function is seen to be a sum of multiples of the others, and a constant.
/// Throws as Algebra does, with `source`, in which the function stands, for a place.
[[nodiscard]] bool is_combination(const Expression& function, const std::vector<Expression>& others,
                                  const std::vector<std::string>& variables,
                                  const std::shared_ptr<const Source>& source);

}  // namespace hvi::gen
