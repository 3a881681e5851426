// Methods by name, by lists, and the values of their parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "generator/read/catalogue.hpp"
#include "generator/read/check.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

std::string part(const Source& source, Range range) {
    return source.text.substr(range.begin, range.end - range.begin);
}

std::vector<std::string_view> method_names() {
    std::vector<std::string_view> names;
    for (const FamilyEntry& entry : node_families()) names.push_back(entry.name);
    for (const MethodEntry& entry : named_methods()) names.push_back(entry.name);
    for (const SplittingEntry& entry : splittings())
        names.push_back(entry.name.substr(0, entry.name.find(":S")));
    return names;
}

std::vector<std::string_view> names_elsewhere() {
    std::vector<std::string_view> names;
    for (const OtherName& other : other_names())
        if (!other.method.empty()) names.push_back(other.name);
    return names;
}

const MethodEntry* find_method(std::string_view name) {
    const std::span<const MethodEntry> methods = named_methods();
    const auto found = std::find_if(methods.begin(), methods.end(),
                                    [&](const MethodEntry& entry) { return entry.name == name; });
    return found == methods.end() ? nullptr : &*found;
}

/// Returns whether a splitting has this name. Throws InputError for a size that it does not have.
bool is_splitting(const std::string& name, const std::shared_ptr<const Source>& source) {
    constexpr std::string_view saba = "saba:";
    if (name.starts_with(saba)) {
        const Family family = parse_family(source);
        if (family.size >= 1 && family.size <= largest_saba) return true;
        throw InputError(fmt::format("there is no `{}`", name), whole(source),
                         fmt::format("S is from 1 to {}", largest_saba));
    }
    return std::any_of(splittings().begin(), splittings().end(), [&](const SplittingEntry& entry) {
        return entry.name == name && entry.sizes.empty();
    });
}

/// Returns our name of a method that is named as in other programs; empty where there is none.
std::string_view known_elsewhere(std::string_view name) {
    for (const OtherName& other : other_names())
        if (other.name == name) return other.method;
    return {};
}

[[noreturn]] void refuse_name(const std::string& name,
                              const std::shared_ptr<const Source>& source) {
    const std::string first = name.substr(0, name.find(':'));
    for (const OtherName& other : other_names())
        if (other.name == first && !other.help.empty())
            throw InputError(fmt::format("there is no method `{}`", name), whole(source),
                             std::string(other.help));
    throw InputError(fmt::format("there is no method `{}`", name), whole(source),
                     did_you_mean(name, method_names(),
                                  did_you_mean(name, names_elsewhere(),
                                               "`hvi-gen list methods` shows them all")));
}

/// Makes a family of nodes with its interpolating polynomials.
Method family_method(const std::shared_ptr<const Source>& source) {
    Family nodes = parse_family(source);
    if (find_method(nodes.name) != nullptr)
        throw InputError(fmt::format("`{}` is a single method, without a size", nodes.name),
                         whole(source), fmt::format("write `{}`", nodes.name));
    if (find_family(node_families(), nodes.name) == nullptr) refuse_name(nodes.name, source);
    const Range range = nodes.range;
    const Family basis{"monomials", nodes.size, range};
    Method method;
    method.name = fmt::format("{}:{}", nodes.name, nodes.size);
    method.nodes = {source, {{std::move(nodes), range}}};
    check_nodes(method.nodes);
    method.basis = {source, {{basis, range}}};
    return method;
}

Method single_method(const MethodEntry& entry) {
    const auto list = [&](std::string_view text) {
        return parse_list(
            std::make_shared<const Source>(Source{std::string(entry.name), std::string(text)}));
    };
    Method method;
    method.name = entry.name;
    method.basis = list(entry.basis);
    method.nodes = list(entry.nodes);
    return method;
}

/// NOTE: one stage at the end of the step is a drift, and a kick after it.
Method splitting_method(const std::string& name) {
    Method method = single_method({name, "1", "1", "", ""});
    method.splitting = name;
    return method;
}

/// Returns a text without blanks inside items and without characters that the shell or a comment in
/// C++ would act on.
std::string canonical_text(const List& list) {
    std::string text;
    for (const Item& item : list.items) {
        if (!text.empty()) text += ", ";
        if (const auto* family = std::get_if<Family>(&item.what))
            text += fmt::format("{}:{}", family->name, family->size);
        else
            text += to_text(std::get<Expression>(item.what));
    }
    return text;
}

void insert_parameters(const List& list, std::set<std::string>& names) {
    for (const Item& item : list.items) {
        if (const auto* expression = std::get_if<Expression>(&item.what))
            insert_parameters(*expression, names);
    }
}

}  // namespace

Method named_method(std::shared_ptr<const Source> source) {
    const std::string name = part(*source, trimmed(source->text, whole(source).range));
    if (name.empty()) throw InputError("the name of the method is empty", whole(source));
    if (is_splitting(name, source)) {
        Method method = splitting_method(name);
        method.origin = "--method " + name;
        method.place = whole(source);
        return method;
    }
    const std::string_view here = known_elsewhere(name);
    const MethodEntry* entry = find_method(here.empty() ? name : here);
    if (entry == nullptr && name.find(':') == std::string::npos) {
        const bool is_family = find_family(node_families(), name) != nullptr || name == "saba";
        if (!is_family) refuse_name(name, source);
        throw InputError(fmt::format("`{}` is a family of methods and wants a size", name),
                         whole(source), fmt::format("write for example `{}:3`", name));
    }
    Method method = entry != nullptr ? single_method(*entry) : family_method(source);
    method.origin = "--method " + method.name;
    method.place = whole(source);
    return method;
}

Method method_from_text(std::shared_ptr<const Source> basis, std::shared_ptr<const Source> nodes,
                        std::shared_ptr<const Source> weights) {
    List functions = parse_list(std::move(basis));
    List points = parse_list(std::move(nodes));
    std::optional<List> factors;
    if (weights != nullptr) factors = parse_list(std::move(weights));
    Method method = method_from_lists(std::move(functions), std::move(points), std::move(factors));
    method.origin = fmt::format("--basis \"{}\" --nodes \"{}\"", canonical_text(method.basis),
                                canonical_text(method.nodes));
    if (method.weights)
        method.origin += fmt::format(" --weights \"{}\"", canonical_text(*method.weights));
    return method;
}

Method method_from_lists(List basis, List nodes, std::optional<List> weights) {
    check_basis(basis);
    check_nodes(nodes);
    if (weights) check_weights(*weights);
    Method method;
    method.basis = std::move(basis);
    method.nodes = std::move(nodes);
    method.weights = std::move(weights);
    method.place = whole(method.basis.source);
    if (parameter_names(method).size() > most_parameters)
        throw InputError(fmt::format("there are more than {} parameters", most_parameters),
                         whole(method.basis.source));
    return method;
}

Parameter parse_parameter(std::shared_ptr<const Source> source) {
    const std::string& text = source->text;
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos)
        throw InputError("a name and its value are wanted here", whole(source),
                         "write for example `w=2`");
    const Range name = trimmed(text, {0, sign});
    Parameter parameter{part(*source, name), {}, {source, name}};
    check_symbol_name(parameter.name, parameter.place);
    const Range value{sign + 1, text.size()};
    if (trimmed(text, value).begin == value.end)
        throw InputError("a value is missing after `=`", Place{source, {sign, sign + 1}});
    read_value(parameter, source, value);
    return parameter;
}

void read_value(Parameter& parameter, std::shared_ptr<const Source> source, Range part) {
    const std::string_view text = std::string_view(source->text).substr(0, part.end);
    if (text.find(':', part.begin) != std::string_view::npos)
        throw InputError("a parameter has one value, and no range of them",
                         Place{source, trimmed(source->text, part)},
                         "call hvi-gen once for each value, as in --param w=1/10");
    parameter.value = parse_expression(source, part);
    check_parameter_value(parameter.value, {source, part});
    parameter.source = std::move(source);
}

std::vector<std::string> parameter_names(const Method& method) {
    std::set<std::string> names;
    insert_parameters(method.basis, names);
    insert_parameters(method.nodes, names);
    if (method.weights) insert_parameters(*method.weights, names);
    return {names.begin(), names.end()};
}

void assign(std::vector<Parameter>& parameters, Parameter parameter) {
    const auto same = std::find_if(parameters.begin(), parameters.end(),
                                   [&](const auto& other) { return other.name == parameter.name; });
    if (same == parameters.end())
        parameters.push_back(std::move(parameter));
    else
        *same = std::move(parameter);
}

void set_parameter(std::vector<Parameter>& values, const std::vector<std::string>& names,
                   Parameter parameter, std::string_view subject) {
    if (std::find(names.begin(), names.end(), parameter.name) == names.end()) {
        const std::string otherwise =
            names.empty() ? std::string() : fmt::format("the parameters are {}", listed(names));
        throw InputError(fmt::format("{} has no parameter `{}`", subject, parameter.name),
                         parameter.place,
                         did_you_mean(parameter.name, {names.begin(), names.end()}, otherwise));
    }
    assign(values, std::move(parameter));
}

std::string parameter_option(const Parameter& parameter) {
    return fmt::format(" --param \"{}={}\"", parameter.name, to_text(parameter.value));
}

void set_parameter(Method& method, Parameter parameter) {
    const std::string option = parameter_option(parameter);
    set_parameter(method.parameters, parameter_names(method), std::move(parameter), "the method");
    method.origin += option;
}

}  // namespace hvi::gen
