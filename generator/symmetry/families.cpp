// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symmetry/families.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "generator/graph/written.hpp"
#include "generator/hamiltonian/family_symmetries.hpp"
#include "generator/lower/system.hpp"
#include "generator/lower/totals.hpp"
#include "generator/read/own_functions.hpp"

namespace hvi::gen {

namespace {

/// Summands with equal loops, as functions of symbols whose names are the elements' text.
struct Group {
    std::vector<Loop> loops;
    std::vector<Expression> values;
    std::vector<std::size_t> accesses;
    std::map<std::string, Expression> elements;  ///< the elements that the symbols stand for
};

/// Names of the loops of one nest, by their names in another.
using IndexNames = std::map<std::string, std::string>;

AffineForm renamed(AffineForm form, const IndexNames& names) {
    AffineForm result{form.constant, {}};
    for (const auto& [name, coefficient] : form.coefficients) {
        const auto other = names.find(name);
        result.coefficients[other == names.end() ? name : other->second] = coefficient;
    }
    return result;
}

/// Returns new names for the indices of one nest: those of another nest with equal ranges.
std::optional<IndexNames> renaming(const std::vector<Loop>& from, const std::vector<Loop>& to) {
    if (from.size() != to.size()) return {};
    IndexNames names;
    for (std::size_t d = 0; d < from.size(); ++d) {
        const LoopRange& range = from[d].range;
        if (!(LoopRange{renamed(range.first, names), renamed(range.last, names)} == to[d].range))
            return {};
        names[from[d].index] = to[d].index;
    }
    return names;
}

ElementIndex renamed(const ElementIndex& index, const IndexNames& names) {
    ElementIndex result{renamed(index.form, names), {}, renamed(index.offset, names)};
    if (index.modulus) result.modulus = renamed(*index.modulus, names);
    return result;
}

std::vector<Expression> indices_of(const Access& access, const IndexNames& names) {
    std::vector<Expression> indices;
    for (const ElementIndex& index : access.indices)
        indices.push_back(as_expression(renamed(index, names)));
    return indices;
}

/// Returns the place of an access, `i,j`.
std::string place_of(const Access& access, const IndexNames& names) {
    std::string text;
    for (const Expression& index : indices_of(access, names))
        text += (text.empty() ? "" : ",") + to_text(index);
    return text;
}

/// Returns an element; a family without indices is a single symbol.
Expression element_of(const std::string& family, std::vector<Expression> indices) {
    if (indices.empty()) return Expression::symbol(family);
    return Expression::element(family, std::move(indices));
}

bool has_element(const Expression& expression) {
    return expression.kind == Expression::Kind::element ||
           std::any_of(expression.arguments.begin(), expression.arguments.end(), has_element);
}

/// Returns the scene with steps of time: symmetries are those of its own H.
Scene in_time(Scene scene) {
    scene.scale.reset();
    return scene;
}

class FamilyScene {
public:
    explicit FamilyScene(const Scene& scene)
        : scene_(scene),
          system_(system_of(in_time(scene))),
          groups_(groups_of(system_.sums)),
          totals_(totals_in(system_, system_.sums)) {
        for (const SystemFamily& family : system_.coordinates) {
            const auto same = std::find_if(
                system_.coordinates.begin(), system_.coordinates.end(),
                [&](const SystemFamily& other) { return other.ranges == family.ranges; });
            shapes_.push_back(static_cast<std::size_t>(same - system_.coordinates.begin()));
            nests_.push_back(nest_of(family));
        }
    }

    [[nodiscard]] SceneSymmetries found() {
        SceneSymmetries result;
        result.name = scene_.name;
        result.degrees_of_freedom = degrees_of_freedom(scene_);
        for (std::size_t f = 0; f < shapes_.size(); ++f)
            result.coordinates.push_back(to_text(element(system_.coordinates[f], f)));
        result.affine.doubt = "families are moved as wholes, all elements alike";
        if (!totals_.empty())
            result.affine.doubt += ", and sums in products or functions are kept each";
        if (!is_written()) {
            result.affine.doubt = "a summand is too long";
            set_invariants(result, {});
            return result;
        }
        refuse_own_functions(scene_.function.written, scene_.function.source,
                             "what is computed exactly");
        std::vector<FamilySummand> summands;
        for (const Group& group : groups_) summands.push_back(summand(group));
        // NOTE: a field that keeps each total and each summand keeps H; a total's summand is no
        // mass.
        for (const SystemTotal& total : totals_)
            for (const Group& group : groups_of(total.sums)) {
                summands.push_back(summand(group));
                summands.back().is_over_family = false;
            }
        const FamilySymmetries found =
            with_elements(family_symmetries(summands, shapes_, scene_.function.source));
        for (const FamilyField& field : found.fields) add(result, field);
        add_turned_centres(result, found);
        if (!result.affine.basis.empty() && !found.algebra.empty())
            result.affine.algebra = SymmetryAlgebra{found.algebra, {}};
        const bool is_regular = std::all_of(found.masses.begin(), found.masses.end(),
                                            [](const auto& mass) { return mass.has_value(); });
        if (is_regular) result.rank = result.degrees_of_freedom;
        set_invariants(result, found.fields);
        return result;
    }

private:
    /// Groups summands with equal loops, up to the names of indices. A value that is too long is
    /// left out.
    [[nodiscard]] std::vector<Group> groups_of(const std::vector<SystemSum>& sums) const {
        std::vector<Group> groups;
        for (const SystemSum& sum : sums) {
            if (sum.value.is_zero()) continue;
            std::optional<IndexNames> names;
            Group* target = nullptr;
            for (Group& group : groups) {
                names = renaming(sum.loops, group.loops);
                target = &group;
                if (names) break;
            }
            if (!names) {
                target = &groups.emplace_back(Group{sum.loops, {}, {}, {}});
                names = renaming(sum.loops, sum.loops);
            }
            const auto value = written(system_.graph, sum.value);
            if (!value) return {};
            std::map<std::string, std::string> symbols(names->begin(), names->end());
            for (const std::size_t number : sum.accesses) {
                const Access& access = system_.accesses[number];
                Expression element = element_at(access, *names);
                std::string name = to_text(element);
                symbols[system_.graph.at(access.node).name] = name;
                target->elements.emplace(std::move(name), std::move(element));
                target->accesses.push_back(number);
            }
            target->values.push_back(hvi::gen::renamed(*value, symbols));
        }
        return groups;
    }

    [[nodiscard]] bool is_written() const {
        return !groups_.empty() &&
               std::none_of(totals_.begin(), totals_.end(), [&](const SystemTotal& total) {
                   return groups_of(total.sums).empty();
               });
    }

    /// Returns the names of all indices of H's sums in these loops.
    [[nodiscard]] IndexNames names_in(const std::vector<Loop>& loops) const {
        IndexNames names = names_in(system_.sums, loops);
        for (const SystemTotal& total : totals_) names.merge(names_in(total.sums, loops));
        return names;
    }

    /// Returns the loops over all elements of a family.
    [[nodiscard]] std::vector<Loop> nest_of(const SystemFamily& family) const {
        for (const Group& group : groups_)
            if (covers(group.loops, family)) return group.loops;
        std::vector<Loop> loops;
        std::set<std::string> taken{"i"};
        for (const SystemFamily& each : system_.coordinates) taken.insert(each.name);
        for (const SystemFamily& each : system_.conjugates) taken.insert(each.name);
        for (const SystemParameter& each : system_.parameters) taken.insert(each.name);
        for (const SystemSize& each : system_.sizes) taken.insert(each.name);
        taken.erase("i");
        for (const LoopRange& range : family.ranges) {
            std::string name(1, static_cast<char>('i' + loops.size()));
            while (taken.count(name) != 0) name += "_";
            loops.push_back({name, range});
        }
        return loops;
    }

    [[nodiscard]] static bool covers(const std::vector<Loop>& loops, const SystemFamily& family) {
        if (loops.size() != family.ranges.size()) return false;
        for (std::size_t d = 0; d < loops.size(); ++d)
            if (!(loops[d].range == family.ranges[d])) return false;
        return true;
    }

    /// Returns the place `i,j` of a nest.
    [[nodiscard]] static std::string place_of(const std::vector<Loop>& loops) {
        std::string text;
        for (const Loop& loop : loops) text += (text.empty() ? "" : ",") + loop.index;
        return text;
    }

    [[nodiscard]] FamilySummand summand(const Group& group) const {
        FamilySummand result;
        result.function = Expression::sum(group.values);
        for (const Loop& loop : group.loops) result.others.push_back(loop.index);
        std::set<std::string> seen;
        bool is_over_family = true;
        for (const std::size_t number : group.accesses) {
            const Access& access = system_.accesses[number];
            const IndexNames names = names_in(group.loops);
            const std::string place = hvi::gen::place_of(access, names);
            const SystemFamily& family = system_.family(access);
            const std::string symbol = to_text(element_at(access, names));
            if (!seen.insert(symbol).second) continue;
            if (access.kind == FamilyKind::coordinate)
                result.coordinates.push_back({symbol, access.family, place});
            else if (access.kind == FamilyKind::conjugate)
                result.momenta.push_back({symbol, access.family, place});
            else
                result.others.push_back(symbol);
            if (access.kind == FamilyKind::conjugate)
                is_over_family =
                    is_over_family && covers(group.loops, family) && place == place_of(group.loops);
        }
        result.is_over_family = is_over_family;
        return result;
    }

    [[nodiscard]] Expression element_at(const Access& access, const IndexNames& names) const {
        return element_of(system_.family(access).name, indices_of(access, names));
    }

    [[nodiscard]] Expression element(const SystemFamily& family, std::size_t number) const {
        std::vector<Expression> indices;
        for (const Loop& loop : nests_[number]) indices.push_back(Expression::symbol(loop.index));
        return element_of(family.name, std::move(indices));
    }

    [[nodiscard]] Expression q(std::size_t f) const { return element(system_.coordinates[f], f); }
    [[nodiscard]] Expression p(std::size_t f) const { return element(system_.conjugates[f], f); }

    /// Sums a term over all elements of a family.
    [[nodiscard]] Expression summed(Expression term, std::size_t family) const {
        const std::vector<Loop>& loops = nests_[family];
        for (auto loop = loops.rbegin(); loop != loops.rend(); ++loop)
            term = Expression::sum_over(loop->index, as_expression(loop->range.first),
                                        as_expression(loop->range.last), std::move(term));
        return term;
    }

    /// Returns value * a * b, with the sign in front.
    [[nodiscard]] static Expression term(const Expression& value, std::vector<Expression> factors) {
        const bool negative = value.kind == Expression::Kind::negation;
        const Expression& size = negative ? value.arguments[0] : value;
        if (!(size == Expression::integer(1))) factors.insert(factors.begin(), size);
        Expression result = Expression::product(std::move(factors));
        return negative ? Expression::negation(std::move(result)) : result;
    }

    /// Returns p xi of the families of one shape, at one place.
    [[nodiscard]] Expression local_map(const FamilyField& field, std::size_t shape) const {
        std::vector<Expression> positive, negative;
        for (const FamilyField::Entry& entry : field.entries) {
            if (shapes_[entry.row] != shape) continue;
            std::vector<Expression> factors;
            if (entry.column) factors.push_back(q(*entry.column));
            factors.push_back(p(entry.row));
            Expression each = term(entry.value, std::move(factors));
            (each.kind == Expression::Kind::negation ? negative : positive)
                .push_back(std::move(each));
        }
        positive.insert(positive.end(), negative.begin(), negative.end());
        return Expression::sum(std::move(positive));
    }

    [[nodiscard]] std::set<std::size_t> shapes_in(const FamilyField& field) const {
        std::set<std::size_t> result;
        for (const FamilyField::Entry& entry : field.entries) result.insert(shapes_[entry.row]);
        return result;
    }

    static void add(SceneSymmetries& result, AffineSymmetry symmetry) {
        ConservedQuantity& map = result.momentum_maps.emplace_back();
        map.kind = ConservedQuantity::Kind::momentum_map;
        map.name = "J" + std::to_string(result.momentum_maps.size());
        map.expression = symmetry.momentum_map;
        map.finding.conserved = Vanishing::proved;
        map.finding.bracket = Expression::integer(0);
        map.finding.is_momentum_map = true;
        map.finding.quadratic = QuantityFinding::Quadratic{false, false, true};
        result.affine.basis.push_back(std::move(symmetry));
    }

    void add(SceneSymmetries& result, const FamilyField& field) const {
        AffineSymmetry symmetry{std::vector<Expression>(shapes_.size()), {}};
        for (const FamilyField::Entry& entry : field.entries) {
            std::vector<Expression> terms;
            Expression& component = symmetry.generator[entry.row];
            if (!(component == Expression::integer(0))) terms.push_back(component);
            terms.push_back(entry.column ? term(entry.value, {q(*entry.column)}) : entry.value);
            component = Expression::sum(std::move(terms));
        }
        std::vector<Expression> sums;
        for (const std::size_t shape : shapes_in(field))
            sums.push_back(summed(local_map(field, shape), shape));
        symmetry.momentum_map = Expression::sum(std::move(sums));
        add(result, std::move(symmetry));
    }

    /// Adds turns of the centre of mass: for two families that may be translated, and whose part of
    /// H is the sum of p^2/(2 m) with equal m. Then the sums of p are constant, and the sums of m q
    /// grow linearly in time.
    void add_turned_centres(SceneSymmetries& result, const FamilySymmetries& found) const {
        std::vector<std::size_t> translated;
        for (const FamilyField& field : found.fields)
            if (field.entries.size() == 1 && !field.entries[0].column)
                translated.push_back(field.entries[0].row);
        for (std::size_t a = 0; a < translated.size(); ++a)
            for (std::size_t b = a + 1; b < translated.size(); ++b) {
                const std::size_t f = translated[a], g = translated[b];
                const auto& mass = found.masses[f];
                const bool alike = shapes_[f] == shapes_[g] && mass && mass == found.masses[g];
                if (!alike || system_.coordinates[f].ranges.empty()) continue;
                add(result, turned_centre(f, g, *mass));
            }
    }

    [[nodiscard]] AffineSymmetry turned_centre(std::size_t f, std::size_t g,
                                               const Expression& mass) const {
        const bool is_one_mass = !has_element(mass);
        const auto centre = [&](std::size_t family) {
            return summed(is_one_mass ? q(family) : Expression::product({mass, q(family)}), family);
        };
        const auto momentum = [&](std::size_t family) { return summed(p(family), family); };
        AffineSymmetry symmetry{std::vector<Expression>(shapes_.size()), {}};
        symmetry.generator[f] = Expression::negation(centre(g));
        symmetry.generator[g] = centre(f);
        symmetry.momentum_map =
            Expression::sum({Expression::product({centre(f), momentum(g)}),
                             Expression::negation(Expression::product({centre(g), momentum(f)}))});
        return symmetry;
    }

    /// Replaces symbols, whose names are the elements' text, by these elements.
    [[nodiscard]] FamilySymmetries with_elements(FamilySymmetries found) const {
        std::map<std::string, Expression> elements;
        for (const Group& group : groups_)
            elements.insert(group.elements.begin(), group.elements.end());
        for (FamilyField& field : found.fields)
            for (FamilyField::Entry& entry : field.entries)
                entry.value = replaced(entry.value, elements);
        for (auto& mass : found.masses)
            if (mass) mass = replaced(*mass, elements);
        return found;
    }

    /// Replaces elements by symbols, whose names are the elements' text.
    [[nodiscard]] static Expression with_symbols(const Expression& expression) {
        if (expression.kind == Expression::Kind::element)
            return Expression::symbol(to_text(expression));
        std::vector<Expression> arguments;
        for (const Expression& argument : expression.arguments)
            arguments.push_back(with_symbols(argument));
        return with_arguments(expression, std::move(arguments));
    }

    /// An invariant that is one sum over all elements of families.
    struct SummedUp {
        std::size_t shape;
        Expression function;
        std::vector<std::string> variables;
    };

    [[nodiscard]] std::optional<SummedUp> summed_up(const SystemValue& invariant) const {
        const std::vector<Group> groups = groups_of(invariant.sums);
        const bool has_totals = !totals_in(system_, invariant.sums).empty();
        if (groups.size() != 1 || has_totals) return {};
        for (std::size_t shape = 0; shape < shapes_.size(); ++shape) {
            const bool is_over =
                shapes_[shape] == shape && renaming(groups[0].loops, nests_[shape]);
            if (!is_over || !covers(nests_[shape], system_.coordinates[shape])) continue;
            const IndexNames before = names_in(invariant.sums, groups[0].loops);
            const IndexNames after = names_in(invariant.sums, nests_[shape]);
            SummedUp result{shape, Expression::sum(groups[0].values), variables_of(shape)};
            std::map<std::string, std::string> symbols;
            for (const std::size_t number : groups[0].accesses) {
                const Access& access = system_.accesses[number];
                const std::string name = to_text(element_at(access, after));
                symbols[to_text(element_at(access, before))] = name;
                result.variables.push_back(name);
            }
            result.function = hvi::gen::renamed(result.function, symbols);
            return result;
        }
        return {};
    }

    /// Returns the elements at one place.
    [[nodiscard]] std::vector<std::string> variables_of(std::size_t shape) const {
        std::vector<std::string> names;
        for (std::size_t f = 0; f < shapes_.size(); ++f) {
            if (shapes_[f] != shape) continue;
            names.push_back(to_text(q(f)));
            names.push_back(to_text(p(f)));
        }
        return names;
    }

    /// Returns the summands of momentum maps, for one shape.
    [[nodiscard]] std::vector<Expression> maps_of(const std::vector<FamilyField>& fields,
                                                  std::size_t shape) const {
        std::vector<Expression> maps;
        for (const FamilyField& field : fields)
            if (shapes_in(field) == std::set<std::size_t>{shape})
                maps.push_back(with_symbols(local_map(field, shape)));
        return maps;
    }

    /// Marks momentum maps that invariants tell already. NOTE: turned centres of mass, which follow
    /// the fields, are products of sums. No invariant is compared with them, so that they are not
    /// marked.
    void set_said(SceneSymmetries& result, const std::vector<FamilyField>& fields,
                  const std::vector<SummedUp>& invariants) const {
        for (std::size_t k = 0; k < fields.size(); ++k) {
            const std::set<std::size_t> shapes = shapes_in(fields[k]);
            std::vector<Expression> said;
            std::vector<std::string> variables = variables_of(*shapes.begin());
            for (const SummedUp& invariant : invariants) {
                if (invariant.shape != *shapes.begin()) continue;
                said.push_back(invariant.function);
                variables.insert(variables.end(), invariant.variables.begin(),
                                 invariant.variables.end());
            }
            result.momentum_maps[k].is_said =
                shapes.size() == 1 &&
                is_combination(with_symbols(local_map(fields[k], *shapes.begin())), said, variables,
                               scene_.function.source);
        }
    }

    void set_invariants(SceneSymmetries& result, const std::vector<FamilyField>& fields) const {
        std::vector<SummedUp> all;
        for (std::size_t k = 0; k < system_.invariants.size(); ++k) {
            const SystemValue& invariant = system_.invariants[k];
            ConservedQuantity& quantity = result.invariants.emplace_back();
            quantity.name = invariant.name;
            quantity.expression = invariant.expression;
            quantity.place = scene_.invariants[k].place;
            quantity.is_approximate = scene_.approximate.count(invariant.name) != 0;
            auto sum = summed_up(invariant);
            if (!sum) continue;
            all.push_back(*sum);
            if (!is_combination(sum->function, maps_of(fields, sum->shape), sum->variables,
                                quantity.place.source))
                continue;
            quantity.finding.conserved = Vanishing::proved;
            quantity.finding.bracket = Expression::integer(0);
            quantity.finding.is_momentum_map = true;
        }
        set_said(result, fields, all);
    }

    /// Returns the names of all indices of `sums` in these loops.
    [[nodiscard]] static IndexNames names_in(const std::vector<SystemSum>& sums,
                                             const std::vector<Loop>& loops) {
        IndexNames names;
        for (const SystemSum& sum : sums)
            if (const auto found = renaming(sum.loops, loops))
                names.insert(found->begin(), found->end());
        return names;
    }

    const Scene& scene_;
    System system_;
    std::vector<Group> groups_;
    std::vector<SystemTotal> totals_;       ///< totals that H is made of
    std::vector<std::size_t> shapes_;       ///< for each family, the first one with its ranges
    std::vector<std::vector<Loop>> nests_;  ///< loops over all elements of each family
};

}  // namespace

SceneSymmetries symmetries_of_families(const Scene& scene) {
    if (!scene.rotations.texts.empty())
        throw MathError("symmetries of rotations are looked for where sums are written out",
                        whole(scene.function.source), "of a few bodies: a smaller size by --param");
    return FamilyScene(scene).found();
}

}  // namespace hvi::gen
