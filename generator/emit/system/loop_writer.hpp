// Sums as loops in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/emit/system/class_function.hpp"
#include "generator/emit/system/class_names.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/lower/loop_structure.hpp"

namespace hvi::gen {

/// Returns the values of derivatives, one after the other.
[[nodiscard]] std::vector<Scaled> values(const std::vector<AccessSlope>& slopes);

/// Return whether values depend on each total of the system, and whether they depend on any.
[[nodiscard]] std::vector<bool> needed_totals(const System& system, std::vector<Scaled> values);
[[nodiscard]] bool needs_totals(const System& system, const std::vector<Scaled>& values);

/// Returns whether a total depends on the time.
[[nodiscard]] bool has_time(const System& system, std::size_t total);

/// Writes computations for each value of the indices of sums. Innermost loops go in lanes where all
/// elements stand in a row or stay.
class LoopWriter {
public:
    LoopWriter(const System& system, ClassNames& names) : system_(system), names_(names) {}

    void write(Writer& writer, const BodyOfSums& body) {
        std::visit([&](const auto& sums) { write(writer, sums); }, body);
    }

    /// Loads the elements that a kernel is given, under their own names, and returns all names that
    /// it needs. `value` is the type of the loaded elements.
    [[nodiscard]] NodeNames load(Writer& writer, const std::vector<std::size_t>& accesses,
                                 const Kernel& kernel, const std::vector<Loop>& loops);

    /// Open loops, or a block where there are none, and close them.
    void open_loops(Writer& writer, const std::vector<Loop>& loops) const;
    static void close_loops(Writer& writer, const std::vector<Loop>& loops);

    [[nodiscard]] ClassNames& names() { return names_; }
    [[nodiscard]] const System& system() const { return system_; }

private:
    /// The loop of an innermost index from first to end - 1, with `width` numbers side by side.
    struct AlongLoop {
        std::size_t width;
        std::string first, end;
    };

    void write(Writer& writer, const DerivativesOfSum& body);
    void write(Writer& writer, const ScatteredSums& body);
    void write(Writer& writer, const TotalOfSums& body);
    void write(Writer& writer, const ValueOfSums& body);
    void write(Writer& writer, const EntriesOfSums& body);

    /// Writes the innermost loop in lanes: elements that stay are loaded before it, and `use`
    /// writes the use of the results, which are of the type V.
    void write_along(Writer& writer, const SystemSum& sum, const Kernel& kernel,
                     const AlongLoop& loop,
                     const std::function<void(const std::vector<std::string>&)>& use);
    /// Writes the call of derivatives of a whole sum, with these arrays.
    void call(Writer& writer, const DerivativesOfSum& function, std::string_view arrays);

    /// Writes an array of the totals that values depend on; nothing where there are none.
    void sum_totals(Writer& writer, const std::vector<Scaled>& values,
                    std::string_view arrays) const;

    /// Adds a sum to `total`.
    void write_total(Writer& writer, const SystemSum& sum);
    void write_entries(Writer& writer, const SumEntries& entries);
    void write_body(Writer& writer, const SystemSum& sum, const std::vector<AccessSlope>& slopes);
    void write_lanes(Writer& writer, const SystemSum& sum, const std::vector<AccessSlope>& slopes);
    void open_loop(Writer& writer, const Loop& loop) const;
    [[nodiscard]] bool goes_in_lanes(const SystemSum& sum) const;
    [[nodiscard]] bool depends(std::size_t access, const std::string& index) const;
    /// Names the indices of loops, the time and totals.
    void name_numbers(NodeNames& locals, const std::vector<Loop>& loops) const;

    const System& system_;
    ClassNames& names_;
};

}  // namespace hvi::gen
