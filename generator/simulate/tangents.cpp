// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/tangents.hpp"

#include <algorithm>

namespace hvi::gen {

TangentFindings find_tangents(const Target& target, const TangentWishes& wishes,
                              const std::function<void(double)>& on_progress) {
    const Answers answers = ask(target, wishes, on_progress);
    TangentFindings found;
    if (answers.has("fault")) found.fault = answers.text("fault");
    const auto number = [&](const char* key, std::optional<double>& into) {
        if (answers.has(key)) into = answers.number(key);
    };
    number("lyapunov", found.lyapunov);
    number("megno", found.megno);
    number("sali", found.sali);
    found.exponents = answers.numbers("exponent");
    std::sort(found.exponents.rbegin(), found.exponents.rend());
    found.entries = answers.numbers("entry");
    if (answers.has("form")) found.form = answers.number("form");
    return found;
}

}  // namespace hvi::gen
