// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/expr/places.hpp"

#include <utility>

namespace hvi::gen {

Expression without_places(Expression expression) {
    for (Expression& argument : expression.arguments) {
        argument = without_places(std::move(argument));
    }
    expression.range = {};
    return expression;
}

}  // namespace hvi::gen
