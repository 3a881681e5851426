// Numbers that a stepper of a large scene reads from files.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <large/filed.hpp>

namespace {

namespace fs = std::filesystem;
using hvi::generated::Filed;

/// A directory with files.
class Files {
public:
    Files() { fs::create_directories(path_); }
    ~Files() { fs::remove_all(path_); }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
    }

    [[nodiscard]] std::string path() const { return path_.string(); }

    /// Returns the error for a file of the scene; empty where all is well.
    [[nodiscard]] std::string fault(const std::string& bytes) const {
        write("filed.csv", bytes);
        try {
            static_cast<void>(Filed::read_parameters(path()));
        } catch (const std::runtime_error& error) { return error.what(); }
        return "";
    }

private:
    fs::path path_ = fs::temp_directory_path() /
                     ("hvi-test-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
};

template <class Number>
std::string npy(const char* type, const std::vector<Number>& numbers) {
    const std::string head = "{'descr': '" + std::string(type) +
                             "', 'fortran_order': False, 'shape': (" +
                             std::to_string(numbers.size()) + ",), }\n";
    std::string bytes = "\x93NUMPY\x01" + std::string(1, '\0') +
                        std::string(1, static_cast<char>(head.size())) + std::string(1, '\0') +
                        head;
    const std::size_t begin = bytes.size();
    bytes.resize(begin + numbers.size() * sizeof(Number));
    std::memcpy(&bytes[begin], numbers.data(), numbers.size() * sizeof(Number));
    return bytes;
}

template <class Number>
std::vector<double> read(const Files& files, const char* type, const std::vector<Number>& numbers) {
    files.write("a.npy", npy(type, numbers));
    std::vector<double> found{7};
    hvi::detail::read_columns<double>(files.path(), "a.npy", {{"", &found}});
    return found;
}

}  // namespace

TEST_CASE("a scene begins as a file says, with parameters from there") {
    const Files files;
    files.write("filed.csv", "# a few\r\n\nm , x\r\n2, 0.1\n 4,-1e-3 \n\n0.5,3\n");
    Filed::Parameters parameters = Filed::read_parameters(files.path() + "/");
    parameters.N = 3;
    CHECK(parameters.m == std::vector<double>{2, 4, 0.5});
    CHECK(parameters.x == std::vector<double>{0.1, -1e-3, 3});
    const Filed::State x = Filed::initial(parameters);
    CHECK(x.q == std::vector<double>{0.1, -1e-3, 3});
    CHECK(x.p == std::vector<double>{2, 4, 0.5});
    // sum of p^2/(2m) + m x^2/2
    CHECK(Filed(parameters).energy(x) ==
          Approx(2.0 / 2 + 4.0 / 2 + 0.5 / 2 + 0.01 + 4e-6 / 2 + 0.25 * 9).epsilon(1e-15));
    for (const std::ptrdiff_t n : {0, 2, 4}) {
        parameters.N = n;
        CHECK(Filed::initial(parameters).q.empty());
    }
    CHECK(Filed::initial().q.empty());
}

TEST_CASE("decimals are rounded to the numbers that the stepper computes in") {
    const Files files;
    files.write("filed.csv", "x,m\n0.1,1\n");
    using Wide = hvi::generated::BasicFiled<long double>;
    using Narrow = hvi::generated::BasicFiled<float>;
    CHECK(Wide::read_parameters(files.path()).x[0] == 0.1L);
    CHECK(Narrow::read_parameters(files.path()).x[0] == 0.1F);
}

TEST_CASE("what is wrong with a file is said with its line") {
    const Files files;
    CHECK(files.fault("x,m\n1,2\n") == "");
    const auto says = [&](const std::string& bytes, const std::string& fault) {
        INFO(bytes);
        const std::string found = files.fault(bytes);
        CHECK(found.find("filed.csv: " + fault) != std::string::npos);
    };
    says("x,m\n1,2\nnan,2\n", "line 3: `nan` is not a finite number");
    says("x,m\n\n1,1e999\n", "line 3: `1e999` is not a finite number");
    says("x,m\n1,\n", "line 2: `` is not a finite number");
    says("x,m\n1/2,1\n", "line 2: `1/2` is not a finite number");
    says("x,m\n1\n", "line 2: it has not as many values as there are names");
    says("x,m\n1,2,3\n", "line 2: it has not as many values as there are names");
    says("x,y\n1,2\n", "a column is missing");
    says("x,m,m\n1,2,3\n", "a column is missing, or there twice");
    says("", "the file is empty");
    const Files none;
    CHECK_THROWS_AS(Filed::read_parameters(none.path()), std::runtime_error);
}

TEST_CASE("an array of numpy.save is read in each of its types") {
    const Files files;
    std::vector<double> many;
    while (many.size() < 10000) { many.push_back(std::sin(static_cast<double>(many.size()))); }
    CHECK(read(files, "<f8", many) == many);
    CHECK(read<float>(files, "<f4", {0.5F, -3}) == std::vector<double>{0.5, -3});
    CHECK(read<std::int32_t>(files, "<i4", {7, -8}) == std::vector<double>{7, -8});
    CHECK(read<std::int64_t>(files, "<i8", {1LL << 40}) == std::vector<double>{1099511627776.0});
    CHECK_THROWS_AS(read<double>(files, "<f8", {1, std::numeric_limits<double>::infinity()}),
                    std::runtime_error);
    CHECK_THROWS_AS(read<double>(files, ">f8", {1}), std::runtime_error);
    files.write("a.npy", "\x93NUMPY");
    std::vector<double> numbers;
    CHECK_THROWS_AS(hvi::detail::read_columns<double>(files.path(), "a.npy", {{"", &numbers}}),
                    std::runtime_error);
}
