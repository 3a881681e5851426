// Trajectories of an ensemble, eight side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <hvi/detail/trajectories/courses.hpp>
#include <hvi/detail/trajectories/in_parallel.hpp>
#include <hvi/detail/trajectories/side_by_side.hpp>
#include <hvi/detail/trajectories/trajectories.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Trajectories in groups of eight, as `Stepper` advances them. On their way they stand beside any
/// others.
template <class Stepper>
class LaneGroups {
public:
    using Trajectory = typename Stepper::Trajectory;
    using Courses = detail::Courses<Stepper>;

    explicit LaneGroups(const std::vector<Trajectory>& starts)
        : groups_((starts.size() + width - 1) / width), steps_(starts.size()) {
        for (std::size_t i = 0; i < starts.size(); ++i) {
            groups_[i / width].set(i % width, starts[i]);
        }
    }

    /// Returns the number of pieces: a thread takes one at a time.
    [[nodiscard]] std::size_t pieces() const { return groups_.size(); }

    /// Takes the trajectories of these pieces through their courses, or up to where watch(i, x) of
    /// a trajectory is false.
    template <class Watch>
    void advance(Numbers& pieces, const Courses& courses, const Watch& watch) {
        Stepper stepper(courses.parameters(0));
        Going<Watch> going(*this, pieces, courses, watch);
        SideBySide<Stepper, Going<Watch>>(stepper, going).run();
    }

    [[nodiscard]] Trajectory state(std::size_t i) const { return group(i)[i % width]; }
    [[nodiscard]] Status status(std::size_t i) const { return group(i).status()[i % width]; }
    [[nodiscard]] std::int64_t steps(std::size_t i) const { return steps_[i]; }

    [[nodiscard]] bool ok() const {
        return std::all_of(groups_.begin(), groups_.end(),
                           [](const Group& group) { return group.status().ok(); });
    }

private:
    static constexpr std::size_t width = trajectories_at_once;
    using Group = typename Stepper::State;

    /// The source of the lanes of one thread; see SideBySide.
    template <class Watch>
    class Going {
    public:
        Going(LaneGroups& all, Numbers& pieces, const Courses& courses, const Watch& watch)
            : all_(all), pieces_(pieces), courses_(courses), watch_(watch) {}

        std::int64_t begin(std::size_t lane, Group& x, Stepper& stepper) {
            if (!find()) { return 0; }
            const std::size_t i = next_++;
            who_[lane] = i;
            is_watched_[lane] = true;
            x.take(lane, all_.group(i), i % width);
            if (courses_.has_own_parameters()) {
                stepper.set_parameters(lane, courses_.parameters(i));
            }
            stepper.set_step(lane, courses_.h(i));
            stepper.reset(lane);
            return courses_.steps(i);
        }

        [[nodiscard]] bool see(const Stepper&, [[maybe_unused]] const Group& x) {
            bool all_go_on = true;
            if constexpr (!std::is_same_v<Watch, NoWatch>) {
                for (std::size_t lane = 0; lane < width; ++lane) {
                    if (!is_watched_[lane] || !x.status()[lane].ok()) { continue; }
                    is_watched_[lane] = watch_(who_[lane], x[lane]);
                    all_go_on = all_go_on && is_watched_[lane];
                }
            }
            return all_go_on;
        }
        [[nodiscard]] bool ends(std::size_t lane) const { return !is_watched_[lane]; }
        static constexpr bool goes_on() { return true; }

        void end(std::size_t lane, const Group& x, std::int64_t steps) {
            const std::size_t i = who_[lane];
            is_watched_[lane] = false;
            all_.group(i).take(i % width, x, lane);
            all_.steps_[i] += steps;
        }

    private:
        /// Goes to the next trajectory that has steps to take. Returns whether there is one.
        bool find() {
            for (;; ++next_) {
                if (next_ == end_ && !find_piece()) { return false; }
                const bool is_ok = all_.group(next_).status()[next_ % width].ok();
                if (!is_ok || courses_.steps(next_) <= 0) { continue; }
                if (courses_.h(next_) != 0) { return true; }
                all_.steps_[next_] += courses_.steps(next_);
            }
        }

        bool find_piece() {
            std::size_t piece = 0;
            if (!pieces_.take(piece)) { return false; }
            next_ = piece * width;
            end_ = std::min(next_ + width, all_.steps_.size());
            return true;
        }

        LaneGroups& all_;
        Numbers& pieces_;
        const Courses& courses_;
        const Watch& watch_;
        std::array<std::size_t, width> who_{};
        std::array<bool, width> is_watched_{};  ///< whether its trajectory is to go on
        std::size_t next_ = 0, end_ = 0;        ///< trajectories of the piece
    };

    [[nodiscard]] const Group& group(std::size_t i) const { return groups_[i / width]; }
    [[nodiscard]] Group& group(std::size_t i) { return groups_[i / width]; }

    std::vector<Group> groups_;
    std::vector<std::int64_t> steps_;
};

}  // namespace hvi::detail
