// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/totals.hpp"

#include <algorithm>
#include <utility>

#include "generator/lower/accesses.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

namespace {

/// The reverse sweep over the totals of a system.
class ReverseSweep {
public:
    explicit ReverseSweep(System& system)
        : system_(system), count_(system.totals.size()), by_(count_, Graph::number(0)) {}

    void run() {
        const std::vector<SystemSum> sums = system_.sums;
        for (std::size_t k = count_; k-- > 0;) {
            by_[k] = derivative(k, sums);
            if (!by_[k].is_zero()) { add_slopes(k); }
        }
    }

private:
    /// Returns the derivative of the function by a total: through its sums, and through later
    /// totals.
    [[nodiscard]] Scaled derivative(std::size_t k, const std::vector<SystemSum>& sums) {
        SystemTotal by_loops;
        std::vector<Scaled> terms;
        const auto add_all = [&](const std::vector<SystemSum>& of, const Scaled& factor) {
            for (const SystemSum& sum : of) {
                const Node total = system_.totals[k].node;
                const Scaled value = system_.graph.product(
                    factor, gradient(system_.graph, sum.value, {total}).front());
                if (value.is_zero()) { continue; }
                if (sum.loops.empty()) {
                    terms.push_back(value);
                } else {
                    by_loops.sums.push_back(
                        {sum.loops, value, accesses_in(system_, {value}), {}, {}});
                }
            }
        };
        add_all(sums, Graph::number(1));
        for (std::size_t after = k + 1; after < count_; ++after) {
            // NOTE: a copy, as the graph grows.
            const std::vector<SystemSum> of = system_.totals[after].sums;
            if (!by_[after].is_zero()) { add_all(of, by_[after]); }
        }
        if (!by_loops.sums.empty()) { terms.push_back(input_for(std::move(by_loops), k)); }
        return system_.graph.sum(std::move(terms));
    }

    [[nodiscard]] Scaled input_for(SystemTotal total, std::size_t k) {
        const std::string name = "derivative by " + system_.graph.at(system_.totals[k].node).name;
        const Scaled input = system_.graph.input(name, roles_of_total(system_.graph, total.sums));
        total.node = input.node;
        system_.totals.push_back(std::move(total));
        return input;
    }

    [[nodiscard]] std::vector<AccessSlope> times(const Scaled& factor,
                                                 const std::vector<AccessSlope>& slopes) {
        std::vector<AccessSlope> result;
        for (const AccessSlope& slope : slopes) {
            result.push_back({slope.access, system_.graph.product(factor, slope.value)});
        }
        return result;
    }

    /// Adds the slopes of the sums of a total, times the derivative by it.
    void add_slopes(std::size_t k) {
        const std::vector<SystemSum> of = system_.totals[k].sums;
        for (const SystemSum& sum : of) {
            SystemSum through{sum.loops, Graph::number(0), sum.accesses, times(by_[k], sum.by_q),
                              times(by_[k], sum.by_conjugates)};
            for (const auto* slopes : {&through.by_q, &through.by_conjugates}) {
                for (const AccessSlope& slope : *slopes) {
                    for (const std::size_t access : accesses_in(system_, {slope.value})) {
                        insert(through.accesses, access);
                    }
                }
            }
            if (!through.by_q.empty() || !through.by_conjugates.empty()) {
                system_.sums.push_back(std::move(through));
            }
        }
    }

    static void insert(std::vector<std::size_t>& ascending, std::size_t value) {
        const auto place = std::lower_bound(ascending.begin(), ascending.end(), value);
        if (place == ascending.end() || *place != value) { ascending.insert(place, value); }
    }

    System& system_;
    std::size_t count_;       ///< number of totals that the function depends on
    std::vector<Scaled> by_;  ///< derivative by each total
};

}  // namespace

Roles roles_of_total(const Graph& graph, const std::vector<SystemSum>& sums) {
    // NOTE: a total is computed anew for each state, even where it depends on numbers alone.
    Roles roles = static_cast<Roles>(Role::index);
    for (const SystemSum& sum : sums) {
        roles |= graph.at(sum.value.node).roles & (of_state | static_cast<Roles>(Role::time));
    }
    return roles;
}

std::vector<SystemTotal> totals_in(const System& system, const std::vector<SystemSum>& sums) {
    std::vector<Scaled> values;
    for (const SystemSum& sum : sums) { values.push_back(sum.value); }
    std::vector<SystemTotal> result;
    for (std::size_t k = system.totals.size(); k-- > 0;) {
        const SystemTotal& total = system.totals[k];
        if (kernel(system.graph, values).uses[total.node] == 0) { continue; }
        for (const SystemSum& sum : total.sums) { values.push_back(sum.value); }
        result.push_back(total);
    }
    return result;
}

bool is_made_of_totals(const System& system) { return !totals_in(system, system.sums).empty(); }

System with_slopes_through_totals(System system) {
    ReverseSweep(system).run();
    return system;
}

}  // namespace hvi::gen
