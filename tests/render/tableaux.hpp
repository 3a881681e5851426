// The tableaux that the tests of the formats print.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>

#include "generator/exact/methods/galerkin.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

inline std::shared_ptr<const Source> source(const std::string& text) {
    return std::make_shared<const Source>(Source{"text", text});
}

inline Tableau tableau(const std::string& name) { return derive(named_method(source(name))); }

inline Tableau tableau(const std::string& basis, const std::string& nodes) {
    return derive(method_from_text(source(basis), source(nodes)));
}

}  // namespace hvi::gen
