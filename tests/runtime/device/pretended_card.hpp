// A card that is pretended: functions of CUDA on the host. A card's memory is memory of the host
// that copies and kernels alone may touch.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>

/// NOTE: a kernel is known by its address on the host, and gets the addresses of its arguments.
struct PretendedCard {
    using Kernel = void (*)(void** arguments);

    std::map<const void*, Kernel> kernels;
    int count = 1;             ///< of cards
    std::size_t room = 0;      ///< bytes of an array at most
    std::size_t launches = 0;  ///< how often a kernel was started
    std::size_t refused = 0;   ///< how often there was no room
    std::size_t arrays = 0;    ///< how many there are
};

extern PretendedCard pretended_card;
