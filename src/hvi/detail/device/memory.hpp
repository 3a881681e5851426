// Memory of a device, and loops over it: those of a card, or of the host.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <hvi/detail/device/device.hpp>

namespace hvi::device {

/// The host as a device.
struct Host {
    static void check() {}

    /// An array that the loops of the device may use.
    template <class T>
    class Array {
    public:
        static_assert(std::is_trivially_copyable_v<T>);

        /// Throws std::bad_alloc where the device has no room, and std::runtime_error where it
        /// fails, as all functions do.
        explicit Array(std::size_t count) : items_(count) {}
        explicit Array(const std::vector<T>& items) : items_(items) {}

        [[nodiscard]] T* data() { return items_.data(); }

        void set(std::size_t k, const T& item) { items_[k] = item; }
        /// Copies the first items, after the loops that were begun before.
        void read(T* items, std::size_t count) const { std::copy_n(items_.begin(), count, items); }

    private:
        std::vector<T> items_;
    };

    /// Calls body(i) for each i below `count`, in any order. It may end later.
    template <class Body>
    static void for_each(std::size_t count, const Body& body) {
        for (std::size_t i = 0; i < count; ++i) { body(i); }
    }
};

#if defined(__CUDACC__)
/// A card, by the functions of CUDA; see Host.
struct Card {
    /// Throws std::runtime_error where there is no card.
    static void check() {
        int count = 0;
        const cudaError_t error = cudaGetDeviceCount(&count);
        if (error == cudaSuccess && count > 0) { return; }
        throw std::runtime_error("no CUDA device was found" +
                                 (error == cudaSuccess ? "" : ": " + text_of(error)));
    }

    template <class T>
    class Array {
    public:
        static_assert(std::is_trivially_copyable_v<T>);

        explicit Array(std::size_t count) {
            demand(cudaMalloc(&items_, std::max<std::size_t>(count, 1) * sizeof(T)));
        }
        explicit Array(const std::vector<T>& items) : Array(items.size()) {
            demand(
                cudaMemcpy(items_, items.data(), items.size() * sizeof(T), cudaMemcpyHostToDevice));
        }
        ~Array() { cudaFree(items_); }
        Array(const Array&) = delete;
        Array& operator=(const Array&) = delete;

        [[nodiscard]] T* data() { return items_; }

        void set(std::size_t k, const T& item) {
            demand(cudaMemcpy(items_ + k, &item, sizeof(T), cudaMemcpyHostToDevice));
        }
        void read(T* items, std::size_t count) const {
            demand(cudaMemcpy(items, items_, count * sizeof(T), cudaMemcpyDeviceToHost));
        }

    private:
        T* items_ = nullptr;
    };

    template <class Body>
    static void for_each(std::size_t count, const Body& body) {
        constexpr std::size_t block = 128;
        if (count == 0) { return; }
        const auto blocks = static_cast<unsigned>((count + block - 1) / block);
        void (*const kernel)(std::size_t, Body) = body_kernel<Body>;
        void* arguments[] = {&count, const_cast<Body*>(&body)};
        demand(cudaLaunchKernel(reinterpret_cast<const void*>(kernel), dim3(blocks), dim3(block),
                                arguments, 0, nullptr));
    }

private:
    static std::string text_of(cudaError_t error) { return cudaGetErrorString(error); }

    static void demand(cudaError_t error) {
        if (error == cudaSuccess) { return; }
        cudaGetLastError();  // or the next call would report it again
        if (error == cudaErrorMemoryAllocation) { throw std::bad_alloc(); }
        throw std::runtime_error("the CUDA device failed: " + text_of(error));
    }
};

using Device = Card;
#else
using Device = Host;
#endif

}  // namespace hvi::device
