// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace dmp {

/// Leaves new elements as memory holds them, until they are written.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
    static_assert(std::is_trivially_copyable_v<T>);
    template <class U>
    struct rebind {
        using other = UninitializedAllocator<U>;
    };
    UninitializedAllocator() = default;
    template <class U>
    explicit UninitializedAllocator(const UninitializedAllocator<U>& /*other*/) noexcept {}

    void construct(T* /*at*/) noexcept {}
    template <class First, class... Rest>
    void construct(T* at, First&& first, Rest&&... rest) {
        std::construct_at(at, std::forward<First>(first), std::forward<Rest>(rest)...);
    }
};

/// A vector whose new elements after resize() have yet to be written, by the threads that will use them: filling large
/// memory with zeros first, which is when the system hands it out, would be the work of one.
template <class T>
using Uninitialized = std::vector<T, UninitializedAllocator<T>>;

}  // namespace dmp
