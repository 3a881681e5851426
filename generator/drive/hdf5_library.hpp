// HDF5's C library, loaded at its first use, so that starting hvi-gen is not slower.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <hdf5.h>

namespace hvi::gen {

/// Functions and values of the library, by the names of its header. NOTE: macros of this header,
/// such as H5F_ACC_TRUNC, call functions that are not linked.
class Hdf5Library {
    void* library_;

public:
    /// Throws EnvironmentError where the library is missing, or differs from its header.
    Hdf5Library();
    Hdf5Library(const Hdf5Library&) = delete;
    Hdf5Library& operator=(const Hdf5Library&) = delete;
    ~Hdf5Library() = default;  // it stays loaded

#define HVI_FUNCTION(name)                                                                         \
    const decltype(&::name) name = reinterpret_cast<decltype(&::name)>(symbol(#name))
    HVI_FUNCTION(H5Aclose);
    HVI_FUNCTION(H5Acreate2);
    HVI_FUNCTION(H5Awrite);
    HVI_FUNCTION(H5Dclose);
    HVI_FUNCTION(H5Dcreate2);
    HVI_FUNCTION(H5Dget_space);
    HVI_FUNCTION(H5Dget_type);
    HVI_FUNCTION(H5Dread);
    HVI_FUNCTION(H5Dset_extent);
    HVI_FUNCTION(H5Dwrite);
    HVI_FUNCTION(H5Eset_auto2);
    HVI_FUNCTION(H5Fclose);
    HVI_FUNCTION(H5Fcreate);
    HVI_FUNCTION(H5Fopen);
    HVI_FUNCTION(H5Gget_info);
    HVI_FUNCTION(H5Iget_type);
    HVI_FUNCTION(H5Lget_name_by_idx);
    HVI_FUNCTION(H5Oclose);
    HVI_FUNCTION(H5Oopen);
    HVI_FUNCTION(H5Pclose);
    HVI_FUNCTION(H5Pcreate);
    HVI_FUNCTION(H5Pset_attr_creation_order);
    HVI_FUNCTION(H5Pset_chunk);
    HVI_FUNCTION(H5Pset_chunk_cache);
    HVI_FUNCTION(H5Pset_fclose_degree);
    HVI_FUNCTION(H5Pset_libver_bounds);
    HVI_FUNCTION(H5Pset_link_creation_order);
    HVI_FUNCTION(H5Pset_obj_track_times);
    HVI_FUNCTION(H5Rcreate);
    HVI_FUNCTION(H5Sclose);
    HVI_FUNCTION(H5Screate);
    HVI_FUNCTION(H5Screate_simple);
    HVI_FUNCTION(H5Sget_simple_extent_dims);
    HVI_FUNCTION(H5Sget_simple_extent_ndims);
    HVI_FUNCTION(H5Sselect_hyperslab);
    HVI_FUNCTION(H5Tclose);
    HVI_FUNCTION(H5Tcopy);
    HVI_FUNCTION(H5Tcreate);
    HVI_FUNCTION(H5Tget_class);
    HVI_FUNCTION(H5Tinsert);
    HVI_FUNCTION(H5Tset_cset);
    HVI_FUNCTION(H5Tset_size);
    HVI_FUNCTION(H5Tvlen_create);
    HVI_FUNCTION(H5dont_atexit);
    HVI_FUNCTION(H5get_libversion);
    HVI_FUNCTION(H5open);
#undef HVI_FUNCTION

    // Property lists: H5P_FILE_ACCESS and so on.
    [[nodiscard]] hid_t file_access() const { return value("H5P_CLS_FILE_ACCESS_ID_g"); }
    [[nodiscard]] hid_t file_creation() const { return value("H5P_CLS_FILE_CREATE_ID_g"); }
    [[nodiscard]] hid_t dataset_access() const { return value("H5P_CLS_DATASET_ACCESS_ID_g"); }
    [[nodiscard]] hid_t dataset_creation() const { return value("H5P_CLS_DATASET_CREATE_ID_g"); }
    // Types: H5T_IEEE_F64LE and so on.
    [[nodiscard]] hid_t double_here() const { return value("H5T_NATIVE_DOUBLE_g"); }
    [[nodiscard]] hid_t double_in_file() const { return value("H5T_IEEE_F64LE_g"); }
    [[nodiscard]] hid_t float_in_file() const { return value("H5T_IEEE_F32LE_g"); }
    [[nodiscard]] hid_t int_here() const { return value("H5T_NATIVE_INT_g"); }
    [[nodiscard]] hid_t reference() const { return value("H5T_STD_REF_OBJ_g"); }
    [[nodiscard]] hid_t text() const { return value("H5T_C_S1_g"); }

private:
    [[nodiscard]] void* symbol(const char* name) const;
    [[nodiscard]] hid_t value(const char* name) const {
        return *static_cast<const hid_t*>(symbol(name));
    }
};

/// Returns the library, loaded once. Throws as its constructor does.
[[nodiscard]] const Hdf5Library& hdf5();

}  // namespace hvi::gen
