// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/work.hpp"

#include <limits>

#include "generator/support/error.hpp"
#include "generator/support/process.hpp"

namespace hvi::gen {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

thread_local double left = unlimited;

}  // namespace

WorkLimit::WorkLimit(double most) {
    HVI_CHECK(left == unlimited);
    left = most;
}

WorkLimit::~WorkLimit() { left = unlimited; }

void spend_work(double units) {
    if (is_interrupted()) throw Interruption();
    left -= units;
    if (left < 0) throw WorkLimitReached();
}

}  // namespace hvi::gen
