// C functions of a module, as static members of a class.
// SPDX-License-Identifier: MIT
//
// `Problem` is as in instance.hpp, with more static members: coordinates(parameters),
// momenta(parameters), names_of_parameters(parameters) and invariants(), all NamedNumbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <hvi/detail/module/answer.hpp>
#include <hvi/detail/module/columns.hpp>
#include <hvi/detail/module/handles.hpp>
#include <hvi/detail/module/instance.hpp>
#include <hvi/integrate.hpp>

namespace hvi::detail {

/// Version of the C interface. It changes with the functions and their arguments.
inline constexpr int abi_version = 1;

/// A table that integrate() fills.
struct FilledTable {
    std::size_t every;    ///< number of steps for each row
    const char* columns;  ///< names between commas; null for all columns
    double* buffer;       ///< null for no table
    std::size_t rows;     ///< number of rows that fit
    std::size_t* written;
};

/// Kinds of names.
enum class NameKind { parameter, coordinate, momentum, invariant };

/// Steppers of one class under handles. C programs see a handle as a pointer to `Opaque`. No
/// function throws.
template <class Problem, class Opaque>
class Face {
public:
    using Parameters = typename Problem::Stepper::Parameters;

    /// Creates a stepper. `message` is null, or room for `room` characters of an error in words.
    static int create(const char* directory, unsigned threads, const double* values,
                      std::size_t count, Opaque** handle, char* message,
                      std::size_t room) noexcept {
        std::string unreadable;
        const int status = guarded(
            [&] {
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
                auto made = std::make_unique<Of>(std::move(parameters), threads);
                if (made->coordinates() == 0) { return Answer::wrong_size; }
                return give(std::move(made), handle);
            },
            &unreadable);
        if (status != 0 && message != nullptr && room != 0) {
            const std::string_view text =
                unreadable.empty() ? text_of_answer(status) : std::string_view(unreadable);
            const std::size_t size = std::min(text.size(), room - 1);
            *std::copy_n(text.begin(), size, message) = '\0';
        }
        return status;
    }

    static int destroy(Opaque* handle) noexcept {
        return guarded(
            [&] { return instances().remove(number(handle)) ? Answer::ok : Answer::no_handle; });
    }

    static int copy(const Opaque* handle, Opaque** copied) noexcept {
        return with(handle, [&](const Of& of) {
            if (copied == nullptr) { return Answer::null_pointer; }
            return give(std::make_unique<Of>(of), copied);
        });
    }

    static int reset(Opaque* handle) noexcept {
        return with(handle, [](Of& of) {
            of.reset();
            return Answer::ok;
        });
    }

    static int counts(const Opaque* handle, std::int64_t* steps, std::int64_t* iterations,
                      std::int64_t* evaluations) noexcept {
        return with(handle, [&](const Of& of) {
            if (steps != nullptr) { *steps = of.steps(); }
            if (iterations != nullptr) { *iterations = of.iterations(); }
            if (evaluations != nullptr) { *evaluations = of.stepper().evaluations(); }
            return Answer::ok;
        });
    }

    // ---- what there is ----

    static std::size_t dof(const Opaque* handle) noexcept {
        const Of* const of = instances().find(number(handle));
        return of == nullptr ? 0 : of->momenta();
    }

    static std::size_t size(const Opaque* handle) noexcept {
        const Of* const of = instances().find(number(handle));
        return of == nullptr ? 0 : of->size();
    }

    static std::size_t count(int kind) noexcept {
        std::size_t result = 0;
        with_names(kind, nullptr, [&](const auto& names) { result = names.size(); });
        return result;
    }

    static const char* name(int kind, std::size_t index) noexcept {
        const char* result = nullptr;
        with_names(kind, nullptr, [&](const auto& names) {
            if (index < names.size()) { result = names[index].name; }
        });
        return result;
    }

    static std::size_t size_of_name(const Opaque* handle, int kind, std::size_t index) noexcept {
        const Of* const of = instances().find(number(handle));
        std::size_t result = 0;
        if (of == nullptr) { return 0; }
        with_names(kind, &of->parameters(), [&](const auto& names) {
            if (index < names.size()) { result = names[index].size(); }
        });
        return result;
    }

    // ---- steps ----

    static int initial(const Opaque* handle, double* state) noexcept {
        return with(handle, [&](const Of& of) {
            if (state == nullptr) { return Answer::null_pointer; }
            of.begin(state);
            return Answer::ok;
        });
    }

    static int step(Opaque* handle, double* state, double h) noexcept {
        return with(handle, [&](Of& of) {
            if (state == nullptr) { return number_of(Answer::null_pointer); }
            of.read(state);
            const Run run = of.take_one(h);
            of.write(state);
            return number_of(run.status.code());
        });
    }

    static int integrate(Opaque* handle, double* state, double t, double h, std::size_t steps,
                         const FilledTable& table) noexcept {
        if (table.written != nullptr) { *table.written = 0; }
        return with(handle, [&](Of& of) {
            if (state == nullptr) { return number_of(Answer::null_pointer); }
            std::vector<std::size_t> columns;
            if (const Answer wrong = check(of, steps, table, columns); wrong != Answer::ok) {
                return number_of(wrong);
            }
            of.read(state);
            const Status status = integrate(of, t, h, steps, table, columns);
            of.write(state);
            return number_of(status.code());
        });
    }

    // ---- values of a state ----

    static int energy(const Opaque* handle, const double* state, double* value) noexcept {
        return at(handle, state, value, [&](const auto& stepper, const auto& x) {
            *value = static_cast<double>(stepper.energy(x));
        });
    }

    static int invariants(const Opaque* handle, const double* state, double* values) noexcept {
        return at(handle, state, values,
                  [&](const auto& stepper, const auto& x) { Problem::values(stepper, x, values); });
    }

private:
    using Of = Instance<Problem>;

    /// Returns the handles. NOTE: they are the only global data of a module.
    static Handles<Of>& instances() {
        static Handles<Of> all;
        return all;
    }

    static std::uintptr_t number(const Opaque* handle) {
        return reinterpret_cast<std::uintptr_t>(handle);
    }
    static constexpr int number_of(Answer answer) { return static_cast<int>(answer); }
    static constexpr int number_of(Status::Code code) { return detail::number_of(code); }

    static Answer give(std::unique_ptr<Of> made, Opaque** handle) {
        const std::uintptr_t number = instances().add(std::move(made));
        if (number == 0) { return Answer::too_many; }
        *handle = reinterpret_cast<Opaque*>(number);
        return Answer::ok;
    }

    /// Returns the result of f(), or a code for its exception. NOTE: readers of files throw
    /// std::runtime_error with a message about the file.
    template <class F>
    static int guarded(F&& f, std::string* unreadable = nullptr) noexcept {
        try {
            return static_cast<int>(f());
        } catch (const std::bad_alloc&) {
            return number_of(Answer::out_of_memory);
        } catch (const std::length_error&) {
            return number_of(Answer::out_of_memory);
        } catch (const std::runtime_error& error) {
            if (unreadable != nullptr) { keep(error.what(), *unreadable); }
            return number_of(Answer::unreadable_file);
        } catch (...) { return number_of(Answer::failed); }
    }

    /// Keeps a text, or loses it where there is no memory.
    static void keep(const char* text, std::string& to) noexcept {
        try {
            to = text;
        } catch (...) {}
    }

    /// Returns the result of f(instance).
    template <class Pointer, class F>
    static int with(Pointer* handle, F&& f) noexcept {
        using Found = std::conditional_t<std::is_const_v<Pointer>, const Of, Of>;
        return guarded([&]() -> int {
            Found* const of = instances().find(number(handle));
            return of == nullptr ? number_of(Answer::no_handle) : static_cast<int>(f(*of));
        });
    }

    /// Calls f(stepper, x) for a state.
    template <class F>
    static int at(const Opaque* handle, const double* state, const double* out, F&& f) noexcept {
        return with(handle, [&](const Of& of) {
            if (state == nullptr || out == nullptr) { return Answer::null_pointer; }
            of.at(state, f);
            return Answer::ok;
        });
    }

    /// Calls f(names) with names of a kind; `of` is null for the parameters of the scene.
    template <class F>
    static void with_names(int kind, const Parameters* of, F&& f) noexcept {
        try {
            if (of == nullptr) {
                const Parameters usual{};
                return with_names(kind, &usual, f);
            }
            switch (static_cast<NameKind>(kind)) {
            case NameKind::parameter: return f(Problem::names_of_parameters(*of));
            case NameKind::coordinate: return f(Problem::coordinates(*of));
            case NameKind::momentum: return f(Problem::momenta(*of));
            case NameKind::invariant: return f(Problem::invariants());
            }
        } catch (...) {}
    }

    // ---- tables ----

    static Answer check(const Of& of, std::size_t steps, const FilledTable& table,
                        std::vector<std::size_t>& columns) {
        if (table.buffer == nullptr) { return Answer::ok; }
        if (table.written == nullptr) { return Answer::null_pointer; }
        if (table.every == 0) { return Answer::no_rows; }
        if (table.rows < steps / table.every) { return Answer::too_few_rows; }
        return choose(of, table.columns, columns) ? Answer::ok : Answer::unknown_column;
    }

    static bool choose(const Of& of, const char* list, std::vector<std::size_t>& columns) {
        std::vector<NamedNumbers> names = Problem::coordinates(of.parameters());
        for (const NamedNumbers& each : Problem::momenta(of.parameters())) {
            names.push_back(each);
        }
        for (const NamedNumbers& each : Problem::invariants()) { names.push_back(each); }
        names.push_back({"energy"});
        ChosenColumns chosen(names);
        if (list == nullptr) {
            chosen.add_range(0, 1 + of.coordinates() + of.momenta());
        } else if (!chosen.choose(list)) {
            return false;
        }
        columns = chosen.numbers();
        return true;
    }

    /// Takes steps until one fails, and writes the rows of the table.
    static Status integrate(Of& of, double t, double h, std::size_t steps, const FilledTable& table,
                            const std::vector<std::size_t>& columns) {
        const std::size_t every = table.buffer == nullptr ? steps : table.every;
        Row row(columns);
        double* to = table.buffer;
        for (std::size_t taken = 0; taken < steps;) {
            const std::size_t ahead = std::min(every - taken % every, steps - taken);
            const Run run = of.take(h, static_cast<std::int64_t>(ahead));
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

        double* write(const Of& of, double t, double* out) {
            const std::size_t variables = of.coordinates() + of.momenta();
            constexpr std::size_t values = Problem::invariant_count;
            all_.resize(1 + of.size() + values + 1);
            of.write(all_.data() + 1);
            all_[0] = Of::has_time ? all_[1 + variables] : t;
            double* const after = all_.data() + 1 + variables;
            const auto is_value = [&](std::size_t number) { return number > variables; };
            if (std::any_of(columns_.begin(), columns_.end(), is_value)) {
                Problem::values(of.stepper(), of.state(), after);
                after[values] = static_cast<double>(of.stepper().energy(of.state()));
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
