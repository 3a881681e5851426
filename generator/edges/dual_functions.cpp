// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/dual_functions.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "generator/emit/text/text.hpp"

namespace hvi::gen {

namespace {

constexpr const char* header_of_duals = "~dual_functions.hpp";

void rename_own_calls(Expression& expression) {
    if (expression.kind == Expression::Kind::call && is_own_function(expression.name)) {
        expression.name.insert(0, "hvi::driver::own::");
    }
    for (Expression& argument : expression.arguments) rename_own_calls(argument);
}

/// Returns `x1, x2`, each with something before it and behind.
std::string arguments(std::size_t count, std::string_view before, std::string_view behind) {
    std::string text;
    for (std::size_t k = 1; k <= count; ++k)
        text += fmt::format("{}{}x{}{}", k == 1 ? "" : ", ", before, k, behind);
    return text;
}

/// Writes f of dual numbers: f(x) + sum_k f_k(x) dx_k.
void write_function(Writer& writer, const OwnFunction& function, const std::string& name,
                    bool has_slopes) {
    const std::string values = arguments(function.arguments, "", ".value");
    const auto at_values = [&](const std::string& called) {
        return fmt::format("::{}<double>({})", called, values);
    };
    std::string sum = at_values(name);
    for (std::size_t k = 0; has_slopes && k < function.arguments; ++k)
        sum = fmt::format("{}chain(x{}, {}, {})", k == 0 ? "" : sum + " + ", k + 1,
                          k == 0 ? sum : "0", at_values(own_derivative(name, k)));
    writer.blank().line("template <class Number>");
    writer.open("Number {}({}) {{", name, arguments(function.arguments, "const Number& ", ""));
    writer.line("return {};", sum).close();
}

/// NOTE: second derivatives are constants here. They stand in the matrices of Newton's method only.
/// Derivatives of its solutions converge whatever the derivatives of these matrices are; see
/// dual.hpp.
void write_functions(Writer& writer, const OwnFunction& function) {
    write_function(writer, function, function.name, true);
    for (std::size_t i = 0; i < function.arguments; ++i)
        write_function(writer, function, own_derivative(function.name, i), true);
    for (std::size_t i = 0; i < function.arguments; ++i)
        for (std::size_t j = i; j < function.arguments; ++j)
            write_function(writer, function, own_derivative(own_derivative(function.name, i), j),
                           false);
}

std::string header_text(const OwnFunctions& own) {
    Writer writer(0);
    writer.line("#pragma once").blank().line("#include <driver/dual.hpp>").blank();
    for (const std::string& header : own.includes()) writer.line("#include \"{}\"", header);
    writer.blank().line("namespace hvi::driver::own {{");
    for (const OwnFunction& function : own.functions) write_functions(writer, function);
    return writer.blank().line("}}  // namespace hvi::driver::own").str();
}

}  // namespace

Scene with_dual_functions(Scene scene) {
    if (scene.own.functions.empty()) return scene;
    scene.own.headers.push_back({header_of_duals, header_text(scene.own)});
    for (OwnFunction& function : scene.own.functions) function.header = header_of_duals;
    rename_own_calls(scene.function.written);
    for (Definition& definition : scene.definitions) rename_own_calls(definition.value.written);
    for (NamedIndexed& invariant : scene.invariants) rename_own_calls(invariant.expression.written);
    return scene;
}

}  // namespace hvi::gen
