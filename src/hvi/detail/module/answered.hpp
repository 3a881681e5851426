// Answers of a module to hvi-gen, and the parameters that it is given.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>

#include <hvi/detail/module/driven_functions.hpp>
#include <hvi/detail/module/parameters.hpp>

namespace hvi::detail {

/// Returns these parameters with numbers in their places. `Problem` is as in instance.hpp. Throws
/// std::invalid_argument unless the numbers are those of the scene.
template <class Problem, class Parameters>
[[nodiscard]] Parameters with_numbers(Parameters parameters, const double* numbers,
                                      std::size_t count) {
    ParameterReader reader(numbers, count);
    Problem::set(parameters, reader);
    if (!reader.are_right() || !reader.is_count_right()) {
        throw std::invalid_argument("these are not the parameters of the scene");
    }
    return parameters;
}

/// Does the work, and returns the answer. Where the work throws, `message` gets the reason, in
/// `room` characters.
template <class Work>
[[nodiscard]] DrivenAnswer answered(Work&& work, char* message, std::size_t room) {
    try {
        work();
        return DrivenAnswer::ok;
    } catch (const std::bad_alloc&) {
        return DrivenAnswer::out_of_memory;
    } catch (const std::exception& error) {
        std::size_t k = 0;
        for (const char* text = error.what(); text[k] != '\0' && k + 1 < room; ++k) {
            message[k] = text[k];
        }
        message[k] = '\0';
        return DrivenAnswer::failed;
    }
}

}  // namespace hvi::detail
