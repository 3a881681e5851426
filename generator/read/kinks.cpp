// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/kinks.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "generator/read/names.hpp"

namespace hvi::gen {

std::vector<Expression> kinks_of(const Expression& function) {
    static const std::set<std::string> of_one{"abs", "sign"};
    static const std::set<std::string> of_two{"min", "max", "if<", "if<="};
    std::vector<Expression> found;
    walk(function, [&](const Expression& part) {
        if (part.kind != Expression::Kind::call) { return true; }
        Expression zero = part.arguments.front();
        if (of_two.count(part.name) != 0) {
            zero = Expression::sum({zero, Expression::negation(part.arguments[1])});
        } else if (of_one.count(part.name) == 0) {
            return true;
        }
        const bool is_new = std::find(found.begin(), found.end(), zero) == found.end();
        if (is_new) { found.push_back(std::move(zero)); }
        return true;
    });
    return found;
}

}  // namespace hvi::gen
