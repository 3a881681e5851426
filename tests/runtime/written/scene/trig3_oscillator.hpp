// Written by hvi-gen 0.1.0. Do not edit; to write it again:
//     hvi-gen stepper --method trig3 harmonic-oscillator --name Trig3Oscillator
// SPDX-License-Identifier: MIT
//
// trig3: symplectic, 3 stages, for separable Hamiltonians.
// Basis functions of tau: 1, cos(pi*tau), sin(pi*tau).
// A != A~: a partitioned method, which conserves q^T C p for constant C.
//
// The tableau of (4.18) in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:
//
//     c_1 = 0
//     c_2 = 1/2
//     c_3 = 1
//     b_1 = 1/2-1/pi
//     b_2 = 2/pi
//     b_3 = 1/2-1/pi
//     a_1,1 = 0
//     a_1,2 = 0
//     a_1,3 = 0
//     a_2,1 = 1/4
//     a_2,2 = 1/pi
//     a_2,3 = 1/4-1/pi
//     a_3,1 = 1/2-1/pi
//     a_3,2 = 2/pi
//     a_3,3 = 1/2-1/pi
//     a~_1,1 = 1/2-1/pi
//     a~_1,2 = (pi-4)/(pi^2-2*pi)
//     a~_1,3 = 0
//     a~_2,1 = 1/2-1/pi
//     a~_2,2 = 1/pi
//     a~_2,3 = 0
//     a~_3,1 = 1/2-1/pi
//     a~_3,2 = 1/(pi-2)
//     a~_3,3 = 0
//
// Found in H:
//
//     H is quadratic: Hamilton's equations are linear
//     H = T(p) + U(q)
//     2 of 4 second derivatives are not zero, 2 constant
//
// Cost:
//
//     a step: 3 multiplications and 3 additions
//
// Choices:
//
//     no solver: H is quadratic: a step is a product of three shears where these exist for h, else
//         with a matrix, computed when h changes
//     no compensated summation: the shears are symplectic however they round; --solver fixed-point
//         iterates with it
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <hvi/detail/linear/linear_map.hpp>
#include <hvi/detail/stepper.hpp>

namespace hvi::generated {

static_assert(hvi::supports_format(15),
              "this header is for another version of hvi: write it again with hvi-gen");

/// The scene harmonic-oscillator with trig3, computed in Number: float, double or long double.
/// States hold Numbers: arrays, or vectors of Eigen of fixed size.
/// The harmonic oscillator, Section 6.2 of Leok & Zhang
template <class Number, class Numbers = std::array<Number, 1>>
class BasicTrig3Oscillator {
    static_assert(hvi::detail::is_standard<Number>,
                  "hvi: a scene is computed in float, double or long double");
    static_assert(hvi::detail::is_fixed_vector<Numbers, Number, 1>(),
                  "hvi: vectors are of these numbers, and of fixed size: std::array, or Eigen's");

public:
    using Scalar = Number;
    using Vector = Numbers;

    /// As the scene has them.
    struct Parameters {
        Scalar omega = Scalar(1.0);  // omega = 1
    };

    /// H = p^2/2+omega^2*q^2/2, where q is (q) and p is (p).
    struct System {
        using Vector = Numbers;

        constexpr explicit System(const Parameters& parameters) {
            c1_ = parameters.omega * parameters.omega;
        }

        constexpr void quadratic(hvi::detail::Quadratic<Scalar, 1>& H) const {
            H.qq[0][0] = c1_;
            H.pp[0][0] = Scalar(1.0);
        }

        static constexpr void begin([[maybe_unused]] const Parameters& parameters, Vector& q,
            Vector& p) {
            q[0] = Scalar(1.0);
            p[0] = Scalar(0.0);
        }

        Scalar c1_ = 0;
    };

    using State = hvi::State<Vector>;

    BasicTrig3Oscillator() : BasicTrig3Oscillator(Parameters{}) {}
    explicit BasicTrig3Oscillator(const Parameters& parameters) : system_(parameters) {}

    /// Where the scene begins.
    [[nodiscard]] static constexpr State initial(const Parameters& parameters) {
        State x;
        System::begin(parameters, x.q, x.p);
        return x;
    }
    [[nodiscard]] static constexpr State initial() { return initial(Parameters{}); }

    /// Advances x by a step of size h: negative is back, 0 leaves every bit. Unless the status is
    /// ok, x has kept its bits. The matrix is computed when h changes.
    [[nodiscard]] Status step(State& x, Scalar h) {
        const End next = map_.after(x.q, middle_);
        if (h == h_ && is_last(x) && is_ordinary(next)) {
            move(x, next);
            return {};
        }
        if (h == 0) { return {}; }
        // NOTE: what is rare works on copies, so that compilers may keep x and the members in
        // registers, and of q and p one by one, since g++ would keep a pair in one register.
        if (h != h_) {
            const Map map = made(system_, h);
            if (!map.status().ok()) { return map.status(); }
            map_ = map;
            h_ = h;
            last_ = nowhere();
        }
        if (!map_.is_sheared()) {
            Memory memory = s_;
            State y = x;
            const Status status = increase(map_, memory, y, h);
            s_ = memory;
            x = y;
            return status;
        }
        const Map map = map_;
        auto q = Map::own(x.q), p = Map::own(x.p), middle = middle_;
        const Status status = map.step(q, p, middle, is_last(x));
        if (!status.ok()) { return status; }
        s_.forget();
        const End end{q, p, middle};
        move(x, end);
        if (!is_ordinary(end)) { last_ = nowhere(); }
        return {};
    }

    /// Forgets what the last step left; the matrix is that of h and the parameters.
    void reset() {
        last_ = nowhere();
        s_.forget();
    }

private:
    using Index = hvi::detail::IndexOf<Vector>;

    // rounded(...) is the number of its comment as float, double, long double or __float128: the
    // one that Scalar is.
    static constexpr auto& rounded = hvi::detail::rounded<Scalar>;

    static constexpr Scalar b[3] = {
        // b_1 = 1/2-1/pi
        rounded(0.18169011f, 0.18169011381620934, -0x1.2ap-57, -0x1.29fc2757d1f53p-57, -0x1.3p-111),
        // b_2 = 2/pi
        rounded(0.63661975f, 0.6366197723675814, -0x1.6bp-55, -0x1.6b01ec5417056p-55, -0x1.6p-109),
        // b_3 = 1/2-1/pi
        rounded(0.18169011f, 0.18169011381620934, -0x1.2ap-57, -0x1.29fc2757d1f53p-57, -0x1.3p-111),
    };

    // m_ij = a_ij/b_j and mt_ij = a~_ij/b_j, rounded so that m_ij + mt_ji is 1 exactly.
    static constexpr Scalar m[3][3] = {
        {
            Scalar(0.0),  // m_1,1 = 0
            Scalar(0.0),  // m_1,2 = 0
            Scalar(0.0),  // m_1,3 = 0
        },
        {
            // m_2,1 = pi/(2*pi-4)
            rounded(1.3759692f, 1.3759691969420544, -0x1.f88p-54, -0x1.f851261772405p-54,
                -0x1.fp-107),
            Scalar(0.5),  // m_2,2 = 1/2
            // m_2,3 = (pi-4)/(2*pi-4)
            rounded(-0.37596917f, -0.37596919694205444, 0x1.f88p-54, 0x1.f851261772405p-54,
                0x1.fp-107),
        },
        {
            Scalar(1.0),  // m_3,1 = 1
            Scalar(1.0),  // m_3,2 = 1
            Scalar(1.0),  // m_3,3 = 1
        },
    };
    static constexpr Scalar mt[3][3] = {
        {
            Scalar(1.0),  // mt_1,1 = 1
            // mt_1,2 = (pi-4)/(2*pi-4)
            rounded(-0.37596917f, -0.37596919694205444, 0x1.f88p-54, 0x1.f851261772405p-54,
                0x1.fp-107),
            Scalar(0.0),  // mt_1,3 = 0
        },
        {
            Scalar(1.0),  // mt_2,1 = 1
            Scalar(0.5),  // mt_2,2 = 1/2
            Scalar(0.0),  // mt_2,3 = 0
        },
        {
            Scalar(1.0),  // mt_3,1 = 1
            // mt_3,2 = pi/(2*pi-4)
            rounded(1.3759692f, 1.3759691969420544, -0x1.f88p-54, -0x1.f851261772405p-54,
                -0x1.fp-107),
            Scalar(0.0),  // mt_3,3 = 0
        },
    };
    static_assert(hvi::detail::complementary(m, mt), "the method is symplectic");

    using Map = hvi::detail::LinearMap<Scalar, 1, false>;
    using End = typename Map::End;
    using Memory = hvi::detail::StepMemory<Vector>;

    [[nodiscard, gnu::cold]] static Map made(const System& system, Scalar h) {
        hvi::detail::Quadratic<Scalar, 1> H;
        system.quadratic(H);
        return Map(h, H, m, mt, b, b);
    }

    /// The step without shears.
    [[nodiscard]] static Status increase(const Map& map, Memory& memory, State& x, Scalar h) {
        const Status status = memory.begin(x, h);
        if (!status.ok()) { return status; }
        map.increments().add_to(memory);
        return memory.end(x, 0);
    }

    /// A state from which there is no step.
    [[nodiscard]] static State nowhere() {
        State x;
        x.q.fill(std::numeric_limits<Scalar>::infinity());
        x.p.fill(std::numeric_limits<Scalar>::infinity());
        return x;
    }

    /// Whether x is where the last step ended, or is no number, from which there is no step.
    ///
    /// NOTE: this is one jump for each component, where == is two. g++ would keep what is compared
    /// bit for bit in registers of integers. Zeros, of which there are two, are not remembered.
    [[nodiscard]] bool is_last(const State& x) const {
        bool same = true;
        for (Index k = 0; k < x.q.size(); ++k) {
            same = same && !std::islessgreater(x.q[k], last_.q[k]) &&
                   !std::islessgreater(x.p[k], last_.p[k]);
        }
        return same;
    }

    /// Whether no component is zero, infinite or no number; of very large and very small ones that
    /// is not said either.
    [[nodiscard]] static bool is_ordinary(const End& end) {
        bool ordinary = true;
        for (std::size_t k = 0; k < end.q.size(); ++k) {
            const Scalar product = std::abs(end.q[k] * end.p[k]);
            ordinary = ordinary && product > 0 && product <= std::numeric_limits<Scalar>::max();
        }
        return ordinary;
    }

    void move(State& x, const End& end) {
        for (std::size_t k = 0; k < 1; ++k) {
            hvi::detail::at(last_.q, k) = hvi::detail::at(x.q, k) = end.q[k];
            hvi::detail::at(last_.p, k) = hvi::detail::at(x.p, k) = end.p[k];
            middle_[k] = end.middle[k];
        }
    }

    System system_;
    Map map_;
    Scalar h_ = 0;                   // of the map; 0 where there is none
    State last_ = nowhere();         // where the last step ended, if that is ordinary
    typename Map::Vector middle_{};  // p between the shears of that step
    Memory s_;                       // where the last step without shears ended
};

using Trig3Oscillator = BasicTrig3Oscillator<double>;

}  // namespace hvi::generated
