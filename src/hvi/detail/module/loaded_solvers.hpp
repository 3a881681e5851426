// A module's library of solvers that its steps seldom call.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi::detail {

using AnyFunction = void (*)();

/// Type of a function that finds a solver by the name of its types; null where there is none.
using FindSolver = AnyFunction (*)(const char* name);

/// Content of the symbol hvi_solvers of the library.
struct SolverFunctions {
    int version;  ///< as in DrivenFunctions
    FindSolver find;
};

/// Thrown by a step that calls for a solver where none is loaded.
struct SolverIsApart {};

/// The loaded library of a module; null until it is loaded. NOTE: a template, so that there is one
/// in the program.
template <class Nothing = void>
struct LoadedSolvers {
    static FindSolver find;
};
template <class Nothing>
FindSolver LoadedSolvers<Nothing>::find = nullptr;

}  // namespace hvi::detail
