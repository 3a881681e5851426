// The names that a user declares, and the check that a symbol is one of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// An index: the 1 and 2 of u[1,2].
using Index = std::vector<long>;

/// Returns 3 for `x[3]`, 1 and 2 for `u[1,2]`, or an empty index.
[[nodiscard]] Index index_of(const std::string& name);

/// A declared name with its place.
struct DeclaredName {
    std::string name;  ///< `x`, or with an index `x[3]`, `u[1,2]`
    Place place;
};

/// Names, with the place of the whole list.
struct NameList {
    std::vector<DeclaredName> names;
    Place place;
};

/// The names declared so far. Names that differ in the index only, like x[1] and x[2], share a
/// subject.
class Vocabulary {
public:
    /// Declares a name. `subject` is the thing that it names: `a coordinate`. Throws InputError for
    /// a name that is reserved or taken.
    void declare(const DeclaredName& declared, std::string_view subject);

    [[nodiscard]] bool contains(const std::string& name) const { return names_.count(name) != 0; }

    /// Returns the indices of x[1], x[2], ... in ascending order; an empty index for x alone; none
    /// where `stem` names nothing.
    [[nodiscard]] std::vector<Index> indices(std::string_view stem) const;

    /// Returns the names without their indices.
    [[nodiscard]] std::set<std::string> stems() const;

    /// Whether a stem names something.
    [[nodiscard]] bool has(std::string_view stem) const { return entries_.count(stem) != 0; }

    /// Whether a stem has this subject.
    [[nodiscard]] bool is(std::string_view subject, std::string_view stem) const;

    /// Throws InputError for a symbol that has a declared name, but not its index: x[7] of x[1..6].
    void check_index(const std::string& symbol, const Place& place) const;

    /// Throws InputError for a stem that names nothing. `text` stands for it in messages; `help` is
    /// shown where no name resembles it.
    void check_stem(std::string_view stem, const std::string& text, const Place& place,
                    std::string help) const;

private:
    struct Entry {
        std::string subject;
        std::vector<Index> indices;  ///< the indices in the order of declaration
    };
    std::map<std::string, Entry, std::less<>> entries_;  ///< by name without an index
    std::set<std::string> names_;
};

}  // namespace hvi::gen
