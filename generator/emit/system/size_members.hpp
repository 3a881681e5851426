// Data of a class System that has sizes at run time: where families begin, tables, and threads.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/system/loop_names.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Writes members of System, and what its constructor does with them.
class SizeMembers {
public:
    SizeMembers(const System& system, const Step& step, const LoopNames& names)
        : system_(system), step_(step), names_(names) {}

    /// Members that are copies of parameters, `N_(parameters.N)`.
    [[nodiscard]] std::vector<std::string> initialised() const;

    /// Whether sums over pairs are cut into chunks, for threads.
    [[nodiscard]] bool has_chunks() const;

    void write_setup(Writer& writer) const;
    void write_data(Writer& writer) const;

private:
    void write_places(Writer& writer, const SystemFamily& family, std::string_view total) const;
    void write_fits(Writer& writer) const;

    const System& system_;
    const Step& step_;
    const LoopNames& names_;
};

}  // namespace hvi::gen
