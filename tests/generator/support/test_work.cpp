// How much work a computation may take, and interruptions that it looks at.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <unistd.h>

#include <csignal>

#include <catch2/catch.hpp>

#include "generator/support/error.hpp"
#include "generator/support/process.hpp"
#include "generator/support/work.hpp"

using namespace hvi::gen;

TEST_CASE("work ends where its limit is, and has none without") {
    spend_work(1e300);
    {
        const WorkLimit limit(10);
        for (int i = 0; i < 10; ++i) spend_work();
        CHECK_THROWS_AS(spend_work(), WorkLimitReached);
    }
    spend_work(1e300);
    const WorkLimit another(3);
    spend_work(2);
    CHECK_THROWS_AS(spend_work(2), WorkLimitReached);
}

TEST_CASE("work ends at an interruption that is held") {
    const int signal = GENERATE(SIGINT, SIGQUIT, SIGTERM);
    set_up_process();
    {
        const InterruptionsHeld held;
        spend_work();
        CHECK_FALSE(is_interrupted());
        ::raise(signal);
        CHECK(is_interrupted());
        CHECK_THROWS_AS(spend_work(), Interruption);
        char byte = 0;
        CHECK(::read(interruption_descriptor(), &byte, 1) == 1);  // seen: the program goes on
    }
    const InterruptionsHeld held_again;
    spend_work();
}
