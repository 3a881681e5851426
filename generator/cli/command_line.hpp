// The words of the command line, and where a caret points to one of them.
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

    /// What follows the name of the program.
    [[nodiscard]] const std::vector<std::string>& words() const { return words_; }

    /// The place of the n-th word that is one of `names`, or that gives a value to it as in
    /// `--name=value`; of the whole line when there is none.
    [[nodiscard]] Place place(const std::vector<std::string>& names, std::size_t n = 0) const;

    /// The place of the last word. Precondition: there is one.
    [[nodiscard]] Place last() const { return {source_, ranges_.back()}; }

    /// The place just behind the last word.
    [[nodiscard]] Place end() const;

private:
    std::vector<std::string> words_;
    std::vector<Range> ranges_;  ///< of the words in the source
    std::shared_ptr<const Source> source_;
};

}  // namespace hvi::gen
