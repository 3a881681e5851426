// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/put_in.hpp"

#include <fmt/format.h>

#include <functional>
#include <set>
#include <utility>

namespace hvi::gen {

namespace {

/// The deepest nesting of expressions: the reader's have up to 6 levels for each of its 200.
constexpr std::size_t most_levels = 1200;

/// Returns the expression in place of a symbol or an element; nothing where it stays.
using Substitute = std::function<std::optional<Expression>(const Expression&)>;

/// Puts expressions of other texts in places of one expression.
class PuttingIn {
public:
    /// `extent` is the total of all expressions that share it.
    PuttingIn(const std::shared_ptr<const Source>& source, Substitute substitute, Extent& extent)
        : source_(source), substitute_(std::move(substitute)), extent_(extent) {}

    /// NOTE: the reader's functions build the result, so that it is as flat as what they read.
    [[nodiscard]] Expression operator()(const Expression& expression) {
        const Level level(*this, expression.range);
        Expression result = expression;
        const bool hides =
            result.kind == Expression::Kind::sum_over && indices_.insert(result.name).second;
        for (Expression& argument : result.arguments) { argument = (*this)(argument); }
        if (hides) { indices_.erase(result.name); }
        if (result.kind == Expression::Kind::symbol && indices_.count(result.name) != 0) {
            return result;
        }
        if (auto other = substitute_(result)) { return placed(std::move(*other), result.range); }
        std::vector<Expression> arguments = std::move(result.arguments);
        return with_arguments(std::move(result), std::move(arguments));
    }

private:
    /// Counts a word, and one more level of nesting while it lives. `place` is in the text.
    class Level {
    public:
        Level(const PuttingIn& whole, Range place) : extent_(whole.extent_) {
            if (++extent_.words > most_words_unrolled) {
                whole.refuse(fmt::format("has more than {} words", most_words_unrolled), place);
            }
            if (++extent_.levels > most_levels) {
                whole.refuse(fmt::format("is nested deeper than {}", most_levels), place);
            }
        }
        ~Level() { --extent_.levels; }
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;

    private:
        Extent& extent_;
    };

    [[nodiscard]] Expression placed(Expression expression, Range range) {
        const Level level(*this, range);
        for (Expression& argument : expression.arguments) {
            argument = placed(std::move(argument), range);
        }
        expression.range = range;
        return expression;
    }

    [[noreturn]] void refuse(const std::string& what, Range place) const {
        throw InputError("with its names replaced by their values this " + what,
                         Place{source_, place});
    }

    const std::shared_ptr<const Source>& source_;
    Substitute substitute_;
    std::set<std::string> indices_;  ///< indices of the sums around a place
    Extent& extent_;
};

/// Renames the indices of sums in a definition to names that no text has. They then differ from the
/// indices around the place where the definition is put in.
Expression with_own_indices(const Expression& expression, const std::string& mark,
                            std::set<std::string>& of_sums) {
    Expression result = expression;
    const bool is_sum = result.kind == Expression::Kind::sum_over;
    const bool is_own =
        is_sum || (result.kind == Expression::Kind::symbol && of_sums.count(result.name) != 0);
    const bool is_new = is_sum && of_sums.insert(result.name).second;
    for (Expression& argument : result.arguments) {
        argument = with_own_indices(argument, mark, of_sums);
    }
    if (is_new) { of_sums.erase(result.name); }
    if (is_own) { result.name += mark; }
    return result;
}

/// Returns the value of a definition for these indices.
Expression value_at(const Definition& definition, const std::vector<Expression>& indices) {
    const auto index = [&](const Expression& part) -> std::optional<Expression> {
        if (part.kind != Expression::Kind::symbol) { return {}; }
        for (std::size_t d = 0; d < indices.size(); ++d) {
            if (definition.indices[d] == part.name) { return indices[d]; }
        }
        return {};
    };
    Extent extent;
    return PuttingIn(definition.value.source, index, extent)(definition.value.written);
}

}  // namespace

void Definitions::add(const Definition& definition) {
    Definition own = definition;
    own.value = put_in(definition.value, extent_);
    std::set<std::string> of_sums;
    own.value.written = with_own_indices(own.value.written, "'" + definition.name, of_sums);
    if (!definitions_.emplace(definition.name, std::move(own)).second) {
        throw InputError(fmt::format("`{}` is defined twice", definition.name), definition.place);
    }
}

IndexedExpression Definitions::put_in(const IndexedExpression& expression) const {
    Extent extent;
    return put_in(expression, extent);
}

IndexedExpression Definitions::put_in(const IndexedExpression& expression, Extent& extent) const {
    const auto defined = [&](const Expression& part) -> std::optional<Expression> {
        if (part.kind != Expression::Kind::symbol && part.kind != Expression::Kind::element) {
            return {};
        }
        const auto found = definitions_.find(part.name);
        if (found == definitions_.end()) { return {}; }
        const Definition& definition = found->second;
        const std::size_t wanted = definition.indices.size();
        if (wanted != part.arguments.size()) {
            throw InputError(fmt::format("`{}` is defined with {} ind{}, and here it has {}",
                                         part.name, wanted, wanted == 1 ? "ex" : "ices",
                                         part.arguments.size()),
                             Place{expression.source, part.range});
        }
        return value_at(definition, part.arguments);
    };
    return {PuttingIn(expression.source, defined, extent)(expression.written), expression.source};
}

namespace {

class Resolution {
public:
    explicit Resolution(std::vector<Parameter>& parameters) : parameters_(parameters) {
        for (std::size_t k = 0; k < parameters.size(); ++k) {
            numbers_.emplace(parameters[k].name, k);
        }
        states_.resize(parameters.size(), State::written);
    }

    void resolve(std::size_t k) {
        Parameter& parameter = parameters_[k];
        if (states_[k] == State::resolved) { return; }
        if (states_[k] == State::begun) {
            throw InputError(fmt::format("the value of `{}` depends on itself", parameter.name),
                             parameter.place);
        }
        states_[k] = State::begun;
        const auto value = [&](const Expression& part) -> std::optional<Expression> {
            const auto found = numbers_.find(part.name);
            if (part.kind != Expression::Kind::symbol || found == numbers_.end()) { return {}; }
            resolve(found->second);
            return parameters_[found->second].value;
        };
        parameter.value = PuttingIn(parameter.source, value, extent_)(parameter.value);
        states_[k] = State::resolved;
    }

private:
    enum class State { written, begun, resolved };

    std::vector<Parameter>& parameters_;
    std::map<std::string, std::size_t> numbers_;
    std::vector<State> states_;
    Extent extent_;  ///< the extent of all values together
};

}  // namespace

void resolve(std::vector<Parameter>& parameters) {
    Resolution resolution(parameters);
    for (std::size_t k = 0; k < parameters.size(); ++k) { resolution.resolve(k); }
}

}  // namespace hvi::gen
