// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/scene_rules.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/read/lagrangian.hpp"
#include "generator/read/names.hpp"
#include "generator/read/own_functions.hpp"

namespace hvi::gen {

namespace {

using Kind = Expression::Kind;

class WordCheck {
public:
    WordCheck(const std::shared_ptr<const Source>& source, const SceneRules& rules,
              const Vocabulary& names, std::set<std::string> known)
        : source_(source), rules_(rules), names_(names), known_(std::move(known)) {}

    void operator()(const Expression& part) {
        if (part.kind == Kind::symbol || part.kind == Kind::element) { return check_name(part); }
        if (part.kind == Kind::sum_over) {
            const bool is_new = known_.insert(part.name).second;
            (*this)(part.arguments[2]);
            if (is_new) { known_.erase(part.name); }
            return;
        }
        for (const Expression& argument : part.arguments) { (*this)(argument); }
    }

private:
    void check_name(const Expression& part) const {
        const std::string& name = part.name;
        const bool is_time = name == "t" && part.kind == Kind::symbol;
        if (is_constant(name) || known_.count(name) != 0 || (is_time && rules_.time)) { return; }
        const Place place{source_, part.range};
        if (is_time) {
            throw InputError(fmt::format("{} cannot depend on the time `t`", rules_.subject),
                             place);
        }
        check_symbol_name(name, place);
        const std::string help(rules_.help), text = to_text(part);
        const std::string_view stem = without_index(name);
        names_.check_stem(stem, text, place, help);
        if (rules_.variables || names_.is("a parameter", stem)) { return; }
        throw InputError(fmt::format("{} cannot depend on the variable `{}`", rules_.subject, text),
                         place, help);
    }

    const std::shared_ptr<const Source>& source_;
    const SceneRules& rules_;
    const Vocabulary& names_;
    std::set<std::string> known_;
};

}  // namespace

std::string_view subject_of_conjugates(const Scene& scene) {
    return scene.side == Side::lagrangian ? words_of_velocities.subject : words_of_momenta.subject;
}

const SceneRules& rules_of_function(Side side) {
    return side == Side::hamiltonian ? hamiltonian_rules : lagrangian_rules;
}

void check_dimension(const std::string& family, std::size_t wanted, std::size_t given,
                     const Place& place, std::string help) {
    if (given == wanted) { return; }
    throw InputError(fmt::format("`{}` has {} ind{}, and here it has {}", family, wanted,
                                 wanted == 1 ? "ex" : "ices", given),
                     place, std::move(help));
}

void check_definition(const Definition& definition, const Vocabulary& names) {
    if (!names.has(definition.name)) { return; }
    throw InputError(fmt::format("`{}` is a variable or a parameter already", definition.name),
                     definition.place);
}

void check_more_names(const Scene& scene, Vocabulary names) {
    for (const NamedIndexed& invariant : scene.invariants) {
        check_parameter_name(invariant.name, invariant.place_of_name, "an invariant");
        names.declare({invariant.name, invariant.place_of_name}, "an invariant");
    }
    for (const IndexedField& field : scene.fields) {
        check_parameter_name(field.name, field.place, "a symmetry");
        names.declare({field.name, field.place}, "a symmetry");
    }
    for (const IndexedEvent& event : scene.events) {
        check_parameter_name(event.name, event.place, "an event");
    }
}

void check_words(const IndexedExpression& expression, const SceneRules& rules,
                 const Vocabulary& names, std::set<std::string> known) {
    const auto& [written, source] = expression;
    check_functions(written, source, rules.subject);
    if (!rules.own_functions) { refuse_own_functions(written, source, rules.subject); }
    WordCheck(source, rules, names, std::move(known))(written);
}

}  // namespace hvi::gen
