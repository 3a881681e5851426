// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/pair_products.hpp"

#include <fmt/format.h>

namespace hvi::gen {

namespace {

std::vector<SumDerivatives> products(const System& system, bool by_q) {
    const bool has_time = system.time && (by_q || !system.structure.is_separable);
    std::vector<SumDerivatives> result;
    for (const SystemSum& sum : std::get<HessianOfSums>(system.second).products) {
        const std::vector<AccessSlope>& slopes = by_q ? sum.by_q : sum.by_conjugates;
        if (slopes.empty()) { continue; }
        const std::string name =
            fmt::format("add_product_by_{}_{}", by_q ? "q" : "p", result.size() + 1);
        result.push_back({.name = name,
                          .sum = &sum,
                          .slopes = &slopes,
                          .other = "p",
                          .has_time = has_time,
                          .has_ways = true});
    }
    return result;
}

void write_side(Writer& writer, LoopWriter& loops, bool by_q) {
    const System& system = loops.system();
    const std::vector<SumDerivatives> all = products(system, by_q);
    for (const SumDerivatives& each : all) {
        writer.blank();
        loops.write_derivatives(writer, each);
    }
    const bool is_separable = system.structure.is_separable;
    const bool takes_q = by_q || !is_separable, takes_p = !by_q || !is_separable;
    std::string arguments;
    const auto take = [&](bool takes, std::string_view array) {
        if (takes) { arguments += fmt::format("[[maybe_unused]] const Vector& {}, ", array); }
        return takes ? fmt::format("{}.data()", array) : "nullptr";
    };
    const std::string q = take(takes_q, "q"), p = take(takes_p, "p");
    const std::string way = take(takes_q, "way"), way_p = take(takes_p, "way_p");
    if (system.time && takes_q) { arguments += "[[maybe_unused]] Scalar t, "; }
    writer.blank().open("void d2Hd{}({}Vector& out) const {{", by_q ? "q" : "p", arguments);
    writer.line("std::fill(out.begin(), out.end(), Scalar(0));");
    const std::string others = fmt::format("{}, {}, {}", p, way, way_p);
    for (const SumDerivatives& each : all) { loops.call_derivatives(writer, each, q, others); }
    writer.close();
}

}  // namespace

void write_pair_products(Writer& writer, LoopWriter& loops) {
    writer.blank().comment("Rows of d2H times a vector: way of positions, way_p of momenta.");
    write_side(writer, loops, true);
    write_side(writer, loops, false);
}

}  // namespace hvi::gen
