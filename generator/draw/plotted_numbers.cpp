// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/plotted_numbers.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>

#include "generator/draw/gnuplot.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

PlottedNumbers::PlottedNumbers(const std::vector<double>& numbers)
    : descriptor_(::memfd_create("numbers", MFD_CLOEXEC)) {
    const auto* left = reinterpret_cast<const char*>(numbers.data());
    const char* const end = left + numbers.size() * sizeof(double);
    while (descriptor_ >= 0 && left < end) {
        const ssize_t written = ::write(descriptor_, left, static_cast<std::size_t>(end - left));
        if (written <= 0) break;
        left += written;
    }
    if (left == end && descriptor_ >= 0) return;
    ::close(descriptor_);
    throw EnvironmentError("cannot hand numbers to gnuplot: memory is short");
}

PlottedNumbers::~PlottedNumbers() { ::close(descriptor_); }

// NOTE: by the number of this process, as the file is not handed on to gnuplot itself.
std::string PlottedNumbers::quoted_path() const {
    return gnuplot_quoted("/proc/" + std::to_string(::getpid()) + "/fd/" +
                          std::to_string(descriptor_));
}

}  // namespace hvi::gen
