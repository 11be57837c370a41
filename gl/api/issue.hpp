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
Context* outside_begin_end(const char* refusal);

#if SPANGLE_FEATURE_LISTS

/// The slow way in: records while a list is compiled, and checks Begin/End. True when the command is to run
/// now. Errors of a recorded command are found when it is executed, not here (GL 1.3, appendix B, corollary
/// 9).
bool admit_words(Context& context, const Gated& command, const list::Word* words, std::uint32_t count);

// Arguments come by value, so that they stay in registers on the way that does not come here. In line they
// are passed on once.
#if SPANGLE_ARGUMENTS_INLINE
#define SPANGLE_ADMIT [[gnu::noinline, gnu::cold]]
#else
#define SPANGLE_ADMIT [[gnu::always_inline]] inline
#endif
template <class... A> SPANGLE_ADMIT bool admit(const Command<A...>& command, Context& context, A... args) {
    list::Words<A...> words(args...);
    return admit_words(context, command, words.at(), words.count);
}
template <class... A>
SPANGLE_ADMIT bool admit(const EncodedCommand<A...>& command, Context& context, A... args) {
    if ((context.gate & gate_compiling) != 0) {
        command.encode(context, args...);
        if (!context.list.execute)
            return false;
    }
    return allowed(context, command);
}
#undef SPANGLE_ADMIT

#else

template <class... A> inline bool admit(const Gated& command, Context& context, const A&...) {
    return allowed(context, command);
}

/// The current context where a command may run, else null.
Context* admitted(const Gated& command);

#endif

#if !SPANGLE_FEATURE_LISTS

/// Arguments lie where the family's function takes them.
template <template <class...> class Kind, class... A>
[[gnu::noinline]] void issue_command(const Kind<A...>& command, std::type_identity_t<A>... args) {
    if (Context* const context = admitted(command); context != nullptr)
        command.run(*context, args...);
}

#elif !SPANGLE_ARGUMENTS_INLINE

/// Records and plays what stands in `words`, behind room for the player.
void issue_words(const Gated& command, list::Word* words, std::uint32_t count);

/// What lists play is played at once. Commands of as many words share this, whatever their types.
template <class... A> [[gnu::noinline]] void issue_arguments(const Gated& command, A... args) {
    list::Words<A...> words(args...);
    issue_words(command, words.at(), words.count);
}
template <class... A>
inline void issue_command(const Command<A...>& command, std::type_identity_t<A>... args) {
    if constexpr ((std::is_reference_v<A> || ...))
        issue_arguments<A...>(command, args...);
    else
        issue_arguments(command, list::word_of<A>(args)...);
}

/// What is done with arguments next.
enum class Step : std::uint8_t { none, record, run };
Step next_step(Context* context, const Gated& command, Step done);

template <class... A>
[[gnu::noinline]] void issue_command(const EncodedCommand<A...>& command, std::type_identity_t<A>... args) {
    Context* const context = current_context();
    for (Step step = Step::none; (step = next_step(context, command, step)) != Step::none;)
        (step == Step::record ? command.encode : command.run)(*context, args...);
}

#else

/// Arguments lie where the family's function takes them, too.
template <template <class...> class Kind, class... A>
[[gnu::noinline]] void issue_command(const Kind<A...>& command, std::type_identity_t<A>... args) {
    Context* context = current_context();
    if (context == nullptr) [[unlikely]]
        return;
    if ((context->gate & command.stops) != 0 && !admit<A...>(command, *context, args...)) [[unlikely]]
        return;
    command.run(*context, args...);
}

#endif

template <class F, class... A> inline void issue(const A&... args) {
    if constexpr (F::listing == Listing::never) {
        static_assert(!F::inside);
        if (Context* context = outside_begin_end(F::refusal); context != nullptr)
            F::run(*context, args...);
    } else if constexpr (F::listing == Listing::attribute) { // of each vertex: nothing is looked up
        Context* context = current_context();
        if (context == nullptr) [[unlikely]]
            return;
        if ((context->gate & stops<F>) != 0 && !admit<A...>(command<F>, *context, args...)) [[unlikely]]
            return;
        F::run(*context, args...);
    } else {
        issue_command(command<F>, args...);
    }
}

/// The same for commands that return a value: 0 when they may not run (GL 1.3, 2.5).
template <class F, class... A> inline auto ask(A... args) -> decltype(F::run(*current_context(), args...)) {
    static_assert(F::listing == Listing::never && !F::inside);
    Context* context = outside_begin_end(F::refusal);
    if (context == nullptr)
        return 0;
    return F::run(*context, args...);
}

/// The same for queries of parameters; `out` stays empty when they may not run.
template <class F, class... A> inline void fetch(Params& out, A... args) {
    static_assert(F::listing == Listing::never && !F::inside);
    if (Context* context = outside_begin_end(F::refusal); context != nullptr)
        F::run(*context, args..., out);
}

} // namespace spangle::gl
