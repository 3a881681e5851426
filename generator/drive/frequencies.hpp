// The frequencies of a motion: J. Laskar's analysis of the fundamental frequencies.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace hvi::gen {

/// Values of a function at the times first + k step.
struct Samples {
    double first = 0, step = 1;
    std::vector<double> values;
};

/// The term amplitude cos(frequency t + phase), with an angular frequency, in radians per unit of
/// time.
struct FrequencyTerm {
    double frequency = 0, amplitude = 0, phase = 0;
    double uncertainty = 0;  ///< uncertainty of the frequency
};

/// The least number of samples.
inline constexpr std::size_t fewest_samples = 64;

/// Returns the mean, as a term of frequency 0, then at most `most` terms of frequencies above 0, by
/// their amplitudes.
///
/// Each frequency maximizes the projection of the remaining samples onto a pair of cosine and sine,
/// in the product with the window 1 + cos of Hanning (J. Laskar, Physica D 67, 1993, 257-281). It
/// is then improved repeatedly with all other terms subtracted, so that neither these nor the
/// negative frequency disturb it. This finds a sum of few terms to round-off. Frequencies closer
/// than two times 2 pi over the whole time are not distinguished.
///
/// The uncertainty is the larger distance from the frequencies of both halves of the samples. For a
/// quasi-periodic motion it covers the error, as the error of half the time is some 8 to 16 times
/// that of the whole. For a chaotic motion it is the drift of the frequency.
///
/// There are at most n/16 terms for n samples, also in each half. Preconditions: at least
/// fewest_samples, all finite; the step is not 0.
[[nodiscard]] std::vector<FrequencyTerm> frequencies(const Samples& samples, std::size_t most);

}  // namespace hvi::gen
