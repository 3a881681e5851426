// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "generator/drive/checkpoint.hpp"
#include "generator/edges/time_cases.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* key = "edges";

/// Returns a checkpoint after `steps` steps, with numbers of each kind.
Checkpoint checkpoint_after(std::int64_t steps) {
    using Limits = std::numeric_limits<double>;
    Checkpoint checkpoint;
    checkpoint.steps = steps;
    checkpoint.t = 1.0 / 3;
    checkpoint.state = {0.1,           -0.0,
                        Limits::max(), Limits::min(),
                        1.0 / 7,       Limits::denorm_min(),
                        -1e300,        Limits::infinity(),
                        1 - 0x1p-53,   1 + 0x1p-52};
    checkpoint.departures = {{1.0 / 11, 1e-17, -1e-18}};
    return checkpoint;
}

/// Returns the last whole checkpoint; nothing where there is none.
std::optional<Checkpoint> found_in(const std::string& text) {
    try {
        return last_checkpoint(text, key, "checkpoint");
    } catch (const InputError&) { return {}; }
}

}  // namespace

EdgeCheck numbers_of_checkpoint() {
    const Checkpoint written = checkpoint_after(1);
    const std::optional<Checkpoint> read = found_in(text(written, key));
    std::size_t same = 0;
    for (std::size_t k = 0; read && k < read->state.size() && k < written.state.size(); ++k)
        if (std::bit_cast<std::uint64_t>(read->state[k]) ==
            std::bit_cast<std::uint64_t>(written.state[k]))
            ++same;
    return {"any",
            "checkpoint",
            "numbers of all sizes, written and read",
            fmt::format("{} with their bits", written.state.size()),
            fmt::format("{} with their bits", same),
            same == written.state.size()};
}

EdgeCheck cut_checkpoint() {
    const std::string first = text(checkpoint_after(1), key),
                      second = text(checkpoint_after(2), key);
    std::size_t good = 0;
    for (std::size_t length = 0; length < second.size(); ++length) {
        const std::optional<Checkpoint> read = found_in(first + second.substr(0, length));
        if (read && read->steps == 1) ++good;
    }
    return {"any",
            "checkpoint",
            "the second of two, cut off behind each of its bytes, also within a number",
            "the first, each time",
            fmt::format("the first, {} of {} times", good, second.size()),
            good == second.size()};
}

}  // namespace hvi::gen
