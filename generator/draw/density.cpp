// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/density.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t cells_in_line = 50;
constexpr double most_crossed = 0.6, fair_share = 0.25;

/// The cells of a line of a table, as far as its largest number.
std::vector<double> cells_of(const std::string& line, std::size_t most) {
    std::vector<double> cells;
    for (std::size_t at = 0; at <= line.size() && cells.size() < most;) {
        const std::size_t end = std::min(line.find(',', at), line.size());
        const std::string cell = line.substr(at, end - at);
        char* rest = nullptr;
        const double value = std::strtod(cell.c_str(), &rest);
        cells.push_back(rest == cell.c_str() ? std::nan("") : value);
        at = end + 1;
    }
    return cells;
}

/// The least and the largest of the finite values.
struct Extent {
    double least = std::numeric_limits<double>::infinity(), most = -least;

    void add(const std::vector<double>& values) {
        for (const double value : values) {
            if (!std::isfinite(value)) continue;
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }

    /// From 0 to the number of cells.
    [[nodiscard]] double place(double value) const {
        const double length = most - least;
        return length > 0 ? (value - least) / length * static_cast<double>(cells_in_line) : 0;
    }
};

class Cells {
public:
    /// Crosses those on the straight line between two places.
    void cross(double x0, double y0, double x1, double y1) {
        const double pieces = std::ceil(2 * std::max(std::abs(x1 - x0), std::abs(y1 - y0))) + 1;
        if (!std::isfinite(pieces)) return;
        for (double k = 0; k <= pieces; ++k)
            cross(x0 + (x1 - x0) * k / pieces, y0 + (y1 - y0) * k / pieces);
    }

    [[nodiscard]] double share() const {
        return static_cast<double>(count_) / static_cast<double>(crossed_.size());
    }

private:
    void cross(double x, double y) {
        bool& crossed = crossed_.at(index(x) * cells_in_line + index(y));
        count_ += crossed ? 0 : 1;
        crossed = true;
    }

    static std::size_t index(double place) {
        return std::min(cells_in_line - 1, static_cast<std::size_t>(std::max(0.0, place)));
    }

    std::array<bool, cells_in_line * cells_in_line> crossed_{};
    std::size_t count_ = 0;
};

}  // namespace

std::vector<std::vector<double>> read_columns(const std::filesystem::path& table,
                                              const std::vector<std::size_t>& numbers) {
    std::ifstream file(table);
    if (!file) throw EnvironmentError("cannot read " + table.string());
    const std::size_t most =
        numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
    std::vector<std::vector<double>> columns(numbers.size());
    std::string line;
    std::getline(file, line);  // names
    while (std::getline(file, line)) {
        if (line.empty() || line.front() == '#') continue;
        const std::vector<double> cells = cells_of(line, most);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            columns[i].push_back(numbers[i] <= cells.size() ? cells[numbers[i] - 1] : std::nan(""));
    }
    return columns;
}

std::size_t rows_with_turns(const std::vector<double>& values, double least, std::size_t most) {
    std::size_t turns = 0;
    double direction = 0, extreme = std::nan("");  // the last one, while the curve goes on
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) continue;
        if (std::isnan(extreme)) extreme = values[i];
        const double change = values[i] - extreme;
        const bool goes_on = direction == 0 ? std::abs(change) > least : change * direction >= 0;
        const bool turns_back =
            direction != 0 && change * direction < 0 && std::abs(change) > least;
        if (turns_back && ++turns > most) return i;
        if (!goes_on && !turns_back) continue;
        direction = change < 0 ? -1 : change > 0 ? 1 : direction;
        extreme = values[i];
    }
    return values.size();
}

Band band(const std::vector<double>& x, const std::vector<double>& values, std::size_t parts) {
    Band result;
    for (std::size_t k = 0; k < parts; ++k) {
        const std::size_t begin = k * values.size() / parts, end = (k + 1) * values.size() / parts;
        Extent all;
        double sum = 0, count = 0;
        for (std::size_t i = begin; i < end; ++i) {
            if (!std::isfinite(values[i])) continue;
            all.add({values[i]});
            sum += values[i];
            ++count;
        }
        if (count == 0) continue;
        result.x.push_back((x[begin] + x[end - 1]) / 2);
        result.least.push_back(all.least);
        result.most.push_back(all.most);
        result.mean.push_back(sum / count);
    }
    return result;
}

double extent(const std::vector<std::vector<double>>& columns) {
    Extent all;
    for (const std::vector<double>& column : columns) all.add(column);
    return std::max(0.0, all.most - all.least);
}

std::size_t rows_with_room(const std::vector<PlaneCurve>& curves) {
    Extent xs, ys;
    std::size_t rows = 0;
    for (const auto& [x, y] : curves) {
        xs.add(x);
        ys.add(y);
        rows = std::max(rows, x.size());
    }
    Cells cells;
    std::size_t fair = rows;
    for (std::size_t i = 1; i < rows; ++i) {
        for (const auto& [x, y] : curves)
            cells.cross(xs.place(x[i - 1]), ys.place(y[i - 1]), xs.place(x[i]), ys.place(y[i]));
        if (fair == rows && cells.share() > fair_share) fair = i + 1;
    }
    return cells.share() > most_crossed ? fair : rows;
}

}  // namespace hvi::gen
