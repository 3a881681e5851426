// What the C functions of a module do.
// SPDX-License-Identifier: MIT
//
// `Problem` names its Stepper and has static members: stepper(parameters, threads), which makes
// one; parameters(directory), the defaults; set(parameters, reader); coordinates(parameters),
// momenta(parameters) and names_of_parameters(parameters), as NamedNumbers; invariants, their
// names; values(stepper, x, out), which writes them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <hvi/detail/module/answer.hpp>
#include <hvi/detail/module/columns.hpp>
#include <hvi/detail/module/handles.hpp>
#include <hvi/detail/module/parameters.hpp>
#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/detail/trajectories/take.hpp>
#include <hvi/integrate.hpp>

namespace hvi::detail {

/// Version of the C interface: it changes where a function does, or what one expects.
inline constexpr int abi_version = 1;

template <class Stepper, class = void>
struct HasStart : std::false_type {};
template <class Stepper>
struct HasStart<Stepper, std::void_t<decltype(Stepper::initial(
                             std::declval<const typename Stepper::Parameters&>()))>>
    : std::true_type {};

template <class State, class = void>
struct HasTime : std::false_type {};
template <class State>
struct HasTime<State, std::void_t<decltype(std::declval<State&>().t)>> : std::true_type {};

/// A table that integrate() fills.
struct FilledTable {
    std::size_t every;    ///< steps to a row
    const char* columns;  ///< their names between commas; null for all
    double* buffer;       ///< null for no table
    std::size_t rows;     ///< that it has
    std::size_t* written;
};

/// Kinds of names.
enum class NameKind { parameter, coordinate, momentum, invariant };

/// Steppers of one class under handles. `Opaque` is what C programs take the handle for. No
/// function throws.
template <class Problem, class Opaque>
class Face {
public:
    using Stepper = typename Problem::Stepper;
    using State = typename Stepper::State;
    using Parameters = typename Stepper::Parameters;

    static int create(const char* directory, unsigned threads, const double* values,
                      std::size_t count, Opaque** handle) noexcept {
        return guarded([&] {
            if (handle == nullptr || (values == nullptr && count != 0)) {
                return Answer::null_pointer;
            }
            Parameters parameters = Problem::parameters(directory);
            if (count != 0) {
                ParameterReader reader(values, count);
                Problem::set(parameters, reader);
                if (!reader.are_right()) { return Answer::wrong_parameter; }
                if (!reader.is_count_right()) { return Answer::wrong_count; }
            }
            auto made = std::make_unique<Instance>(std::move(parameters), threads);
            if (made->size_of_q() == 0) { return Answer::wrong_size; }
            return give(std::move(made), handle);
        });
    }

    static int destroy(Opaque* handle) noexcept {
        return guarded(
            [&] { return instances().remove(number(handle)) ? Answer::ok : Answer::no_handle; });
    }

    static int copy(const Opaque* handle, Opaque** copied) noexcept {
        return with(handle, [&](const Instance& of) {
            if (copied == nullptr) { return Answer::null_pointer; }
            return give(std::make_unique<Instance>(of), copied);
        });
    }

    static int reset(Opaque* handle) noexcept {
        return with(handle, [](Instance& of) {
            of.stepper.reset();
            return Answer::ok;
        });
    }

    static int counts(const Opaque* handle, std::int64_t* steps, std::int64_t* iterations,
                      std::int64_t* evaluations) noexcept {
        return with(handle, [&](const Instance& of) {
            if (steps != nullptr) { *steps = of.steps; }
            if (iterations != nullptr) { *iterations = of.iterations; }
            if (evaluations != nullptr) { *evaluations = of.stepper.evaluations(); }
            return Answer::ok;
        });
    }

    // ---- what there is ----

    static std::size_t dof(const Opaque* handle) noexcept {
        const Instance* const of = instances().find(number(handle));
        return of == nullptr ? 0 : flat<Stepper>(of->x).p.size();
    }

    static std::size_t size(const Opaque* handle) noexcept {
        const Instance* const of = instances().find(number(handle));
        return of == nullptr ? 0 : of->size();
    }

    static std::size_t count(int kind) noexcept {
        std::size_t result = 0;
        with_names(kind, Parameters{}, [&](const auto& names) { result = names.size(); });
        return result;
    }

    static const char* name(int kind, std::size_t index) noexcept {
        const char* result = nullptr;
        with_names(kind, Parameters{}, [&](const auto& names) {
            if (index < names.size()) { result = names[index].name; }
        });
        return result;
    }

    static std::size_t size_of_name(const Opaque* handle, int kind, std::size_t index) noexcept {
        const Instance* const of = instances().find(number(handle));
        std::size_t result = 0;
        if (of == nullptr) { return 0; }
        with_names(kind, of->parameters, [&](const auto& names) {
            if (index < names.size()) { result = names[index].size(); }
        });
        return result;
    }

    // ---- steps ----

    static int initial(const Opaque* handle, double* state) noexcept {
        return with(handle, [&](const Instance& of) {
            if (state == nullptr) { return Answer::null_pointer; }
            if constexpr (HasStart<Stepper>::value) {
                write(Stepper::initial(of.parameters), state);
                return Answer::ok;
            } else {
                return Answer::no_start;
            }
        });
    }

    static int step(Opaque* handle, double* state, double h) noexcept {
        return with(handle, [&](Instance& of) {
            if (state == nullptr) { return number_of(Answer::null_pointer); }
            read(state, of.x);
            const Status status = of.stepper.step(of.x, static_cast<Scalar>(h));
            of.iterations += status.iterations;
            if (!status.ok()) { return number_of(status.code()); }
            ++of.steps;
            write(of.x, state);
            return 0;
        });
    }

    static int integrate(Opaque* handle, double* state, double t, double h, std::size_t steps,
                         const FilledTable& table) noexcept {
        if (table.written != nullptr) { *table.written = 0; }
        return with(handle, [&](Instance& of) {
            if (state == nullptr) { return number_of(Answer::null_pointer); }
            std::vector<std::size_t> columns;
            if (const Answer wrong = check(of, steps, table, columns); wrong != Answer::ok) {
                return number_of(wrong);
            }
            read(state, of.x);
            const Status status = integrate(of, t, h, steps, table, columns);
            write(of.x, state);
            return number_of(status.code());
        });
    }

    // ---- values of a state ----

    static int energy(const Opaque* handle, const double* state, double* value) noexcept {
        return at(handle, state, value, [&](const Instance& of, const State& x) {
            *value = static_cast<double>(of.stepper.energy(x));
        });
    }

    static int invariants(const Opaque* handle, const double* state, double* values) noexcept {
        return at(handle, state, values, [&](const Instance& of, const State& x) {
            Problem::values(of.stepper, x, values);
        });
    }

private:
    using Scalar = typename Stepper::Scalar;

    struct Instance {
        Instance(Parameters values, unsigned threads)
            : parameters(std::move(values)), stepper(Problem::stepper(parameters, threads)) {
            if constexpr (HasStart<Stepper>::value) { x = Stepper::initial(parameters); }
        }

        [[nodiscard]] std::size_t size_of_q() const { return flat<Stepper>(x).q.size(); }
        [[nodiscard]] std::size_t size() const {
            const auto& all = flat<Stepper>(x);
            return all.q.size() + all.p.size() + (HasTime<State>::value ? 1 : 0);
        }

        Parameters parameters;
        Stepper stepper;
        State x{};  ///< of the system's size, for steps
        std::int64_t steps = 0, iterations = 0;
    };

    /// NOTE: the only data of a module outside of handles: which handles there are.
    static Handles<Instance>& instances() {
        static Handles<Instance> all;
        return all;
    }

    static std::uintptr_t number(const Opaque* handle) {
        return reinterpret_cast<std::uintptr_t>(handle);
    }
    static constexpr int number_of(Answer answer) { return static_cast<int>(answer); }
    static constexpr int number_of(Status::Code code) { return detail::number_of(code); }

    static Answer give(std::unique_ptr<Instance> made, Opaque** handle) {
        const std::uintptr_t number = instances().add(std::move(made));
        if (number == 0) { return Answer::too_many; }
        *handle = reinterpret_cast<Opaque*>(number);
        return Answer::ok;
    }

    /// The result of f(), or what became of it where that throws. NOTE: readers of files throw
    /// std::runtime_error.
    template <class F>
    static int guarded(F&& f) noexcept {
        try {
            return static_cast<int>(f());
        } catch (const std::bad_alloc&) {
            return number_of(Answer::out_of_memory);
        } catch (const std::length_error&) {
            return number_of(Answer::out_of_memory);
        } catch (const std::runtime_error&) {
            return number_of(Answer::unreadable_file);
        } catch (...) { return number_of(Answer::failed); }
    }

    /// The result of f(instance).
    template <class Pointer, class F>
    static int with(Pointer* handle, F&& f) noexcept {
        using Of = std::conditional_t<std::is_const_v<Pointer>, const Instance, Instance>;
        return guarded([&]() -> int {
            Of* const of = instances().find(number(handle));
            return of == nullptr ? number_of(Answer::no_handle) : static_cast<int>(f(*of));
        });
    }

    /// Calls f(instance, x) for a state. NOTE: x is not that of the instance, so that several
    /// threads may ask for values at once.
    template <class F>
    static int at(const Opaque* handle, const double* state, const double* out, F&& f) noexcept {
        return with(handle, [&](const Instance& of) {
            if (state == nullptr || out == nullptr) { return Answer::null_pointer; }
            State x = of.x;
            read(state, x);
            f(of, x);
            return Answer::ok;
        });
    }

    template <class F>
    static void with_names(int kind, const Parameters& parameters, F&& f) noexcept {
        try {
            switch (static_cast<NameKind>(kind)) {
            case NameKind::parameter: return f(Problem::names_of_parameters(parameters));
            case NameKind::coordinate: return f(Problem::coordinates(parameters));
            case NameKind::momentum: return f(Problem::momenta(parameters));
            case NameKind::invariant: return f(Problem::invariants());
            }
        } catch (...) {}
    }

    static void read(const double* state, State& x) {
        const double* const end = read_numbers<Stepper>(x, state);
        if constexpr (HasTime<State>::value) { x.t = *end; }
    }

    static void write(const State& x, double* state) {
        double* const end = write_numbers<Stepper>(x, state);
        if constexpr (HasTime<State>::value) { *end = static_cast<double>(x.t); }
    }

    // ---- tables ----

    static Answer check(const Instance& of, std::size_t steps, const FilledTable& table,
                        std::vector<std::size_t>& columns) {
        if (table.buffer == nullptr) { return Answer::ok; }
        if (table.written == nullptr) { return Answer::null_pointer; }
        if (table.every == 0) { return Answer::no_rows; }
        if (table.rows < steps / table.every) { return Answer::too_few_rows; }
        return choose(of, table.columns, columns) ? Answer::ok : Answer::unknown_column;
    }

    static bool choose(const Instance& of, const char* list, std::vector<std::size_t>& columns) {
        std::vector<NamedNumbers> names = Problem::coordinates(of.parameters);
        for (const NamedNumbers& each : Problem::momenta(of.parameters)) { names.push_back(each); }
        for (const NamedNumbers& each : Problem::invariants()) { names.push_back(each); }
        names.push_back({"energy"});
        ChosenColumns chosen(names);
        if (list == nullptr) {
            const auto& all = flat<Stepper>(of.x);
            chosen.add_range(0, 1 + all.q.size() + all.p.size());
        } else if (!chosen.choose(list)) {
            return false;
        }
        columns = chosen.numbers();
        return true;
    }

    /// Steps until one fails, and the rows that these make.
    static Status integrate(Instance& of, double t, double h, std::size_t steps,
                            const FilledTable& table, const std::vector<std::size_t>& columns) {
        const std::size_t every = table.buffer == nullptr ? steps : table.every;
        Row row(columns);
        double* to = table.buffer;
        for (std::size_t taken = 0; taken < steps;) {
            const std::size_t ahead = std::min(every - taken % every, steps - taken);
            const Run run =
                take(of.stepper, of.x, static_cast<Scalar>(h), static_cast<std::int64_t>(ahead));
            of.steps += run.steps;
            of.iterations += run.iterations;
            if (!run.ok()) { return run.status; }
            taken += ahead;
            if (to == nullptr || taken % every != 0) { continue; }
            to = row.write(of, t + static_cast<double>(taken) * h, to);
            ++*table.written;
        }
        return {};
    }

    /// Writes rows of a table.
    class Row {
    public:
        explicit Row(const std::vector<std::size_t>& columns) : columns_(columns) {}

        double* write(const Instance& of, double t, double* out) {
            all_.resize(2 + of.size() + Problem::invariants().size());
            double* const end = write_numbers<Stepper>(of.x, all_.data() + 1);
            all_[0] = t;
            if constexpr (HasTime<State>::value) { all_[0] = static_cast<double>(of.x.t); }
            const std::size_t variables = static_cast<std::size_t>(end - all_.data());
            const auto is_value = [&](std::size_t number) { return number >= variables; };
            if (std::any_of(columns_.begin(), columns_.end(), is_value)) {
                Problem::values(of.stepper, of.x, end);
                *(end + Problem::invariants().size()) =
                    static_cast<double>(of.stepper.energy(of.x));
            }
            for (const std::size_t number : columns_) { *out++ = all_[number]; }
            return out;
        }

    private:
        const std::vector<std::size_t>& columns_;
        std::vector<double> all_;  // the time, variables, invariants, the energy
    };
};

}  // namespace hvi::detail
