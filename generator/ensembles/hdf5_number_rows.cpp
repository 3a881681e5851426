// Rows of an HDF5 file: datasets of one length.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <utility>

#include "generator/drive/hdf5_library.hpp"
#include "generator/drive/hdf5_rows.hpp"
#include "generator/ensembles/number_formats.hpp"

namespace hvi::gen {

namespace {

constexpr unsigned reads = 0;  // H5F_ACC_RDONLY
constexpr hid_t usual = 0;     // H5P_DEFAULT

/// A dataset of numbers.
struct NumberColumn {
    std::string name;
    Hdf5Object dataset;
    hsize_t count;
};

Hdf5Object opened_file(const NumberFile& file) {
    try {
        return {hdf5().H5Fopen(file.path.c_str(), reads, usual), hdf5().H5Fclose};
    } catch (const Hdf5Failure&) { refuse(file, "this is no HDF5 file that can be read"); }
}

/// Returns the name of a link of the root group, by this index; empty where there is none.
std::optional<std::string> link_name(const Hdf5Object& file, H5_index_t index, hsize_t number) {
    const auto name = [&](char* text, std::size_t size) {
        return hdf5().H5Lget_name_by_idx(file.id(), "/", index, H5_ITER_INC, number, text, size,
                                         usual);
    };
    const auto length = name(nullptr, 0);
    if (length < 0) return {};
    std::string text(static_cast<std::size_t>(length) + 1, '\0');  // and the end of a text in C
    if (name(text.data(), text.size()) != length) return {};
    text.pop_back();
    return text;
}

/// Returns the names of the links of the root group: in the order of their making where the file
/// keeps it, else in that of the alphabet.
std::vector<std::string> link_names(const Hdf5Object& file) {
    H5G_info_t info{};
    if (hdf5().H5Gget_info(file.id(), &info) < 0) throw Hdf5Failure();
    const bool keeps_order = link_name(file, H5_INDEX_CRT_ORDER, 0).has_value();
    std::vector<std::string> names;
    for (hsize_t k = 0; k < info.nlinks; ++k) {
        auto name = link_name(file, keeps_order ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME, k);
        if (!name) throw Hdf5Failure();
        names.push_back(std::move(*name));
    }
    return names;
}

bool has_numbers(const Hdf5Object& dataset) {
    const Hdf5Object type(hdf5().H5Dget_type(dataset.id()), hdf5().H5Tclose);
    const H5T_class_t of = hdf5().H5Tget_class(type.id());
    return of == H5T_FLOAT || of == H5T_INTEGER;
}

/// Opens a dataset; empty for a group, or a type.
std::optional<NumberColumn> column(const NumberFile& file, const Hdf5Object& root,
                                   const std::string& name) {
    Hdf5Object object(hdf5().H5Oopen(root.id(), name.c_str(), usual), hdf5().H5Oclose);
    if (hdf5().H5Iget_type(object.id()) != H5I_DATASET) return {};
    const Hdf5Object space(hdf5().H5Dget_space(object.id()), hdf5().H5Sclose);
    if (!has_numbers(object) || hdf5().H5Sget_simple_extent_ndims(space.id()) != 1)
        refuse(file, fmt::format("`{}` is no column of numbers", name),
               "each dataset of the root group has one dimension; others belong in groups");
    hsize_t count = 0;
    if (hdf5().H5Sget_simple_extent_dims(space.id(), &count, nullptr) != 1) throw Hdf5Failure();
    return NumberColumn{name, std::move(object), count};
}

std::vector<NumberColumn> columns_of(const NumberFile& file, const Hdf5Object& root) {
    std::vector<NumberColumn> columns;
    for (const std::string& name : link_names(root))
        if (auto one = column(file, root, name)) columns.push_back(std::move(*one));
    if (columns.empty())
        refuse(file, "there are no columns", "they are datasets in the root group");
    const NumberColumn& first = columns.front();
    for (const NumberColumn& one : columns)
        if (one.count != first.count)
            refuse(file, fmt::format("`{}` has {} rows, and `{}` {}", one.name, one.count,
                                     first.name, first.count));
    if (first.count == 0) refuse(file, "there are no rows");
    return columns;
}

std::vector<std::string> names_of(const std::vector<NumberColumn>& columns) {
    std::vector<std::string> names;
    for (const NumberColumn& column : columns) names.push_back(column.name);
    return names;
}

class Hdf5NumberRows : public NumberRows {
public:
    Hdf5NumberRows(NumberFile file, Hdf5Object root, std::vector<NumberColumn> columns)
        : NumberRows(file, names_of(columns), static_cast<std::int64_t>(columns.front().count)),
          file_(std::move(file)),
          root_(std::move(root)),
          columns_(std::move(columns)) {}

    std::vector<double> rows(std::int64_t first, std::int64_t count) override {
        HVI_CHECK(0 <= first && 0 <= count && first + count <= this->count());
        const std::size_t width = columns_.size();
        std::vector<double> numbers(static_cast<std::size_t>(count) * width);
        std::vector<double> of_column(static_cast<std::size_t>(count));
        for (std::size_t k = 0; k < width && count > 0; ++k) {
            read(columns_[k].dataset, first, of_column);
            for (std::size_t row = 0; row < of_column.size(); ++row)
                numbers[row * width + k] = of_column[row];
        }
        return numbers;
    }

private:
    void read(const Hdf5Object& dataset, std::int64_t first, std::vector<double>& numbers) const {
        try {
            const hsize_t begin = static_cast<hsize_t>(first), count = numbers.size();
            const Hdf5Object here(hdf5().H5Screate_simple(1, &count, nullptr), hdf5().H5Sclose);
            const Hdf5Object there(hdf5().H5Dget_space(dataset.id()), hdf5().H5Sclose);
            const bool is_read = hdf5().H5Sselect_hyperslab(there.id(), H5S_SELECT_SET, &begin,
                                                            nullptr, &count, nullptr) >= 0 &&
                                 hdf5().H5Dread(dataset.id(), hdf5().double_here(), here.id(),
                                                there.id(), usual, numbers.data()) >= 0;
            if (!is_read) throw Hdf5Failure();
        } catch (const Hdf5Failure&) { refuse(file_, "rows of this file cannot be read"); }
    }

    NumberFile file_;
    Hdf5Object root_;
    std::vector<NumberColumn> columns_;  ///< below the file, so that they are closed first
};

}  // namespace

std::unique_ptr<NumberRows> hdf5_number_rows(const NumberFile& file) {
    try {
        Hdf5Object root = opened_file(file);
        std::vector<NumberColumn> columns = columns_of(file, root);
        return std::make_unique<Hdf5NumberRows>(file, std::move(root), std::move(columns));
    } catch (const Hdf5Failure&) { refuse(file, "this HDF5 file is damaged"); }
}

}  // namespace hvi::gen
