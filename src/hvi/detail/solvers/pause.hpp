// Pauses after a failure.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi::detail {

/// Number of steps for which a failed way is not tried again: `shortest`, then twice, four times,
/// ... as many, up to 64, while it goes on to fail.
template <int shortest>
class Pause {
public:
    [[nodiscard]] bool is_over() const { return left_ == 0; }
    /// Counts a step at its beginning.
    void pass() { left_ -= left_ > 0 ? 1 : 0; }
    void begin() {
        left_ = next_ + 1;  // one more, for the pass() of the next step
        next_ = next_ < longest ? 2 * next_ : next_;
    }
    void forget() { *this = Pause(); }

private:
    static constexpr int longest = 64;
    int left_ = 0, next_ = shortest;
};

}  // namespace hvi::detail
