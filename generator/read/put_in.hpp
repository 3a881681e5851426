// Definitions: names for parts of expressions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/read/scene.hpp"

namespace hvi::gen {

/// The size so far of an expression that is being made.
struct Extent {
    std::size_t words = 0;
    std::size_t levels = 0;  ///< levels of nesting that are open now
};

/// The definitions of a scene: `r`, or `d[i]` for any index.
class Definitions {
public:
    /// Adds a definition, in which those before it are replaced by their values. Throws InputError
    /// where there is one with this name, and where all have more than 100 000 words or one is
    /// nested deeper than 1200.
    void add(const Definition& definition);

    /// Replaces names in an expression by their definitions. An error in a definition is shown at
    /// the place of its name. Throws InputError for a definition with another number of indices,
    /// and for more than 100 000 words or a deeper nesting than 1200.
    [[nodiscard]] IndexedExpression put_in(const IndexedExpression& expression) const;

private:
    [[nodiscard]] IndexedExpression put_in(const IndexedExpression& expression,
                                           Extent& extent) const;

    std::map<std::string, Definition, std::less<>> definitions_;
    Extent extent_;  ///< the extent of all definitions together
};

/// Puts the values of parameters in the values that use them. Throws InputError where a value
/// depends on itself, and where all have more than 100 000 words or one is nested deeper than 1200.
/// Precondition: each symbol in a value is one of the parameters.
void resolve(std::vector<Parameter>& parameters);

}  // namespace hvi::gen
