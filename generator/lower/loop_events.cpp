// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "generator/graph/replaced.hpp"
#include "generator/lower/declarations.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/event_slope.hpp"
#include "generator/lower/lower.hpp"
#include "generator/read/column_file.hpp"
#include "generator/read/names.hpp"
#include "generator/read/put_in.hpp"
#include "generator/read/scene_rules.hpp"

namespace hvi::gen {

namespace {

/// Numbers of elements of a family, which stand in a row, the last index running fastest.
class ElementNumbers {
public:
    ElementNumbers(const SystemFamily& family, const std::map<std::string, long>& sizes) {
        for (const LoopRange& range : family.ranges) {
            firsts_.push_back(range.first.at(sizes));
            counts_.push_back(range.last.at(sizes) - firsts_.back() + 1);
        }
    }

    /// Returns the number of an element; empty where there is no such element.
    [[nodiscard]] std::optional<std::size_t> number(const Index& index) const {
        if (index.size() != firsts_.size()) { return {}; }
        long number = 0;
        for (std::size_t d = 0; d < index.size(); ++d) {
            const long place = index[d] - firsts_[d];
            if (place < 0 || place >= counts_[d]) { return {}; }
            number = number * counts_[d] + place;
        }
        return static_cast<std::size_t>(number);
    }

    /// Returns all indices, in the order of their numbers.
    [[nodiscard]] std::vector<Index> indices() const {
        std::vector<Index> result{{}};
        for (std::size_t d = 0; d < firsts_.size(); ++d) {
            std::vector<Index> longer;
            for (const Index& index : result) {
                for (long k = 0; k < counts_[d]; ++k) {
                    longer.push_back(index);
                    longer.back().push_back(firsts_[d] + k);
                }
            }
            result = std::move(longer);
        }
        return result;
    }

    [[nodiscard]] std::size_t count() const {
        long count = 1;
        for (const long each : counts_) { count *= each; }
        return static_cast<std::size_t>(count);
    }

private:
    std::vector<long> firsts_, counts_;
};

class LoopEventLowering {
public:
    explicit LoopEventLowering(const Scene& scene)
        : scene_(scene), names_(declare(declared_, scene)) {
        sizes_.insert(names_.sizes.begin(), names_.sizes.end());
        for (const auto& [name, size] : names_.sizes) { symbols_[name] = Graph::number(size); }
        for (const SystemParameter& each : declared_.parameters) {
            symbols_[each.name] = lower(result_.graph, each.value, {}, nullptr);
        }
        number_variables();
    }

    [[nodiscard]] LoweredEvents operator()() && {
        const std::optional<Scaled> H = hamiltonian();
        for (const IndexedEvent& event : scene_.events) {
            result_.events.push_back(lowered(event));
        }
        if (H) { add_slopes(*H); }
        leave_out_other_variables();
        return std::move(result_);
    }

private:
    void number_variables() {
        std::size_t first = 0;
        for (const auto* families : {&declared_.coordinates, &declared_.conjugates}) {
            for (const SystemFamily& family : *families) {
                const ElementNumbers numbers(family, names_.sizes);
                variables_.emplace(family.name, std::pair(first, numbers));
                first += numbers.count();
            }
            if (families == &declared_.coordinates) {
                if (scene_.scale) { time_ = first++; }
                result_.degrees = first;
            }
        }
    }

    /// Returns the value of an expression, for these values of indices.
    [[nodiscard]] Scaled value(const IndexedExpression& written, const SceneRules& rules,
                               const WholeNumbers& indices = {}) {
        std::vector<std::string> names;
        WholeNumbers known = sizes_;
        for (const auto& [name, index] : indices) {
            names.push_back(name);
            known[name] = index;
        }
        const IndexedExpression meant = names_.meant(written, rules, names);
        const Expression expression = unrolled(meant, known);
        walk(expression, [&](const Expression& part) {
            if (part.kind == Expression::Kind::symbol) { know(part, meant.source); }
            return true;
        });
        return lower(result_.graph, expression, symbols_, meant.source);
    }

    /// Returns a value of an event. Of an L its velocities are p/m, where masses are known.
    [[nodiscard]] Scaled value_of_event(const IndexedExpression& written, const SceneRules& rules) {
        const Scaled result = value(written, rules);
        if (!velocities_.empty()) { return replaced(result_.graph, result, velocities_); }
        if (scene_.side == Side::lagrangian) {
            check_event_of_L(result_.graph, result, whole(written.source));
        }
        return result;
    }

    /// Gives a symbol the node of its input or its value.
    void know(const Expression& symbol, const std::shared_ptr<const Source>& source) {
        const std::string& name = symbol.name;
        if (symbols_.count(name) != 0 || is_constant(name)) { return; }
        if (name == "t") {
            symbols_[name] = result_.graph.input(name, Role::time);
            const Node node = symbols_[name].node;
            if (time_) {
                result_.variables.push_back({*time_, node});
            } else {
                result_.time = node;
            }
            return;
        }
        const std::string stem(without_index(name));
        const auto found = names_.families.find(stem);
        const std::optional<Scaled> element =
            found == names_.families.end() ? std::nullopt
            : found->second.kind == FamilyKind::table
                ? value_in_list(found->second.number, index_of(name))
                : variable(stem, name, found->second.kind);
        if (!element) {
            throw InputError(fmt::format("there is no `{}`", name), Place{source, symbol.range});
        }
        symbols_[name] = *element;
    }

    [[nodiscard]] std::optional<Scaled> variable(const std::string& stem, const std::string& name,
                                                 FamilyKind kind) {
        const auto& [first, numbers] = variables_.at(stem);
        const auto number = numbers.number(index_of(name));
        if (!number) { return {}; }
        const Role role = kind == FamilyKind::coordinate ? Role::coordinate : Role::conjugate;
        const Scaled input = result_.graph.input(name, role);
        result_.variables.push_back({first + *number, input.node});
        return input;
    }

    [[nodiscard]] std::optional<Scaled> value_in_list(std::size_t table, const Index& index) {
        const SystemTable& list = declared_.tables[table];
        const auto number = ElementNumbers(list.family, names_.sizes).number(index);
        if (!number) { return {}; }
        return lower(result_.graph, values_of(list).at(*number), {}, nullptr);
    }

    /// Returns the values of a list. Values in a file are read once.
    [[nodiscard]] const std::vector<Expression>& values_of(const SystemTable& list) {
        if (const auto* values = std::get_if<std::vector<Expression>>(&list.values)) {
            return *values;
        }
        const auto [known, is_new] = in_files_.try_emplace(list.family.name);
        if (!is_new) { return known->second; }
        const auto& file = std::get<NumbersInFile>(list.values);
        const auto column = file.column.empty() ? std::nullopt : std::optional(file.column);
        const Place place = whole(scene_.function.source);
        for (const IndexedExpression& each :
             all_values_in({scene_.directory, file.path, column, place}).values) {
            known->second.push_back(each.written);
        }
        return known->second;
    }

    [[nodiscard]] std::optional<LoweredSpan> span(const std::optional<IndexedExpression>& written,
                                                  const SceneRules& rules) {
        if (!written) { return {}; }
        return LoweredSpan{value(*written, rules), whole(written->source)};
    }

    [[nodiscard]] LoweredEvent lowered(const IndexedEvent& event) {
        LoweredEvent result{.name = event.name,
                            .direction = event.direction,
                            .stop = event.stop,
                            .zero = value_of_event(event.zero, event_rules)};
        if (event.set && scene_.scale) {
            throw InputError("events that jump are not built where sums stay loops and time is "
                             "scaled",
                             event.place, "the momentum of the time would jump, by what H does");
        }
        if (event.set) { result.set = jumps(*event.set); }
        result.cooldown = span(event.cooldown, cooldown_rules);
        result.period = span(event.period, period_rules);
        return result;
    }

    // ---- slopes ----

    /// Returns H with its sums written out; empty where it is not differentiated here. NOTE: only
    /// the number of words can be wrong in a function that has steps.
    [[nodiscard]] std::optional<Scaled> hamiltonian() {
        const bool is_plain =
            !scene_.scale && scene_.own.headers.empty() && scene_.rotations.texts.empty();
        if (!is_plain) { return {}; }
        try {
            const Scaled function = value(scene_.function, rules_of_function(scene_.side));
            return scene_.side == Side::hamiltonian ? function : hamiltonian_of_L(function);
        } catch (const InputError&) { return {}; }
    }

    /// Returns H of an L, and replaces velocities by momenta. NOTE: an L that has steps is a sum of
    /// m v^2/2 over all velocities, and of what depends on coordinates alone.
    [[nodiscard]] Scaled hamiltonian_of_L(const Scaled& L) {
        Graph& graph = result_.graph;
        std::vector<Node> velocities;
        std::vector<EventVariable> momenta;
        for (EventVariable& each : result_.variables) {
            if (each.number < result_.degrees) { continue; }
            velocities.push_back(each.node);
            each.node =
                graph.input("momentum of " + graph.at(each.node).name, Role::conjugate).node;
            momenta.push_back(each);
        }
        const std::vector<Scaled> slopes = gradient(graph, L, velocities);
        std::map<Node, Scaled> at_rest;
        std::vector<Scaled> terms;
        for (std::size_t k = 0; k < velocities.size(); ++k) {
            const Scaled mass = replaced(graph, slopes[k], {{velocities[k], Graph::number(1)}}),
                         p{{1, 1}, momenta[k].node}, v = graph.product(p, graph.inverse(mass));
            at_rest[velocities[k]] = Graph::number(0);
            velocities_[velocities[k]] = v;
            terms.push_back(graph.times({1, 2}, graph.product(p, v)));
        }
        terms.push_back(graph.times({-1, 1}, replaced(graph, L, at_rest)));
        return graph.sum(std::move(terms));
    }

    /// Returns the variables whose motion is looked for: those of events. All, where there may be
    /// derivatives of the state of an event that ends the run.
    [[nodiscard]] std::vector<std::size_t> moving() const {
        const auto& events = result_.events;
        const bool may_end = std::any_of(events.begin(), events.end(),
                                         [](const LoweredEvent& each) { return each.stop != 0; });
        std::vector<std::size_t> numbers;
        if (may_end && result_.degrees <= most_degrees_of_freedom) {
            numbers.resize(2 * result_.degrees);
            std::iota(numbers.begin(), numbers.end(), std::size_t{0});
            return numbers;
        }
        std::vector<Scaled> zeros;
        for (const LoweredEvent& event : events) { zeros.push_back(event.zero); }
        const std::vector<bool> is_part = nodes_of(result_.graph, zeros);
        for (const EventVariable& each : result_.variables) {
            if (is_part[each.node]) { numbers.push_back(each.number); }
        }
        return numbers;
    }

    void add_slopes(const Scaled& H) {
        result_.motion = motion_under(result_, H, moving());
        for (LoweredEvent& event : result_.events) { differentiate(result_, event); }
    }

    /// Leaves out the variables of H that nothing depends on.
    void leave_out_other_variables() {
        std::vector<Scaled> values;
        for (const auto& [number, value] : result_.motion) { values.push_back(value); }
        for (const LoweredEvent& event : result_.events) {
            values.push_back(event.zero);
            if (event.slope) { values.push_back(*event.slope); }
            for (const LoweredJump& jump : event.set) { values.push_back(jump.value); }
        }
        const std::vector<bool> is_part = nodes_of(result_.graph, values);
        std::erase_if(result_.variables,
                      [&](const EventVariable& each) { return !is_part[each.node]; });
    }

    // ---- jumps ----

    [[nodiscard]] std::vector<LoweredJump> jumps(const ValueTable& table) {
        std::vector<LoweredJump> result;
        std::set<std::string> given;
        for (const IndexedValue& each : table.values) {
            if (scene_.side == Side::lagrangian) { refuse_set_of_L(each.place); }
            const auto variable = variables_.find(each.name);
            if (variable == variables_.end()) {
                throw InputError(fmt::format("`{}` is no variable", each.name), each.place);
            }
            if (!given.insert(each.name).second) {
                throw InputError(fmt::format("`{}` is given values twice", each.name), each.place);
            }
            add_jumps(result, each, variable->second.first, variable->second.second);
        }
        return result;
    }

    /// Adds the new values of a family whose first element has this number.
    void add_jumps(std::vector<LoweredJump>& jumps, const IndexedValue& given, std::size_t first,
                   const ElementNumbers& numbers) {
        const std::vector<Index> indices = numbers.indices();
        const std::size_t dimension = indices.front().size();
        const auto* one = std::get_if<IndexedExpression>(&given.value);
        const auto* rule = std::get_if<ValueRule>(&given.value);
        const auto* list = std::get_if<ValueList>(&given.value);
        const bool fits = (one != nullptr && dimension == 0) || rule != nullptr ||
                          (list != nullptr && list->values.size() == indices.size());
        if (!fits) {
            throw InputError(fmt::format("what is set of `{}` is a rule for all indices, or a list "
                                         "of {} values",
                                         given.name, indices.size()),
                             given.place_of_value, "as \"p[i]\" = \"-p[i]\"");
        }
        if (rule != nullptr) {
            check_dimension(given.name, dimension, rule->indices.size(), given.place);
        }
        for (std::size_t k = 0; k < indices.size(); ++k) {
            WholeNumbers known;
            for (std::size_t d = 0; rule != nullptr && d < dimension; ++d) {
                known[rule->indices[d]] = indices[k][d];
            }
            const IndexedExpression& written = rule != nullptr  ? rule->value
                                               : one != nullptr ? *one
                                                                : list->values[k];
            jumps.push_back({first + k, value(written, jump_rules, known)});
        }
    }

    const Scene& scene_;
    System declared_;
    Declarations names_;
    WholeNumbers sizes_;
    LoweredEvents result_;
    Symbols symbols_;
    /// Number of the first element of each family of variables, and the numbers of the others.
    std::map<std::string, std::pair<std::size_t, ElementNumbers>> variables_;
    std::optional<std::size_t> time_;    ///< its number among the coordinates, where it is one
    std::map<Node, Scaled> velocities_;  ///< of an L, as functions of momenta
    std::map<std::string, std::vector<Expression>> in_files_;
};

}  // namespace

LoweredEvents lowered_events(const Scene& scene) { return LoopEventLowering(scene)(); }

}  // namespace hvi::gen
