// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/lower/accesses.hpp"
#include "generator/lower/element_ranges.hpp"
#include "generator/read/names.hpp"
#include "generator/read/no_loops.hpp"

namespace hvi::gen {

namespace {

class TermLowering {
public:
    TermLowering(System& system, const Declarations& names, const std::vector<Loop>& loops,
                 const std::shared_ptr<const Source>& source, Symbols known)
        : system_(system),
          names_(names),
          loops_(loops),
          source_(source),
          symbols_(std::move(known)) {}

    [[nodiscard]] Scaled operator()(const Expression& term) && {
        const Expression written = with_accesses(term);
        for (const Loop& loop : loops_) {
            symbols_[loop.index] = system_.graph.input(loop.index, Role::index);
        }
        return lower(system_.graph, written, symbols_, source_);
    }

private:
    [[nodiscard]] const SystemFamily& family(const DeclaredFamily& declared) const {
        return system_.family({declared.kind, declared.number});
    }
    [[nodiscard]] Expression with_accesses(const Expression& term);
    [[nodiscard]] std::string access(const Expression& element);
    [[nodiscard]] ElementIndex index(const Expression& written) const;

    System& system_;
    const Declarations& names_;
    const std::vector<Loop>& loops_;
    const std::shared_ptr<const Source>& source_;
    Symbols symbols_;
};

/// Returns an index of an element. NOTE: in an index a mod stands once, with an added offset.
ElementIndex TermLowering::index(const Expression& written) const {
    walk(written, [&](const Expression& part) {
        if (part.kind == Expression::Kind::symbol) {
            const bool is_known = names_.sizes.count(part.name) != 0 ||
                                  std::any_of(loops_.begin(), loops_.end(), [&](const Loop& loop) {
                                      return loop.index == part.name;
                                  });
            if (!is_known) {
                throw InputError(fmt::format("`{}` is neither a size nor an index here", part.name),
                                 Place{source_, part.range});
            }
        }
        return true;
    });
    if (auto form = affine_form(written)) { return {std::move(*form)}; }
    const auto is_mod = [](const Expression& part) {
        return part.kind == Expression::Kind::call && part.name == "mod";
    };
    std::vector<Expression> parts{written};
    if (written.kind == Expression::Kind::sum) { parts = written.arguments; }
    const auto mod = std::find_if(parts.begin(), parts.end(), is_mod);
    if (mod != parts.end()) {
        auto form = affine_form(mod->arguments[0]), modulus = affine_form(mod->arguments[1]);
        parts.erase(mod);
        auto offset = affine_form(Expression::sum(std::move(parts)));
        if (form && modulus && offset) {
            return {std::move(*form), std::move(modulus), std::move(*offset)};
        }
    }
    throw NoLoops("where sums stay loops, an index is made of whole numbers, sizes and indices "
                  "of sums by +, - and products with numbers, or of one mod of these and what "
                  "is added to it",
                  Place{source_, written.range});
}

/// Returns the name of an element in the graph, and among the symbols.
std::string TermLowering::access(const Expression& element) {
    const Place place{source_, element.range};
    const auto found = names_.families.find(element.name);
    if (found == names_.families.end()) {
        throw InputError(fmt::format("`{}` has no index", element.name), place);
    }
    const SystemFamily& of = family(found->second);
    if (of.ranges.size() != element.arguments.size()) {
        throw InputError(fmt::format("`{}` has {} ind{}, and here {}", element.name,
                                     of.ranges.size(), of.ranges.size() == 1 ? "ex" : "ices",
                                     element.arguments.size()),
                         place);
    }
    std::vector<ElementIndex> indices;
    for (const Expression& written : element.arguments) { indices.push_back(index(written)); }
    check_ranges(of, indices, loops_, names_.sizes, place);
    const std::size_t number =
        access_to(system_, found->second.kind, found->second.number, std::move(indices));
    const Node node = system_.accesses[number].node;
    const std::string name = system_.graph.at(node).name;
    symbols_[name] = {{1, 1}, node};
    return name;
}

/// Returns a term with symbols for its elements. NOTE: a graph has elements as inputs.
Expression TermLowering::with_accesses(const Expression& term) {
    const bool is_of_family =
        term.kind == Expression::Kind::symbol && names_.families.count(term.name) != 0;
    if (term.kind == Expression::Kind::element || is_of_family) {
        Expression symbol = Expression::symbol(access(term));
        symbol.range = term.range;
        return symbol;
    }
    Expression result = term;
    for (Expression& argument : result.arguments) { argument = with_accesses(argument); }
    return result;
}

}  // namespace

Scaled value_of_term(System& system, const Declarations& names, const LoopTerm& term,
                     const std::shared_ptr<const Source>& source, Symbols known) {
    return TermLowering(system, names, term.loops, source, std::move(known))(term.term);
}

}  // namespace hvi::gen
