// The target of files of rows of numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <string>
#include <vector>

#include "generator/ensembles/number_rows.hpp"
#include "tests/generator/fuzz/attempt.hpp"
#include "tests/generator/fuzz/targets.hpp"

namespace hvi::gen::fuzz {

namespace {

/// A file in memory.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) : descriptor_(::memfd_create("fuzz", 0)) {
        const auto written = ::write(descriptor_, bytes.data(), bytes.size());
        require(written == static_cast<ssize_t>(bytes.size()), "no file for numbers");
    }
    ~MemoryFile() { ::close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] std::string path() const {
        return "/proc/self/fd/" + std::to_string(descriptor_);
    }

private:
    int descriptor_;
};

/// Checks that rows are the same numbers, whether they are read together or one by one.
void check_rows(NumberRows& rows) {
    require(rows.count() > 0 && !rows.names().empty(), "no rows, or no columns");
    const std::vector<double> all = rows.rows(0, rows.count());
    const std::size_t width = rows.names().size();
    require(all.size() == static_cast<std::size_t>(rows.count()) * width, "too few numbers");
    for (std::int64_t row = rows.count(); row-- > 0;) {
        const std::vector<double> one = rows.rows(row, 1);
        const double* const there = all.data() + static_cast<std::size_t>(row) * width;
        require(std::memcmp(one.data(), there, width * sizeof(double)) == 0, "other numbers");
    }
}

}  // namespace

void rows(std::string_view bytes) {
    // NOTE: damaged HDF5 files are for those to read who make that library.
    if (bytes.substr(0, 4) == "\x89HDF") return;
    const MemoryFile file(bytes);
    attempt([&] { check_rows(*number_rows(given("fuzz", file.path()))); });
}

}  // namespace hvi::gen::fuzz
