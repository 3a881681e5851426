// Directions in which a function passes through zero at an event.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

enum class EventDirection { both, up, down };

}  // namespace hvi::gen
