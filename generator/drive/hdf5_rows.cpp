// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/hdf5_rows.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <variant>

namespace hvi::gen {

Hdf5Object::Hdf5Object(hid_t id, Close how) : id_(id), close_(how) {
    if (id < 0) throw Hdf5Failure();
}

namespace {

constexpr unsigned truncates = 2, reads_and_writes = 1;  // H5F_ACC_TRUNC and H5F_ACC_RDWR
constexpr hid_t usual = 0;                               // H5P_DEFAULT

void done(herr_t result) {
    if (result < 0) throw Hdf5Failure();
}

Hdf5Object properties(hid_t of_class) { return {hdf5().H5Pcreate(of_class), hdf5().H5Pclose}; }
Hdf5Object copied_type(hid_t type) { return {hdf5().H5Tcopy(type), hdf5().H5Tclose}; }
Hdf5Object scalar_space() { return {hdf5().H5Screate(H5S_SCALAR), hdf5().H5Sclose}; }
Hdf5Object space_of(hsize_t count) {
    return {hdf5().H5Screate_simple(1, &count, nullptr), hdf5().H5Sclose};
}

void add_attribute(hid_t to, const char* name, hid_t type, const Hdf5Object& space,
                   const void* value) {
    const Hdf5Object made(hdf5().H5Acreate2(to, name, type, space.id(), usual, usual),
                          hdf5().H5Aclose);
    done(hdf5().H5Awrite(made.id(), type, value));
}

/// Adds a text of any length.
void add_text(hid_t to, const char* name, const std::string& text) {
    const Hdf5Object type = copied_type(hdf5().text());
    done(hdf5().H5Tset_size(type.id(), H5T_VARIABLE));
    done(hdf5().H5Tset_cset(type.id(), H5T_CSET_UTF8));
    const char* const characters = text.c_str();
    add_attribute(to, name, type.id(), scalar_space(), &characters);
}

/// Adds a text of fixed length, as attributes of dimensions need.
void add_word(hid_t to, const char* name, const std::string& text) {
    const Hdf5Object type = copied_type(hdf5().text());
    done(hdf5().H5Tset_size(type.id(), text.size() + 1));
    add_attribute(to, name, type.id(), scalar_space(), text.c_str());
}

void add_note(hid_t to, const TableNote& note) {
    if (const auto* text = std::get_if<std::string>(&note.value))
        return add_text(to, note.name.c_str(), *text);
    // NOTE: numbers in files are little-endian on all machines.
    const double number = std::get<double>(note.value);
    const Hdf5Object attribute(hdf5().H5Acreate2(to, note.name.c_str(), hdf5().double_in_file(),
                                                 scalar_space().id(), usual, usual),
                               hdf5().H5Aclose);
    done(hdf5().H5Awrite(attribute.id(), hdf5().double_here(), &number));
}

/// Returns access by the format of HDF5 1.8: all readers know it, and it does not limit the
/// description of a dataset.
Hdf5Object access_to_file() {
    Hdf5Object access = properties(hdf5().file_access());
    done(hdf5().H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_V18));
    done(hdf5().H5Pset_fclose_degree(access.id(), H5F_CLOSE_STRONG));
    return access;
}

/// Makes a new file. It keeps the order of its objects, but no times of creation.
Hdf5Object new_hdf5_file(const std::filesystem::path& path) {
    constexpr unsigned keeps_order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
    const Hdf5Object creation = properties(hdf5().file_creation());
    done(hdf5().H5Pset_obj_track_times(creation.id(), false));
    done(hdf5().H5Pset_link_creation_order(creation.id(), keeps_order));
    done(hdf5().H5Pset_attr_creation_order(creation.id(), keeps_order));
    return {hdf5().H5Fcreate(path.c_str(), truncates, creation.id(), access_to_file().id()),
            hdf5().H5Fclose};
}

hobj_ref_t reference_to(const Hdf5Object& file, const std::string& name) {
    hobj_ref_t reference{};
    done(hdf5().H5Rcreate(&reference, file.id(), name.c_str(), H5R_OBJECT, -1));
    return reference;
}

/// Returns rows in a chunk of a column, so that all columns together take a few megabytes.
std::size_t rows_in_chunk(std::size_t columns) {
    constexpr std::size_t numbers = 1 << 20, least = 16, most = 1024;
    return std::clamp(numbers / columns, least, most);
}

/// Marks a dataset as the scale of a dimension of other datasets.
void make_scale(const Hdf5Object& scale, const std::vector<hobj_ref_t>& attached) {
    constexpr std::size_t behind_reference = sizeof(hobj_ref_t),
                          size = behind_reference + sizeof(int);
    if (attached.empty()) return;
    const Hdf5Object type(hdf5().H5Tcreate(H5T_COMPOUND, size), hdf5().H5Tclose);
    done(hdf5().H5Tinsert(type.id(), "dataset", 0, hdf5().reference()));
    done(hdf5().H5Tinsert(type.id(), "dimension", behind_reference, hdf5().int_here()));
    std::string all(size * attached.size(), '\0');  // dimensions are their first ones, 0
    for (std::size_t k = 0; k < attached.size(); ++k)
        std::memcpy(all.data() + size * k, &attached[k], sizeof(hobj_ref_t));
    add_attribute(scale.id(), "REFERENCE_LIST", type.id(), space_of(attached.size()), all.data());
}

/// Refers a dataset to the scale of its dimension.
void attach(const Hdf5Object& column, hobj_ref_t scale) {
    const Hdf5Object type(hdf5().H5Tvlen_create(hdf5().reference()), hdf5().H5Tclose);
    const hvl_t list{1, &scale};
    add_attribute(column.id(), "DIMENSION_LIST", type.id(), space_of(1), &list);
}

}  // namespace

Hdf5Rows::Hdf5Rows(const std::filesystem::path& path, const TableHead& head)
    : in_chunk_(rows_in_chunk(head.columns.size())), buffer_(head.columns.size()) {
    try {
        file_.emplace(new_hdf5_file(path));
        begin(head);
    } catch (const Hdf5Failure&) { good_ = false; }
}

void Hdf5Rows::begin(const TableHead& head) {
    for (const TableNote& note : head.notes) add_note(file_->id(), note);
    const Hdf5Object creation = properties(hdf5().dataset_creation());
    const hsize_t chunk = in_chunk_;
    done(hdf5().H5Pset_chunk(creation.id(), 1, &chunk));
    done(hdf5().H5Pset_obj_track_times(creation.id(), false));
    done(hdf5().H5Pset_attr_creation_order(creation.id(),
                                           H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    // NOTE: chunks are written whole, so that a cache of a megabyte for each dataset is of no use.
    const Hdf5Object access = properties(hdf5().dataset_access());
    done(hdf5().H5Pset_chunk_cache(access.id(), 0, 0, 0));
    for (const NamedColumn& column : head.columns) add_column(column, creation, access);
    std::vector<hobj_ref_t> attached;
    const hobj_ref_t scale = reference_to(*file_, head.columns.front().name);
    for (std::size_t k = 1; k < columns_.size(); ++k) {
        attach(columns_[k], scale);
        attached.push_back(reference_to(*file_, head.columns[k].name));
    }
    add_word(columns_.front().id(), "CLASS", "DIMENSION_SCALE");
    add_word(columns_.front().id(), "NAME", head.columns.front().name);
    make_scale(columns_.front(), attached);
}

void Hdf5Rows::add_column(const NamedColumn& column, const Hdf5Object& creation,
                          const Hdf5Object& access) {
    const hsize_t none = 0, any = H5S_UNLIMITED;
    const hid_t type =
        column.numbers == TableNumbers::floats ? hdf5().float_in_file() : hdf5().double_in_file();
    numbers_.push_back(column.numbers);
    const Hdf5Object space(hdf5().H5Screate_simple(1, &none, &any), hdf5().H5Sclose);
    columns_.emplace_back(hdf5().H5Dcreate2(file_->id(), column.name.c_str(), type, space.id(),
                                            usual, creation.id(), access.id()),
                          hdf5().H5Dclose);
    add_text(columns_.back().id(), "long_name", column.meaning);
}

void Hdf5Rows::row(const std::vector<double>& values) {
    if (!good_) return;
    for (std::size_t k = 0; k < values.size(); ++k)
        buffer_[k].push_back(numbers_[k] == TableNumbers::floats
                                 ? static_cast<double>(nearest_float(values[k]))
                                 : values[k]);
    if (buffer_.front().size() == in_chunk_) flush();
}

void Hdf5Rows::flush() {
    const hsize_t count = buffer_.front().size(), all = written_ + count;
    if (count == 0 || !good_) return;
    try {
        const Hdf5Object here = space_of(count), there = space_of(all);
        done(hdf5().H5Sselect_hyperslab(there.id(), H5S_SELECT_SET, &written_, nullptr, &count,
                                        nullptr));
        for (std::size_t k = 0; k < columns_.size(); ++k) {
            done(hdf5().H5Dset_extent(columns_[k].id(), &all));
            done(hdf5().H5Dwrite(columns_[k].id(), hdf5().double_here(), here.id(), there.id(),
                                 usual, buffer_[k].data()));
            buffer_[k].clear();
        }
        written_ = all;
    } catch (const Hdf5Failure&) { good_ = false; }
}

bool Hdf5Rows::close() {
    flush();
    for (Hdf5Object& column : columns_) good_ = column.close() && good_;
    return file_ && file_->close() && good_;
}

bool add_note(const std::filesystem::path& path, const std::string& name, const std::string& text) {
    try {
        Hdf5Object file(hdf5().H5Fopen(path.c_str(), reads_and_writes, access_to_file().id()),
                        hdf5().H5Fclose);
        add_text(file.id(), name.c_str(), text);
        return file.close();
    } catch (const Hdf5Failure&) { return false; }
}

}  // namespace hvi::gen
