// Data of a class System with sizes at run time: places of families, tables, and threads.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/system/class_names.hpp"
#include "generator/emit/text/text.hpp"

namespace hvi::gen {

/// Writes members of System, and their part of its constructor.
class SizeMembers {
public:
    /// `has_chunks`: sums are cut into chunks, for threads.
    SizeMembers(const System& system, const ClassNames& names, bool has_chunks)
        : system_(system), names_(names), has_chunks_(has_chunks) {}

    /// Returns members that arguments initialise, `N_(parameters.N)`.
    [[nodiscard]] std::vector<std::string> initialised() const;

    /// Returns the argument of the constructor beside parameters.
    [[nodiscard]] std::string_view threads() const {
        return has_chunks_ ? ", unsigned threads = 1" : ", unsigned /*threads*/ = 1";
    }

    void write_setup(Writer& writer) const;
    void write_data(Writer& writer) const;

private:
    void write_places(Writer& writer, const SystemFamily& family, std::string_view total) const;
    void write_fits(Writer& writer) const;

    const System& system_;
    const ClassNames& names_;
    bool has_chunks_;
};

}  // namespace hvi::gen
