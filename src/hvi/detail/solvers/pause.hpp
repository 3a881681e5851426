// How long what has failed is not tried again.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi::detail {

/// For how many steps what has failed is not tried again: `shortest` and twice, four times, ... 64
/// as it goes on to fail.
template <int shortest>
class Pause {
public:
    [[nodiscard]] bool is_over() const { return left_ == 0; }
    /// At the beginning of a step.
    void pass() { left_ -= left_ > 0 ? 1 : 0; }
    void begin() {
        left_ = next_ + 1;  // with the pass() of the step to come
        next_ = next_ < longest ? 2 * next_ : next_;
    }
    void forget() { *this = Pause(); }

private:
    static constexpr int longest = 64;
    int left_ = 0, next_ = shortest;
};

}  // namespace hvi::detail
