// Numbers side by side: one operation computes them all.
// SPDX-License-Identifier: MIT
//
// double and float are computed in vectors of the processor, as wide as the compiler's options
// allow. Plain C++ computes the numbers one by one with a compiler that is not like g++, with
// -DHVI_NO_REGISTERS, and for other types of numbers. Both round differently in the last bits, and
// so do vectors of different width where a compiler fuses products and sums. Each build gives the
// same bits again.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <hvi/detail/lanes/registers.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi {
namespace detail {

/// Returns the number of places that hold `count` numbers: registers of 4 and 8 are filled.
[[nodiscard]] constexpr std::size_t places_for(std::size_t count) {
    return count <= 2 ? count : (count + 3) / 4 * 4;
}

/// Numbers in memory, one for each of `count` lanes. Places that are left over are zeros or copies
/// of the last lane, so that nothing can happen in them that does not happen in it.
template <class Number, std::size_t count>
struct LaneRow {
    static constexpr std::size_t places = places_for(count);
    static constexpr std::size_t alignment =
        register_width<Number, places>() == 1 ? alignof(Number) : 64;

    alignas(alignment) Number at[places];

    [[nodiscard]] static constexpr std::size_t size() { return count; }
    [[nodiscard]] constexpr Number& operator[](std::size_t lane) { return at[lane]; }
    [[nodiscard]] constexpr const Number& operator[](std::size_t lane) const { return at[lane]; }

    /// Sets a lane, and its copies.
    constexpr void set(std::size_t lane, const Number& x) {
        at[lane] = x;
        for (std::size_t i = count; lane == count - 1 && i < places; ++i) { at[i] = x; }
    }
};

}  // namespace detail

/// Booleans, one in each of the lanes and in the places that are left over.
template <class Part, std::size_t parts>
class LaneMask {
public:
    using Bits = typename detail::MaskOf<Part>::type;

    LaneMask() = default;

    /// Sets all lanes to x.
    explicit LaneMask(bool x) {
        for (Bits& bits : bits_) { bits = Bits(x); }
    }

    explicit LaneMask(const std::array<Bits, parts>& bits) : bits_(bits) {}

    [[nodiscard]] const Bits& operator[](std::size_t part) const { return bits_[part]; }

    [[nodiscard]] friend LaneMask operator&(const LaneMask& x, const LaneMask& y) {
        return join(
            x, y, [](const Bits& a, const Bits& b) -> Bits { return a && b; }, each{});
    }
    [[nodiscard]] friend LaneMask operator|(const LaneMask& x, const LaneMask& y) {
        return join(
            x, y, [](const Bits& a, const Bits& b) -> Bits { return a || b; }, each{});
    }
    [[nodiscard]] friend LaneMask operator!(const LaneMask& x) {
        return join(
            x, x, [](const Bits& a, const Bits&) -> Bits { return !a; }, each{});
    }

    [[nodiscard]] friend bool any(const LaneMask& x) {
        using detail::any;  // any() of registers is found by its argument
        return any(x.one_of(std::make_index_sequence<parts - 1>()));
    }
    [[nodiscard]] friend bool all(const LaneMask& x) {
        using detail::all;
        return all(x.each_of(std::make_index_sequence<parts - 1>()));
    }

private:
    using each = std::make_index_sequence<parts>;

    template <class F, std::size_t... i>
    [[nodiscard]] static LaneMask join(const LaneMask& x, const LaneMask& y, F f,
                                       std::index_sequence<i...>) {
        return LaneMask(std::array<Bits, parts>{f(x.bits_[i], y.bits_[i])...});
    }

    template <std::size_t... i>
    [[nodiscard]] Bits one_of(std::index_sequence<i...>) const {
        return (bits_[0] || ... || bits_[i + 1]);
    }

    template <std::size_t... i>
    [[nodiscard]] Bits each_of(std::index_sequence<i...>) const {
        return (bits_[0] && ... && bits_[i + 1]);
    }

    std::array<Bits, parts> bits_;
};

/// Holds `count` Numbers in registers.
///
/// NOTE: operations on each register are written out: in loops over several registers compilers
/// keep them in memory, below -O3. For the same reason Lanes serve to compute with, and LaneRow
/// serves to keep numbers: g++ copies an array of registers from memory to memory in halves, for
/// which the next load waits. Registers hold at most `most` numbers. NOTE: wide registers of
/// AVX-512 compute more at once, and each later: where an iteration waits for every sum, registers
/// of 4 are a fifth faster.
template <class Number, std::size_t count, std::size_t most = detail::widest>
class Lanes {
    static constexpr std::size_t places = detail::places_for(count);
    static constexpr std::size_t width = detail::register_width<Number, places, most>();
    static constexpr std::size_t parts = places / width;
    using Register = detail::Register<Number, width>;
    using Part = typename Register::Type;

public:
    using Row = detail::LaneRow<Number, count>;
    using Mask = LaneMask<Part, parts>;
    static constexpr std::size_t registers = parts;  ///< number of registers

    Lanes() = default;

    /// Sets all lanes to x.
    Lanes(const Number& x) : Lanes(spread(x, each{})) {}

    Lanes(const Row& row) : Lanes(load(row, each{})) {}

    void store(Row& row) const { store(row, each{}); }

    /// Loads `count` numbers from any address. Precondition: no places are left over.
    [[nodiscard]] static Lanes load(const Number* from) {
        static_assert(count == places, "registers are filled");
        return Lanes(load(from, each{}));
    }

    /// Stores `count` numbers to any address. Precondition: no places are left over.
    void store(Number* to) const {
        static_assert(count == places, "registers are filled");
        store(to, each{});
    }

    /// Returns f(x) in each lane, where f is a function of one register.
    template <class F>
    [[nodiscard, gnu::always_inline]] Lanes map(F f) const {
        return map(f, each{});
    }

    template <class F>
    [[nodiscard]] Lanes map(const Lanes& other, F f) const {
        return map(other, f, each{});
    }

    [[nodiscard]] friend Lanes operator-(const Lanes& x) {
        return x.map([](const Part& a) -> Part { return -a; });
    }
    [[nodiscard]] friend Lanes operator+(const Lanes& x, const Lanes& y) {
        return x.map(y, [](const Part& a, const Part& b) -> Part { return a + b; });
    }
    [[nodiscard]] friend Lanes operator-(const Lanes& x, const Lanes& y) {
        return x.map(y, [](const Part& a, const Part& b) -> Part { return a - b; });
    }
    [[nodiscard]] friend Lanes operator*(const Lanes& x, const Lanes& y) {
        return x.map(y, [](const Part& a, const Part& b) -> Part { return a * b; });
    }
    [[nodiscard]] friend Lanes operator/(const Lanes& x, const Lanes& y) {
        return x.map(y, [](const Part& a, const Part& b) -> Part { return a / b; });
    }

    Lanes& operator+=(const Lanes& other) { return *this = *this + other; }
    Lanes& operator-=(const Lanes& other) { return *this = *this - other; }

    [[nodiscard]] friend Lanes abs(const Lanes& x) {
        return x.map([](const Part& a) -> Part {
            using detail::abs;  // abs() of registers is found by its argument
            return abs(a);
        });
    }

    /// Returns the sum over all places, those that are left over included.
    [[nodiscard]] friend Number sum(const Lanes& x) { return Register::sum(x.total()); }

    /// Returns the sum over all places of each x.
    template <std::size_t n>
    [[nodiscard, gnu::always_inline]] static std::array<Number, n>
    sums(const std::array<Lanes, n>& x) {
        std::array<Number, n> result;
        for (std::size_t k = 0; k + 1 < n; k += 2) {
            const std::array<Number, 2> both = Register::sums(x[k].total(), x[k + 1].total());
            result[k] = both[0];
            result[k + 1] = both[1];
        }
        if constexpr (n % 2 == 1) { result[n - 1] = sum(x[n - 1]); }
        return result;
    }

    /// Returns the sum over the lanes alone.
    [[nodiscard]] friend Number sum_of_lanes(const Lanes& x) {
        if constexpr (count == places) {
            return sum(x);
        } else {
            Row row;
            x.store(row);
            Number total = row[0];
            for (std::size_t i = 1; i < count; ++i) { total = total + row[i]; }
            return total;
        }
    }

    // A comparison with a NaN is false in its lane.
    [[nodiscard]] friend Mask operator<(const Lanes& x, const Lanes& y) {
        return compare(
            x, y, [](const Part& a, const Part& b) { return a < b; }, each{});
    }
    [[nodiscard]] friend Mask operator<=(const Lanes& x, const Lanes& y) {
        return compare(
            x, y, [](const Part& a, const Part& b) { return a <= b; }, each{});
    }
    [[nodiscard]] friend Mask operator==(const Lanes& x, const Lanes& y) {
        return compare(
            x, y, [](const Part& a, const Part& b) { return a == b; }, each{});
    }

    /// Returns `yes` where the mask is true, else `no`.
    [[nodiscard]] friend Lanes select(const Mask& mask, const Lanes& yes, const Lanes& no) {
        return choose(mask, yes, no, each{});
    }

private:
    using Parts = std::array<Part, parts>;
    using each = std::make_index_sequence<parts>;

    explicit Lanes(const Parts& of) : parts_(of) {}

    [[nodiscard]] Part total() const {
        Part total = parts_[0];
        for (std::size_t i = 1; i < parts; ++i) { total = total + parts_[i]; }
        return total;
    }

    template <std::size_t... i>
    [[nodiscard]] static Parts spread(const Number& x, std::index_sequence<i...>) {
        return {(static_cast<void>(i), Part(x))...};
    }

    template <std::size_t... i>
    [[nodiscard]] static Parts load(const Row& row, std::index_sequence<i...>) {
        return {Register::load(row.at + i * width)...};
    }

    template <std::size_t... i>
    void store(Row& row, std::index_sequence<i...>) const {
        (Register::store(parts_[i], row.at + i * width), ...);
    }

    template <std::size_t... i>
    [[nodiscard]] static Parts load(const Number* from, std::index_sequence<i...>) {
        return {Register::load_anywhere(from + i * width)...};
    }

    template <std::size_t... i>
    void store(Number* to, std::index_sequence<i...>) const {
        (Register::store_anywhere(parts_[i], to + i * width), ...);
    }

    template <class F, std::size_t... i>
    [[nodiscard, gnu::always_inline]] Lanes map(F f, std::index_sequence<i...>) const {
        return Lanes(Parts{f(parts_[i])...});
    }

    template <class F, std::size_t... i>
    [[nodiscard]] Lanes map(const Lanes& other, F f, std::index_sequence<i...>) const {
        return Lanes(Parts{f(parts_[i], other.parts_[i])...});
    }

    template <class F, std::size_t... i>
    [[nodiscard]] static Mask compare(const Lanes& x, const Lanes& y, F f,
                                      std::index_sequence<i...>) {
        return Mask(std::array<typename Mask::Bits, parts>{f(x.parts_[i], y.parts_[i])...});
    }

    template <std::size_t... i>
    [[nodiscard]] static Lanes choose(const Mask& mask, const Lanes& yes, const Lanes& no,
                                      std::index_sequence<i...>) {
        using detail::select;  // select() of registers is found by its arguments
        return Lanes(Parts{select(mask[i], yes.parts_[i], no.parts_[i])...});
    }

    Parts parts_;
};

namespace detail {

/// Number of numbers that are computed at once.
template <class Value>
inline constexpr int lane_count = 1;
template <class Number, std::size_t count, std::size_t most>
inline constexpr int lane_count<Lanes<Number, count, most>> = static_cast<int>(count);

}  // namespace detail
}  // namespace hvi
