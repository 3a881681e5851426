// Catching an error and showing where it points.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>

#include "generator/support/error.hpp"

namespace hvi::gen {

inline std::shared_ptr<const Source> source(std::string text, std::string name = "text") {
    return std::make_shared<const Source>(Source{std::move(name), std::move(text)});
}

/// The parts of an error. `marked` is the text with the caret's range in brackets: `2[tau]`.
struct Refusal {
    int status = 0;  ///< 0 when there was no error
    std::string what;
    std::string name;
    std::string marked;
    std::string help;

    [[nodiscard]] bool says(const std::string& part) const {
        return what.find(part) != std::string::npos;
    }
    [[nodiscard]] bool helps(const std::string& part) const {
        return help.find(part) != std::string::npos;
    }
};

/// The error that `action` ends with.
template <class Action>
Refusal refusal(Action&& action) {
    try {
        static_cast<void>(action());
    } catch (const Error& error) {
        Refusal result{static_cast<int>(error.status()), error.what(), "", "", error.help()};
        if (!error.place()) return result;
        const Range range = error.place()->range;
        result.name = error.place()->source->name;
        result.marked = error.place()->source->text;
        result.marked.insert(range.end, "]");
        result.marked.insert(range.begin, "[");
        return result;
    }
    return {};
}

}  // namespace hvi::gen
