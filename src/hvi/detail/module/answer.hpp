// Results of C functions of a module: 0, why a step was not taken, or which argument is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/state.hpp>

namespace hvi::detail {

/// Codes of C functions. Codes below 100 are those of Status. NOTE: they are part of the interface
/// of modules, which programs are compiled against: none changes its number.
enum class Answer : int {
    ok = 0,
    no_handle = 101,
    null_pointer = 102,
    wrong_count = 103,
    wrong_parameter = 104,
    unknown_column = 106,
    too_few_rows = 107,
    no_rows = 108,
    wrong_size = 109,
    out_of_memory = 110,
    too_many = 111,
    unreadable_file = 112,
    failed = 113,
};

/// Returns the number of a step's Status.
[[nodiscard]] constexpr int number_of(Status::Code code) { return static_cast<int>(code); }

/// Returns a line about any number, without a full stop.
[[nodiscard]] constexpr const char* text_of_answer(int answer) {
    constexpr int codes = number_of(Status::Code::outside_chart);
    if (answer >= 0 && answer <= codes) {
        return Status(static_cast<Status::Code>(answer)).message();
    }
    switch (static_cast<Answer>(answer)) {
    case Answer::ok: return "ok";
    case Answer::no_handle: return "the handle is none, or was destroyed";
    case Answer::null_pointer: return "an argument is a null pointer";
    case Answer::wrong_count: return "there are not as many parameters as that";
    case Answer::wrong_parameter:
        return "a parameter is no finite number, or a size that is no positive whole number";
    case Answer::unknown_column: return "there is no such column";
    case Answer::too_few_rows: return "the buffer has fewer rows than steps would fill";
    case Answer::no_rows: return "every is 0, and there is a buffer";
    case Answer::wrong_size: return "a list of the scene does not fit these sizes";
    case Answer::out_of_memory: return "there is not enough memory";
    case Answer::too_many: return "there are too many handles";
    case Answer::unreadable_file: return "a file with numbers of the scene cannot be read";
    case Answer::failed: return "a function of the scene threw an exception";
    }
    return "unknown status";
}

}  // namespace hvi::detail
