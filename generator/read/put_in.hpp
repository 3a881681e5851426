// Names for parts of expressions, and what they stand for.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/read/scene.hpp"

namespace hvi::gen {

/// How large an expression is that is being made.
struct Extent {
    std::size_t words = 0;
    std::size_t levels = 0;  ///< that are open at the moment
};

/// The definitions of a scene: `r`, or `d[i]` for any index.
class Definitions {
public:
    /// Adds one, with those before it put in. Throws InputError where there is one of that name,
    /// and where all have more than 100 000 words or one is nested deeper than 1200.
    void add(const Definition& definition);

    /// The expression with what its names are defined to be in their places; an error in that is
    /// shown where the name stands. Throws InputError for a definition with another number of
    /// indices, and for more than 100 000 words or a deeper nesting than 1200.
    [[nodiscard]] IndexedExpression put_in(const IndexedExpression& expression) const;

private:
    [[nodiscard]] IndexedExpression put_in(const IndexedExpression& expression,
                                           Extent& extent) const;

    std::map<std::string, Definition, std::less<>> definitions_;
    Extent extent_;  ///< of all
};

/// The parameters with the values of others put in. Throws InputError where a value depends on
/// itself, and where all have more than 100 000 words or one is nested deeper than 1200.
/// Precondition: what stands in a value is one of them.
void resolve(std::vector<Parameter>& parameters);

}  // namespace hvi::gen
