// Ignores memory that libraries allocate before main(): CLN keeps some of it until the end. Looking
// up the names of a suppression took longer than most runs of hvi-gen.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <sanitizer/lsan_interface.h>

namespace {

// Before the initialisers of shared libraries, and after them before any of ours.
void begin(int /*count*/, char** /*words*/, char** /*environment*/) { __lsan_disable(); }
[[gnu::section(".preinit_array"), gnu::used]] void (*const begins)(int, char**, char**) = begin;

[[gnu::constructor(101)]] void end() { __lsan_enable(); }

}  // namespace
