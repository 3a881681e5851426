// Whether verify() finds a mistake in a record.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// Whether verify() finds `mistake` in a record without other mistakes.
template <class Record>
bool is_found(Record record, const std::function<void(Record&)>& mistake) {
    verify(record);
    mistake(record);
    try {
        verify(record);
    } catch (const InternalError&) { return true; }
    return false;
}

}  // namespace hvi::gen
