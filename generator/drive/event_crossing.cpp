// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/event_crossing.hpp"

#include <cmath>

namespace hvi::gen {

std::optional<EventDerivative> event_derivative(const EventCrossing& crossing,
                                                const std::vector<DirectionVector>& columns) {
    EventDerivative result;
    for (const DirectionVector& column : columns) {
        const double dt = -product_of(crossing.by_state, column) / crossing.speed();
        if (!std::isfinite(dt)) return {};
        result.time.push_back(dt);
        DirectionVector& moved = result.state.emplace_back(column);
        for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += crossing.motion[k] * dt;
    }
    return result;
}

}  // namespace hvi::gen
