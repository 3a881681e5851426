// Tables of runs as HDF5, read by its own library, against the same as text.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <hdf5.h>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

namespace {

/// A table that is open for reading.
class Hdf5Table {
public:
    explicit Hdf5Table(const std::filesystem::path& path)
        : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
        REQUIRE(file_ >= 0);
    }
    ~Hdf5Table() { H5Fclose(file_); }
    Hdf5Table(const Hdf5Table&) = delete;
    Hdf5Table& operator=(const Hdf5Table&) = delete;

    /// Names of the columns, in the order in which they were made.
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> result;
        const auto add = [](hid_t, const char* name, const H5L_info_t*, void* all) -> herr_t {
            static_cast<std::vector<std::string>*>(all)->emplace_back(name);
            return 0;
        };
        REQUIRE(H5Literate(file_, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, add, &result) >= 0);
        return result;
    }

    [[nodiscard]] std::vector<double> column(const std::string& name) const {
        const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT), space = H5Dget_space(set);
        REQUIRE(H5Sget_simple_extent_ndims(space) == 1);
        std::vector<double> result(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
        CHECK(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()) >= 0);
        H5Sclose(space);
        H5Dclose(set);
        return result;
    }

    /// How many bytes a number of a column has.
    [[nodiscard]] std::size_t bytes_of(const std::string& name) const {
        const hid_t set = H5Dopen2(file_, name.c_str(), H5P_DEFAULT), type = H5Dget_type(set);
        const std::size_t size = H5Tget_size(type);
        CHECK(H5Tget_class(type) == H5T_FLOAT);
        H5Tclose(type);
        H5Dclose(set);
        return size;
    }

    [[nodiscard]] bool has(const std::string& note) const {
        return H5Aexists(file_, note.c_str()) > 0;
    }

    /// A text of the file, or of one of its columns.
    [[nodiscard]] std::string text(const std::string& note, const std::string& of = ".") const {
        const hid_t attribute =
            H5Aopen_by_name(file_, of.c_str(), note.c_str(), H5P_DEFAULT, H5P_DEFAULT);
        REQUIRE(attribute >= 0);
        const hid_t type = H5Aget_type(attribute);
        std::string result;
        if (H5Tis_variable_str(type) > 0) {
            char* characters = nullptr;
            CHECK(H5Aread(attribute, type, &characters) >= 0);
            result = characters;
            H5free_memory(characters);
        } else {
            result.resize(H5Tget_size(type));
            CHECK(H5Aread(attribute, type, result.data()) >= 0);
            result = result.c_str();
        }
        H5Tclose(type);
        H5Aclose(attribute);
        return result;
    }

    [[nodiscard]] double number(const std::string& note) const {
        const hid_t attribute = H5Aopen(file_, note.c_str(), H5P_DEFAULT);
        double result = 0;
        CHECK(H5Aread(attribute, H5T_NATIVE_DOUBLE, &result) >= 0);
        H5Aclose(attribute);
        return result;
    }

    /// The name of the scale of a column's dimension.
    [[nodiscard]] std::string scale_of(const std::string& name) const {
        const hid_t attribute =
            H5Aopen_by_name(file_, name.c_str(), "DIMENSION_LIST", H5P_DEFAULT, H5P_DEFAULT);
        const hid_t type = H5Aget_type(attribute);
        hvl_t list{};
        REQUIRE(H5Aread(attribute, type, &list) >= 0);
        REQUIRE(list.len == 1);
        const hid_t scale = H5Rdereference2(file_, H5P_DEFAULT, H5R_OBJECT, list.p);
        std::string result(static_cast<std::size_t>(H5Iget_name(scale, nullptr, 0)), '\0');
        H5Iget_name(scale, result.data(), result.size() + 1);
        H5Oclose(scale);
        H5free_memory(list.p);
        H5Tclose(type);
        H5Aclose(attribute);
        return result;
    }

    /// How many datasets the scale says that it is of.
    [[nodiscard]] std::size_t attached() const {
        const hid_t attribute =
            H5Aopen_by_name(file_, "t", "REFERENCE_LIST", H5P_DEFAULT, H5P_DEFAULT);
        const hid_t space = H5Aget_space(attribute);
        const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
        H5Sclose(space);
        H5Aclose(attribute);
        return count;
    }

private:
    hid_t file_;
};

/// Runs in a directory of their own.
struct RunsInHdf5 {
    RunsInHdf5() { use_cache(); }

    [[nodiscard]] Outcome run(const std::string& words, const std::string& before = "") const {
        return shell(before + "exec \"$hvi_gen\" run " + words, directory.path());
    }
    /// One that goes well.
    void make(const std::string& words) const {
        const Outcome outcome = run(words);
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
    }

    Directory directory;
};

/// Checks that both tables of a run have equal numbers.
void agree_in_hdf5(const std::string& words, std::size_t rows, std::size_t bytes = 8) {
    CAPTURE(words);
    const RunsInHdf5 runs;
    runs.make(words + " --only table -o text");
    runs.make(words + " --only table -o h5 --format hdf5");
    CHECK(names_in(runs.directory / "h5") == std::vector<std::string>{"trajectory.h5"});
    const Hdf5Table table(runs.directory / "h5/trajectory.h5");
    const auto lines = lines_of(contents(runs.directory / "text/trajectory.csv"));
    REQUIRE(lines.size() == rows + 1);
    const std::vector<std::string> names = table.names();
    std::string header;
    for (const std::string& name : names) header += (header.empty() ? "" : ",") + name;
    CHECK(header == lines.front());
    std::vector<std::vector<double>> expected(names.size());
    for (std::size_t k = 1; k < lines.size(); ++k) {
        const std::vector<double> row = numbers_of(lines[k]);
        for (std::size_t i = 0; i < row.size(); ++i)
            expected[i].push_back(
                i > 0 && bytes == 4 ? static_cast<double>(static_cast<float>(row[i])) : row[i]);
    }
    CHECK(table.bytes_of("t") == 8);
    for (std::size_t i = 0; i < names.size(); ++i) CHECK(table.column(names[i]) == expected[i]);
    for (std::size_t i = 1; i < names.size(); ++i) CHECK(table.bytes_of(names[i]) == bytes);
    CHECK(table.text("CLASS", "t") == "DIMENSION_SCALE");
    CHECK(table.text("NAME", "t") == "t");
    CHECK(table.attached() == names.size() - 1);
    for (std::size_t i = 1; i < names.size(); ++i) CHECK(table.scale_of(names[i]) == "/t");
}

}  // namespace

TEST_CASE("a table as HDF5 has names, the same doubles, and t as their scale") {
    agree_in_hdf5("kepler --method gauss:4 --interpret --until 1 --columns \"energy, x\"", 21);
    agree_in_hdf5("kepler --method gauss:4 --interpret --until 1 --numbers float", 21, 4);
    // NOTE: as many rows as are written at once, and one more.
    agree_in_hdf5("kepler --method stormer-verlet --interpret --step 1/100 --until 1023/100", 1024);
    agree_in_hdf5("kepler --method stormer-verlet --interpret --step 1/100 --until 1024/100", 1025);
    agree_in_hdf5("outer-solar-system --method stormer-verlet --interpret --times 0:1000:3 "
                  "--columns \"px[1..2]\"",
                  3);
}

TEST_CASE("a table as HDF5 with more columns than an attribute used to hold") {
    const RunsInHdf5 runs;
    runs.make("fpu-chain --method stormer-verlet --param N=6000 --step 1/10 --until 1/5 --columns "
              "q --only table --format hdf5 -o out");
    const Hdf5Table table(runs.directory / "out/trajectory.h5");
    CHECK(table.attached() > 5000);
    CHECK(table.column("q[5000]").size() == 3);
    CHECK(table.scale_of("q[5000]") == "/t");
}

TEST_CASE("a table as HDF5 says of which run it is") {
    const RunsInHdf5 runs;
    const std::string scene =
        "# of 1 µm\ndescription = \"A spring\"\nhamiltonian = \"p^2/2 + k*q^4/4\"\n"
        "coordinates = [\"q\"]\nmomenta = [\"p\"]\nparameters = {k = 1}\ninvariants = {twice = "
        "\"p^2 + k*q^4/2\"}\n"
        "initial = {q = 1, p = 0}\nrun = {method = \"gauss:4\", step = \"1/8\", until = 1}\n";
    write(runs.directory / "spring.toml", scene);
    runs.make("spring.toml --interpret --param k=2 --only table --format hdf5 -o out");
    const Hdf5Table table(runs.directory / "out/trajectory.h5");
    CHECK(table.text("scene") == "spring");
    CHECK(table.text("description") == "A spring");
    CHECK(table.text("scene_text") == scene);
    CHECK(table.text("method") == "gauss:4");
    CHECK(table.number("step") == 0.125);
    CHECK(table.text("command").find("--param \"k=2\"") != std::string::npos);
    CHECK(table.text("source").find("hvi-gen ") == 0);
    CHECK(!table.has("incomplete"));
    CHECK(table.text("long_name", "t") == "time");
    CHECK(table.text("long_name", "q") == "coordinate q");
    CHECK(table.text("long_name", "p") == "momentum p");
    CHECK(table.text("long_name", "energy") == "energy");
    CHECK(table.text("long_name", "twice") == "invariant twice");
}

TEST_CASE("two tables as HDF5 of one run are the same to the byte, whenever they are made") {
    const RunsInHdf5 runs;
    const std::string words = "kepler --method stormer-verlet --interpret --format hdf5 -o ";
    runs.make(words + "first");
    REQUIRE(shell("sleep 1.1").status == 0);
    runs.make(words + "second");
    CHECK(contents(runs.directory / "first/trajectory.h5") ==
          contents(runs.directory / "second/trajectory.h5"));
    CHECK(names_in(runs.directory / "first") ==
          std::vector<std::string>{"picture.svg", "summary.txt", "trajectory.h5"});
}

TEST_CASE("a table as HDF5 of a run that ends on the way is whole, and says so") {
    const RunsInHdf5 runs;
    const Outcome interrupted = shell(
        "\"$hvi_gen\" run kepler --method stormer-verlet --interpret --step 1/1000 --until "
        "10^9 --every 1000 --only table --format hdf5 -o out & sleep 1; kill -INT $!; wait $!",
        runs.directory.path());
    CHECK(interrupted.status == 130);
    const Hdf5Table table(runs.directory / "out/trajectory.h5");
    CHECK(table.text("incomplete") == "interrupted");
    CHECK(table.column("t").size() > 1);
    CHECK(table.column("t").size() == table.column("energy").size());
    CHECK(table.column("t")[1] == 1);
}

TEST_CASE("tables as HDF5 that cannot be") {
    const RunsInHdf5 runs;
    const std::string words =
        "kepler --method stormer-verlet --interpret --until 1000 --format hdf5 ";
    // Writing fails when the file has this size, as it does on a full disk.
    for (const std::string blocks : {"1", "8", "40", "100"}) {
        const Outcome full = runs.run(words + "-o out", "ulimit -f " + blocks + "; ");
        CAPTURE(blocks, full.err);
        CHECK(full.status == 3);
        CHECK(full.err.find("error: cannot write out/") == 0);
        CHECK(lines_of(full.err).size() == 1);
        CHECK(!std::filesystem::exists(runs.directory / "out"));
    }
    for (const std::string file : {"--checkpoint", "--resume"}) {
        const Outcome refused = runs.run(words + file + " run.hvi");
        CHECK(refused.status == 2);
        CHECK(refused.err == "error: a table in HDF5 does not go with checkpoints\n"
                             "  --format: hdf5\n            ^~~~\n"
                             "help: it cannot be read where the run is killed; --format npy can\n");
    }
    const std::string name = HVI_HDF5_LIBRARY;
    write(runs.directory / name, "no library");
    const Outcome missing = runs.run(words + "-o out", "LD_LIBRARY_PATH=. ");
    CHECK(missing.status == 3);
    CHECK(missing.err.find("error: a table in HDF5 needs " + name + ", which cannot be loaded\n") ==
          0);
    CHECK(missing.err.find("libhdf5-103-1") != std::string::npos);
    // NOTE: other runs do without.
    CHECK(runs.run("kepler --interpret --only table -o out", "LD_LIBRARY_PATH=. ").status == 0);
}
