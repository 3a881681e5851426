// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/text/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/emit/text/macros.hpp"

namespace hvi::gen {
namespace {

// NOTE: not <cctype>, whose answers depend on the locale.
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) { return is_lower(c) || is_upper(c) || is_digit(c); }
char to_upper(char c) { return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c; }

/// Keywords of C++17 and C++20, sorted.
constexpr std::array<std::string_view, 92> keywords{
    "alignas",       "alignof",     "and",
    "and_eq",        "asm",         "auto",
    "bitand",        "bitor",       "bool",
    "break",         "case",        "catch",
    "char",          "char16_t",    "char32_t",
    "char8_t",       "class",       "co_await",
    "co_return",     "co_yield",    "compl",
    "concept",       "const",       "const_cast",
    "consteval",     "constexpr",   "constinit",
    "continue",      "decltype",    "default",
    "delete",        "do",          "double",
    "dynamic_cast",  "else",        "enum",
    "explicit",      "export",      "extern",
    "false",         "float",       "for",
    "friend",        "goto",        "if",
    "inline",        "int",         "long",
    "mutable",       "namespace",   "new",
    "noexcept",      "not",         "not_eq",
    "nullptr",       "operator",    "or",
    "or_eq",         "private",     "protected",
    "public",        "register",    "reinterpret_cast",
    "requires",      "return",      "short",
    "signed",        "sizeof",      "static",
    "static_assert", "static_cast", "struct",
    "switch",        "template",    "this",
    "thread_local",  "throw",       "true",
    "try",           "typedef",     "typeid",
    "typename",      "union",       "unsigned",
    "using",         "virtual",     "void",
    "volatile",      "wchar_t",     "while",
    "xor",           "xor_eq",
};

/// Names that have another meaning where the class is declared: members, template parameters, and
/// names of hvi.
constexpr std::array<std::string_view, 37> taken{
    "System",     "Solver",    "Vector", "State",      "Status", "Index",   "Coupled", "Stages",
    "Sum",        "step",      "reset",  "Trajectory", "Values", "predict", "system_", "s_",
    "solver_",    "tangents_", "force_", "p_",         "q_",     "slope_",  "known_",  "velocity_",
    "m",          "mt",        "N",      "b",          "b_q",    "b_p",     "hvi",     "std",
    "FixedPoint", "Newton",    "Scalar", "rounded",    "Steps",
};

/// Names that are taken where the constructor takes a parameter.
constexpr std::array<std::string_view, 7> taken_by_coefficients{
    "Coefficients", "Functions", "coefficients", "coefficients_", "status", "parameter", "at",
};

/// Names that are taken where a scene has functions of its own.
constexpr std::array<std::string_view, 43> taken_by_scenes{
    "dHdq",
    "dHdp",
    "d2Hdq2",
    "d2Hdqdp",
    "d2Hdp2",
    "energy",
    "evaluations",
    "initial",
    "begin",
    "Parameters",
    "position",
    "curve",
    "curve_rates",
    "curve_terms",
    "c",
    "n",
    "q",
    "p",
    "t",
    "x",
    "h",
    "clock_",
    "stages",
    "inverse_mass",
    "quadratic",
    "Map",
    "Number",
    "Numbers",
    "N_lanes",
    "m_lanes",
    "mt_lanes",
    "cn_lanes",
    "sums_",
    "gradient",
    "N_before",
    "N_before_lanes",
    "W_before_",
    "Lq_before_",
    "Lp_before_",
    "has_slopes_before_",
    "weights_",
    "read_parameters",
    "has_diagonal_mass",
};

/// Names that are taken where the class has an action.
constexpr std::array<std::string_view, 5> taken_by_actions{
    "generating_function", "action", "action_", "integral_over_step", "lagrangian",
};

/// Names of tables of the stepper, and of variables that are declared in functions alone: they give
/// way to functions of the user with these names.
constexpr std::array<std::string_view, 6> tables{"b", "c", "m", "mt", "n", "N"};
constexpr std::array<std::string_view, 5> locals{"q", "p", "t", "x", "h"};

bool gives_way(std::string_view name) {
    return std::find(tables.begin(), tables.end(), name) != tables.end() ||
           std::find(locals.begin(), locals.end(), name) != locals.end();
}

bool is_identifier(std::string_view name) {
    return !name.empty() && !is_digit(name.front()) &&
           std::all_of(name.begin(), name.end(), [](char c) { return is_word(c) || c == '_'; });
}

bool is_reserved(std::string_view name) {
    return name.find("__") != std::string_view::npos ||
           (name.size() > 1 && name[0] == '_' && is_upper(name[1]));
}

/// Prefixes that C functions of a module cannot have: the names of headers of C, in whose place
/// NAME.h would be found, and each NAME for which NAME_create() exists.
constexpr std::array<std::string_view, 35> taken_by_c{
    "assert", "complex", "ctype",   "errno",  "fenv",      "float",  "inttypes", "iso646", "limits",
    "locale", "math",    "setjmp",  "signal", "stdalign",  "stdarg", "stdbit",   "stddef", "stdint",
    "stdio",  "stdlib",  "stdbool", "string", "tgmath",    "time",   "threads",  "uchar",  "wchar",
    "wctype", "pthread", "timer",   "memory", "semaphore", "unistd", "poll",     "glob",
};

bool is_taken_by_c(std::string_view name) {
    return std::find(taken_by_c.begin(), taken_by_c.end(), name) != taken_by_c.end();
}

bool is_keyword(std::string_view name) {
    static_assert(std::is_sorted(keywords.begin(), keywords.end()));
    return std::binary_search(keywords.begin(), keywords.end(), name);
}

/// Returns whether the declaration of a scene's parameter contains the name.
bool names_type(std::string_view name) {
    return name == "Number" || name == "Numbers" || name == "Scalar" || name == "Parameters" ||
           name == "std" || name == "hvi";
}

/// Returns whether the name is that word followed by digits: `Coupled1` and the like are structs of
/// the class.
bool is_numbered(std::string_view name, std::string_view word) {
    return name.substr(0, word.size()) == word &&
           std::all_of(name.begin() + static_cast<std::ptrdiff_t>(word.size()), name.end(),
                       is_digit);
}

/// Returns whether member_name() makes this name of another one: `LZ_`.
bool is_renamed(std::string_view name) {
    return name.size() > 1 && name.back() == '_' &&
           member_name(name.substr(0, name.size() - 1)) == name;
}

bool is_taken(std::string_view name) {
    const auto is_in = [&](const auto& names) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    return is_in(taken) || is_in(taken_by_coefficients) || is_in(taken_by_scenes) ||
           is_in(taken_by_actions) || is_numbered(name, "Coupled");
}

/// Returns `Gauss2` for `gauss:2`: letters and digits alone, with a capital after each character
/// that is left out.
std::string joined_words(std::string_view method) {
    std::string name;
    bool at_start = true;
    for (const char c : method) {
        if (is_word(c)) {
            name += at_start ? to_upper(c) : c;
            at_start = false;
        } else {
            at_start = true;
        }
    }
    return name;
}

[[noreturn]] void refuse(std::string_view name, std::string_view meaning,
                         const std::optional<Place>& place, const std::string& help) {
    throw InputError(fmt::format("'{}' {}", name, meaning), place, help);
}

/// NOTE: callers treat names that are spelled like macros in their own ways.
void check_word(std::string_view name, const std::optional<Place>& place, const std::string& help) {
    if (is_keyword(name)) { refuse(name, "is a word of C++ itself", place, help); }
    if (is_macro(name) && !is_spelled_as_macro(name)) {
        refuse(name, "may be a macro of a standard header", place, help);
    }
}

}  // namespace

std::string class_name(std::string_view method) {
    const std::string name = joined_words(method);
    if (name.empty() || is_digit(name.front())) { return "Stepper" + name; }
    return is_taken(name) || is_macro(name) ? name + "Stepper" : name;
}

std::string file_name(std::string_view method) {
    std::string name;
    for (const char c : method) { name += is_word(c) ? c : '_'; }
    return (name.empty() ? "stepper" : name) + ".hpp";
}

std::string module_name(std::string_view scene) {
    std::string name;
    for (const char c : scene) {
        if (is_word(c)) {
            name += c;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    while (!name.empty() && name.back() == '_') { name.pop_back(); }
    return is_identifier(name) && !is_taken_by_c(name) ? name : "scene_" + name;
}

void check_module_name(std::string_view name, const std::optional<Place>& place) {
    constexpr auto help = "an identifier like kepler, of letters, digits and single underscores";
    if (!is_identifier(name) || name.front() == '_' || name.back() == '_') {
        refuse(name, "cannot begin the names of C functions", place, help);
    }
    if (is_reserved(name)) { refuse(name, "begins names that C++ reserves", place, help); }
    if (is_taken_by_c(name)) {
        refuse(name, "is a header of C, or begins the names of its functions", place, help);
    }
}

void check_class_name(std::string_view name, const std::optional<Place>& place) {
    constexpr auto help = "an identifier like Gauss2, of letters, digits and single underscores";
    if (!is_identifier(name)) { refuse(name, "cannot be the name of a class", place, help); }
    if (is_reserved(name)) { refuse(name, "is a name that C++ reserves", place, help); }
    check_word(name, place, help);
    if (is_spelled_as_macro(name)) { refuse(name, "is spelled as macros are", place, help); }
    if (is_taken(name)) { refuse(name, "means something else in the header", place, help); }
}

void check_function_name(std::string_view name, const std::optional<Place>& place) {
    const std::string help = fmt::format("take another name, such as {}_value", name);
    const bool is_ours = (is_taken(name) && !gives_way(name)) ||
                         (is_numbered(name, "k") && name != "k") || is_renamed(name);
    if (is_ours) { refuse(name, "means something else in the header", place, help); }
}

void check_own_function_name(std::string_view name, const std::optional<Place>& place) {
    const std::string help = fmt::format("take another name, such as {}_of", name);
    if (is_reserved(name)) { refuse(name, "is a name that C++ reserves", place, help); }
    check_word(name, place, help);
}

std::string with_other_tables(const std::string& text, std::string_view name) {
    if (std::find(tables.begin(), tables.end(), name) == tables.end()) { return text; }
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
        const bool is_comment = text.compare(begin, 2, "//") == 0;
        const auto is_inside = [&](char c) {
            return is_comment ? c != '\n' : is_word(c) || c == '_';
        };
        std::size_t end = begin + 1;
        if (is_inside(text[begin])) {
            while (end < text.size() && is_inside(text[end])) { ++end; }
        }
        const std::string_view word = std::string_view(text).substr(begin, end - begin);
        const bool is_member = begin > 0 && (text[begin - 1] == '.' || text[begin - 1] == ':');
        const bool is_function = text.compare(end, 1, "(") == 0;
        result += word;
        if (word == name && !is_member && !is_function) { result += '_'; }
        begin = end;
    }
    return result;
}

std::string member_name(std::string_view name) {
    const bool is_free = !is_keyword(name) && !is_macro(name) && !names_type(name);
    return std::string(name) + (is_free ? "" : "_");
}

}  // namespace hvi::gen
