// Lets a copy of hvi-gen allocate memory, whatever other threads were at when it was made. NOTE:
// clang's sanitizers do so from release 17 on. Before, a copy that was made while another thread
// held the allocator waits for it for ever.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <pthread.h>

namespace __lsan {

void LockAllocator();
void UnlockAllocator();

}  // namespace __lsan

namespace {

[[gnu::constructor]] void hold_allocator_at_forks() {
    pthread_atfork(__lsan::LockAllocator, __lsan::UnlockAllocator, __lsan::UnlockAllocator);
}

}  // namespace
