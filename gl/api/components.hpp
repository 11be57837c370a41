// Entry points that take components of vertices, colours, normals or coordinates in memory. The entry points
// of a family share one function for all types of components.
#pragma once

#include <bit>
#include <cstddef>
#include <utility>

#include "gl/api/convert.hpp"
#include "gl/api/issue.hpp"
#include "gl/context/limits.hpp"

namespace spangle::gl {

/// Issues a command with loaded components. Components that the entry point does not give are those of (0, 0,
/// 0, 1).
template <class F, class... Leading, std::size_t... I>
inline void issue_first(const Real* v, std::index_sequence<I...>, Leading... leading) {
    issue<F>(leading..., v[I]...);
}

template <class... A> constexpr std::size_t count_reals(void (*)(Context&, A...)) {
    return (std::size_t{std::is_same_v<A, Real>} + ...);
}

/// Loads components and issues the command, with the leading argument `target` if the command has one. All
/// families share this code.
void issue_loaded(const void* v, convert::Components kind, const Command& command, const char* null_text);
void issue_loaded_at(GLenum target, const void* v, convert::Components kind, const Command& command,
                     const char* null_text);

template <class F>
[[gnu::noinline]] void issue_components(const void* v, convert::Components kind, const char* null_text) {
    if constexpr (!converts_in_line)
        issue_loaded(v, kind, command<F>, null_text);
    else if (is_left_out(stops<F>) && v != nullptr)
        return;
    else if (const convert::Loaded loaded = convert::load(v, kind, null_text); !loaded.null)
        issue_first<F>(loaded.at, std::make_index_sequence<count_reals(F::run)>{});
}
template <class F>
[[gnu::noinline]] void issue_components(GLenum target, const void* v, convert::Components kind,
                                        const char* null_text) {
    if constexpr (!converts_in_line)
        issue_loaded_at(target, v, kind, command<F>, null_text);
    else if (const convert::Loaded loaded = convert::load(v, kind, null_text); !loaded.null)
        issue_first<F>(loaded.at, std::make_index_sequence<count_reals(F::run)>{}, target);
}

/// Issues Rect with two corners of two components each.
template <class F>
[[gnu::noinline]] void issue_corners(const void* v1, const void* v2, convert::Components kind,
                                     const char* null_text) {
    const convert::Loaded first = convert::load(v1, kind, null_text);
    if (first.null)
        return;
    const convert::Loaded second = convert::load(v2, kind, null_text);
    if (!second.null)
        issue<F>(first.at[0], first.at[1], second.at[0], second.at[1]);
}

/// Issues up to three components given as words in registers.
template <class F>
[[gnu::noinline]] void issue_given(std::uint32_t x, std::uint32_t y, std::uint32_t z,
                                   convert::Components kind) {
    const std::uint32_t given[] = {x, y, z};
    issue_components<F>(given, kind, static_cast<const char*>(nullptr));
}
template <class F>
[[gnu::noinline]] void issue_given_at(GLenum target, std::uint32_t x, std::uint32_t y,
                                      convert::Components kind) {
    const std::uint32_t given[] = {x, y};
    issue_components<F>(target, given, kind, static_cast<const char*>(nullptr));
}

template <std::size_t i, class T, std::size_t count> inline std::uint32_t word_at(const T (&given)[count]) {
    if constexpr (i < count && sizeof(T) < sizeof(std::uint32_t))
        return static_cast<std::uint32_t>(given[i]);
    else if constexpr (i < count)
        return std::bit_cast<std::uint32_t>(given[i]);
    return 0;
}

/// Whether components of type T are passed as words. On little-endian machines a word also holds the smaller
/// types in its first bytes.
template <class T>
inline constexpr bool passed_as_words =
    !converts_in_line && (sizeof(T) == 4 || (sizeof(T) < 4 && std::endian::native == std::endian::little));

/// Issues components that were given as single arguments.
template <class F, class T, std::size_t count>
inline void issue_components(const T (&given)[count], convert::Components kind, std::nullptr_t) {
    if constexpr (sizeof(T) < 4)
        kind |= passed_as_words<T> ? convert::of_words : convert::Components{0};
    if constexpr (passed_as_words<T> && count <= 3) {
        issue_given<F>(word_at<0>(given), word_at<1>(given), word_at<2>(given), kind);
    } else if constexpr (passed_as_words<T> && sizeof(T) < 4) {
        const std::uint32_t words[] = {word_at<0>(given), word_at<1>(given), word_at<2>(given),
                                       word_at<3>(given)};
        issue_components<F>(static_cast<const void*>(words), kind, static_cast<const char*>(nullptr));
    } else {
        issue_components<F>(static_cast<const void*>(given), kind, static_cast<const char*>(nullptr));
    }
}
template <class F, class T, std::size_t count>
inline void issue_components(GLenum target, const T (&given)[count], convert::Components kind,
                             std::nullptr_t) {
    if constexpr (!converts_in_line && sizeof(T) == 4 && count <= 2)
        issue_given_at<F>(target, word_at<0>(given), word_at<1>(given), kind);
    else
        issue_components<F>(target, static_cast<const void*>(given), kind, static_cast<const char*>(nullptr));
}

template <convert::Element kind, unsigned count, std::size_t index, class T> inline Real real_at(const T* v) {
    if constexpr (index < count)
        return convert::one<kind>(v[index]);
    return index == 3 ? numeric::one : numeric::zero;
}

/// Issues components that are converted inline. The most frequent vertex commands use this function, and
/// commands that take reals only.
template <class F, convert::Element kind, unsigned count, class T>
inline void issue_reals(const T* v, const char* null_text) {
    if constexpr (converts_in_line) {
        if (v == nullptr)
            return refuse_null(null_text);
        if (is_left_out(stops<F>)) [[unlikely]]
            return;
        const auto issue_all = [v]<std::size_t... I>(std::index_sequence<I...>) {
            issue<F>(real_at<kind, count, I>(v)...);
        };
        issue_all(std::make_index_sequence<count_reals(F::run)>{});
    } else if constexpr (F::listing == Listing::attribute) {
        issue_components<F>(v, convert::components(kind, count), null_text);
    } else {
        issue_loaded(v, convert::components(kind, count), command<F>, null_text);
    }
}

template <class F, convert::Element kind, unsigned count, class T>
inline void issue_reals(const T (&given)[count], std::nullptr_t) {
    if constexpr (!converts_in_line && F::listing == Listing::attribute)
        issue_components<F>(given, convert::components(kind, count), nullptr);
    else
        issue_reals<F, kind, count>(static_cast<const T*>(given), static_cast<const char*>(nullptr));
}

/// Issues a command whose last argument is an array in client memory, with elements of the given type.
template <class F, class A> [[gnu::noinline]] void issue_array(A a, const void* at, GLenum type) {
    issue<F>(a, Values{at, type});
}
template <class F, class A, class B>
[[gnu::noinline]] void issue_array(A a, B b, const void* at, GLenum type) {
    issue<F>(a, b, Values{at, type});
}

void issue_loaded_matrix(const void* m, convert::Element kind, const Command& command, const char* null_text);

template <class F, convert::Element kind, class T>
inline void issue_matrix(const T* m, const char* null_text) {
    if constexpr (converts_in_line) {
        if (m == nullptr)
            return refuse_null(null_text);
        issue<F>(convert::matrix<kind>(m));
    } else {
        issue_loaded_matrix(m, kind, command<F>, null_text);
    }
}

} // namespace spangle::gl
