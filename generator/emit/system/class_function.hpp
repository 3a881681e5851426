// Functions of the generated class System: their arguments, and what they compute.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/emit/system/kernel_code.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

// ---- bodies without loops ----

/// Straight-line code, whose results go to the targets. Without targets the only result is
/// returned.
struct StraightCode {
    Kernel kernel;
    std::vector<std::string> targets = {};
    NodeNames names = {};         ///< names of values that only this code is given
    bool takes_lanes = false;     ///< whether it takes lanes as well as numbers
    bool is_mirrored = false;     ///< whether `out` is a matrix of which the lower half is computed
    bool has_parameters = false;  ///< as arguments: it is computed before there is a System
};

/// A statement on the line of the signature.
struct OneLine {
    std::string statement;
};

/// Statements that call the runtime, or other functions of the class.
struct Statements {
    std::vector<std::string> lines;
};

// ---- bodies of sums ----

/// Adds derivatives of a sum to `out`, for values of its first index from `from` to `to`.
struct DerivativesOfSum {
    std::string name;  ///< of the function
    const SystemSum* sum;
    const std::vector<AccessSlope>* slopes;
    std::vector<std::string> arrays;  ///< arrays that it reads, as q and p
    bool has_time = false;            ///< whether the time follows the arrays as an argument
    bool has_totals = false;          ///< whether totals follow the time as arguments
};

/// Calls functions of single sums with the names of arrays, after `out` is set to zero.
struct ScatteredSums {
    std::vector<DerivativesOfSum> sums;
    std::string arrays;
};

/// Adds up a total of the system, from the arrays q and p, and the totals before it.
struct TotalOfSums {
    const std::vector<SystemSum>* sums;
};

/// Adds up sums of vectors q and p; NaN where their sizes do not fit.
struct ValueOfSums {
    const std::vector<SystemSum>* sums;
};

/// Adds entries of d2H/dq2 to a matrix.
struct EntriesOfSums {
    const std::vector<SumEntries>* sums;
};

using BodyOfSums =
    std::variant<DerivativesOfSum, ScatteredSums, TotalOfSums, ValueOfSums, EntriesOfSums>;

/// Sets variables to their initial values.
struct StartOfFamilies {};

// ---- bodies of the sites of a lattice ----

/// Ranges of all sites, and of the sites that have all their neighbours.
struct SiteRanges {};

/// Values of sites side by side, one for each component.
struct ValuesOfSites {
    const std::vector<Scaled>* values;
};

/// Force on any site, term by term.
struct ForceAtEdge {};

using BodyOfSites = std::variant<SiteRanges, ValuesOfSites, ForceAtEdge>;

// ---- functions ----

using FunctionBody =
    std::variant<StraightCode, OneLine, Statements, BodyOfSums, StartOfFamilies, BodyOfSites>;

/// An argument, as `const Vector& q`. An argument that may be unused is marked so.
struct Argument {
    std::string text;
    bool is_used = true;
};

/// A member function of System.
struct SystemFunction {
    std::string name;
    std::vector<Argument> arguments;
    FunctionBody body;
    std::string doc = {};
    std::string_view returns = "void";
    std::string_view parameters = {};  ///< parameters of a template
    bool is_counted = false;           ///< whether each call is counted
    bool is_inlined = false;           ///< whether it is inlined wherever it is called
};

}  // namespace hvi::gen
