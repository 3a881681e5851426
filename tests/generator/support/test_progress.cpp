// Words about work that takes long.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

#include <catch2/catch.hpp>

#include "generator/support/progress.hpp"

using namespace hvi::gen;
using namespace std::chrono_literals;

namespace {

/// Returns the output of `work` on standard error.
template <class Work>
std::string standard_error_of(Work work) {
    std::FILE* file = std::tmpfile();
    REQUIRE(file != nullptr);
    const int before = ::dup(STDERR_FILENO);
    ::dup2(::fileno(file), STDERR_FILENO);
    work();
    ::dup2(before, STDERR_FILENO);
    ::close(before);
    std::string text(1000, '\0');
    std::rewind(file);
    text.resize(std::fread(text.data(), 1, text.size(), file));
    std::fclose(file);
    return text;
}

}  // namespace

TEST_CASE("what ends soon is not spoken of") {
    CHECK(standard_error_of([] {
              const Progress progress;
              const Progress::Stage stage("something quick");
          }).empty());
}

TEST_CASE("after two seconds the innermost stage is named") {
    CHECK(standard_error_of([] {
              const Progress progress;
              const Progress::Stage outer("something slow");
              { const Progress::Stage done("a part of it that is done"); }
              std::this_thread::sleep_for(2500ms);
          }) == "hvi-gen: something slow (2 s)\n");
}
