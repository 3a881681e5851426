// Sums as loops in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/emit/system/loop_names.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/lower/loop_structure.hpp"

namespace hvi::gen {

/// A function that adds derivatives of a sum to `out`, for values of its first index from `first`
/// to `last`. It looks at the array q, and at another one.
struct SumDerivatives {
    std::string name;
    const SystemSum* sum;
    const std::vector<AccessSlope>* slopes;
    std::string_view other;   ///< `p`, or what second derivatives are multiplied by
    bool has_time = false;    ///< among its arguments
    bool has_totals = false;  ///< the same
    bool has_ways = false;    ///< the same, after p: what d2H is multiplied by, of q and of p
};

[[nodiscard]] std::vector<Scaled> values(const std::vector<AccessSlope>& slopes);

/// Writes what is computed for each value of the indices of sums. Innermost loops go in lanes where
/// all elements stand in a row or stay.
class LoopWriter {
public:
    LoopWriter(const System& system, LoopNames& names) : system_(system), names_(names) {}

    void write_derivatives(Writer& writer, const SumDerivatives& function);

    /// The call of it for the whole sum, with these arrays.
    void call_derivatives(Writer& writer, const SumDerivatives& function, std::string_view q,
                          std::string_view other);

    /// Functions of the totals of the system: `total_1(q, p, totals)` is made of those before it.
    void write_totals(Writer& writer);

    /// An array of the totals that values are made of, computed with these arrays; nothing where
    /// there are none.
    void sum_totals(Writer& writer, const std::vector<Scaled>& values, std::string_view q,
                    std::string_view p) const;

    /// Whether values are made of totals.
    [[nodiscard]] bool needs_totals(const std::vector<Scaled>& values) const;

    /// Adds the entries of a matrix to `out`.
    void write_entries(Writer& writer, const SumEntries& entries);

    /// Adds a sum to `total`.
    void write_total(Writer& writer, const SystemSum& sum);

    /// Gives the elements of a family their values in `array`.
    void write_start(Writer& writer, const SystemFamily& family, std::string_view array,
                     const SystemStart& start);

    /// Loads the elements that a kernel is given, by their own names, and returns all names that it
    /// needs. `value`: the type of what is loaded.
    [[nodiscard]] NodeNames load(Writer& writer, const std::vector<std::size_t>& accesses,
                                 const Kernel& kernel, const std::vector<Loop>& loops);

    [[nodiscard]] LoopNames& names() { return names_; }
    [[nodiscard]] const System& system() const { return system_; }

private:
    /// The loop of an innermost index, with so many numbers side by side, from first to end - 1.
    struct AlongLoop {
        std::size_t width;
        std::string first, end;
    };

    /// Writes the innermost loop in lanes: what stays is loaded before it, and `use` writes what
    /// becomes of the results, which are of the type V.
    void write_along(Writer& writer, const SystemSum& sum, const Kernel& kernel,
                     const AlongLoop& loop,
                     const std::function<void(const std::vector<std::string>&)>& use);
    void write_body(Writer& writer, const SystemSum& sum, const std::vector<AccessSlope>& slopes);
    void write_lanes(Writer& writer, const SystemSum& sum, const std::vector<AccessSlope>& slopes);
    void write_list(Writer& writer, const SystemFamily& family, std::string_view array,
                    const SystemStart::List& list);
    void write_points(Writer& writer, const SystemFamily& family, std::string_view array,
                      const SystemStart::Points& points);
    void write_rule(Writer& writer, const SystemFamily& family, std::string_view array,
                    const SystemStart::Rule& rule);
    [[nodiscard]] std::string place(const SystemFamily& family,
                                    const std::vector<std::string>& indices) const;
    [[nodiscard]] std::string first_place(const SystemFamily& family) const;
    void open_loop(Writer& writer, const Loop& loop) const;
    [[nodiscard]] bool goes_in_lanes(const SystemSum& sum) const;
    [[nodiscard]] bool depends(std::size_t access, const std::string& index) const;
    [[nodiscard]] bool has_time(std::size_t total) const;
    [[nodiscard]] std::vector<bool> needed_totals(std::vector<Scaled> values) const;
    /// Names the indices of loops, the time and totals.
    void name_numbers(NodeNames& locals, const std::vector<Loop>& loops) const;

    const System& system_;
    LoopNames& names_;
};

}  // namespace hvi::gen
