// Steps of bodies that turn, in natural charts.
// SPDX-License-Identifier: MIT
#include <drift/body_gauss_4.hpp>
#include <drift/body_gauss_6.hpp>
#include <drift/top_gauss_6.hpp>

#include "bench/drift/measure.hpp"

namespace drift {

using namespace hvi::generated;

void add_charts(std::vector<Row>& rows) {
    add<BodyGauss6, BasicBodyGauss6<long double>>(rows, {"charts", "free body", "gauss:6", "one"},
                                                  {0.4, 3.0 / 7, 0.3719, 0.5, 0.21}, 0.2);
    add<BodyGauss4, BasicBodyGauss4<long double>>(rows, {"charts", "free body", "gauss:4", "one"},
                                                  {0.1, 1.0 / 7, 0.0937}, 0.2);
    add<TopGauss6, BasicTopGauss6<long double>>(rows, {"charts", "heavy-top", "gauss:6", "one"},
                                                {0.1, 1.0 / 7, 0.0937}, 0.2);
}

}  // namespace drift
