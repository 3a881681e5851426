// `hvi-gen cache`: the compiled programs that are kept.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/cli/commands.hpp"
#include "generator/program/cache_content.hpp"
#include "generator/program/cache_directory.hpp"
#include "generator/support/output_file.hpp"

namespace hvi::gen {

namespace {

std::string size_text(std::uintmax_t bytes) {
    return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

}  // namespace

void run(const CacheOptions& options) {
    CacheDirectory cache;
    const CacheContent content = content_of(cache.path());
    const std::size_t count = content.programs.size();
    if (options.clear) {
        cache.clear();
        write_standard_output(fmt::format("{} program{} removed, {}\n", count,
                                          count == 1 ? "" : "s", size_text(content.bytes())));
        return;
    }
    write_standard_output(fmt::format("directory  {}\nprograms   {}\nsize       {}, of at most {}: "
                                      "beyond, the least recently used "
                                      "go\n",
                                      cache.path().string(), count, size_text(content.bytes()),
                                      size_text(most_bytes_of_cache)));
}

}  // namespace hvi::gen
