// Numbers that stand for objects where a C program holds them.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

namespace hvi::detail {

/// Objects under numbers. A number that was never given out, or whose object is gone, finds
/// nothing. A pointer in its place could not be checked: it might point to memory of something
/// else. Looking up takes no lock. NOTE: an object may not be removed while another thread uses it.
template <class Object>
class Handles {
public:
    using Number = std::uintptr_t;

    Handles() = default;
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    ~Handles() {
        for (std::size_t i = 0; i < count_; ++i) { delete slot(i).object; }
        for (std::atomic<Slot*>& block : blocks_) { delete[] block.load(); }
    }

    /// Adds an object. Returns its number, which is not 0, or 0 where there are too many objects.
    /// Throws std::bad_alloc.
    [[nodiscard]] Number add(std::unique_ptr<Object> object) {
        const std::lock_guard lock(mutex_);
        const std::size_t index = free_ != none ? free_ : count_;
        if (index == most) { return 0; }
        if (index == count_) { begin_block(index); }
        Slot& to = slot(index);
        if (index == count_) {
            ++count_;
        } else {
            free_ = to.next_free;
        }
        // NOTE: the lower part of the number is the slot, the rest tells objects of one slot apart.
        to.uses = (to.uses + 1) % most_uses;
        to.object = object.release();
        const Number number = (to.uses + 1) << bits | index;
        to.number.store(number, std::memory_order_release);
        return number;
    }

    [[nodiscard]] Object* find(Number number) const {
        const std::size_t index = number & (most - 1);
        const Slot* const block = blocks_[index / block_size].load(std::memory_order_acquire);
        if (block == nullptr || number == 0) { return nullptr; }
        const Slot& at = block[index % block_size];
        return at.number.load(std::memory_order_acquire) == number ? at.object : nullptr;
    }

    /// Removes an object; empty where the number has none.
    [[nodiscard]] std::unique_ptr<Object> remove(Number number) {
        const std::lock_guard lock(mutex_);
        if (find(number) == nullptr) { return nullptr; }
        const std::size_t index = number & (most - 1);
        Slot& from = slot(index);
        from.number.store(0, std::memory_order_release);
        from.next_free = free_;
        free_ = index;
        return std::unique_ptr<Object>(std::exchange(from.object, nullptr));
    }

private:
    static constexpr std::size_t bits = sizeof(Number) >= 8 ? 24 : 16;  // bits of the slot
    static constexpr std::size_t most = std::size_t(1) << bits;
    static constexpr std::size_t block_size = std::size_t(1) << bits / 2;
    static constexpr Number most_uses = ~Number(0) >> bits;
    static constexpr std::size_t none = most;

    struct Slot {
        std::atomic<Number> number{0};  ///< number of the object; 0 where there is none
        Object* object = nullptr;
        Number uses = 0;
        std::size_t next_free = none;
    };

    [[nodiscard]] Slot& slot(std::size_t index) {
        return blocks_[index / block_size].load()[index % block_size];
    }

    void begin_block(std::size_t index) {
        std::atomic<Slot*>& block = blocks_[index / block_size];
        if (block == nullptr) { block.store(new Slot[block_size], std::memory_order_release); }
    }

    std::mutex mutex_;
    std::atomic<Slot*> blocks_[most / block_size] = {};
    std::size_t count_ = 0;    // number of slots that were ever used
    std::size_t free_ = none;  // first slot without an object
};

}  // namespace hvi::detail
