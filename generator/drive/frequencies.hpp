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

/// amplitude cos(frequency t + phase), with an angular frequency, in radians per unit of time.
struct FrequencyTerm {
    double frequency = 0, amplitude = 0, phase = 0;
    double uncertainty = 0;  ///< of the frequency
};

/// How many samples there have to be.
inline constexpr std::size_t fewest_samples = 64;

/// The mean, as a term of frequency 0, then at most so many terms of frequencies above 0, by their
/// amplitudes.
///
/// Each frequency is where the projection of what is left onto a pair of cosine and sine is
/// largest, in the product with the window 1 + cos of Hanning (J. Laskar, Physica D 67, 1993,
/// 257-281); and then again and again with all other terms taken away, so that neither these nor
/// the frequency of the other sign disturb it. A sum of few terms is found to round-off so. Terms
/// within two parts of 2 pi in the whole time of each other are not told apart.
///
/// The uncertainty is the larger distance from the frequencies that both halves of the samples
/// have. Where the motion is quasi-periodic that covers the error, as the error of half the time
/// is some 8 to 16 times that of the whole; where it is chaotic it is the drift of the frequency.
///
/// There are at most n/16 terms of n samples, also in each half. Preconditions: at least
/// fewest_samples, all finite; the step is not 0.
[[nodiscard]] std::vector<FrequencyTerm> frequencies(const Samples& samples, std::size_t most);

}  // namespace hvi::gen
