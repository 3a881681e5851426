// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/names.hpp"
#include "generator/read/parse.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Refusal refused_parameter_name(const std::string& name) {
    return refusal([&] {
        check_parameter_name(name, {source(name), {0, name.size()}});
        return 0;
    });
}

}  // namespace

TEST_CASE("reserved names suggest another") {
    CHECK(refused_parameter_name("e").helps("`ecc`"));
    CHECK(refused_parameter_name("e").marked == "[e]");
    for (const std::string name : {"pi", "tau", "t", "h", "sin", "roots"}) {
        CHECK(refused_parameter_name(name).says("reserved"));
        CHECK(refused_parameter_name(name).helps("another name"));
        CHECK(is_reserved(name));
    }
}

TEST_CASE("a suggested name is free") {
    for (const std::string name : {"pi", "e", "tau", "t", "h", "log"}) {
        const std::string help = refused_parameter_name(name).help;
        const std::size_t begin = help.find('`') + 1;
        const std::string suggested = help.substr(begin, help.rfind('`') - begin);
        CHECK(refused_parameter_name(suggested).status == 0);
    }
}

TEST_CASE("what is a name and what is none") {
    for (const std::string name : {"w", "Omega", "w_1", "mu2", "E", "H", "T"})
        CHECK(refused_parameter_name(name).status == 0);
    for (const std::string name : {"", "2w", "a b", "_w", "a-b", "\u03c9", "w\n"})
        CHECK(refused_parameter_name(name).status == 2);
}

TEST_CASE("walk goes everywhere that it is let") {
    const Expression expression = parse_expression(source("a+sin(b*c)^d"));
    std::string symbols;
    walk(expression, [&](const Expression& part) {
        symbols += part.kind == Expression::Kind::symbol ? part.name : "";
        return part.kind != Expression::Kind::call;
    });
    CHECK(symbols == "ad");
}
