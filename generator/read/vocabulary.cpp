// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

/// Returns `3`, or `1,2`.
std::string in_words(const Index& index) { return fmt::format("{}", fmt::join(index, ",")); }

/// Returns "from 1 to 6" for neighbours in ascending order, else all indices.
std::string in_words(const std::vector<Index>& indices) {
    constexpr std::size_t most_written = 20;
    bool ascend = indices.size() > 2 && indices.front().size() == 1;
    for (std::size_t k = 1; ascend && k < indices.size(); ++k)
        ascend = indices[k].front() == indices[k - 1].front() + 1;
    if (ascend || indices.size() > most_written)
        return fmt::format("from {} to {}", in_words(indices.front()), in_words(indices.back()));
    std::vector<std::string> all;
    for (const Index& index : indices) all.push_back(in_words(index));
    return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace

Index index_of(const std::string& name) {
    Index index;
    std::size_t begin = name.find('[');
    while (begin != std::string::npos) {
        index.push_back(std::stol(name.substr(begin + 1)));
        begin = name.find(',', begin + 1);
    }
    return index;
}

void Vocabulary::declare(const DeclaredName& declared, std::string_view subject) {
    const auto& [name, place] = declared;
    check_symbol_name(name, place, subject);
    const std::string stem(without_index(name));
    const auto [position, is_new] = entries_.try_emplace(stem);
    Entry& entry = position->second;
    if (is_new) entry.subject = subject;
    if (entry.subject != subject)
        throw InputError(fmt::format("`{}` is {} already", stem, entry.subject), place);
    if (!names_.insert(name).second)
        throw InputError(fmt::format("`{}` is named twice", name), place);
    const Index index = index_of(name);
    const std::size_t dimension = is_new ? index.size() : entry.indices.front().size();
    if (dimension != index.size())
        throw InputError(dimension == 0 || index.empty()
                             ? fmt::format("`{}` is named with an index and without", stem)
                             : fmt::format("`{}` is named with {} and with {} indices", stem,
                                           dimension, index.size()),
                         place);
    entry.indices.push_back(index);
}

std::vector<Index> Vocabulary::indices(std::string_view stem) const {
    const auto found = entries_.find(stem);
    if (found == entries_.end()) return {};
    std::vector<Index> indices = found->second.indices;
    std::sort(indices.begin(), indices.end());
    return indices;
}

std::set<std::string> Vocabulary::stems() const {
    std::set<std::string> result;
    for (const auto& [stem, entry] : entries_) result.insert(stem);
    return result;
}

bool Vocabulary::is(std::string_view subject, std::string_view stem) const {
    const auto found = entries_.find(stem);
    return found != entries_.end() && found->second.subject == subject;
}

void Vocabulary::check_index(const std::string& symbol, const Place& place) const {
    const auto found = entries_.find(without_index(symbol));
    if (found == entries_.end() || contains(symbol)) return;
    const auto& [stem, entry] = *found;
    if (entry.indices.front().empty())
        throw InputError(fmt::format("`{}` has no index", stem), place,
                         fmt::format("it is {}: write `{}`", entry.subject, stem));
    if (symbol == stem)
        throw InputError(fmt::format("`{}` wants an index", stem), place,
                         fmt::format("its indices are {}", in_words(entry.indices)));
    throw InputError(fmt::format("there is no `{}`", symbol), place,
                     fmt::format("the indices of `{}` are {}", stem, in_words(entry.indices)));
}

void Vocabulary::check_stem(std::string_view stem, const std::string& text, const Place& place,
                            std::string help) const {
    if (has(stem)) return;
    std::vector<std::string_view> stems;
    for (const auto& [name, entry] : entries_) stems.push_back(name);
    throw InputError(fmt::format("`{}` is neither a variable nor a parameter with a value", text),
                     place, did_you_mean(std::string(stem), stems, std::move(help)));
}

}  // namespace hvi::gen
