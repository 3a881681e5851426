// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/flow.hpp"

#include <utility>

namespace hvi::gen {

namespace {

/// Returns the operations of a function of the runtime.
OperationCounts counts_of(const RuntimeValues& values) {
    // NOTE: of an orbit at one place, which is enough for most: see two_bodies.hpp of the runtime.
    constexpr OperationCounts of_orbit{
        .additions = 70, .multiplications = 90, .divisions = 3, .square_roots = 1};
    constexpr OperationCounts of_turn{
        .additions = 200, .multiplications = 100, .divisions = 5, .square_roots = 1, .calls = 2};
    if (values.function == RuntimeFunction::turn_about_momentum) { return of_turn; }
    OperationCounts counts;
    for (std::size_t j = 0; j < values.results.size() / changes_of_orbit; ++j) {
        counts += of_orbit;
    }
    return counts;
}

}  // namespace

OperationCounts counts_of_flow(const Graph& graph, const HamiltonianPart& part) {
    std::vector<Scaled> changes;
    for (const Moved& moved : part.usual ? part.usual->moved : part.moved) {
        changes.push_back(moved.change);
    }
    for (const RuntimeValues& values : part.in_each_flow) {
        changes.insert(changes.end(), values.given.begin(), values.given.end());
    }
    OperationCounts counts = kernel(graph, std::move(changes)).counts;
    for (const RuntimeValues& values : part.in_each_flow) { counts += counts_of(values); }
    for (const FormMoved& form : part.forms) {
        // NOTE: an entry of the matrix has two parts, and its sum keeps what is cut off.
        const std::size_t entries = 4 * form.degrees.size() * form.degrees.size();
        counts.multiplications += 2 * entries;
        counts.additions += 8 * entries;
    }
    return counts;
}

std::size_t numbers_moved(const HamiltonianPart& part) {
    std::size_t count = part.moved.size();
    for (const FormMoved& form : part.forms) { count += 2 * form.degrees.size(); }
    return count;
}

}  // namespace hvi::gen
