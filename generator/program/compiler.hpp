// The user's C++ compiler.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hvi::gen {

struct Compiler {
    std::vector<std::string> command;  ///< CXX of the environment, a path or words; else c++
    std::string version;               ///< the first line of what `--version` prints
};

/// Finds the compiler. Throws EnvironmentError where there is none.
[[nodiscard]] Compiler find_compiler();

/// Finds the compiler of MPI: MPICXX of the environment, else mpicxx. Its version names the MPI,
/// too. Throws EnvironmentError where there is none.
[[nodiscard]] Compiler find_mpi_compiler();

/// Finds the compiler of CUDA: NVCC of the environment, else nvcc. Throws EnvironmentError where
/// there is none.
[[nodiscard]] Compiler find_device_compiler();

/// Kinds of files that the compiler makes; nvcc makes a library with kernels for a GPU.
enum class Artifact { program, library, device_library };

/// Returns options for fast programs.
[[nodiscard]] std::vector<std::string> compiler_options(Artifact artifact);

/// Compiles `main.cpp` in the directory, which may include files there, to the file `program`
/// beside it, and links the libraries: a program, or a library that programs load. Throws
/// EnvironmentError with the first error of the compiler, and where the file is not made.
void compile(const Compiler& compiler, const std::filesystem::path& directory,
             const std::vector<std::string>& libraries = {}, Artifact artifact = Artifact::program);

}  // namespace hvi::gen
