// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stages/dependency_graph.hpp"

#include <algorithm>
#include <limits>

namespace hvi::gen {
namespace {

/// Tarjan's algorithm. A component is complete when all components that it needs are, so that
/// components come in an order in which they can be computed. The depth of the recursion is at most
/// the number of vertices: four for each of at most 64 stages and 64 degrees of freedom.
class Tarjan {
public:
    explicit Tarjan(const DependencyGraph& needs)
        : needs_(needs),
          number_(needs.size(), unseen),
          lowest_(needs.size()),
          open_(needs.size()) {}

    std::vector<std::vector<std::size_t>> run() {
        for (std::size_t v = 0; v < needs_.size(); ++v) {
            if (number_[v] == unseen) { visit(v); }
        }
        return std::move(components_);
    }

private:
    static constexpr std::size_t unseen = std::numeric_limits<std::size_t>::max();

    void visit(std::size_t v) {
        number_[v] = lowest_[v] = next_++;
        path_.push_back(v);
        open_[v] = true;
        for (const std::size_t w : needs_[v]) {
            if (number_[w] == unseen) {
                visit(w);
                lowest_[v] = std::min(lowest_[v], lowest_[w]);
            } else if (open_[w]) {
                lowest_[v] = std::min(lowest_[v], number_[w]);
            }
        }
        if (lowest_[v] == number_[v]) { close(v); }
    }

    void close(std::size_t root) {
        const auto first = std::find(path_.begin(), path_.end(), root);
        std::vector<std::size_t> component(first, path_.end());
        path_.erase(first, path_.end());
        for (const std::size_t v : component) { open_[v] = false; }
        std::sort(component.begin(), component.end());
        components_.push_back(std::move(component));
    }

    const DependencyGraph& needs_;
    std::vector<std::size_t> number_;
    std::vector<std::size_t> lowest_;
    std::vector<bool> open_;
    std::vector<std::size_t> path_;
    std::vector<std::vector<std::size_t>> components_;
    std::size_t next_ = 0;
};

}  // namespace

std::vector<std::vector<std::size_t>> components(const DependencyGraph& needs) {
    return Tarjan(needs).run();
}

}  // namespace hvi::gen
