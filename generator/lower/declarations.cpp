// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/declarations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/read/names.hpp"
#include "generator/read/no_loops.hpp"
#include "generator/read/own_functions.hpp"
#include "generator/read/sizes.hpp"

namespace hvi::gen {

namespace {

SystemFamily family_of(const std::string& name, const std::vector<std::size_t>& extents) {
    SystemFamily family{name, {}};
    for (const std::size_t extent : extents) {
        family.ranges.push_back({{1}, {static_cast<long>(extent)}});
    }
    return family;
}

class Declaring {
public:
    Declaring(System& system, const Scene& scene) : system_(system), scene_(scene) {}

    [[nodiscard]] Declarations operator()() && {
        declare_sizes();
        declare_families(scene_.coordinates, FamilyKind::coordinate, "a coordinate");
        declare_families(scene_.rotations, FamilyKind::coordinate, "a rotation",
                         rotations_of_space);
        declare_families(scene_.conjugates, FamilyKind::conjugate, subject_of_conjugates(scene_));
        declare_families(scene_.angular_momenta, FamilyKind::conjugate, "an angular momentum",
                         angular_momenta);
        check_pairs();
        declare_parameters();
        define();
        check_more_names(scene_, names_.names);
        names_.taken = names_.names.stems();
        return std::move(names_);
    }

private:
    void declare_sizes();
    void declare_families(const NameTexts& texts, FamilyKind kind, std::string_view subject,
                          const Space& space = real_line);
    void check_extents() const;
    [[nodiscard]] bool are_pairs(bool that_turn) const;
    void check_pairs() const;
    void declare_parameters();
    void declare_table(SystemTable table);
    [[nodiscard]] SystemTable table(const std::string& name, const ValueList& list) const;
    void define();

    System& system_;
    const Scene& scene_;
    Declarations names_;
};

// ---- names ----

void Declaring::declare_sizes() {
    for (const auto& [name, value] : sizes(scene_)) {
        names_.sizes[name] = value;
        system_.sizes.push_back({name, value});
        names_.symbols[name] = system_.graph.input(name, Role::parameter);
    }
}

/// NOTE: with loops the numbers of a point are elements too: the rotations R[k] are R[k,i,j].
void Declaring::declare_families(const NameTexts& texts, FamilyKind kind, std::string_view subject,
                                 const Space& space) {
    std::vector<SystemFamily>& families =
        kind == FamilyKind::coordinate ? system_.coordinates : system_.conjugates;
    for (const NameTexts::Text& text : texts.texts) {
        for (const Name& name : text.names) {
            const Place place{text.source, name.range};
            names_.names.declare({name.stem, place}, subject);
            SystemFamily family{name.stem, {}, space};
            for (const IndexBounds& written : name.bounds) {
                const auto first = affine_form(written.first), last = affine_form(written.last);
                if (!first || !last) {
                    throw NoLoops("bounds of indices are made of whole numbers and sizes",
                                  Place{text.source, written.range});
                }
                family.ranges.push_back({*first, *last});
            }
            family.ranges.insert(family.ranges.end(), component_dimensions(space), {{1}, {3}});
            names_.families[name.stem] = {kind, families.size()};
            families.push_back(std::move(family));
        }
    }
}

void Declaring::check_extents() const {
    for (const SystemFamily& family : system_.coordinates) {
        for (const LoopRange& range : family.ranges) {
            if (range.last.at(names_.sizes) >= range.first.at(names_.sizes)) { continue; }
            throw InputError(fmt::format("`{}` has no index", family.name),
                             scene_.coordinates.place);
        }
    }
}

/// Returns whether coordinates and their conjugates are pairs, among the families that turn, or
/// among the others.
bool Declaring::are_pairs(bool that_turn) const {
    const auto chosen = [&](const std::vector<SystemFamily>& families) {
        std::vector<SystemFamily> result = families;
        std::erase_if(result, [&](const SystemFamily& family) {
            return (family.space != real_line) != that_turn;
        });
        return result;
    };
    const std::vector<SystemFamily> q = chosen(system_.coordinates), y = chosen(system_.conjugates);
    return std::equal(q.begin(), q.end(), y.begin(), y.end(), are_of_one_body);
}

void Declaring::check_pairs() const {
    const auto check = [&](bool that_turn, std::string_view which, const Place& place,
                           const char* help) {
        if (are_pairs(that_turn)) { return; }
        throw NoLoops(fmt::format("where sums stay loops, {} are pairs of families with the same "
                                  "indices",
                                  which),
                      place, help);
    };
    check(false,
          scene_.side == Side::hamiltonian ? "coordinates and momenta"
                                           : "coordinates and velocities",
          scene_.conjugates.place, "as x[1..N], y[1..N] and px[1..N], py[1..N]");
    check(true, "rotations and angular momenta", scene_.angular_momenta.place,
          "as R[1..N] and L[1..N]");
    check_extents();
}

// ---- parameters ----

SystemTable Declaring::table(const std::string& name, const ValueList& list) const {
    std::vector<Expression> values;
    for (const IndexedExpression& each : list.values) {
        Expression number = unrolled(each, {names_.sizes.begin(), names_.sizes.end()});
        check_words({number, each.source}, parameter_rules, names_.names, {});
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

void Declaring::declare_table(SystemTable table) {
    names_.families[table.family.name] = {FamilyKind::table, system_.tables.size()};
    system_.tables.push_back(std::move(table));
}

void Declaring::declare_parameters() {
    std::vector<Parameter> numbers;
    for (const IndexedValue& value : scene_.parameters) {
        names_.names.declare({value.name, value.place}, "a parameter");
        if (names_.sizes.count(value.name) != 0) { continue; }
        if (const auto* list = std::get_if<ValueList>(&value.value)) {
            declare_table(table(value.name, *list));
            continue;
        }
        if (const auto* file = std::get_if<ValueFile>(&value.value)) {
            declare_table({family_of(value.name, file->extents), numbers_in(*file)});
            continue;
        }
        const auto& written = std::get<IndexedExpression>(value.value);
        numbers.push_back({value.name,
                           unrolled(written, {names_.sizes.begin(), names_.sizes.end()}),
                           value.place, written.source});
    }
    for (const Parameter& number : numbers) {
        check_words({number.value, number.source}, parameter_rules, names_.names, {});
    }
    resolve(numbers);
    for (Parameter& number : numbers) {
        if (scene_.fixed.count(number.name) != 0) {
            names_.symbols[number.name] = lower(system_.graph, number.value, {}, number.source);
            continue;
        }
        const Scaled node = system_.graph.input(number.name, Role::parameter);
        names_.symbols[number.name] = node;
        system_.parameters.push_back({number.name, std::move(number.value), node.node});
    }
}

void Declaring::define() {
    for (const Definition& definition : scene_.definitions) {
        check_definition(definition, names_.names);
        names_.definitions.add(definition);
    }
}

}  // namespace

IndexedExpression Declarations::meant(const IndexedExpression& written, const SceneRules& rules,
                                      const std::vector<std::string>& indices) const {
    IndexedExpression put = definitions.put_in(written);
    std::set<std::string> known(indices.begin(), indices.end());
    for (const auto& [name, size] : sizes) { known.insert(name); }
    check_words(put, rules, names, std::move(known));
    return put;
}

Declarations declare(System& system, const Scene& scene) { return Declaring(system, scene)(); }

NumbersInFile numbers_in(const ValueFile& file) { return {file.path, file.column.value_or("")}; }

}  // namespace hvi::gen
