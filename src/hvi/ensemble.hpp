// Many trajectories of one scene, with the same parameters and steps, on all processors.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <hvi/detail/trajectories/trajectories.hpp>

namespace hvi {

/// `Stepper` is a class that `hvi-gen stepper --lanes ensemble` has written. Each trajectory ends
/// with the same bits whatever the others are, where it stands among them, and on however many
/// threads. One of which a step fails keeps the state before that step, and the others go on.
/// # Use
/// All trajectories have the same parameters, h and number of steps; h is a time in the units of H
/// and may be negative. Precondition of state(i), status(i) and steps(i): i < size(). A step that
/// fails throws nothing: ok() and status(i) tell of it. With -pthread and the header of
///
///     hvi-gen stepper --method stormer-verlet pendulum --lanes ensemble -o pendulums.hpp
///
/// this is a program:
/// ```cpp
/// #include <cmath>
/// #include <cstddef>
/// #include <vector>
///
/// #include <hvi/ensemble.hpp>
/// #include <pendulums.hpp>
///
/// using Pendulum = hvi::generated::PendulumStormerVerlet;  // H = p^2/2 - cos(q)
///
/// double energy(const Pendulum::Trajectory& x) { return x.p[0] * x.p[0] / 2 - std::cos(x.q[0]); }
///
/// int main() {
///     std::vector<Pendulum::Trajectory> starts(20);
///     double angle = 0;
///     for (Pendulum::Trajectory& x : starts) { x.q[0] = angle += 0.1; }
///     starts[7].p[0] = std::nan("");
///     hvi::Ensemble<Pendulum> swings(starts);
///     const double h = 0.05;
///     swings.advance(h, 1000);
///
///     for (std::size_t i = 0; i < swings.size(); ++i) {
///         if (i == 7) { continue; }
///         // The method conserves H + h^2 (p^2 cos(q)/12 - sin(q)^2/24) up to h^4, and |p| <= 2.
///         const double error = energy(swings.state(i)) - energy(starts[i]);
///         if (swings.steps(i) != 1000 || std::abs(error) > h * h) { return 1; }
///     }
///     const bool has_stopped = swings.status(7).code() == hvi::Status::Code::not_finite;
///     return has_stopped && swings.steps(7) == 0 && !swings.ok() ? 0 : 1;
/// }
/// ```
template <class Stepper>
class Ensemble {
public:
    using Trajectory = typename Stepper::Trajectory;
    using Parameters = typename Stepper::Parameters;
    using Scalar = typename Stepper::Scalar;

    /// One trajectory from each of these states.
    explicit Ensemble(const std::vector<Trajectory>& starts, const Parameters& parameters = {})
        : stepper_(parameters), size_(starts.size()), groups_((size_ + width - 1) / width) {
        // NOTE: where places are left over in the last group there are copies, in which nothing can
        // happen that does not happen to the last trajectory.
        for (std::size_t i = 0; i < groups_.size() * width; ++i) {
            groups_[i / width].x.set(i % width, starts[std::min(i, size_ - 1)]);
        }
    }

    [[nodiscard]] std::size_t size() const { return size_; }

    /// Takes each trajectory so many steps of size h further, on so many threads; 0: as many as
    /// there are processors. Each group of eight takes all its steps at once, as long as it is in
    /// the nearest cache.
    ///
    /// What a step throws, std::bad_alloc or std::system_error comes out when all threads have
    /// ended, the first of them; of the groups then some have been advanced, and some not.
    void advance(Scalar h, std::int64_t steps, unsigned threads = 0) {
        if (threads == 0) { threads = std::max(1U, std::thread::hardware_concurrency()); }
        std::atomic<std::size_t> next{0};
        Failure failure;
        const auto work = [&] {
            try {
                Stepper stepper = stepper_;
                for (std::size_t i = next++; i < groups_.size(); i = next++) {
                    advance(stepper, groups_[i], h, steps);
                }
            } catch (...) {
                next = groups_.size();
                failure.keep(std::current_exception());
            }
        };
        {
            Joined others;
            try {
                others.start(std::min<std::size_t>(threads, groups_.size()), work);
            } catch (...) { failure.keep(std::current_exception()); }
            work();
        }
        failure.rethrow();
    }

    [[nodiscard]] Trajectory state(std::size_t i) const { return group(i).x[i % width]; }

    /// What became of the last step of trajectory i.
    [[nodiscard]] Status status(std::size_t i) const { return group(i).x.status()[i % width]; }

    /// How many steps it has taken.
    [[nodiscard]] std::int64_t steps(std::size_t i) const { return group(i).steps[i % width]; }

    /// Whether no step of any trajectory has failed.
    [[nodiscard]] bool ok() const {
        return std::all_of(groups_.begin(), groups_.end(),
                           [](const Group& group) { return group.x.status().ok(); });
    }

    /// Its energy and invariants, of a state, are members where they were asked for.
    [[nodiscard]] const Stepper& stepper() const { return stepper_; }

private:
    static constexpr std::size_t width = trajectories_at_once;
    using Steps = std::array<std::int64_t, width>;

    /// Trajectories that go side by side.
    struct Group {
        typename Stepper::State x;
        Steps steps{};
    };

    /// The first one of several threads.
    class Failure {
    public:
        void keep(std::exception_ptr exception) {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!first_) { first_ = std::move(exception); }
        }

        void rethrow() const {
            if (first_) { std::rethrow_exception(first_); }
        }

    private:
        std::mutex mutex_;
        std::exception_ptr first_;
    };

    /// Threads beside this one, that end before it goes on.
    class Joined {
    public:
        template <class Work>
        void start(std::size_t threads, const Work& work) {
            for (std::size_t i = 1; i < threads; ++i) { threads_.emplace_back(work); }
        }

        Joined() = default;
        Joined(const Joined&) = delete;
        Joined& operator=(const Joined&) = delete;
        ~Joined() {
            for (std::thread& thread : threads_) { thread.join(); }
        }

    private:
        std::vector<std::thread> threads_;
    };

    /// NOTE: on a copy, which no other thread sees, so that compilers keep it in registers. And
    /// what the stepper remembers of another group is forgotten first.
    static void advance(Stepper& stepper, Group& group, Scalar h, std::int64_t steps) {
        typename Stepper::State x = group.x;
        stepper.reset();
        Going going(x.status());
        std::int64_t step = 0;
        for (; step < steps && going.any; ++step) {
            if (!stepper.step(x, h).ok()) { going.update(x.status(), step, group.steps); }
        }
        going.end(step, group.steps);
        group.x = x;
    }

    /// The lanes that have not stopped, where the steps of each are counted.
    struct Going {
        std::array<bool, width> lanes{};
        bool any = false;

        explicit Going(const LaneStatus& status) {
            for (std::size_t lane = 0; lane < width; ++lane) {
                lanes[lane] = status[lane].ok();
                any = any || lanes[lane];
            }
        }

        void update(const LaneStatus& status, std::int64_t step, Steps& steps) {
            const Going before = *this;
            *this = Going(status);
            for (std::size_t lane = 0; lane < width; ++lane) {
                if (before.lanes[lane] && !lanes[lane]) { steps[lane] += step; }
            }
        }

        void end(std::int64_t step, Steps& steps) const {
            for (std::size_t lane = 0; lane < width; ++lane) {
                if (lanes[lane]) { steps[lane] += step; }
            }
        }
    };

    [[nodiscard]] const Group& group(std::size_t i) const { return groups_[i / width]; }

    Stepper stepper_;
    std::size_t size_;
    std::vector<Group> groups_;
};

}  // namespace hvi
