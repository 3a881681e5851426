// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/element_conditions.hpp"

#include <fmt/format.h>

#include <map>

namespace hvi::gen {

namespace {

enum class End { least, largest };

/// Returns the extreme of an index within loops, by the bounds of each loop.
AffineForm extreme(const ElementIndex& index, const std::vector<Loop>& loops, End end) {
    AffineForm form = index.form;
    if (index.modulus) {
        form = index.offset;
        if (end == End::largest) { form = form + *index.modulus - AffineForm{1}; }
    }
    for (auto loop = loops.rbegin(); loop != loops.rend(); ++loop) {
        const bool rises = form.coefficient(loop->index) > 0;
        const bool is_at_last = rises == (end == End::largest);
        form = replaced(form, loop->index, is_at_last ? loop->range.last : loop->range.first);
    }
    return form;
}

class Conditions {
public:
    Conditions(const System& system, const ClassNames& names) : system_(system), names_(names) {
        for (const SystemSize& size : system.sizes) { sizes_[size.name] = size.value; }
    }

    void add(const std::vector<std::size_t>& accesses, const std::vector<Loop>& loops) {
        for (const std::size_t a : accesses) { add(system_.accesses[a], loops); }
    }

    [[nodiscard]] std::set<std::string> all() && { return std::move(all_); }

private:
    void add(const Access& access, const std::vector<Loop>& loops) {
        const SystemFamily& family = system_.family(access);
        const bool is_list = access.kind == FamilyKind::table && family.ranges.size() == 1;
        for (std::size_t d = 0; d < access.indices.size(); ++d) {
            const AffineForm largest = extreme(access.indices[d], loops, End::largest);
            add_order(family.ranges[d].first, extreme(access.indices[d], loops, End::least));
            if (is_list) {
                add_length(family, largest);
            } else {
                add_order(largest, family.ranges[d].last);
            }
        }
    }

    void add_order(const AffineForm& lower, const AffineForm& upper) {
        const AffineForm difference = upper - lower;
        if (difference.is_number() || difference.at(sizes_) < 0) { return; }
        all_.insert(fmt::format("{} <= {}", names_.whole(lower), names_.whole(upper)));
    }

    /// Adds a condition on the length of a list. NOTE: a program may give a list of another length.
    void add_length(const SystemFamily& list, const AffineForm& largest) {
        if (largest.at(sizes_) > list.ranges[0].last.constant) { return; }
        all_.insert(fmt::format("{} <= static_cast<Place>({}_values_.size())",
                                names_.whole(largest), member_of(list.name)));
    }

    const System& system_;
    const ClassNames& names_;
    std::map<std::string, long> sizes_;
    std::set<std::string> all_;
};

}  // namespace

std::set<std::string> conditions_of_sums(const System& system, const ClassNames& names) {
    Conditions conditions(system, names);
    const auto add_all = [&](const std::vector<SystemSum>& sums) {
        for (const SystemSum& sum : sums) { conditions.add(sum.accesses, sum.loops); }
    };
    add_all(system.sums);
    for (const SystemTotal& total : system.totals) { add_all(total.sums); }
    for (const SystemValue& invariant : system.invariants) { add_all(invariant.sums); }
    return std::move(conditions).all();
}

std::set<std::string> conditions_of_starts(const System& system, const ClassNames& names) {
    Conditions conditions(system, names);
    std::set<std::string> lengths;
    const std::size_t count = system.coordinates.size();
    for (std::size_t k = 0; k < system.initial.size(); ++k) {
        const SystemFamily& family =
            k < count ? system.coordinates[k] : system.conjugates[k - count];
        if (std::holds_alternative<NumbersInFile>(system.initial[k].values)) { continue; }
        if (const auto* list = std::get_if<SystemStart::List>(&system.initial[k].values)) {
            lengths.insert(fmt::format("{} == {}", names.count(family), list->values.size()));
            conditions.add(list->accesses, {});
            continue;
        }
        const auto add = [&](const auto& rule) {
            std::vector<Loop> loops;
            for (std::size_t d = 0; d < rule.indices.size(); ++d) {
                loops.push_back({rule.indices[d], family.ranges[d]});
            }
            conditions.add(rule.accesses, loops);
        };
        if (const auto* rule = std::get_if<SystemStart::Rule>(&system.initial[k].values)) {
            add(*rule);
        } else if (const auto* all = std::get_if<SystemStart::Points>(&system.initial[k].values)) {
            add(*all);
        }
    }
    std::set<std::string> all = std::move(conditions).all();
    all.merge(lengths);
    return all;
}

}  // namespace hvi::gen
