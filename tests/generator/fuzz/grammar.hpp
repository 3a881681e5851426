// Texts that follow a grammar: bytes choose among its alternatives.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hvi::gen::fuzz {

/// Rules, one in a line and in those below it that begin with four blanks:
///
///     sum: <term> | <term><more>
///     more: _ |  + <sum>
///     term: x | 1
///         | sin(<sum>)
///
/// A name in angles stands for an alternative of its rule. The alternative of <$name> is chosen
/// once in a text and used wherever it occurs. `_` is nothing, `~` the end of a line of the text.
/// The first alternatives lead to an end.
class Grammar {
public:
    explicit Grammar(std::string_view rules);

    /// The text of the first rule. Each choice takes one byte; where none are left, it is the first
    /// alternative.
    [[nodiscard]] std::string derive(std::string_view choices) const;

private:
    struct Part {
        bool is_name;  ///< the name of a rule
        std::string text;
    };
    using Alternative = std::vector<Part>;

    class Derivation;

    void add_rule(std::string_view line);

    std::string first_;
    std::map<std::string, std::vector<Alternative>> rules_;
};

}  // namespace hvi::gen::fuzz
