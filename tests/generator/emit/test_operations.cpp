// Operations in the text of forces, counted by their signs.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/emit/system/kernel_code.hpp"
#include "tests/generator/lower/textbook_potentials.hpp"

using namespace hvi::gen;

namespace {

/// Returns the code of the forces, with numbers in place of quotients of numbers, which compilers
/// compute.
std::string code_of(const Forces& forces) {
    const Kernel force = kernel(forces.graph, forces.values);
    NodeNames names;
    for (const Node node : force.given) {
        if (!forces.graph.is_number({{1, 1}, node})) {
            names[node] = 'x' + std::to_string(names.size());
        }
    }
    Writer writer(0);
    std::string results;
    for (const std::string& result : write_code(writer, forces.graph, force, names, "std")) {
        results += "out = " + result + ";\n";
    }
    const std::string code =
        std::regex_replace(writer.str() + results, std::regex("Scalar\\([^()]*\\)"), "1");
    return std::regex_replace(code, std::regex("\\b1 / 1\\b(?! /)"), "1");
}

/// Returns how often a sign stands between two operands.
std::size_t count_between(const std::string& code, char sign) {
    std::size_t count = 0;
    for (std::size_t i = 2; i < code.size(); ++i) {
        // NOTE: blanks are around each sign between operands, and around no other.
        count += code[i] == sign && code[i - 1] == ' ' && code[i + 1] == ' ' ? 1 : 0;
    }
    return count;
}

/// Returns the calls of functions, each with its arguments.
std::vector<std::string> calls_in(const std::string& code) {
    static const std::regex name("(?:std|hvi::math)::[a-z_0-9]+(?:<Scalar>)?\\(");
    std::vector<std::string> result;
    for (std::sregex_iterator found(code.begin(), code.end(), name), end; found != end; ++found) {
        auto at = static_cast<std::size_t>(found->position() + found->length());
        for (int depth = 1; depth > 0; ++at) {
            depth += code[at] == '(' ? 1 : code[at] == ')' ? -1 : 0;
        }
        const auto first = static_cast<std::size_t>(found->position());
        result.push_back(code.substr(first, at - first));
    }
    return result;
}

Operations operations_in(const std::string& code) {
    Operations result{count_between(code, '+') + count_between(code, '-') +
                          count_between(code, '*'),
                      count_between(code, '/')};
    // NOTE: a compiler takes one root for sqrt(a) and 1/sqrt(a).
    std::set<std::string> roots;
    for (const std::string& call : calls_in(code)) {
        if (call.rfind("std::sqrt(", 0) == 0) {
            roots.insert(call);
        } else {
            ++result.calls;
        }
    }
    result.roots = roots.size();
    return result;
}

}  // namespace

TEST_CASE("the text of forces has the operations that are counted") {
    for (const Potential& potential : textbook_potentials) {
        const std::string code = code_of(Forces(potential));
        CAPTURE(potential.name, code);
        CHECK(text_of(operations_in(code)) == text_of(potential.has.value_or(potential.least)));
    }
}
