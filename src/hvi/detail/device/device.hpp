// The three devices: CUDA, HIP, and the host. One text of a step is compiled for each of them.
// SPDX-License-Identifier: MIT
//
// NOTE: under CUDA and HIP functions without a mark are functions of the host, those of the
// standard library too, and tables as static members lie in the memory of the host. What a device
// calls stands in this directory; the numbers of a method reach it as an argument of the kernel.
#ifndef HVI_DEVICE_HPP
#define HVI_DEVICE_HPP

#include <cfloat>
#include <cstddef>
#include <cstdint>

// NOTE: nvcc defines nothing for -use_fast_math. Of that these numbers are touched by -ftz=true
// alone, and only floats below 2^-126.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error "hvi: -ffast-math and -fassociative-math change the bits of a device: compile without"
#endif
#if FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD < 0
#error "hvi: needs arithmetic that rounds to its own type after each operation: -mfpmath=sse"
#endif

// HVI_DEVICE marks what host and device call, HVI_KERNEL what the host starts on a device.
#if defined(__clang__) && (defined(__CUDA__) || defined(__HIP__))
#define HVI_DEVICE __attribute__((host)) __attribute__((device))
#define HVI_KERNEL __attribute__((global))
#elif defined(__CUDACC__)
#define HVI_DEVICE __host__ __device__
#define HVI_KERNEL __global__
#else
#define HVI_DEVICE
#endif

// HVI_ON_CUDA and HVI_ON_HIP say what the present text is compiled for.
#if defined(__CUDA_ARCH__)
#define HVI_ON_CUDA 1
#elif defined(__HIP_DEVICE_COMPILE__)
#define HVI_ON_HIP 1
#endif

namespace hvi::device {

/// Returns a * b, rounded.
///
/// NOTE: where one instruction multiplies and adds, compilers leave out the rounding between unless
/// they are told otherwise, each in its own way, and clang even where an intrinsic asks for it. No
/// compiler fuses a product that it does not see.
#if defined(HVI_ON_CUDA)
[[nodiscard]] HVI_DEVICE inline double product(double a, double b) {
    double result;
    asm("mul.rn.f64 %0, %1, %2;" : "=d"(result) : "d"(a), "d"(b));
    return result;
}
[[nodiscard]] HVI_DEVICE inline float product(float a, float b) {
    float result;
    asm("mul.rn.f32 %0, %1, %2;" : "=f"(result) : "f"(a), "f"(b));
    return result;
}
#else
template <class Number>
[[nodiscard]] HVI_DEVICE inline Number product(Number a, Number b) {
    Number result = a * b;
#if defined(HVI_ON_HIP)
    asm("" : "+v"(result));
#elif defined(__x86_64__) && defined(__FMA__)
    asm("" : "+x"(result));
#elif defined(__aarch64__)
    asm("" : "+w"(result));
#elif !defined(__x86_64__)
    const volatile Number seen = result;
    result = seen;
#endif
    return result;
}
#endif

/// Returns a b + c, rounded once. NOTE: processors without such an instruction do it in software.
[[nodiscard]] HVI_DEVICE inline double fused(double a, double b, double c) {
#if defined(HVI_ON_CUDA) && !defined(__clang__)
    return __fma_rn(a, b, c);
#else
    return __builtin_fma(a, b, c);
#endif
}

[[nodiscard]] HVI_DEVICE inline float fused(float a, float b, float c) {
#if defined(HVI_ON_CUDA) && !defined(__clang__)
    return __fmaf_rn(a, b, c);
#else
    return __builtin_fmaf(a, b, c);
#endif
}

/// Returns the number nearest to sqrt(x), where y is that or a number beside it. Precondition: x is
/// not so small that the rest of a division is no normal number.
template <class Number>
[[nodiscard]] HVI_DEVICE inline Number nearest_root(Number x, Number y) {
    if (!(y > 0) || y - y != 0) { return y; }
    return fused(fused(-y, y, x), Number(0.5) / y, y);
}

/// Return a / b and sqrt(x), rounded to the nearest number whatever the compiler is told.
///
/// NOTE: the root of LLVM before 17 for AMD's cards is off by a unit in the last place here and
/// there.
[[nodiscard]] HVI_DEVICE inline double quotient(double a, double b) { return a / b; }
[[nodiscard]] HVI_DEVICE inline float quotient(float a, float b) {
#if defined(HVI_ON_CUDA)
    float result;
    asm("div.rn.f32 %0, %1, %2;" : "=f"(result) : "f"(a), "f"(b));
    return result;
#else
    return a / b;
#endif
}
[[nodiscard]] HVI_DEVICE inline double square_root(double x) {
#if defined(HVI_ON_CUDA)
    double result;
    asm("sqrt.rn.f64 %0, %1;" : "=d"(result) : "d"(x));
    return result;
#elif defined(HVI_ON_HIP)
    const bool is_small = x < 0x1p-900;
    const double scaled = is_small ? x * 0x1p200 : x;
    const double root = nearest_root(scaled, __builtin_sqrt(scaled));
    return is_small ? root * 0x1p-100 : root;
#else
    return __builtin_sqrt(x);
#endif
}
[[nodiscard]] HVI_DEVICE inline float square_root(float x) {
#if defined(HVI_ON_CUDA)
    float result;
    asm("sqrt.rn.f32 %0, %1;" : "=f"(result) : "f"(x));
    return result;
#elif defined(HVI_ON_HIP)
    const bool is_small = x < 0x1p-90f;
    const float scaled = is_small ? x * 0x1p60f : x;
    const float root = nearest_root(scaled, __builtin_sqrtf(scaled));
    return is_small ? root * 0x1p-30f : root;
#else
    return __builtin_sqrtf(x);
#endif
}

#if defined(HVI_KERNEL)
/// Returns the number of this thread among all of the kernel, and how many there are.
[[nodiscard]] __attribute__((device)) inline std::size_t thread_number() {
#if defined(HVI_ON_CUDA) && defined(__clang__)
    return static_cast<std::size_t>(__nvvm_read_ptx_sreg_ctaid_x()) *
               static_cast<std::size_t>(__nvvm_read_ptx_sreg_ntid_x()) +
           static_cast<std::size_t>(__nvvm_read_ptx_sreg_tid_x());
#elif defined(HVI_ON_CUDA)
    return static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x;
#elif defined(HVI_ON_HIP)
    return static_cast<std::size_t>(__builtin_amdgcn_workgroup_id_x()) *
               static_cast<std::size_t>(__builtin_amdgcn_workgroup_size_x()) +
           static_cast<std::size_t>(__builtin_amdgcn_workitem_id_x());
#else
    return 0;
#endif
}

[[nodiscard]] __attribute__((device)) inline std::size_t thread_count() {
#if defined(HVI_ON_CUDA) && defined(__clang__)
    return static_cast<std::size_t>(__nvvm_read_ptx_sreg_nctaid_x()) *
           static_cast<std::size_t>(__nvvm_read_ptx_sreg_ntid_x());
#elif defined(HVI_ON_CUDA)
    return static_cast<std::size_t>(gridDim.x) * blockDim.x;
#elif defined(HVI_ON_HIP)
    return static_cast<std::size_t>(__builtin_amdgcn_grid_size_x());
#else
    return 1;
#endif
}

/// Calls body(i) for each i below `count`. Any number of threads does so.
template <class Body>
HVI_KERNEL void body_kernel(std::size_t count, Body body) {
    for (std::size_t i = thread_number(); i < count; i += thread_count()) { body(i); }
}
#endif

/// Returns the counter, and adds 1 to it.
[[nodiscard]] HVI_DEVICE inline std::uint32_t counted(std::uint32_t* counter) {
#if defined(HVI_ON_CUDA) && !defined(__clang__)
    return atomicAdd(counter, 1U);
#elif defined(HVI_ON_CUDA) || defined(HVI_ON_HIP)
    return __atomic_fetch_add(counter, 1U, __ATOMIC_RELAXED);
#else
    return (*counter)++;
#endif
}

}  // namespace hvi::device

#endif  // HVI_DEVICE_HPP
