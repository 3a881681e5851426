// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/warning.hpp"

#include <unistd.h>

#include <mutex>
#include <set>
#include <string_view>

#include "generator/support/error.hpp"

namespace hvi::gen {

void warn(const std::string& what, const std::string& help) {
    std::string text = message(EnvironmentError(what, help));
    text.replace(0, std::string_view("error").size(), "warning");
    static std::mutex saying;
    static std::set<std::string> said;
    const std::lock_guard lock(saying);
    if (!said.insert(text).second) return;
    // NOTE: one write, so that it is not mixed with others; a failure is ignored.
    (void)!::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace hvi::gen
