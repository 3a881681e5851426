// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/shadow.hpp"

namespace hvi::gen {

ShadowFindings find_shadow(const Target& target, const ShadowWishes& wishes,
                           const std::function<void(double)>& on_progress) {
    const Answers answers = ask(target, wishes, on_progress);
    if (answers.has("fault")) return {.fault = answers.text("fault")};
    return {answers.number("shadow"),
            answers.number("largest"),
            answers.number("last"),
            answers.number("error"),
            {}};
}

}  // namespace hvi::gen
