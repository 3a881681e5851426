// Whether states have the time.
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

namespace hvi::detail {

/// Whether states are positions, momenta and the time t.
template <class State, class = void>
struct HasTime : std::false_type {};
template <class State>
struct HasTime<State, std::void_t<decltype(std::declval<State&>().t)>> : std::true_type {};

}  // namespace hvi::detail
