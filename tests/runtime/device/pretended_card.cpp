// SPDX-License-Identifier: GPL-2.0-or-later
#include "pretended_card.hpp"

#include <cuda_runtime_api.h>

#include <cstdlib>
#include <cstring>

PretendedCard pretended_card;

namespace {

PretendedCard& card = pretended_card;
std::map<char*, std::size_t> arrays;  // their sizes
cudaError_t last = cudaSuccess;       // the error of the last call that failed

cudaError_t failed(cudaError_t error) { return last = error; }

/// Returns whether the card has all of these bytes.
bool has(const void* from, std::size_t bytes) {
    const auto* const begin = static_cast<const char*>(from);
    for (const auto& [array, size] : arrays) {
        if (array <= begin && begin + bytes <= array + size) { return true; }
    }
    return false;
}

}  // namespace

extern "C" {
cudaError_t cudaGetDeviceCount(int* count) {
    *count = card.count;
    return card.count > 0 ? cudaSuccess : failed(cudaErrorNoDevice);
}
cudaError_t cudaMalloc(void** made, std::size_t size) {
    if (size > card.room) {
        ++card.refused;
        return failed(cudaErrorMemoryAllocation);
    }
    *made = std::memset(std::malloc(size), 0xee, size);  // nothing is there yet
    arrays[static_cast<char*>(*made)] = size;
    card.arrays = arrays.size();
    return cudaSuccess;
}
cudaError_t cudaFree(void* array) {
    arrays.erase(static_cast<char*>(array));
    card.arrays = arrays.size();
    std::free(array);
    return cudaSuccess;
}
cudaError_t cudaMemcpy(void* to, const void* from, std::size_t size, cudaMemcpyKind kind) {
    const bool is_to = kind == cudaMemcpyHostToDevice;
    if (size > 0 && (has(to, size) != is_to || has(from, size) == is_to)) {
        return failed(cudaErrorInvalidValue);
    }
    std::memcpy(to, from, size);
    return cudaSuccess;
}
cudaError_t cudaGetLastError() {
    const cudaError_t error = last;
    last = cudaSuccess;
    return error;
}
const char* cudaGetErrorString(cudaError_t error) {
    return error == cudaErrorNoDevice ? "none is there" : "it is broken";
}
cudaError_t cudaLaunchKernel(const void* kernel, dim3 blocks, dim3 threads, void** arguments,
                             std::size_t, cudaStream_t) {
    const std::size_t count = *static_cast<const std::size_t*>(arguments[0]);
    if (blocks.x == 0 || std::size_t{blocks.x} * threads.x < count ||
        card.kernels.count(kernel) == 0) {
        return failed(cudaErrorInvalidConfiguration);
    }
    ++card.launches;
    card.kernels.at(kernel)(arguments);
    return cudaSuccess;
}
}
