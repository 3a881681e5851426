// What --only asks for.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "generator/cli/words.hpp"

namespace hvi::gen {

/// What --only names: of the files that a command writes, and of the parts that they have.
class Only {
public:
    Only(const Words& words, const std::vector<std::string_view>& files,
         const std::vector<std::string_view>& parts = {}) {
        std::vector<std::string_view> all = files;
        all.insert(all.end(), parts.begin(), parts.end());
        for (const std::string& item : words.chosen("--only", all))
            (std::find(files.begin(), files.end(), item) != files.end() ? files_ : parts_)
                .insert(item);
    }

    /// All files where none is named.
    [[nodiscard]] bool wants(const std::string& file) const {
        return files_.empty() || files_.count(file) != 0;
    }
    /// The usual parts where none is named.
    [[nodiscard]] bool wants_part(const std::string& part, bool is_usual) const {
        return parts_.empty() ? is_usual : parts_.count(part) != 0;
    }
    [[nodiscard]] bool names_parts() const { return !parts_.empty(); }

private:
    std::set<std::string> files_, parts_;
};

}  // namespace hvi::gen
