// Initial values of families of variables in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/system/loop_writer.hpp"

namespace hvi::gen {

/// Writes the first state of a scene with loops.
class StartWriter {
public:
    explicit StartWriter(LoopWriter& loops)
        : loops_(loops), names_(loops.names()), graph_(loops.system().graph) {}

    void write(Writer& writer, const StartOfFamilies& body);

private:
    /// Sets the elements of a family to their values in `array`.
    void write_start(Writer& writer, const SystemFamily& family, std::string_view array,
                     const SystemStart& start);
    void write_values(Writer& writer, const SystemFamily& family, std::string_view array,
                      const SystemStart::Points& points);
    [[nodiscard]] std::string place(const SystemFamily& family,
                                    const std::vector<std::string>& indices) const;

    LoopWriter& loops_;
    ClassNames& names_;
    const Graph& graph_;
};

}  // namespace hvi::gen
