// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/own_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "generator/read/file.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_header = 1024 * 1024;
constexpr std::size_t most_headers = 64;

bool has_header(const OwnFunctions& own, const std::string& path) {
    return std::any_of(own.headers.begin(), own.headers.end(),
                       [&](const OwnHeader& header) { return header.path == path; });
}

bool is_plain(char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
           std::string_view("_-+.").find(c) != std::string_view::npos;
}

/// Whether the path names a file in the scene's directory or below.
bool is_path_below(std::string_view path) {
    for (;;) {
        const std::size_t slash = path.find('/');
        const std::string_view part = path.substr(0, slash);
        const bool is_name = !part.empty() && part != "." && part != ".." &&
                             std::all_of(part.begin(), part.end(), is_plain);
        if (!is_name) { return false; }
        if (slash == std::string_view::npos) { return true; }
        path.remove_prefix(slash + 1);
    }
}

/// Returns `table.hpp` of a line `#include "table.hpp"`, else an empty text.
std::string_view included(std::string_view line) {
    const auto skip = [&](std::string_view what) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        const bool is_next = line.substr(0, what.size()) == what;
        if (is_next) { line.remove_prefix(what.size()); }
        return is_next;
    };
    if (!skip("#") || !skip("include") || !skip("\"")) { return {}; }
    return line.substr(0, std::min(line.find('"'), line.size()));
}

/// Returns the paths, relative to the scene, of the files that a header includes by name.
std::vector<std::string> included_by(const OwnHeader& header) {
    const fs::path directory = fs::path(header.path).parent_path();
    std::vector<std::string> paths;
    std::string_view rest = header.text;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        if (const std::string_view name = included(rest.substr(0, end)); !name.empty()) {
            paths.push_back((directory / name).lexically_normal().generic_string());
        }
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return paths;
}

}  // namespace

OwnArguments OwnFunctions::arguments() const {
    OwnArguments result;
    for (const OwnFunction& function : functions) { result[function.name] = function.arguments; }
    return result;
}

std::vector<std::string> OwnFunctions::includes() const {
    std::vector<std::string> result;
    for (const OwnFunction& function : functions) {
        if (!contains(result, function.header)) { result.push_back(function.header); }
    }
    return result;
}

void check_own_name(const std::string& name, const Place& place) {
    check_parameter_name(name, place, "a function");
    const bool is_taken = name == "sum" || name == "mod" || name == "std" || name == "hvi";
    if (is_taken) {
        throw InputError(fmt::format("`{}` has a meaning of its own", name), place,
                         fmt::format("take another name, such as `{}_of`", name));
    }
    if (without_derivatives(name) != name) {
        throw InputError(
            fmt::format("`{}` looks like a derivative of `{}`", name, without_derivatives(name)),
            place, "the name of a function does not end in `_` and digits");
    }
}

void check_own_header(const std::string& path, const Place& place) {
    if (is_path_below(path)) { return; }
    throw InputError("this is no path of a header", place,
                     "it is relative to the scene, without `..`, of letters, digits and `_-+.`: "
                     "\"potential.hpp\"");
}

void add_own_header(OwnFunctions& own, const fs::path& directory, const std::string& path,
                    const Place& place) {
    if (has_header(own, path)) { return; }
    if (own.headers.size() == most_headers) {
        throw InputError(fmt::format("these are more than {} headers", most_headers), place);
    }
    try {
        own.headers.push_back({path, read_file(directory / path, largest_header)});
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", path, error.what()), place,
                         "the path of a header is relative to that of the scene");
    }
    for (const std::string& other : included_by(OwnHeader(own.headers.back()))) {
        std::error_code ignored;
        const bool is_there =
            is_path_below(other) && fs::is_regular_file(directory / other, ignored);
        if (is_there) { add_own_header(own, directory, other, place); }
    }
}

void check_apart(const OwnFunctions& own, std::string_view name, const Place& place) {
    for (const OwnFunction& function : own.functions) {
        if (without_derivatives(name) != function.name) { continue; }
        throw InputError(
            name == function.name
                ? fmt::format("`{}` is a function of [functions] already", name)
                : fmt::format("`{}` is a derivative of the function `{}`", name, function.name),
            place, "take another name for one of them");
    }
}

void refuse_own_functions(const Expression& expression, const std::shared_ptr<const Source>& source,
                          std::string_view subject) {
    const Expression* const call = own_call_in(expression);
    if (call == nullptr) { return; }
    throw InputError(fmt::format("`{}` cannot stand in {}", call->name, subject),
                     Place{source, call->range},
                     "functions of [functions] stand in the Hamiltonian and in invariants: they "
                     "have values where C++ computes them, and no exact ones");
}

}  // namespace hvi::gen
