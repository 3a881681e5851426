// The entry of libFuzzer; HVI_FUZZ_TARGET is one of the functions in targets.hpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>
#include <cstdint>

#include "tests/generator/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    hvi::gen::fuzz::HVI_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
    return 0;
}
