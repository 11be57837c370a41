// What every entry point does once its arguments are canonical: checks Begin and End, records, or runs the
// command.
#pragma once

#include <type_traits>

#include "gl/api/command.hpp"
#include "gl/context/limits.hpp"

namespace spangle::gl {

/// Raises INVALID_VALUE for a null pointer that must not be null, instead of a crash.
void refuse_null(const char* text);

/// Raises INVALID_OPERATION for a command of a system that this build leaves out, with a message that names
/// the feature.
void refuse_feature(const char* text);

/// The current context if no primitive is open in it. Between Begin and End it raises INVALID_OPERATION and
/// returns null; without a context it returns null.
Context* outside_begin_end(const CommandText* text);

/// The slow path of entry points: reports to the watcher, records while a list is compiled, and checks Begin
/// and End. Returns whether the command is to run now. Errors of a recorded command are found when it is
/// played, not here (GL 1.3, appendix B, corollary 9).
bool must_run_now(Context& context, const Command& command, const Arg (&args)[most_args]);

/// Whether the band leaves out the batch that the vertex belongs to, so that its components need no
/// conversion. `stops` are the command's. Lists and watchers still get such vertices.
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

/// Takes arguments by value, so that they stay in registers on the path that does not call this.
template <class... A>
[[gnu::noinline, gnu::cold]] bool admit_given(const Command& command, Context& context, A... args) {
    const Arg given[most_args] = {args...};
    return must_run_now(context, command, given);
}

/// Issues a command that comes with every vertex: its function is called directly, without its descriptor.
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

/// The current context if a command may run, else null.
Context* admitted(const Command& command);

/// Issues a command. Arguments lie where the family's function takes them, so all commands with as many
/// arguments share this function, whatever their types.
template <class... A> [[gnu::noinline]] void issue_command(const Command& command, A... args) {
    if (Context* const context = admitted(command); context != nullptr)
        command(*context, args...);
}

#elif SPANGLE_ARGUMENTS_INLINE

/// Issues a command. Arguments lie where the family's function takes them, so all commands with as many
/// arguments share this function, whatever their types.
template <class... A> [[gnu::noinline]] void issue_command(const Command& command, A... args) {
    Context* context = current_context();
    if (context == nullptr) [[unlikely]]
        return;
    if ((context->gate & command.stops) != 0 && !admit_given(command, *context, args...)) [[unlikely]]
        return;
    command(*context, args...);
}

#else

/// Issues a command whose arguments are an array of words.
void issue_args(const Command& command, const Arg* args);

/// Issue a command with up to three arguments, which stay in the registers that they came in.
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

/// Issues a command of any kind. In line, because arguments passed by reference would have to lie in memory.
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

/// Runs a command that returns a value; returns 0 when it may not run (GL 1.3, 2.5).
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

/// Runs a query of parameters; `out` stays empty when it may not run.
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
