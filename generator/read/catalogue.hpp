// The families and methods that have names: data for the reader and for `hvi-gen list`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hvi::gen {

/// The largest size of a family, and the largest number of stages of a method.
constexpr long largest_size = 64;

/// A family of functions or nodes: `name:S`.
struct FamilyEntry {
    std::string_view name;
    long smallest;                 ///< the least S
    std::string_view sizes;        ///< the values of S, for people: `1..64`
    std::string_view description;  ///< one line
    std::string_view paper;        ///< the place in the paper, or empty
};

/// A method with a name of its own.
struct MethodEntry {
    std::string_view name;
    std::string_view basis;
    std::string_view nodes;
    std::string_view description;
    std::string_view paper;
};

/// A splitting of H into parts.
struct SplittingEntry {
    std::string_view name;   ///< `saba:S` for a family
    std::string_view sizes;  ///< the values of S, for people; empty for one that is no family
    std::string_view description;
    std::string_view source;  ///< who found it
};

/// Another program's name for a method.
struct OtherName {
    std::string_view name;
    std::string_view method;  ///< the method's name here; empty where no method matches
    std::string_view help;    ///< the advice where no method matches
};

/// A form of basis function or node that is written as a call: `roots(P(tau))`.
struct FormEntry {
    std::string_view form;
    std::string_view description;
};

[[nodiscard]] std::span<const FamilyEntry> basis_families();
[[nodiscard]] std::span<const FamilyEntry> node_families();
[[nodiscard]] std::span<const FormEntry> basis_forms();
[[nodiscard]] std::span<const FormEntry> node_forms();

/// The methods that are no families. Besides them every family of nodes is a family of methods,
/// with its interpolating polynomials.
[[nodiscard]] std::span<const MethodEntry> named_methods();

/// Splittings, which step H by the flows of its parts.
[[nodiscard]] std::span<const SplittingEntry> splittings();

/// The largest S of `saba:S`.
constexpr long largest_saba = 10;

/// Names of methods in textbooks and in other programs.
[[nodiscard]] std::span<const OtherName> other_names();

/// Returns the entry with this name, or null.
[[nodiscard]] const FamilyEntry* find_family(std::span<const FamilyEntry> families,
                                             std::string_view name);

}  // namespace hvi::gen
