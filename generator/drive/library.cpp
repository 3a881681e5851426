// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/library.hpp"

#include <dlfcn.h>

#include <stdexcept>

namespace hvi::gen {

const void* functions_of_library(const std::string& path, const char* symbol, int version) {
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw std::runtime_error(::dlerror());
    const void* const found = ::dlsym(library, symbol);
    if (found == nullptr || *static_cast<const int*>(found) != version)
        throw std::runtime_error(path + " is no module of this version of hvi");
    return found;
}

}  // namespace hvi::gen
