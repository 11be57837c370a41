// Vertices, colours, normals, coordinates as they lie in memory: one function for the entry points of a
// family, whatever the type of their components.
#pragma once

#include <utility>

#include "gl/api/convert.hpp"
#include "gl/api/issue.hpp"

namespace spangle::gl {

/// Components of a family that its entry point does not give are those of (0, 0, 0, 1).
template <class F, class... Leading, std::size_t... I>
inline void issue_first(const Real* v, std::index_sequence<I...>, Leading... leading) {
    issue<F>(leading..., v[I]...);
}

template <class... A> constexpr std::size_t count_reals(void (*)(Context&, A...)) {
    return (std::size_t{std::is_same_v<A, Real>} + ...);
}

template <class F>
[[gnu::noinline]] void issue_components(const void* v, convert::Components kind, const char* null_text) {
    Real out[4];
    if (convert::load(v, kind, null_text, out))
        issue_first<F>(out, std::make_index_sequence<count_reals(F::run)>{});
}
template <class F>
[[gnu::noinline]] void issue_components(GLenum target, const void* v, convert::Components kind,
                                        const char* null_text) {
    Real out[4];
    if (convert::load(v, kind, null_text, out))
        issue_first<F>(out, std::make_index_sequence<count_reals(F::run)>{}, target);
}

} // namespace spangle::gl
