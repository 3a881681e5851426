// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/json.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

using Kind = JsonValue::Kind;

Refusal refused_json(const std::string& text) {
    return refusal([&] { return JsonFile({"t.json", text}); });
}

std::string repeated(const std::string& piece, std::size_t times) {
    std::string text;
    for (std::size_t k = 0; k < times; ++k) { text += piece; }
    return text;
}

}  // namespace

TEST_CASE("values are read with their kinds, in the order of the file") {
    const JsonFile file({"t.json", R"( {"b": [null, true, "x\ty\u00e9", {}], "a": -1.50e+3} )"});
    const JsonValue& root = file.root();
    REQUIRE(root.is(Kind::object));
    REQUIRE(root.members.size() == 2);
    CHECK(root.members[0].key == "b");
    REQUIRE(root.find("b")->items.size() == 4);
    CHECK(root.find("b")->items[0].is(Kind::null));
    CHECK(root.find("b")->items[1].is(Kind::boolean));
    CHECK(root.find("b")->items[2].text == "x\ty\xc3\xa9");
    CHECK(root.find("b")->items[3].is(Kind::object));
    CHECK(root.find("a")->is(Kind::number));
    CHECK(root.find("c") == nullptr);
}

TEST_CASE("numbers keep every digit that is written") {
    for (const std::string number :
         {"0", "-0", "0.1", "0.10", "-1.5e-3", "1E5", "0.1000000000000000000000000000000000000001",
          "123456789012345678901234567890", "-9223372036854775809", "1e-400"}) {
        CHECK(JsonFile({"t.json", number}).root().text == number);
        CHECK(JsonFile({"t.json", "[" + number + ",1]"}).root().items[0].text == number);
        CHECK(JsonFile({"t.json", "{\"a\": " + number + "}"}).root().find("a")->text == number);
    }
}

TEST_CASE("every value knows its place") {
    const std::string text = "{\n  \"a\" : [ 12 , \"q\\\"]\" ],\n  \"b\":{\"c\":-3.5}}";
    const JsonFile file({"t.json", text});
    const auto marked = [&](Range range) {
        const Place place = file.place(range);
        std::string line = place.source->text;
        line.insert(place.range.end, "]]");
        line.insert(place.range.begin, "[[");
        return place.source->name + " " + line;
    };
    const JsonValue& a = *file.root().find("a");
    CHECK(marked(a.range) == "t.json:2   \"a\" : [[[ 12 , \"q\\\"]\" ]]],");
    CHECK(marked(a.items[0].range) == "t.json:2   \"a\" : [ [[12]] , \"q\\\"]\" ],");
    CHECK(marked(a.items[1].range) == "t.json:2   \"a\" : [ 12 , [[\"q\\\"]\"]] ],");
    CHECK(marked(file.root().members[1].range) == "t.json:3   [[\"b\"]]:{\"c\":-3.5}}");
    CHECK(marked(file.root().find("b")->find("c")->range) == "t.json:3   \"b\":{\"c\":[[-3.5]]}}");
    // For a value over several lines the first one is shown.
    CHECK(marked(file.root().range) == "t.json:1 [[{]]");
}

TEST_CASE("what is no JSON is refused at its place") {
    CHECK(refused_json("").status == 2);
    CHECK(refused_json("").says("unexpected end of input"));
    CHECK(refused_json("[1,]").marked == "[1,[]]");
    CHECK(refused_json("[1,]").name == "t.json:1");
    CHECK(refused_json("{\"a\": 1,}").says("expected string literal"));
    CHECK(refused_json("{\"a\":\n NaN}").name == "t.json:2");
    CHECK(refused_json("{\"a\": Infinity}").says("invalid literal"));
    CHECK(refused_json("[01]").status == 2);
    CHECK(refused_json("[.5]").status == 2);
    CHECK(refused_json("[+1]").status == 2);
    CHECK(refused_json("['a']").status == 2);
    CHECK(refused_json("[1] 2").status == 2);
    CHECK(refused_json("// 1\n1").status == 2);
    CHECK(refused_json("[1e999]").says("number overflow"));
    CHECK(refused_json("[\"\xff\"]").says("UTF-8"));
    CHECK(refused_json("[\"\xed\xa0\x80\"]").says("UTF-8"));
    CHECK(refused_json("[\"a\nb\"]").status == 2);
    CHECK(refused_json(std::string("[1\0]", 4)).status == 2);
    CHECK_FALSE(refused_json("[1,]").says("json.exception"));
    CHECK_FALSE(refused_json("[1e999]").says("json.exception"));
}

TEST_CASE("a byte order mark is refused, with what to do") {
    for (const std::string mark : {"\xef\xbb\xbf", "\xff\xfe", "\xfe\xff"}) {
        CHECK(refused_json(mark + "[1]").says("byte order mark"));
        CHECK(refused_json(mark + "[1]").helps("UTF-8"));
    }
}

TEST_CASE("a name that is given twice is refused") {
    const Refusal twice = refused_json("{\"a\": 1,\n \"b\": 2,\n \"\\u0061\": 3}");
    CHECK(twice.says("`a` is given twice"));
    CHECK(twice.marked == " [\"\\u0061\"]: 3}");
    CHECK(refused_json("[{\"a\": {\"b\": 1}, \"b\": {\"a\": 1}}]").status == 0);
}

TEST_CASE("depth and number of values are limited") {
    CHECK(refused_json(repeated("[", 32) + repeated("]", 32)).status == 0);
    CHECK(refused_json(repeated("[", 33) + repeated("]", 33)).says("nested deeper than 32"));
    CHECK(refused_json(repeated("[", 1000000)).says("nested deeper than 32"));
    CHECK(refused_json("[" + repeated("1,", 299998) + "1]").status == 0);
    CHECK(refused_json("[" + repeated("1,", 299999) + "1]").says("more than 300000 values"));
    std::string many = "{";
    for (int k = 0; k < 100000; ++k) { many += "\"" + std::to_string(k) + "\":0,"; }
    CHECK(refused_json(many + "\"7\":0}").says("`7` is given twice"));
}
