// The words of the command line, and their places for carets.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/error.hpp"

namespace hvi::gen {

class CommandLine {
public:
    CommandLine(int argc, const char* const* argv);

    /// Returns the words after the name of the program.
    [[nodiscard]] const std::vector<std::string>& words() const { return words_; }

    /// Returns the place of the n-th word that is one of `names`, or that gives a value to it as in
    /// `--name=value`; the place of the whole line when there is none.
    [[nodiscard]] Place place(const std::vector<std::string>& names, std::size_t n = 0) const;

    /// Returns the place of the last word. Precondition: there is one.
    [[nodiscard]] Place last() const { return {source_, ranges_.back()}; }

    /// Returns the place just behind the last word.
    [[nodiscard]] Place end() const;

private:
    std::vector<std::string> words_;
    std::vector<Range> ranges_;  ///< ranges of the words in the source
    std::shared_ptr<const Source> source_;
};

}  // namespace hvi::gen
