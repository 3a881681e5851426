// Names of a scene whose sums stay loops, and their meaning.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/ir/system.hpp"
#include "generator/lower/lower.hpp"
#include "generator/read/put_in.hpp"
#include "generator/read/scene_rules.hpp"

namespace hvi::gen {

/// A family by its number among those of its kind.
struct DeclaredFamily {
    FamilyKind kind;
    std::size_t number;
};

/// Names, and their meanings.
struct Declarations {
    std::map<std::string, long> sizes;
    std::map<std::string, DeclaredFamily> families;
    Vocabulary names;             ///< without indices
    std::set<std::string> taken;  ///< names that no index of a loop may have
    Symbols symbols;              ///< parameters, and sizes as numbers
    Definitions definitions;

    /// Returns the expression with definitions put in. Throws InputError for a word that has no
    /// meaning, or that the rules forbid; `indices` are known beside sizes.
    [[nodiscard]] IndexedExpression meant(const IndexedExpression& written, const SceneRules& rules,
                                          const std::vector<std::string>& indices = {}) const;
};

/// Adds the sizes, families, tables and parameters of a scene to a system. Throws InputError for a
/// word that is no name, is taken, or has no value, and NoLoops for parts that loops do not have:
/// rotations, families that are no pairs, bounds and lists of other things than numbers and sizes.
[[nodiscard]] Declarations declare(System& system, const Scene& scene);

[[nodiscard]] NumbersInFile numbers_in(const ValueFile& file);

}  // namespace hvi::gen
