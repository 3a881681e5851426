// The chain of Fermi, Pasta, Ulam & Tsingou: its energy leaves a mode, and comes back.
// SPDX-License-Identifier: MIT
//
//     fpu_recurrence FILE [N] [MODE] [AMPLITUDE] [PERIODS] [STEP]
//
// writes the energies E_k = (P_k^2 + w_k^2 Q_k^2)/2 of MODE and of its multiples, as parts of the
// energy of the chain, over the time in periods of MODE, and says when most was back.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include <fpu_chain.hpp>

using Chain = hvi::generated::FpuChain;
using Vector = std::vector<double>;

namespace {

const double pi = std::acos(-1.0);
constexpr std::size_t mode_count = 8;
using Energies = std::array<double, mode_count>;

/// Some modes of n masses between fixed ends: Q_k = sqrt(2/(n+1)) sum_i q_i sin(pi i k/(n+1)), of
/// the frequency w_k = 2 sin(pi k/(2 (n+1))).
class Modes {
public:
    Modes(std::size_t n, std::size_t first) : n_(n) {
        const double length = static_cast<double>(n + 1);
        for (std::size_t k = first; k <= mode_count * first; k += first) {
            frequencies_.push_back(2 * std::sin(pi * static_cast<double>(k) / (2 * length)));
            for (std::size_t i = 1; i <= n; ++i) {
                shapes_.push_back(std::sin(pi * static_cast<double>(i * k) / length));
            }
        }
    }

    /// That of the first one.
    [[nodiscard]] double period() const { return 2 * pi / frequencies_[0]; }
    [[nodiscard]] double shape(std::size_t i) const { return shapes_[i]; }

    [[nodiscard]] Energies energies(const Vector& q, const Vector& p) const {
        Energies result{};
        for (std::size_t k = 0; k < mode_count; ++k) {
            const double wQ = frequencies_[k] * sum(q, k), P = sum(p, k);
            result.at(k) = (P * P + wQ * wQ) / static_cast<double>(n_ + 1);
        }
        return result;
    }

private:
    [[nodiscard]] double sum(const Vector& x, std::size_t k) const {
        double result = 0;
        for (std::size_t i = 0; i < n_; ++i) { result += shapes_[k * n_ + i] * x[i]; }
        return result;
    }

    std::size_t n_;
    Vector frequencies_, shapes_;
};

/// Where most of the energy was in the mode again, after less than half of it had been there.
struct Recurrence {
    double time = 0, part = 0, least = 1;

    void see(double now, double part_now) {
        if (part_now < least) {
            *this = {0, 0, part_now};
        } else if (least < 0.5 && part_now > part) {
            time = now;
            part = part_now;
        }
    }
};

struct Wishes {
    Chain::Parameters parameters;
    std::size_t mode;
    double periods, step;
};

void write_names(std::FILE* table, std::size_t first_mode) {
    std::fprintf(table, "period");
    for (std::size_t k = 1; k <= mode_count; ++k) { std::fprintf(table, ",E_%zu", k * first_mode); }
    std::fprintf(table, "\n");
}

/// Writes the table. False where a step fails.
bool run(const Wishes& wishes, std::FILE* table, Recurrence& recurrence) {
    constexpr int rows = 2000;
    const double h = wishes.step;
    Chain chain{wishes.parameters};
    Chain::State x = Chain::initial(wishes.parameters);
    const Modes modes(x.q.size(), wishes.mode);
    for (std::size_t i = 0; i < x.q.size(); ++i) {
        x.q[i] = wishes.parameters.amplitude * modes.shape(i);
    }
    const double energy = chain.energy(x);
    write_names(table, wishes.mode);
    const auto steps = std::llround(wishes.periods * modes.period() / h / rows);
    for (int row = 0; row <= rows; ++row) {
        if (row > 0 && !chain.advance(x, h, steps).ok()) { return false; }
        const double time = row * static_cast<double>(steps) * h / modes.period();
        std::fprintf(table, "%.6g", time);
        const Energies energies = modes.energies(x.q, x.p);
        for (const double each : energies) { std::fprintf(table, ",%.6g", each / energy); }
        std::fprintf(table, "\n");
        recurrence.see(time, energies[0] / energy);
    }
    return true;
}

/// Wishes that the words say; nothing where they are not as they should be.
std::optional<Wishes> wishes_of(const std::vector<const char*>& words) {
    const auto whole = [&](std::size_t i, int usual) {
        return words.size() > i ? std::atoi(words[i]) : usual;
    };
    const auto number = [&](std::size_t i, double usual) {
        return words.size() > i ? std::atof(words[i]) : usual;
    };
    Chain::Parameters parameters;  // alpha = 1/4, as in 1955
    parameters.N = whole(2, 31);
    parameters.amplitude = number(4, 1);
    const int mode = whole(3, 1);
    const double periods = number(5, 160), step = number(6, 0.1);
    const bool is_right = words.size() >= 2 && words.size() <= 7 && mode >= 1 &&
                          mode <= parameters.N && periods > 0 && step > 0;
    if (!is_right) { return {}; }
    return Wishes{parameters, static_cast<std::size_t>(mode), periods, step};
}

}  // namespace

int main(int argc, char** argv) {
    const auto wishes = wishes_of({argv, argv + argc});
    if (!wishes) {
        std::fprintf(stderr,
                     "usage: fpu_recurrence FILE [N] [MODE] [AMPLITUDE] [PERIODS] [STEP]\n");
        return 2;
    }
    std::FILE* table = std::fopen(argv[1], "w");
    if (table == nullptr) {
        std::perror(argv[1]);
        return 1;
    }
    Recurrence recurrence;
    const bool is_well = run(*wishes, table, recurrence);
    if (std::fclose(table) != 0 || !is_well) {
        std::fprintf(stderr, "a step has failed, or %s cannot be written\n", argv[1]);
        return 1;
    }
    std::printf("%.1f %% of the energy were back after %.1f periods, when there had been %.1f %%\n",
                100 * recurrence.part, recurrence.time, 100 * recurrence.least);
}
