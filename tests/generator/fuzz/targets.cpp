// The targets.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/generator/fuzz/targets.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <string>

#include "generator/read/coefficients.hpp"
#include "generator/read/hamiltonian.hpp"
#include "generator/read/method.hpp"
#include "generator/read/names.hpp"
#include "generator/read/scene.hpp"
#include "tests/generator/fuzz/attempt.hpp"

namespace hvi::gen::fuzz {

namespace {

std::shared_ptr<const Source> source(std::string_view bytes) {
    return std::make_shared<const Source>(Source{"fuzz", std::string(bytes)});
}

int depth(const Expression& expression) {
    int deepest = 0;
    for (const Expression& argument : expression.arguments)
        deepest = std::max(deepest, depth(argument));
    return deepest + 1;
}

void check_ranges(const Expression& expression, const Source& text) {
    require(expression.range.begin <= expression.range.end &&
                expression.range.end <= text.text.size(),
            "a range leaves the text");
    for (const Expression& argument : expression.arguments) check_ranges(argument, text);
}

/// NOTE: a fraction such as 0.5 is printed as 1/2, with parentheses that make the text deeper and
/// longer, so that printed text near a limit may be refused.
void check_printing(const Expression& expression) {
    const std::string printed = to_text(expression);
    static_cast<void>(to_latex(expression));
    if (depth(expression) > 90 || printed.size() > 60000) return;
    require(to_text(unrolled(parse_indexed_expression(source(printed)))) == printed,
            "printing changes a meaning");
}

template <class Reader>
void attempt_to_read(Reader&& reader) {
    attempt([&] {
        try {
            reader();
        } catch (const MathError& error) {
            require(error.place().has_value(), "an error without a place");
            throw;
        }
    });
}

void check_list(const List& list) {
    for (const Item& item : list.items) {
        const auto* expression = std::get_if<Expression>(&item.what);
        if (expression == nullptr) continue;
        check_ranges(*expression, *list.source);
        check_printing(*expression);
    }
}

}  // namespace

void expression(std::string_view bytes) {
    const auto text = source(bytes);
    attempt_to_read([&] {
        const Expression result = parse_expression(text);
        check_ranges(result, *text);
        check_printing(result);
    });
}

void list(std::string_view bytes) {
    attempt_to_read([&] { check_list(parse_list(source(bytes))); });
    attempt_to_read([&] { static_cast<void>(method_from_text(source(bytes), source("0"))); });
    attempt_to_read([&] { static_cast<void>(method_from_text(source("1"), source(bytes))); });
}

void name(std::string_view bytes) {
    attempt_to_read([&] { static_cast<void>(named_method(source(bytes))); });
}

void parameter(std::string_view bytes) {
    attempt_to_read([&] { static_cast<void>(parse_parameter(source(bytes))); });
}

void method_file(std::string_view bytes) {
    attempt_to_read([&] {
        const Method method = method_from_toml({"fuzz.toml", std::string(bytes)});
        check_list(method.basis);
        check_list(method.nodes);
        require(method.origin.find('\n') == std::string::npos, "an origin of several lines");
    });
}

void coefficients(std::string_view bytes) {
    attempt_to_read([&] {
        const Coefficients result = coefficients_from_json({"fuzz.json", std::string(bytes)});
        const std::size_t stages = result.stages();
        require(1 <= stages && stages <= 64 && result.b.size() == stages &&
                    result.A.size() == stages,
                "a tableau of another shape");
        for_each_coefficient(result, [](const Coefficient& entry) {
            check_ranges(entry.value, *entry.source);
            check_printing(entry.value);
        });
        static_cast<void>(parameter_names(result));
        require(result.origin.find('\n') == std::string::npos, "an origin of several lines");
    });
}

void check_scene(const WrittenOutScene& result) {
    const MechanicalFunction& function = function_of(result);
    check_ranges(function.expression, *function.source);
    check_printing(function.expression);
    std::set<std::string> names;
    for (const Parameter& parameter : result.parameters)
        names.insert(std::string(without_index(parameter.name)));
    require(names.size() <= 64, "too many parameters");
    require(result.initial.size() == variables(result).size(), "not all initial values");
    require(result.exact.empty() || result.exact.size() == result.initial.size(),
            "not all exact solutions");
    for (const auto* list : {&result.invariants, &result.initial, &result.exact}) {
        for (const NamedExpression& entry : *list) {
            check_ranges(entry.expression, *entry.place.source);
            check_printing(entry.expression);
        }
    }
    require(!result.name.empty(), "a scene without a name");
    require((result.description + function.origin).find('\n') == std::string::npos,
            "a description or an origin of several lines");
}

/// NOTE: see check_printing() for its exceptions.
void check_indices(const IndexedExpression& expression) {
    check_ranges(expression.written, *expression.source);
    const std::string printed = to_text(expression.written);
    if (depth(expression.written) > 90 || printed.size() > 60000) return;
    require(to_text(parse_indexed_expression(source(printed)).written) == printed,
            "printing changes a sum");
}

void scene(std::string_view bytes) {
    attempt_to_read([&] {
        const Scene written = scene_from_toml({"fuzz.toml", std::string(bytes)});
        check_indices(written.function);
        for (const Definition& definition : written.definitions) check_indices(definition.value);
        check_scene(unrolled(written));
    });
}

void hamiltonian(std::string_view bytes) {
    const std::size_t first = std::min(bytes.find('\n'), bytes.size());
    const std::size_t second = std::min(bytes.find('\n', first + 1), bytes.size());
    const auto text = source(bytes.substr(0, first));
    const bool named = second < bytes.size();
    attempt_to_read([&] {
        const Hamiltonian H =
            named ? hamiltonian_from_text(text, source(bytes.substr(first + 1, second - first - 1)),
                                          source(bytes.substr(second + 1)))
                  : hamiltonian_from_text(text);
        check_ranges(H.expression, *text);
        check_printing(H.expression);
        require(H.coordinates.size() == H.momenta.size(), "a variable without its partner");
        require(H.degrees_of_freedom() > 0, "no variables");
        std::set<std::string> names;
        for (const std::string& name : parameter_names(H))
            names.insert(std::string(without_index(name)));
        require(names.size() <= 64, "too many parameters");
        require(H.origin.find('\n') == std::string::npos, "an origin of several lines");
    });
}

}  // namespace hvi::gen::fuzz
