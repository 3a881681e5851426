// A library that in the place of a module runs a script: it answers as a test likes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace {

/// Called when the library is loaded, with the words of the process: @drive LIBRARY SOLVERS
/// DIRECTORY COUNT and so many parameters, then the command.
[[gnu::constructor]] void begin(int argc, char** argv) {
    constexpr int place_of_count = 5;
    const char* const script = std::getenv("HVI_PRETENDED");
    if (script == nullptr || argc <= place_of_count) { return; }
    std::vector<char*> words{argv[0], const_cast<char*>(script)};
    for (int k = place_of_count + 1 + std::atoi(argv[place_of_count]); k < argc; ++k) {
        words.push_back(argv[k]);
    }
    words.push_back(nullptr);
    ::execv("/bin/sh", words.data());
    std::_Exit(127);
}

}  // namespace
