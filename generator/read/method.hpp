// Methods as the user gave them: by a name, by basis functions and nodes, or in a file.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/read/parse.hpp"

namespace hvi::gen {

/// The most parameters that a method, a Hamiltonian or a scene can have.
constexpr std::size_t most_parameters = 64;

/// A value given to a free symbol of a method.
struct Parameter {
    std::string name;
    Expression value;                                ///< without symbols other than `pi` and `e`
    Place place;                                     ///< the place of the name
    std::shared_ptr<const Source> source = nullptr;  ///< source of the ranges in `value`
};

/// Whether the parameter has a value; a parameter of an H on the command line need not have one.
[[nodiscard]] inline bool has_value(const Parameter& parameter) {
    return parameter.place.source != nullptr;
}

/// A method as it was given, with its words checked. Families exist, have a possible size, and
/// stand in the right list; `tau` occurs in basis functions and within `roots` only; there are at
/// most 64 functions, 64 nodes and 64 parameters. The mathematics is checked later.
struct Method {
    std::string name;  ///< `gauss:3`, the name in a file, or empty
    std::string
        origin;  ///< METHOD as the command line has it: `--method gauss:3`; one line of ASCII
    List basis;
    List nodes;
    std::optional<List> weights;
    std::vector<Parameter> parameters;  ///< each a symbol of the method, no name twice
    std::optional<Place> place;         ///< the place of its name, or of its basis, for errors
    /// The name of a splitting of H into parts, `saba:4`; empty for other methods. The lists are
    /// those of the drift and the kick that make it up.
    std::string splitting = {};
};

/// Returns the method with this name: `gauss:3`, or one of `named_methods()`. Throws InputError for
/// an unknown name and for a size that the family does not have, MathError for Chebyshev nodes that
/// are not real.
[[nodiscard]] Method named_method(std::shared_ptr<const Source> name);

/// Returns the method of `--basis`, `--nodes` and, in the general Galerkin form, `--weights`.
/// Throws InputError for what cannot be read, MathError as `named_method` does.
[[nodiscard]] Method method_from_text(std::shared_ptr<const Source> basis,
                                      std::shared_ptr<const Source> nodes,
                                      std::shared_ptr<const Source> weights = nullptr);

/// Makes a method of lists that are already read; `origin` is left empty. Throws as
/// method_from_text() does.
[[nodiscard]] Method method_from_lists(List basis, List nodes, std::optional<List> weights);

/// Reads the method in a TOML file of at most 1 MiB: `name`, `basis`, `nodes`, `weights` and
/// `[parameters]`, as CONTRACT.md has them. Throws InputError with the line of the file.
[[nodiscard]] Method method_from_file(const std::filesystem::path& path);

/// Reads the text of such a file; the source's name is the file's name.
[[nodiscard]] Method method_from_toml(const Source& file);

/// Reads the value of `--param`: `w=2`. Throws InputError.
[[nodiscard]] Parameter parse_parameter(std::shared_ptr<const Source> source);

/// Reads the value of a parameter that stands in a part of a text. Throws InputError.
void read_value(Parameter& parameter, std::shared_ptr<const Source> source, Range part);

/// Returns the symbols of a method that are parameters, with a value or without, sorted.
[[nodiscard]] std::vector<std::string> parameter_names(const Method& method);

/// Adds a parameter, in place of one with its name.
void assign(std::vector<Parameter>& parameters, Parameter parameter);

/// Gives a value to a symbol of the method, in place of an earlier value, and adds it to the
/// method's origin. Throws InputError when the method has no such symbol.
void set_parameter(Method& method, Parameter parameter);

/// Gives a value to one of the symbols `names`. `subject` is the name of their owner in messages.
void set_parameter(std::vector<Parameter>& values, const std::vector<std::string>& names,
                   Parameter parameter, std::string_view subject);

/// Returns the method as stable text, for people and tests.
[[nodiscard]] std::string dump(const Method& method);

/// Returns ` --param "w=2"`, as origins have it.
[[nodiscard]] std::string parameter_option(const Parameter& parameter);

}  // namespace hvi::gen
