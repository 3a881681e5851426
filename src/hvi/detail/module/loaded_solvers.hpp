// What a module has of the library with the solvers that its steps seldom call.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi::detail {

using AnyFunction = void (*)();

/// A function of the library by the name of the types that it is for; null where it has none.
using FindSolver = AnyFunction (*)(const char* name);

/// What the library has as its symbol hvi_solvers.
struct SolverFunctions {
    int version;  ///< as of DrivenFunctions
    FindSolver find;
};

/// Thrown by a step that calls for a solver where none is loaded.
struct SolverIsApart {};

/// The library of a module; null until it is loaded. NOTE: a template, so that there is one.
template <class Nothing = void>
struct LoadedSolvers {
    static FindSolver find;
};
template <class Nothing>
FindSolver LoadedSolvers<Nothing>::find = nullptr;

}  // namespace hvi::detail
