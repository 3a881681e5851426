// Requirements of all targets: the program does its task, or says why not and where.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "generator/support/error.hpp"

namespace hvi::gen::fuzz {

inline void require(bool condition, const std::string& what) {
    if (!condition) throw std::logic_error(what);
}

/// Errors of the user's are a result like any other.
inline void check_error(const Error& error) {
    const auto& place = error.place();
    require(!place || (place->source != nullptr && place->range.begin <= place->range.end &&
                       place->range.end <= place->source->text.size()),
            "a place outside of its text");
    const std::string text = message(error);
    require(!text.empty() && text.size() < 5000, "an error without a message, or with a long one");
    require(error.status() == ExitStatus::input || error.status() == ExitStatus::mathematics,
            "an error that is not the user's: " + text);
    // NOTE: what mathematics forbids may be no part of the text.
    require(place || error.status() == ExitStatus::mathematics,
            "an error without a place: " + text);
}

template <class Action>
void attempt(Action&& action) {
    try {
        action();
    } catch (const Error& error) { check_error(error); }
}

}  // namespace hvi::gen::fuzz
