// Rows of numbers in HDF5 files.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <dlfcn.h>

#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/drive/hdf5_rows.hpp"
#include "generator/ensembles/number_rows.hpp"
#include "tests/generator/ensembles/number_files.hpp"

using namespace hvi::gen;

namespace {

/// A file of HDF5 in the making.
class Hdf5File {
public:
    explicit Hdf5File(const std::string& path)
        : file_(hdf5().H5Fcreate(path.c_str(), 2, 0, 0), hdf5().H5Fclose) {}

    void add(const char* name, const std::vector<double>& values, hid_t type,
             const std::vector<hsize_t>& extents) const {
        const Hdf5Object space(
            hdf5().H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr),
            hdf5().H5Sclose);
        const Hdf5Object set(hdf5().H5Dcreate2(file_.id(), name, type, space.id(), 0, 0, 0),
                             hdf5().H5Dclose);
        REQUIRE(hdf5().H5Dwrite(set.id(), hdf5().double_here(), 0, 0, 0, values.data()) >= 0);
    }

    void add(const char* name, const std::vector<double>& values) const {
        add(name, values, hdf5().double_in_file(), {values.size()});
    }

    void add_group(const char* name) const {
        void* const library = ::dlopen(HVI_HDF5_LIBRARY, RTLD_NOW | RTLD_NOLOAD);
        const auto make = reinterpret_cast<decltype(&::H5Gcreate2)>(::dlsym(library, "H5Gcreate2"));
        const Hdf5Object group(make(file_.id(), name, 0, 0, 0), hdf5().H5Oclose);
    }

private:
    Hdf5Object file_;
};

}  // namespace

TEST_CASE("datasets of an HDF5 file are columns") {
    const NumberFiles files;
    {
        const Hdf5File file(files.path("a.h5"));
        file.add("y", {0.5, 1e300, -3});
        file.add("x", {1, 2, 3}, hdf5().int_here(), {3});
        file.add("f", {0.25, 0.5, 0.75}, hdf5().float_in_file(), {3});
        file.add_group("notes");
    }
    const auto rows = files.rows("a.h5");
    CHECK(rows->names() == std::vector<std::string>{"f", "x", "y"});
    CHECK(rows->count() == 3);
    CHECK(rows->rows(0, 3) == std::vector<double>{0.25, 1, 0.5, 0.5, 2, 1e300, 0.75, 3, -3});
    CHECK(rows->rows(2, 1) == std::vector<double>{0.75, 3, -3});
    CHECK(rows->rows(3, 0).empty());
}

TEST_CASE("a table of a run is a file of rows") {
    const NumberFiles files;
    const TableHead head{{{"t", "time", TableNumbers::doubles}, {"x", "x", TableNumbers::floats}},
                         {}};
    Hdf5Rows table(files.path("a.h5"), head);
    table.row({0, 0.5});
    table.row({1, 0.25});
    REQUIRE(table.close());
    const auto rows = files.rows("a.h5");
    CHECK(rows->names() == std::vector<std::string>{"t", "x"});
    CHECK(rows->rows(0, 2) == std::vector<double>{0, 0.5, 1, 0.25});
}

TEST_CASE("what is wrong with an HDF5 file of rows is said") {
    const NumberFiles files;
    const auto refused = [&](const auto& fill) {
        { fill(Hdf5File(files.path("a.h5"))); }
        return refusal([&] { return files.rows("a.h5"); });
    };
    CHECK(refused([](const Hdf5File& file) { file.add_group("g"); }).what ==
          "a.h5: there are no columns");
    const Refusal plane = refused([](const Hdf5File& file) {
        file.add("x", {1, 2, 3, 4}, hdf5().double_in_file(), {2, 2});
    });
    CHECK(plane.what == "a.h5: `x` is no column of numbers");
    CHECK(plane.helps("groups"));
    CHECK(refused([](const Hdf5File& file) {
              file.add("x", {1, 2});
              file.add("y", {1, 2, 3});
          }).what == "a.h5: `y` has 3 rows, and `x` 2");
    CHECK(refused([](const Hdf5File& file) { file.add("x", {}); }).what ==
          "a.h5: there are no rows");
    CHECK(files.refused("a.h5", "\x89HDF\r\n\x1a\nnothing else").says("no HDF5 file"));
}
