// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/parse.hpp"

#include <utility>

#include "generator/read/expression_parser.hpp"
#include "generator/read/indexed_parser.hpp"
#include "generator/read/list_parser.hpp"

namespace hvi::gen {

Expression parse_expression(std::shared_ptr<const Source> source) {
    const Range part = whole(source).range;
    return parse_expression(std::move(source), part);
}

Expression parse_expression(std::shared_ptr<const Source> source, Range part) {
    return ExpressionParser(std::move(source), part).lone_expression();
}

IndexedExpression parse_indexed_expression(std::shared_ptr<const Source> source,
                                           const OwnArguments& own) {
    const Range all = whole(source).range;
    return parse_indexed_expression(std::move(source), all, own);
}

IndexedExpression parse_indexed_expression(std::shared_ptr<const Source> source, Range part,
                                           const OwnArguments& own) {
    Expression written = IndexedParser(source, part, own).lone_expression();
    return {std::move(written), std::move(source)};
}

std::vector<Name> parse_names(std::shared_ptr<const Source> source) {
    const Range part = whole(source).range;
    return parse_names(std::move(source), part);
}

std::vector<Name> parse_names(std::shared_ptr<const Source> source, Range part) {
    return IndexedParser(std::move(source), part).names();
}

RuleName parse_rule_name(std::shared_ptr<const Source> source, Range part) {
    return IndexedParser(std::move(source), part).rule_name();
}

List parse_list(std::shared_ptr<const Source> source) {
    std::vector<Item> items = ListParser(source, whole(source).range).items();
    return {std::move(source), std::move(items)};
}

Family parse_family(std::shared_ptr<const Source> source) {
    const List list = parse_list(source);
    const auto* family = std::get_if<Family>(&list.items.front().what);
    if (family == nullptr || list.items.size() > 1)
        throw InputError("one family with its size is wanted here", whole(source),
                         "write for example `gauss:3`");
    return *family;
}

}  // namespace hvi::gen
