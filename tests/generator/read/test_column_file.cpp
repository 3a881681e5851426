// Initial values that stand in a file of their own.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "generator/read/scene.hpp"
#include "tests/generator/read/scenes.hpp"
#include "tests/generator/read/scratch.hpp"

using namespace hvi::gen;

namespace {

/// A scene whose coordinates stand in files beside it.
class Files {
public:
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(scratch_.path / name, std::ios::binary) << bytes;
    }

    [[nodiscard]] WrittenOutScene scene(const std::string& values) const {
        return unrolled(indexed(values));
    }

    [[nodiscard]] Scene indexed(const std::string& values) const {
        write("s.toml", "coordinates = \"x[1..2,1..2]\"\nmomenta = \"p[1..2,1..2]\"\n"
                        "hamiltonian = \"sum(i=1..2, j=1..2, p[i,j]^2/2 + k*x[i,j])\"\n"
                        "[parameters]\nk = 1\n[initial]\n\"p[i,j]\" = 0\nx = " +
                            values + "\n");
        return scene_from_file(scratch_.path / "s.toml");
    }

    [[nodiscard]] Names lines(const std::string& values) const {
        Names all = hvi::gen::lines(scene(values).initial);
        all.resize(4);
        return all;
    }

    [[nodiscard]] Refusal refused(const std::string& values) const {
        return refusal([&] { return scene(values); });
    }

private:
    Scratch scratch_;
};

constexpr const char* x_of_csv = "{file = \"a.csv\", column = \"x\"}";
constexpr const char* all_of_npy = "{file = \"a.npy\"}";

std::string little_endian(std::uint64_t value, int bytes) {
    std::string result;
    for (int i = 0; i < bytes; ++i) result += static_cast<char>(value >> (8 * i) & 0xff);
    return result;
}

std::string npy(const std::string& type, const std::string& shape, const std::string& data,
                const std::string& order = "False") {
    const std::string head =
        "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
    return "\x93NUMPY\x01" + std::string(1, '\0') + little_endian(head.size(), 2) + head + data;
}

/// 1, -2, 1/4 and 1e-300, as IEEE 754 has them.
const std::string doubles =
    little_endian(0x3ff0000000000000, 8) + little_endian(0xc000000000000000, 8) +
    little_endian(0x3fd0000000000000, 8) + little_endian(0x01a56e1fc2f8f359, 8);

}  // namespace

TEST_CASE("a column of a CSV file has the values of a name") {
    const Files files;
    files.write("a.csv", "# a star\r\ny, x ,\"z\"\n7, 0.1,0\n\n7,k/3 ,0\n8,-1e-3,0\n8,pi,0");
    CHECK(files.lines(x_of_csv) ==
          Names{"x[1,1] = 1/10", "x[1,2] = k/3", "x[2,1] = -1/1000", "x[2,2] = pi"});
}

TEST_CASE("an NPY file has the values of a name") {
    const Files files;
    const Names expected{"x[1,1] = 1", "x[1,2] = -2", "x[2,1] = 1/4",
                         "x[2,2] = 1/1" + std::string(300, '0')};
    for (const std::string shape : {"(2, 2)", "(4,)"}) {
        files.write("a.npy", npy("<f8", shape, doubles));
        CHECK(files.lines(all_of_npy) == expected);
    }
    files.write("a.npy", npy("<i4", "(2, 2)",
                             little_endian(1, 4) + little_endian(0xffffffff, 4) +
                                 little_endian(3, 4) + little_endian(70000, 4)));
    CHECK(files.lines(all_of_npy) ==
          Names{"x[1,1] = 1", "x[1,2] = -1", "x[2,1] = 3", "x[2,2] = 70000"});
}

TEST_CASE("what is wrong with a CSV file is said where it is") {
    const Files files;
    const Refusal none = files.refused(x_of_csv);
    CHECK(none.what == "a.csv: there is no such file");
    CHECK(none.marked == std::string("x = [") + x_of_csv + "]");
    files.write("a.csv", "y,xx\n1,2\n");
    CHECK(files.refused(x_of_csv).what == "a.csv: there is no column `x`");
    CHECK(files.refused(x_of_csv).helps("`xx`"));
    CHECK(files.refused("{file = \"a.csv\"}").what == "a.csv: of which column?");
    files.write("a.csv", "y,x\n1,2\n1,2,3\n");
    const Refusal longer = files.refused(x_of_csv);
    CHECK(longer.what == "this row has 3 values, and the first line 2 names");
    CHECK(longer.marked == "[1,2,3]");
    CHECK(longer.name.find("a.csv:3") != std::string::npos);
    files.write("a.csv", "x\n1\n2\n3\n");
    CHECK(files.refused(x_of_csv).what == "`x` has 4 indices, and here are 3 values");
    files.write("a.csv", "x,y\n1,1\n2,1\nnan,1\n4,1\n");
    CHECK(files.refused(x_of_csv).marked == "[nan],1");
    files.write("a.csv", "x,y\n1,1\n2,1\n,1\n4,1\n");
    CHECK(files.refused(x_of_csv).status == 2);
    files.write("a.csv", "\n# nothing\n");
    CHECK(files.refused(x_of_csv).what == "a.csv: the file is empty");
    CHECK(files.refused("{file = \".\", column = \"x\"}").says("no regular file"));
    CHECK(files.refused("{file = 3}").what == "a text is wanted here");
    CHECK(files.refused("{column = \"x\"}").what == "there is no file");
    CHECK(files.refused("{fil = \"a.csv\"}").helps("`file`"));
}

TEST_CASE("what is wrong with an NPY file is said") {
    const Files files;
    const auto says = [&](const std::string& bytes, const std::string& values = all_of_npy) {
        files.write("a.npy", bytes);
        return files.refused(values).what;
    };
    const std::string good = npy("<f8", "(4,)", doubles);
    CHECK(says(good, "{file = \"a.npy\", column = \"x\"}") == "a.npy: an NPY file has no columns");
    CHECK(says(npy("<f8", "(3,)", doubles)) ==
          "a.npy: the shape of the array is not that of its data");
    CHECK(says(npy("<f8", "(1000000, 1000000, 1000000)", doubles)) ==
          "a.npy: the shape of the array is not that of its data");
    CHECK(says(npy("<f8", "()", doubles)).find("is not that of its data") != std::string::npos);
    CHECK(says(npy("<f8", "(a)", doubles)).find("no shape") != std::string::npos);
    CHECK(says(npy(">f8", "(4,)", doubles)).find("in a format that is not read") !=
          std::string::npos);
    CHECK(says(npy("<f8", "(2, 2)", doubles, "True")).find("in a format") != std::string::npos);
    CHECK(says(npy("<f8", "(4,)", doubles.substr(8) + little_endian(0x7ff0000000000000, 8))) ==
          "a.npy: `inf` is not a finite number");
    CHECK(says(npy("<f8", "(0,)", "")) == "a.npy: the array is empty");
    CHECK(says(npy("<f8", "(4,)", doubles, "Fals")).find("in a format") != std::string::npos);
    CHECK(says(npy("<f8', 'more': '", "(4,)", doubles)).find("no NPY file") != std::string::npos);
    for (const std::size_t length : {6U, 9U, 11U, 40U})
        CHECK(says(good.substr(0, length)).find("no NPY file") != std::string::npos);
    for (std::size_t length = 6; length < good.size(); ++length)
        CHECK(says(good.substr(0, length)) != "");
}

TEST_CASE("an NPY file with names of columns is not the values of one name") {
    const Files files;
    const std::string head = "{'descr': [('x', '<f8'), ('y', '<f8')], 'fortran_order': False, "
                             "'shape': (2,), }\n";
    files.write("a.npy", "\x93NUMPY\x01" + std::string(1, '\0') + little_endian(head.size(), 2) +
                             head + doubles);
    const Refusal error = files.refused(all_of_npy);
    CHECK(error.what == "a.npy: this array has columns");
    CHECK(error.helps("x['NAME']"));
}

namespace {

/// Reads a file of values in [initial].
IndexedValue value_in(const Files& files, const std::string& values) {
    return files.indexed(values).initial->values.back();
}

/// `x`, and so many rows.
std::string csv(std::size_t count, const std::string& last = "0.5") {
    std::string text = "x\n";
    for (std::size_t k = 1; k < count; ++k) text += std::to_string(k) + "\n";
    return text + last + "\n";
}

}  // namespace

TEST_CASE("many values stay in their file") {
    const Files files;
    files.write("a.csv", csv(256, "pi"));
    CHECK(std::get<ValueList>(value_in(files, x_of_csv).value).values.size() == 256);
    files.write("a.csv", csv(257));
    const IndexedValue many = value_in(files, x_of_csv);
    const auto& file = std::get<ValueFile>(many.value);
    CHECK(file.path == "a.csv");
    CHECK(file.column == "x");
    CHECK(file.extents == std::vector<std::size_t>{257});
    CHECK(files.refused(x_of_csv).what == "`x` has 4 indices, and here are 257 values");
    std::string data;
    for (int k = 0; k < 257; ++k) data += little_endian(0x3ff0000000000000, 8);
    for (const std::string shape : {"(257,)", "(1, 257)"}) {
        files.write("a.npy", npy("<f8", shape, data));
        CHECK(count(std::get<ValueFile>(value_in(files, all_of_npy).value)) == 257);
    }
    files.write("a.npy",
                npy("<f8", "(257,)", data.substr(8) + little_endian(0x7ff8000000000000, 8)));
    CHECK(files.refused(all_of_npy).what == "a.npy: `nan` is not a finite number");
}

TEST_CASE("each of many values is a number") {
    const Files files;
    for (const std::string text : {"pi", "1/2", "nan", "inf", "1e999", "", "0x10", "1 2"}) {
        files.write("a.csv", csv(300, text));
        const Refusal last = files.refused(x_of_csv);
        CHECK(last.status == 2);
        if (text.empty()) continue;  // a blank line
        CHECK(last.what == "`" + text + "` is not a finite number");
        CHECK(last.marked == "[" + text + "]");
        CHECK(last.name.find("a.csv:301") != std::string::npos);
        files.write("a.csv", "x\n" + text + csv(299).substr(1));
        CHECK(files.refused(x_of_csv).name.find("a.csv:2") != std::string::npos);
    }
}

TEST_CASE("a path with a character of code 0 is no other path") {
    const Files files;
    files.write("a.csv", "x\n1\n2\n3\n4\n");
    const Refusal error = files.refused("{file = \"a.csv\\u0000.bak\", column = \"x\"}");
    CHECK(error.status == 2);
    CHECK(error.what == "a path has no character with code 0");
}

TEST_CASE("a long column is a list of parameters too") {
    const Scratch scratch;
    std::ofstream csv(scratch.path / "a.csv");
    csv << "a\n";
    for (int k = 1; k <= 1000; ++k) csv << "1/" << k << "\n";
    csv.close();
    const auto scene = [&](const std::string& column) {
        std::ofstream(scratch.path / "s.toml")
            << "coordinates = \"q\"\nmomenta = \"p\"\n"
               "hamiltonian = \"p^2/2 + sum(k=1..1000, a[k]*cos(k*q))\"\n"
               "[parameters]\na = {file = \"" +
                   column +
                   ".csv\", column = \"a\"}\n"
                   "[initial]\nq = 1\np = 0\n";
        return unrolled(scene_from_file(scratch.path / "s.toml"));
    };
    CHECK(refusal([&] { return scene("a"); }).says("`1/257` is not a finite number"));
    std::ofstream numbers(scratch.path / "b.csv");
    numbers << "a\n";
    for (int k = 1; k <= 1000; ++k) numbers << k << "e-3\n";
    numbers.close();
    const WrittenOutScene read = scene("b");
    REQUIRE(read.parameters.size() == 1000);
    CHECK(read.parameters[998].name == "a[999]");
    CHECK(to_text(read.parameters[998].value) == "999/1000");
}
