// What every wrapper does once its arguments are canonical: check Begin/End, record, or run.
#pragma once

#include <type_traits>

#include "gl/api/family.hpp"
#include "gl/context/context.hpp"
#include "gl/list/record.hpp"

namespace spangle::gl {

/// A pointer that must not be null was: INVALID_VALUE instead of a crash.
void refuse_null(const char* text);

/// A command of a system this build left out: INVALID_OPERATION and a message that names the feature.
void refuse_feature(const char* text);

/// INVALID_OPERATION for a command that Begin and End do not allow between them (GL 1.3, 2.6.3).
void refuse_inside(Context& context, const char* text);

/// The bits of the gate that keep a family from simply running.
template <class F>
constexpr std::uint8_t stops =
    static_cast<std::uint8_t>((F::inside ? 0 : gate_inside) |
                              (SPANGLE_FEATURE_LISTS && F::listing != Listing::never ? gate_compiling : 0));

/// The slow way in: records while a list is compiled, and checks Begin/End. True when the command is to run
/// now. Errors of a recorded command are found when it is executed, not here (GL 1.3, appendix B, corollary
/// 9). Arguments come by value, so that they stay in registers on the way that does not come here.
template <class F, class... A> [[gnu::noinline, gnu::cold]] bool admit(Context& context, A... args) {
    if constexpr ((stops<F> & gate_compiling) != 0) {
        if ((context.gate & gate_compiling) != 0) {
            if constexpr (F::listing == Listing::words)
                list::record_words<F>(context, args...);
            else
                F::encode(context, args...);
            if (!context.list.execute)
                return false;
        }
    }
    if constexpr (!F::inside) {
        if (context.inside_begin_end()) {
            refuse_inside(context, F::refusal);
            return false;
        }
    }
    return true;
}

template <class F, class... A> inline void issue(A... args) {
    Context* context = current_context();
    if (context == nullptr) [[unlikely]]
        return;
    if ((context->gate & stops<F>) != 0) [[unlikely]] {
        if (!admit<F>(*context, args...))
            return;
    }
    F::run(*context, args...);
}

/// The same for commands that return a value: 0 when they may not run (GL 1.3, 2.5).
template <class F, class... A> inline auto ask(A... args) -> decltype(F::run(*current_context(), args...)) {
    Context* context = current_context();
    if (context == nullptr)
        return 0;
    if ((context->gate & stops<F>) != 0 && !admit<F>(*context, args...))
        return 0;
    return F::run(*context, args...);
}

/// The same for queries of parameters; `out` stays empty when they may not run.
template <class F, class... A> inline void fetch(Params& out, A... args) {
    Context* context = current_context();
    if (context == nullptr || ((context->gate & stops<F>) != 0 && !admit<F>(*context, args...)))
        return;
    F::run(*context, args..., out);
}

} // namespace spangle::gl
