// Rows of numbers in CSV and NPY files.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/ensembles/number_rows.hpp"
#include "generator/support/digest.hpp"
#include "tests/generator/ensembles/number_files.hpp"

using namespace hvi::gen;

namespace {

using Names = std::vector<std::string>;
using Values = std::vector<double>;

const std::string one = low_bytes_first(0x3ff0000000000000, 8);
const std::string minus_two = low_bytes_first(0xc000000000000000, 8);
const std::string quarter_float = low_bytes_first(0x3e800000, 4);
const std::string nan_bytes = low_bytes_first(0x7ff8000000000000, 8);

}  // namespace

TEST_CASE("rows of a CSV file are numbers below names") {
    const NumberFiles files;
    const std::string text = "# start\r\n x , \"u[1,2]\",px\r\n\n1,2.5,-1e-3\n# between\n"
                             "0.1,1e300, 7 \r\n";
    files.write("a.csv", text);
    const auto rows = files.rows("a.csv");
    CHECK(rows->names() == Names{"x", "u[1,2]", "px"});
    CHECK(rows->count() == 2);
    CHECK(rows->rows(0, 2) == Values{1, 2.5, -1e-3, 0.1, 1e300, 7});
    CHECK(rows->rows(1, 1) == Values{0.1, 1e300, 7});
    CHECK(rows->rows(0, 1) == Values{1, 2.5, -1e-3});
    CHECK(rows->rows(2, 0).empty());
    CHECK(rows->digest() == digest(text));
}

TEST_CASE("numbers that are not finite, and those that are missing, are numbers of a row") {
    const NumberFiles files;
    files.write("a.csv", "x,y\n,nan\ninf,-inf\nNaN, ");
    const Values read = files.rows("a.csv")->rows(0, 3);
    REQUIRE(read.size() == 6);
    for (const int k : {0, 1, 4, 5}) CHECK(std::isnan(read[static_cast<std::size_t>(k)]));
    CHECK(read[2] == HUGE_VAL);
    CHECK(read[3] == -HUGE_VAL);
}

TEST_CASE("rows are found wherever they are in a long file") {
    const NumberFiles files;
    constexpr int count = 5000;
    std::string text = "k,square\n";
    for (int k = 0; k < count; ++k) {
        if (k % 7 == 0) text += "# " + std::string(static_cast<std::size_t>(k % 50), '-') + "\n\n";
        text += std::to_string(k) + "," + std::to_string(k * k) + "\n";
    }
    files.write("a.csv", text);
    const auto rows = files.rows("a.csv");
    REQUIRE(rows->count() == count);
    for (const int first : {4999, 0, 1023, 1024, 1025, 2047, 3000, 3001, 4096, 1}) {
        const int some = std::min(5, count - first);
        const Values read = rows->rows(first, some);
        REQUIRE(read.size() == static_cast<std::size_t>(2 * some));
        for (int k = 0; k < some; ++k) {
            const auto at = static_cast<std::size_t>(2 * k);
            CHECK(read[at] == first + k);
            CHECK(read[at + 1] == (first + k) * (first + k));
        }
    }
    CHECK(rows->rows(0, count).size() == 2 * count);
}

TEST_CASE("what is wrong with rows of a CSV file is said where it is") {
    const NumberFiles files;
    const Refusal word = files.refused("a.csv", "x,y\n\n1,2\n3,1/2\n");
    CHECK(word.status == 2);
    CHECK(word.what == "`1/2` is no number");
    CHECK(word.name == files.path("a.csv") + ":4");
    CHECK(word.marked == "3,[1/2]");
    CHECK(word.helps("nan"));
    CHECK(files.refused("a.csv", "x\n1 2\n").marked == "[1 2]");
    CHECK(files.refused("a.csv", "x\n1e999\n").says("beyond the range of doubles"));
    const Refusal shorter = files.refused("a.csv", "x,y\n1,2\n3\n");
    CHECK(shorter.what == "this row has 1 values, and the first line 2 names");
    CHECK(shorter.name == files.path("a.csv") + ":3");
    CHECK(files.refused("a.csv", "x,y\n1,2,3\n").marked == "[1,2,3]");
    const Refusal twice = files.refused("a.csv", "x, y ,x\n1,2,3\n");
    CHECK(twice.what == "two columns have the name `x`");
    CHECK(twice.marked == "x, y ,[x]");
    CHECK(files.refused("a.csv", "x,,y\n").marked == "x,[],y");
    CHECK(files.refused("a.csv", "0.5,1\n1,2\n").says("a name is wanted here"));
    CHECK(files.refused("a.csv", "0.5,1\n1,2\n").helps("names of the columns"));
    const Refusal none = files.refused("a.csv", "x,y\n# 1,2\n");
    CHECK(none.what == "a.csv: there are no rows below the names");
    CHECK(none.name == "--initial");
    CHECK(none.marked == "[" + files.path("a.csv") + "]");
    CHECK(files.refused("a.csv", "\n# x\n").what == "a.csv: the file is empty");
    CHECK(refusal([&] { return files.rows("no.csv"); }).what == "no.csv: there is no such file");
    CHECK(refusal([&] { return files.rows("."); }).says("no regular file"));
}

TEST_CASE("a file that changes while it is read is refused") {
    const NumberFiles files;
    files.write("a.csv", "x\n1\n2\n");
    const auto csv = files.rows("a.csv");
    files.write("a.csv", "x\n1\n");
    CHECK(refusal([&] { return csv->rows(0, 2); }).says("has changed"));
    files.write("a.npy", npy_file("[('x', '<f8')]", "(2,)", one + minus_two));
    const auto npy = files.rows("a.npy");
    files.write("a.npy", npy_file("[('x', '<f8')]", "(1,)", one));
    CHECK(refusal([&] { return npy->rows(0, 2); }).says("has changed"));
}

TEST_CASE("records of an NPY file are rows") {
    const NumberFiles files;
    const std::string seven = low_bytes_first(7, 4), minus_one = low_bytes_first(~0ULL, 8);
    files.write("a.npy",
                npy_file("[('x', '<f8'), ('shape', '<f4'), (\"n\", '<i4'), ('m', '<i8')]", "(2,)",
                         one + quarter_float + seven + minus_one +  //
                             minus_two + quarter_float + low_bytes_first(~0ULL, 4) +
                             low_bytes_first(1LL << 40, 8)));
    const auto rows = files.rows("a.npy");
    CHECK(rows->names() == Names{"x", "shape", "n", "m"});
    CHECK(rows->count() == 2);
    CHECK(rows->rows(0, 2) == Values{1, 0.25, 7, -1, -2, 0.25, -1, 1099511627776.0});
    CHECK(rows->rows(1, 1) == Values{-2, 0.25, -1, 1099511627776.0});
}

TEST_CASE("padding of aligned records is no column") {
    const NumberFiles files;
    files.write("a.npy", npy_file("[('x', '<f4'), ('', '|V4'), ('y', '<f8')]", "(1,)",
                                  quarter_float + "....") +
                             nan_bytes);
    const auto rows = files.rows("a.npy");
    CHECK(rows->names() == Names{"x", "y"});
    CHECK(rows->rows(0, 1).front() == 0.25);
    CHECK(std::isnan(rows->rows(0, 1).back()));
}

TEST_CASE("what is wrong with records of an NPY file is said") {
    const NumberFiles files;
    const auto refused = [&](const std::string& type, const std::string& shape,
                             const std::string& data) {
        return files.refused("a.npy", npy_file(type, shape, data));
    };
    const Refusal plain = refused("'<f8'", "(1, 2)", one + one);
    CHECK(plain.what == "a.npy: the columns of this array have no names");
    CHECK(plain.helps("names='x, px'"));
    CHECK(refused("[('x', '<f8')]", "(1, 2)", one + one).says("more dimensions than one"));
    CHECK(refused("[('x', '<f8')]", "(3,)", one + one).says("is not that of its data"));
    CHECK(refused("[('x', '<f8')]", "(0,)", "").says("the array is empty"));
    CHECK(refused("[('x', '<f8'), ('x', '<f8')]", "(1,)", one + one)
              .says("two columns have the name `x`"));
    CHECK(refused("[('', '<f8')]", "(1,)", one).says("a column has no name"));
    for (const std::string type :
         {"[('x', '>f8')]", "[('x', '<f8', (2,))]", "[('x', [('y', '<f8')])]",
          "[(('title', 'x'), '<f8')]", "[('x', '<U4')]", "[]"}) {
        const Refusal format = refused(type, "(1,)", one);
        CHECK(format.says("in a format that is not read"));
        CHECK(format.helps("dtype=[('x', '<f8')"));
    }
    const std::string good = npy_file("[('x', '<f8')]", "(1,)", one);
    for (std::size_t length = 6; length < good.size(); ++length)
        CHECK(files.refused("a.npy", good.substr(0, length)).status == 2);
}
