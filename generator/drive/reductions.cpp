// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/reductions.hpp"

#include <algorithm>
#include <cmath>

namespace hvi::gen {

namespace {

/// Adds a value to a compensated sum. NOTE: an infinite sum has no remainder.
void add(Sum<double>& sum, double value) {
    const Sum<double> next = two_sum(sum.value, value);
    sum.value = next.value;
    sum.remainder = std::isfinite(next.value) ? sum.remainder + next.remainder : 0;
}

}  // namespace

bool Reductions::any_from(std::size_t column) const {
    return std::any_of(wishes_.begin(), wishes_.end(),
                       [&](const Reduction& each) { return each.column >= column; });
}

void Reductions::begin(double t, const Value& value) {
    first_ = last_ = t;
    for (std::size_t k = 0; k < wishes_.size(); ++k) {
        const double now = value(wishes_[k].column);
        states_[k] = {{wishes_[k].kind == ReductionKind::mean ? 0 : now, 0}, now};
    }
}

void Reductions::see(double t, const Value& value) {
    for (std::size_t k = 0; k < wishes_.size(); ++k) {
        const double now = value(wishes_[k].column);
        State& state = states_[k];
        double& extreme = state.total.value;
        switch (wishes_[k].kind) {
        case ReductionKind::least:
            if (now < extreme || std::isnan(now)) extreme = now;
            break;
        case ReductionKind::largest:
            if (now > extreme || std::isnan(now)) extreme = now;
            break;
        case ReductionKind::mean: add(state.total, (t - last_) * (now / 2 + state.last / 2)); break;
        }
        state.last = now;
    }
    last_ = t;
}

std::vector<double> Reductions::results() const {
    std::vector<double> results;
    for (std::size_t k = 0; k < wishes_.size(); ++k) {
        const State& state = states_[k];
        const double total = state.total.value + state.total.remainder;
        const bool is_mean = wishes_[k].kind == ReductionKind::mean;
        results.push_back(!is_mean          ? total
                          : last_ == first_ ? state.last
                                            : total / (last_ - first_));
    }
    return results;
}

std::vector<double> Reductions::memory() const {
    std::vector<double> all{first_, last_};
    for (const State& state : states_)
        all.insert(all.end(), {state.total.value, state.total.remainder, state.last});
    return all;
}

void Reductions::resume(const std::vector<double>& memory) {
    auto next = memory.begin();
    first_ = *next++;
    last_ = *next++;
    for (State& state : states_) {
        state.total.value = *next++;
        state.total.remainder = *next++;
        state.last = *next++;
    }
}

}  // namespace hvi::gen
