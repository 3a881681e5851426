// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/unrolling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "generator/read/put_in.hpp"
#include "generator/read/sizes.hpp"

namespace hvi::gen {

namespace {

using Kind = Expression::Kind;

class Count {
public:
    Count(const std::shared_ptr<const Source>& source, WholeNumbers known, std::size_t most)
        : source_(source), known_(std::move(known)), most_(most) {}

    [[nodiscard]] std::size_t operator()(const Expression& written) {
        switch (written.kind) {
        case Kind::number:
        case Kind::symbol:
        case Kind::element: return 0;
        case Kind::sum_over: return of_sum(written);
        case Kind::sum:
        case Kind::product: return of_arguments(written, written.arguments.size() - 1);
        case Kind::negation: return of_arguments(written, 0);
        case Kind::reciprocal:
        case Kind::power:
        case Kind::call: break;
        }
        return of_arguments(written, 1);
    }

private:
    [[nodiscard]] std::size_t of_arguments(const Expression& written, std::size_t own) {
        for (const Expression& argument : written.arguments) {
            own += (*this)(argument);
            if (own >= most_) { return most_; }
        }
        return own;
    }

    /// Counts an addition for each term. NOTE: a term without sums counts equally for every index.
    [[nodiscard]] std::size_t of_sum(const Expression& sum) {
        const long first = whole_number(sum.arguments[0], source_, known_);
        const long last = whole_number(sum.arguments[1], source_, known_);
        const Expression& term = sum.arguments[2];
        const auto before = known_.find(sum.name);
        const auto hidden = before == known_.end() ? std::nullopt : std::optional(before->second);
        std::size_t total = 0;
        if (!has_sum(term)) {
            const auto terms = static_cast<std::size_t>(std::max(0L, last - first + 1));
            const std::size_t each = (*this)(term) + 1;
            total = terms > most_ / each ? most_ : terms * each;
        } else {
            for (long index = first; index <= last && total < most_; ++index) {
                known_[sum.name] = index;
                total += (*this)(term) + 1;
            }
        }
        known_.erase(sum.name);
        if (hidden) { known_[sum.name] = *hidden; }
        return std::min(total, most_);
    }

    const std::shared_ptr<const Source>& source_;
    WholeNumbers known_;
    std::size_t most_;
};

bool has_indices(const NameTexts& names) {
    return std::any_of(names.texts.begin(), names.texts.end(), [](const NameTexts::Text& text) {
        return std::any_of(text.names.begin(), text.names.end(),
                           [](const Name& name) { return !name.bounds.empty(); });
    });
}

}  // namespace

std::size_t operations_written_out(const IndexedExpression& expression, const WholeNumbers& known,
                                   std::size_t most) {
    return Count(expression.source, known, most)(expression.written);
}

UnrollDecision unroll_decision(const Scene& scene, const UnrollWish& wish) {
    // NOTE: measured; see docs/inside/large.md.
    constexpr std::size_t most_operations = 2000;
    if (!has_indices(scene.coordinates) && !has_indices(scene.rotations)) {
        return {true, "no variable has an index"};
    }
    if (!scene.initial) { return {true, "no initial values are given"}; }
    switch (wish.choice) {
    case Unroll::yes: return {true, "--unroll yes"};
    case Unroll::no: return {false, "--unroll no"};
    case Unroll::automatic: break;
    }
    Definitions definitions;
    for (const Definition& definition : scene.definitions) { definitions.add(definition); }
    const IndexedExpression function = definitions.put_in(scene.function);
    const std::size_t degrees = degrees_of_freedom(scene);
    const std::size_t operations =
        operations_written_out(function, sizes(scene), most_operations + 1);
    if (operations <= most_operations && degrees <= wish.most_degrees) {
        return {true, fmt::format("they make {} operations, and {} are the most", operations,
                                  most_operations)};
    }
    if (!wish.needed_for.empty()) {
        return {true, fmt::format("{} is not built for loops", wish.needed_for)};
    }
    if (operations <= most_operations) {
        return {false, fmt::format("there are more than {} degrees of freedom", wish.most_degrees)};
    }
    return {false, fmt::format("written out they make more than {} operations", most_operations)};
}

bool may_write_out(const Scene& scene, Unroll wish) {
    return wish == Unroll::automatic && degrees_of_freedom(scene) <= most_degrees_of_freedom;
}

}  // namespace hvi::gen
