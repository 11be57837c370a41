// What every wrapper does once its arguments are canonical: check Begin/End, record, or run.
#pragma once

#include <type_traits>

#include "gl/api/command.hpp"
#include "gl/context/limits.hpp"

namespace spangle::gl {

/// A pointer that must not be null was: INVALID_VALUE instead of a crash.
void refuse_null(const char* text);

/// A command of a system this build left out: INVALID_OPERATION and a message that names the feature.
void refuse_feature(const char* text);

/// The current context where Begin and End allow a command; else null, and INVALID_OPERATION if there is one.
Context* outside_begin_end(const CommandText* text);

/// The slow way in: records while a list is compiled, and checks Begin/End. True when the command is to run
/// now. Errors of a recorded command are found when it is executed, not here (GL 1.3, appendix B, corollary
/// 9).
bool admit(Context& context, const Command& command, const Arg (&args)[most_args]);

/// The band leaves out the batch that the command's vertex belongs to, so its components are not converted.
/// `stops` are those of the command. Lists and watchers get such vertices, though.
inline bool is_left_out([[maybe_unused]] std::uint8_t stops) {
#if SPANGLE_FEATURE_BANDS
    const Context* const context = (stops & gate_left_out) != 0 ? current_context() : nullptr;
    return context != nullptr &&
           (context->gate & (gate_left_out | gate_compiling | gate_watched)) == gate_left_out;
#else
    return false;
#endif
}

#if SPANGLE_ARGUMENTS_INLINE

/// Arguments come by value, so that they stay in registers on the way that does not come here.
template <class... A>
[[gnu::noinline, gnu::cold]] bool admit_given(const Command& command, Context& context, A... args) {
    const Arg given[most_args] = {args...};
    return admit(context, command, given);
}

/// Of each vertex: nothing is looked up.
template <class F, class... A> inline void issue_attribute(const A&... args) {
    Context* context = current_context();
    if (context == nullptr) [[unlikely]]
        return;
    if ((context->gate & stops<F>) != 0 && !admit_given(command<F>, *context, Passed<A>::arg(args)...))
        [[unlikely]]
        return;
    F::run(*context, args...);
}

#endif

#if SPANGLE_ARGUMENTS_INLINE && !SPANGLE_FEATURE_LISTS

/// The current context where a command may run, else null.
Context* admitted(const Command& command);

/// Arguments lie where the family's function takes them. Commands of as many share this, whatever their
/// types.
template <class... A> [[gnu::noinline]] void issue_command(const Command& command, A... args) {
    if (Context* const context = admitted(command); context != nullptr)
        command(*context, args...);
}

#elif SPANGLE_ARGUMENTS_INLINE

/// Arguments lie where the family's function takes them. Commands of as many share this, whatever their
/// types.
template <class... A> [[gnu::noinline]] void issue_command(const Command& command, A... args) {
    Context* context = current_context();
    if (context == nullptr) [[unlikely]]
        return;
    if ((context->gate & command.stops) != 0 && !admit_given(command, *context, args...)) [[unlikely]]
        return;
    command(*context, args...);
}

#else

/// Of as many as the command has.
void issue_args(const Command& command, const Arg* args);

/// Up to three stay in the registers that they came in.
void issue_few(const Command& command);
void issue_few(Arg a, const Command& command);
void issue_few(Arg a, Arg b, const Command& command);
void issue_few(Arg a, Arg b, Arg c, const Command& command);

template <class... A> inline void issue_command(const Command& command, A... args) {
    if constexpr (sizeof...(A) <= few_args) {
        issue_few(args..., command);
    } else {
        const Arg given[] = {args...};
        issue_args(command, given);
    }
}

#endif

template <class F, class... A>
inline void issue_as(void (*)(Context&, A...), const std::type_identity_t<A>&... args) {
    issue_command(command<F>, Passed<A>::arg(args)...);
}

/// In line: arguments passed on by reference would have to lie in memory.
template <class F, class... A> [[gnu::always_inline]] inline void issue(const A&... args) {
    if constexpr (F::listing == Listing::never) {
        static_assert(!F::inside);
        tell_run<F>(F::run, args...);
        if (Context* context = outside_begin_end(F::text); context != nullptr) {
            F::run(*context, args...);
            explain_run<F>(*context, F::run, args...);
        }
    } else if constexpr (converts_in_line && F::listing == Listing::attribute) {
        issue_attribute<F>(args...);
    } else {
        issue_as<F>(F::run, args...);
    }
}

/// The same for commands that return a value: 0 when they may not run (GL 1.3, 2.5).
template <class F, class... A>
[[gnu::always_inline]] inline auto ask(A... args) -> decltype(F::run(*current_context(), args...)) {
    static_assert(F::listing == Listing::never && !F::inside);
    tell_run<F>(F::run, args...);
    Context* context = outside_begin_end(F::text);
    if (context == nullptr)
        return {};
    const auto answer = F::run(*context, args...);
    explain_run<F>(*context, F::run, args...);
    return answer;
}

/// The same for queries of parameters; `out` stays empty when they may not run.
template <class F, class... A> [[gnu::always_inline]] inline void fetch(Params& out, A... args) {
    static_assert(F::listing == Listing::never && !F::inside);
    const Arg given[] = {Passed<A>::arg(args)...};
    if (SPANGLE_WATCHED && current_context() != nullptr)
        tell_watcher(*current_context(), F::text, given, sizeof...(A));
    if (Context* context = outside_begin_end(F::text); context != nullptr) {
        F::run(*context, args..., out);
        explain_error(*context, F::text, given, sizeof...(A));
    }
}

} // namespace spangle::gl
