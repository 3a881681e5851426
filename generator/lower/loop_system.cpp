// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/lower/accesses.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/element_ranges.hpp"
#include "generator/lower/loop_legendre.hpp"
#include "generator/lower/loop_structure.hpp"
#include "generator/lower/loop_terms.hpp"
#include "generator/lower/lower.hpp"
#include "generator/lower/sites.hpp"
#include "generator/lower/totals.hpp"
#include "generator/read/hamiltonian.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/no_loops.hpp"
#include "generator/read/own_functions.hpp"
#include "generator/read/put_in.hpp"
#include "generator/read/sizes.hpp"

namespace hvi::gen {

namespace {

/// A family by its name.
struct Named {
    FamilyKind kind;
    std::size_t number;
};

NumbersInFile numbers_in(const ValueFile& file) { return {file.path, file.column.value_or("")}; }

SystemFamily family_of(const std::string& name, const std::vector<std::size_t>& extents) {
    SystemFamily family{name, {}};
    for (const std::size_t extent : extents) {
        family.ranges.push_back({{1}, {static_cast<long>(extent)}});
    }
    return family;
}

class LoopLowering {
public:
    explicit LoopLowering(const Scene& written) : written_(written) {}

    [[nodiscard]] System operator()();

private:
    void refuse_what_has_no_loops() const;
    void declare_sizes();
    void declare_families(const NameTexts& texts, FamilyKind kind);
    void check_pairs() const;
    void declare(const std::string& name, const Place& place);
    void declare_parameters();
    void declare_table(SystemTable table);
    [[nodiscard]] SystemTable table(const std::string& name, const ValueList& list) const;
    void define();

    /// Adds the time to what symbols stand for, where the expression has it.
    [[nodiscard]] Symbols symbols_in_time(const IndexedExpression& expression);
    [[nodiscard]] std::vector<SystemSum> sums(const IndexedExpression& expression, Symbols known);
    [[nodiscard]] Scaled total(const std::string& name, const IndexedExpression& sum,
                               const Symbols& known);
    [[nodiscard]] Scaled value(const Expression& term, const std::vector<Loop>& loops,
                               const std::shared_ptr<const Source>& source, Symbols known);
    [[nodiscard]] Expression with_accesses(const Expression& term, const std::vector<Loop>& loops,
                                           const std::shared_ptr<const Source>& source,
                                           Symbols& symbols);
    [[nodiscard]] std::string access(const Expression& element, const std::vector<Loop>& loops,
                                     const std::shared_ptr<const Source>& source, Symbols& symbols);
    [[nodiscard]] ElementIndex index(const Expression& written, const std::vector<Loop>& loops,
                                     const std::shared_ptr<const Source>& source) const;
    void check_known(const Expression& part, const std::vector<Loop>& loops,
                     const std::shared_ptr<const Source>& source, const Symbols& symbols) const;
    void add_slopes(SystemSum& sum);
    [[nodiscard]] const SystemFamily& family(const Named& named) const;

    void check_count(const SystemFamily& family, std::size_t given, const Place& place) const;
    [[nodiscard]] Scaled value_at_start(const LoopTerm& term, const IndexedExpression& whole);
    [[nodiscard]] SystemStart start(const SystemFamily& family);
    [[nodiscard]] SystemStart start(const SystemFamily& family, const IndexedValue& value);

    const Scene& written_;
    System system_;
    std::map<std::string, long> sizes_;
    std::map<std::string, Named> families_;
    std::set<std::string> taken_;  ///< all names but those of indices
    Symbols symbols_;              ///< parameters, and sizes as numbers
    Definitions definitions_;
};

// ---- names ----

void LoopLowering::refuse_what_has_no_loops() const {
    if (!written_.rotations.texts.empty()) {
        throw NoLoops("rotations have no loops", written_.rotations.place);
    }
}

void LoopLowering::declare(const std::string& name, const Place& place) {
    if (!taken_.insert(name).second) {
        throw InputError(fmt::format("`{}` is named twice", name), place);
    }
}

void LoopLowering::declare_sizes() {
    for (const auto& [name, value] : sizes(written_)) {
        sizes_[name] = value;
        system_.sizes.push_back({name, value});
        symbols_[name] = system_.graph.input(name, Role::parameter);
    }
}

void LoopLowering::declare_families(const NameTexts& texts, FamilyKind kind) {
    std::vector<SystemFamily>& families =
        kind == FamilyKind::coordinate ? system_.coordinates : system_.conjugates;
    for (const NameTexts::Text& text : texts.texts) {
        for (const Name& name : text.names) {
            const Place place{text.source, name.range};
            check_parameter_name(name.stem, place, "a variable");
            declare(name.stem, place);
            SystemFamily family{name.stem, {}};
            for (const IndexBounds& written : name.bounds) {
                const auto first = affine_form(written.first), last = affine_form(written.last);
                if (!first || !last) {
                    throw NoLoops("bounds of indices are made of whole numbers and sizes",
                                  Place{text.source, written.range});
                }
                family.ranges.push_back({*first, *last});
            }
            families_[name.stem] = {kind, families.size()};
            families.push_back(std::move(family));
        }
    }
}

void LoopLowering::check_pairs() const {
    const auto extent = [&](const LoopRange& range) {
        return range.last.at(sizes_) - range.first.at(sizes_);
    };
    const auto& [coordinates, momenta] = std::tie(system_.coordinates, system_.conjugates);
    bool are_pairs = coordinates.size() == momenta.size();
    for (std::size_t k = 0; are_pairs && k < coordinates.size(); ++k) {
        are_pairs = coordinates[k].ranges == momenta[k].ranges;
        for (const LoopRange& range : coordinates[k].ranges) {
            if (extent(range) < 0) {
                throw InputError(fmt::format("`{}` has no index", coordinates[k].name),
                                 written_.coordinates.place);
            }
        }
    }
    if (!are_pairs) {
        const std::string_view others =
            written_.side == Side::hamiltonian ? "momenta" : "velocities";
        throw NoLoops(fmt::format("where sums stay loops, coordinates and {} are pairs of families "
                                  "with the same indices",
                                  others),
                      written_.conjugates.place, "as x[1..N], y[1..N] and px[1..N], py[1..N]");
    }
}

// ---- parameters ----

SystemTable LoopLowering::table(const std::string& name, const ValueList& list) const {
    std::vector<Expression> values;
    for (const IndexedExpression& each : list.values) {
        Expression number = unrolled(each, {sizes_.begin(), sizes_.end()});
        refuse_own_functions(number, each.source, "the value of a parameter");
        walk(number, [&](const Expression& part) {
            if (part.kind == Expression::Kind::symbol && !is_constant(part.name)) {
                throw NoLoops("where sums stay loops, lists of parameters are made of numbers",
                              Place{each.source, part.range});
            }
            return true;
        });
        values.push_back(std::move(number));
    }
    return {family_of(name, list.extents), std::move(values)};
}

void LoopLowering::declare_table(SystemTable table) {
    families_[table.family.name] = {FamilyKind::table, system_.tables.size()};
    system_.tables.push_back(std::move(table));
}

void LoopLowering::declare_parameters() {
    std::vector<Parameter> numbers;
    for (const IndexedValue& value : written_.parameters) {
        check_parameter_name(value.name, value.place);
        declare(value.name, value.place);
        if (sizes_.count(value.name) != 0) { continue; }
        if (const auto* list = std::get_if<ValueList>(&value.value)) {
            declare_table(table(value.name, *list));
            continue;
        }
        if (const auto* file = std::get_if<ValueFile>(&value.value)) {
            declare_table({family_of(value.name, file->extents), numbers_in(*file)});
            continue;
        }
        const auto& written = std::get<IndexedExpression>(value.value);
        numbers.push_back({value.name, unrolled(written, {sizes_.begin(), sizes_.end()}),
                           value.place, written.source});
    }
    resolve(numbers);
    for (Parameter& number : numbers) {
        refuse_own_functions(number.value, number.source, "the value of a parameter");
        walk(number.value, [&](const Expression& part) {
            if (part.kind == Expression::Kind::symbol && !is_constant(part.name)) {
                throw InputError(fmt::format("`{}` is no parameter", part.name),
                                 Place{number.source, part.range});
            }
            return true;
        });
        if (written_.fixed.count(number.name) != 0) {
            symbols_[number.name] = lower(system_.graph, number.value, {}, number.source);
            continue;
        }
        const Scaled node = system_.graph.input(number.name, Role::parameter);
        symbols_[number.name] = node;
        system_.parameters.push_back({number.name, std::move(number.value), node.node});
    }
}

void LoopLowering::define() {
    for (const Definition& definition : written_.definitions) {
        declare(definition.name, definition.place);
        definitions_.add(definition);
    }
}

// ---- summands ----

const SystemFamily& LoopLowering::family(const Named& named) const {
    return system_.family({named.kind, named.number});
}

/// NOTE: in an index a mod stands once, and what is beside it is added.
ElementIndex LoopLowering::index(const Expression& written, const std::vector<Loop>& loops,
                                 const std::shared_ptr<const Source>& source) const {
    walk(written, [&](const Expression& part) {
        if (part.kind == Expression::Kind::symbol) {
            const bool is_known = sizes_.count(part.name) != 0 ||
                                  std::any_of(loops.begin(), loops.end(), [&](const Loop& loop) {
                                      return loop.index == part.name;
                                  });
            if (!is_known) {
                throw InputError(fmt::format("`{}` is neither a size nor an index here", part.name),
                                 Place{source, part.range});
            }
        }
        return true;
    });
    if (auto form = affine_form(written)) { return {std::move(*form)}; }
    const auto is_mod = [](const Expression& part) {
        return part.kind == Expression::Kind::call && part.name == "mod";
    };
    std::vector<Expression> parts{written};
    if (written.kind == Expression::Kind::sum) { parts = written.arguments; }
    const auto mod = std::find_if(parts.begin(), parts.end(), is_mod);
    if (mod != parts.end()) {
        auto form = affine_form(mod->arguments[0]), modulus = affine_form(mod->arguments[1]);
        parts.erase(mod);
        auto offset = affine_form(Expression::sum(std::move(parts)));
        if (form && modulus && offset) {
            return {std::move(*form), std::move(modulus), std::move(*offset)};
        }
    }
    throw NoLoops("where sums stay loops, an index is made of whole numbers, sizes and indices "
                  "of sums by +, - and products with numbers, or of one mod of these and what "
                  "is added to it",
                  Place{source, written.range});
}

/// The name of an element in the graph, and among the symbols.
std::string LoopLowering::access(const Expression& element, const std::vector<Loop>& loops,
                                 const std::shared_ptr<const Source>& source, Symbols& symbols) {
    const Place place{source, element.range};
    const auto found = families_.find(element.name);
    if (found == families_.end()) {
        std::vector<std::string_view> names;
        for (const auto& [name, named] : families_) { names.push_back(name); }
        throw InputError(
            fmt::format("there is no variable or parameter `{}` with an index", element.name),
            place, did_you_mean(element.name, names, ""));
    }
    const SystemFamily& of = family(found->second);
    if (of.ranges.size() != element.arguments.size()) {
        throw InputError(fmt::format("`{}` has {} ind{}, and here {}", element.name,
                                     of.ranges.size(), of.ranges.size() == 1 ? "ex" : "ices",
                                     element.arguments.size()),
                         place);
    }
    std::vector<ElementIndex> indices;
    for (const Expression& written : element.arguments) {
        indices.push_back(index(written, loops, source));
    }
    check_ranges(of, indices, loops, sizes_, place);
    const std::size_t number =
        access_to(system_, found->second.kind, found->second.number, std::move(indices));
    const Node node = system_.accesses[number].node;
    const std::string name = system_.graph.at(node).name;
    symbols[name] = {{1, 1}, node};
    return name;
}

/// NOTE: elements become symbols, as a graph has them.
Expression LoopLowering::with_accesses(const Expression& term, const std::vector<Loop>& loops,
                                       const std::shared_ptr<const Source>& source,
                                       Symbols& symbols) {
    const bool is_scalar_variable = term.kind == Expression::Kind::symbol &&
                                    families_.count(term.name) != 0 &&
                                    family(families_.at(term.name)).ranges.empty();
    if (term.kind == Expression::Kind::element || is_scalar_variable) {
        Expression symbol = Expression::symbol(access(term, loops, source, symbols));
        symbol.range = term.range;
        return symbol;
    }
    if (term.kind == Expression::Kind::symbol) { check_known(term, loops, source, symbols); }
    Expression result = term;
    for (Expression& argument : result.arguments) {
        argument = with_accesses(argument, loops, source, symbols);
    }
    return result;
}

void LoopLowering::check_known(const Expression& part, const std::vector<Loop>& loops,
                               const std::shared_ptr<const Source>& source,
                               const Symbols& symbols) const {
    const std::string& name = part.name;
    const bool is_index = std::any_of(loops.begin(), loops.end(),
                                      [&](const Loop& loop) { return loop.index == name; });
    if (is_constant(name) || is_index || symbols.count(name) != 0) { return; }
    const Place place{source, part.range};
    if (families_.count(name) != 0) {
        throw InputError(fmt::format("`{}` has an index", name), place);
    }
    std::vector<std::string_view> names(taken_.begin(), taken_.end());
    throw InputError(fmt::format("`{}` has no meaning here", name), place,
                     did_you_mean(name, names, "give it a value: add it to [parameters]"));
}

Scaled LoopLowering::value(const Expression& term, const std::vector<Loop>& loops,
                           const std::shared_ptr<const Source>& source, Symbols symbols) {
    const Expression written = with_accesses(term, loops, source, symbols);
    check_functions(written, source, "an expression of a scene");
    for (const Loop& loop : loops) {
        symbols[loop.index] = system_.graph.input(loop.index, Role::index);
    }
    return lower(system_.graph, written, symbols, source);
}

Symbols LoopLowering::symbols_in_time(const IndexedExpression& expression) {
    Symbols known = symbols_;
    if (!depends_on_time(definitions_.put_in(expression).written)) { return known; }
    const Scaled time = system_.graph.input("t", Role::time);
    system_.time = time.node;
    known["t"] = time;
    return known;
}

std::vector<SystemSum> LoopLowering::sums(const IndexedExpression& expression, Symbols known) {
    const IndexedExpression whole = definitions_.put_in(expression);
    check_numbers(whole.written, whole.source);
    const auto roles = [&](const std::string& name) -> Roles {
        const auto found = families_.find(name);
        if (found == families_.end()) { return 0; }
        switch (found->second.kind) {
        case FamilyKind::coordinate: return static_cast<Roles>(Role::coordinate);
        case FamilyKind::conjugate: return static_cast<Roles>(Role::conjugate);
        case FamilyKind::table:
        case FamilyKind::direction:
        case FamilyKind::direction_of_conjugate:
        case FamilyKind::turn: break;
        }
        return 0;
    };
    struct Group {
        std::vector<Loop> loops;
        Roles roles;
        std::vector<Scaled> values;
    };
    std::vector<Group> groups;
    const LoopTerms split = loop_terms(whole, {taken_, roles});
    for (const auto& [name, sum] : split.totals) {
        known[name] = total(name, {sum, whole.source}, known);
    }
    for (const LoopTerm& term : split.terms) {
        const Scaled summand = value(term.term, term.loops, whole.source, known);
        if (summand.is_zero()) { continue; }
        // NOTE: where the kinds of what a summand depends on differ, it is another sum.
        const Roles found = system_.graph.at(summand.node).roles & of_state;
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
            return group.loops == term.loops && group.roles == found;
        });
        if (same == groups.end()) {
            groups.push_back({term.loops, found, {summand}});
        } else {
            same->values.push_back(summand);
        }
    }
    std::vector<SystemSum> result;
    for (Group& group : groups) {
        result.push_back(
            {std::move(group.loops), system_.graph.sum(std::move(group.values)), {}, {}, {}});
        add_slopes(result.back());
    }
    return result;
}

/// The input for a sum that others are made of.
Scaled LoopLowering::total(const std::string& name, const IndexedExpression& sum,
                           const Symbols& known) {
    for (const SystemTotal& before : system_.totals) {
        if (system_.graph.at(before.node).name == name) { return {{1, 1}, before.node}; }
    }
    std::vector<SystemSum> of = sums(sum, known);
    const Scaled input = system_.graph.input(name, roles_of_total(system_.graph, of));
    system_.totals.push_back({input.node, std::move(of)});
    return input;
}

void LoopLowering::add_slopes(SystemSum& sum) {
    sum.accesses = accesses_in(system_, {sum.value});
    std::vector<Node> inputs;
    for (const std::size_t k : sum.accesses) { inputs.push_back(system_.accesses[k].node); }
    const std::vector<Scaled> slopes = gradient(system_.graph, sum.value, inputs);
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        const FamilyKind kind = system_.accesses[sum.accesses[k]].kind;
        if (kind == FamilyKind::table || slopes[k].is_zero()) { continue; }
        (kind == FamilyKind::coordinate ? sum.by_q : sum.by_conjugates)
            .push_back({sum.accesses[k], slopes[k]});
    }
}

// ---- where it begins ----

void LoopLowering::check_count(const SystemFamily& family, std::size_t given,
                               const Place& place) const {
    const std::size_t wanted = element_count(family, sizes_);
    if (given == wanted) { return; }
    throw InputError(fmt::format("`{}` has {} {}, and here are {} values", family.name, wanted,
                                 wanted == 1 ? "index" : "indices", given),
                     place);
}

/// `whole`: the expression that the term is made of.
Scaled LoopLowering::value_at_start(const LoopTerm& term, const IndexedExpression& whole) {
    const Scaled result = value(term.term, term.loops, whole.source, symbols_);
    if ((system_.graph.at(result.node).roles & of_state) != 0) {
        throw InputError("an initial value cannot depend on a variable",
                         Place{whole.source, whole.written.range});
    }
    return result;
}

SystemStart LoopLowering::start(const SystemFamily& family, const IndexedValue& value) {
    if (const auto* file = std::get_if<ValueFile>(&value.value)) {
        check_count(family, count(*file), value.place_of_value);
        return {numbers_in(*file)};
    }
    if (const auto* list = std::get_if<ValueList>(&value.value)) {
        check_count(family, list->values.size(), value.place_of_value);
        SystemStart::List result;
        for (const IndexedExpression& each : list->values) {
            const IndexedExpression put = definitions_.put_in(each);
            refuse_own_functions(put.written, each.source, "an initial value");
            result.values.push_back(value_at_start({{}, without_sums(put)}, each));
        }
        result.accesses = accesses_in(system_, result.values);
        return {std::move(result)};
    }
    const auto* rule = std::get_if<ValueRule>(&value.value);
    const IndexedExpression& written =
        rule != nullptr ? rule->value : std::get<IndexedExpression>(value.value);
    const std::vector<std::string> indices =
        rule != nullptr ? rule->indices : std::vector<std::string>{};
    if (indices.size() != family.ranges.size()) {
        throw InputError(fmt::format("`{}` has {} ind{}, and here it has {}", family.name,
                                     family.ranges.size(),
                                     family.ranges.size() == 1 ? "ex" : "ices", indices.size()),
                         value.place, "give a rule for all indices: \"x[i]\" = \"sin(i)\"");
    }
    const IndexedExpression whole = definitions_.put_in(written);
    refuse_own_functions(whole.written, whole.source, "an initial value");
    LoopTerm term{{}, without_sums(whole)};
    for (std::size_t d = 0; d < indices.size(); ++d) {
        term = within_loop(std::move(term), indices[d], family.ranges[d], taken_);
    }
    SystemStart::Rule result;
    for (const Loop& loop : term.loops) { result.indices.push_back(loop.index); }
    result.value = value_at_start(term, whole);
    result.accesses = accesses_in(system_, {result.value});
    return {std::move(result)};
}

SystemStart LoopLowering::start(const SystemFamily& family) {
    for (const IndexedValue& value : written_.initial->values) {
        if (value.name == family.name) { return start(family, value); }
    }
    throw InputError(fmt::format("an initial value is missing: that of `{}`", family.name),
                     written_.initial->place);
}

System LoopLowering::operator()() {
    refuse_what_has_no_loops();
    system_.side = written_.side;
    system_.name = written_.name;
    system_.description = written_.description;
    system_.directory = written_.directory;
    system_.expression = written_.function.written;
    system_.own_headers = written_.own.includes();
    declare_sizes();
    declare_families(written_.coordinates, FamilyKind::coordinate);
    declare_families(written_.conjugates, FamilyKind::conjugate);
    check_pairs();
    declare_parameters();
    define();
    system_.sums = sums(written_.function, symbols_in_time(written_.function));
    system_.energy = system_.sums;
    for (const auto* families : {&system_.coordinates, &system_.conjugates}) {
        for (const SystemFamily& each : *families) { system_.initial.push_back(start(each)); }
    }
    for (const IndexedValue& value : written_.initial->values) {
        const auto found = families_.find(value.name);
        if (found == families_.end() || found->second.kind == FamilyKind::table) {
            throw InputError(fmt::format("`{}` is no variable", value.name), value.place);
        }
    }
    for (const NamedIndexed& invariant : written_.invariants) {
        check_parameter_name(invariant.name, invariant.place_of_name, "an invariant");
        declare(invariant.name, invariant.place_of_name);
        system_.invariants.push_back(
            {invariant.name, invariant.expression.written, sums(invariant.expression, symbols_)});
    }
    return std::move(system_);
}

}  // namespace

System loop_system(const Scene& scene) {
    System system = LoopLowering(scene)();
    if (scene.side == Side::lagrangian) {
        system = legendre_transform(std::move(system), whole(scene.function.source));
    }
    system = with_slopes_through_totals(std::move(system));
    system = with_loop_structure(with_sites(std::move(system)));
    verify(system);
    return system;
}

}  // namespace hvi::gen
