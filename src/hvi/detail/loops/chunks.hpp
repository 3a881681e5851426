// Sums whose outer index is shared out among threads.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <hvi/detail/loops/stretch.hpp>
#include <hvi/detail/loops/team.hpp>

namespace hvi::detail {

/// Returns the number of chunks that `indices` outer indices are cut into. Each chunk adds to a
/// vector of its own, and inner loops are about as long as the outer one. So these vectors cost a
/// fixed part, below a hundredth, of the work of the pairs. Vectors of a million components have
/// four chunks at most, for the memory.
[[nodiscard]] constexpr Place chunks_of(Place indices, std::size_t size) {
    constexpr std::size_t most_numbers = std::size_t{1} << 22;
    const auto fit = static_cast<Place>(most_numbers / std::max(size, std::size_t{1}));
    return std::max(std::min({indices / 128, Place{64}, fit}), Place{1});
}

/// Adds to out[0], ..., out[size - 1] what part(from, to, stride, Scalar* out) adds for the outer
/// indices from, from + stride, ... < to. Chunks interleave, so that they take equally long where
/// inner loops become shorter or longer. The number of chunks depends on `last - first` and `size`
/// alone, and chunks are added in their order: the bits do not depend on the number of threads.
///
/// `memory` is kept from call to call, a vector for each caller, and grows to one vector for each
/// chunk. Precondition: part throws nothing. Throws std::bad_alloc, before anything is added.
template <class Scalar, class Part>
void chunked(Team& team, Place first, Place last, Scalar* out, std::size_t size,
             std::vector<Scalar>& memory, Part&& part) {
    const Place chunks = chunks_of(last - first, size);
    if (chunks == 1) {
        part(first, last, Place{1}, out);
        return;
    }
    const auto count = static_cast<std::size_t>(chunks);
    if (memory.size() < count * size) { memory.resize(count * size); }
    team.run(count, [&](std::size_t chunk) {
        Scalar* const own = memory.data() + chunk * size;
        std::fill(own, own + size, Scalar(0));
        part(first + static_cast<Place>(chunk), last, chunks, own);
    });
    team.run(count, [&](std::size_t slice) {
        const std::size_t begin = size * slice / count, end = size * (slice + 1) / count;
        for (std::size_t chunk = 0; chunk < count; ++chunk) {
            const Scalar* const own = memory.data() + chunk * size;
            for (std::size_t i = begin; i < end; ++i) { out[i] = out[i] + own[i]; }
        }
    });
}

}  // namespace hvi::detail
