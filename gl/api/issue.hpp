// The steps that every entry point takes once its arguments are canonical. It checks Begin and End, and then
// records the command or runs it.
#pragma once

#include <type_traits>

#include "gl/api/command.hpp"
#include "gl/context/limits.hpp"

namespace spangle::gl {

/// Raises INVALID_VALUE for a null pointer that must not be null, so that the program does not crash.
void refuse_null(const char* text);

/// Raises INVALID_OPERATION for a command of a system that this build leaves out, with a message that names
/// the feature.
void refuse_feature(const char* text);

/// Returns the current context if no primitive is open in it. Between Begin and End, the function raises
/// INVALID_OPERATION and returns null. Without a current context it returns null.
Context* outside_begin_end(const CommandText* text);

/// The slow path of entry points. It reports a command to the watcher, records it while a list is compiled,
/// and checks Begin and End. Returns whether the command is to run now. Errors of a recorded command are
/// found when it is played, not here (GL 1.3, appendix B, corollary 9).
bool must_run_now(Context& context, const Command& command, const Arg (&args)[most_args]);

/// Whether the band leaves out the batch that the vertex belongs to, so that its components need no
/// conversion. `stops` has the bits of the gate that stop the command. Lists and watchers still get such
/// vertices.
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

/// Does what must_run_now() does. Arguments are passed by value, so that they stay in registers on the path
/// that does not call this function.
template <class... A>
[[gnu::noinline, gnu::cold]] bool admit_given(const Command& command, Context& context, A... args) {
    const Arg given[most_args] = {args...};
    return must_run_now(context, command, given);
}

/// Issues a command that programs give for every vertex. The function of its family is called directly,
/// without the descriptor.
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

/// Returns the current context if a command may run, or else null.
Context* admitted(const Command& command);

/// Issues a command. Arguments are already where the family's function expects them. All commands with the
/// same number of arguments therefore share this function, although their types differ.
template <class... A> [[gnu::noinline]] void issue_command(const Command& command, A... args) {
    if (Context* const context = admitted(command); context != nullptr)
        command(*context, args...);
}

#elif SPANGLE_ARGUMENTS_INLINE

/// Issues a command. Arguments are already where the family's function expects them. All commands with the
/// same number of arguments therefore share this function, although their types differ.
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

/// These functions issue a command with up to three arguments, which stay in the registers in which they were
/// passed.
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

/// Issues a command of any kind. The function is inline, because arguments passed by reference would have to
/// be stored in memory.
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

/// Runs a command that returns a value. Returns 0 if the command may not run (GL 1.3, 2.5).
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

/// Runs a query of parameters. If the query may not run, `out` stays empty.
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
