// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/hdf5_library.hpp"

#include <dlfcn.h>

#include <string>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

[[noreturn]] void refuse_hdf5(const std::string& why) {
    throw EnvironmentError("a table in HDF5 needs " HVI_HDF5_LIBRARY ", " + why,
                           "`apt-get install libhdf5-103-1` installs it; CSV and NPY need nothing");
}

void* loaded_hdf5() {
    void* const library = ::dlopen(HVI_HDF5_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) refuse_hdf5("which cannot be loaded");
    return library;
}

}  // namespace

Hdf5Library::Hdf5Library() : library_(loaded_hdf5()) {
    unsigned major = 0, minor = 0, release = 0;
    // NOTE: called first; at its exit the library would print where a file cannot be closed on a
    // full disk.
    const bool is_quiet =
        H5dont_atexit() >= 0 && H5open() >= 0 && H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
    if (!is_quiet || H5get_libversion(&major, &minor, &release) < 0)
        refuse_hdf5("which does not start");
    if (major != H5_VERS_MAJOR || minor != H5_VERS_MINOR)
        refuse_hdf5("which is of another version");
}

void* Hdf5Library::symbol(const char* name) const {
    void* const found = ::dlsym(library_, name);
    if (found == nullptr) refuse_hdf5("which has no " + std::string(name));
    return found;
}

const Hdf5Library& hdf5() {
    static const Hdf5Library library;
    return library;
}

}  // namespace hvi::gen
