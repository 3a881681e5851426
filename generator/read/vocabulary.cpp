// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/vocabulary.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

namespace {

/// `3` of `x[3]`, or empty.
std::string index_of(const std::string& name) {
    const std::size_t bracket = name.find('[');
    return bracket == std::string::npos ? "" : name.substr(bracket + 1, name.size() - bracket - 2);
}

/// "from 1 to 6" for neighbours in ascending order, else all of them.
std::string in_words(const std::vector<std::string>& indices) {
    bool ascend = indices.size() > 2;
    for (std::size_t k = 1; k < indices.size(); ++k)
        ascend = ascend && std::stol(indices[k]) == std::stol(indices[k - 1]) + 1;
    return ascend ? fmt::format("from {} to {}", indices.front(), indices.back())
                  : fmt::format("{}", fmt::join(indices, ", "));
}

}  // namespace

NameList names_in(const std::shared_ptr<const Source>& source) {
    NameList list{{}, whole(source)};
    for (Name& name : parse_names(source))
        list.names.push_back({std::move(name.text), {source, name.range}});
    return list;
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
    const std::string index = index_of(name);
    if (!is_new && entry.indices.front().empty() != index.empty())
        throw InputError(fmt::format("`{}` is named with an index and without", stem), place);
    entry.indices.push_back(index);
}

std::vector<std::string> Vocabulary::indices(std::string_view stem) const {
    const auto found = entries_.find(stem);
    return found == entries_.end() ? std::vector<std::string>{} : found->second.indices;
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

void Vocabulary::check(const std::string& symbol, const Place& place, std::string help) const {
    if (contains(symbol)) return;
    check_index(symbol, place);
    throw InputError(fmt::format("`{}` is neither a variable nor a parameter with a value", symbol),
                     place, did_you_mean(symbol, {names_.begin(), names_.end()}, std::move(help)));
}

}  // namespace hvi::gen
