// Describes each command family as a constant. With it, common code checks, records and plays the commands of
// all families, although their arguments differ.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "gl/list/record.hpp"

namespace spangle::gl {

namespace family {
struct Vertex; // generated/commands.hpp defines it
}

inline constexpr std::size_t most_args = 10;

/// Converts a canonical argument of type T to a word, in which it is passed, and back.
template <class T> struct Passed {
    static constexpr Arg arg(T value) { return static_cast<Arg>(value); }
    static constexpr T value(Arg arg) { return static_cast<T>(arg); }
};
template <> struct Passed<bool> {
    static constexpr Arg arg(bool value) { return value ? 1 : 0; }
    static constexpr bool value(Arg arg) { return (arg & 1) != 0; }
};
template <> struct Passed<Real> {
    static constexpr Arg arg(Real value) { return value.bits; }
    static constexpr Real value(Arg arg) { return {static_cast<std::uint32_t>(arg)}; }
};
template <class T> struct Passed<T*> {
    static Arg arg(T* value) { return reinterpret_cast<Arg>(value); }
    static T* value(Arg arg) { return reinterpret_cast<T*>(arg); }
};
template <class T> struct Passed<const T&> {
    static Arg arg(const T& value) { return reinterpret_cast<Arg>(&value); }
    static const T& value(Arg arg) { return *reinterpret_cast<const T*>(arg); }
};

// The functions of families are called through common types of functions, which take 3, 6 or 10 words. A
// family uses the type with the fewest words that hold its arguments.
template <std::size_t> using AnyArg = Arg;
template <class Places> struct Taking;
template <std::size_t... I> struct Taking<std::index_sequence<I...>> {
    using Function = void(Context&, AnyArg<I>...);

    /// The function is inline, so that arguments stay in registers.
    [[gnu::always_inline]] static void call(Function* function, Context& context, const Arg* args) {
        function(context, args[I]...);
    }

    template <auto function, class... A, std::size_t... J>
    static constexpr Function* of(void (*)(Context&, A...), std::index_sequence<J...>) {
        return [](Context& context, AnyArg<I>... args) {
            [[maybe_unused]] const Arg given[] = {args...};
            function(context, Passed<A>::value(given[J])...);
        };
    }
};
inline constexpr std::size_t few_args = 3, some_args = 6;
using Few = Taking<std::make_index_sequence<few_args>>;
using Some = Taking<std::make_index_sequence<some_args>>;
using Many = Taking<std::make_index_sequence<most_args>>;

union Run {
    Few::Function* few = nullptr;
    Some::Function* some;
    Many::Function* many;
};

template <auto function, class... A> constexpr Run run_of(void (*typed)(Context&, A...)) {
    constexpr auto places = std::index_sequence_for<A...>{};
    if constexpr (sizeof...(A) <= few_args)
        return {.few = Few::of<function>(typed, places)};
    else if constexpr (sizeof...(A) <= some_args)
        return {.some = Some::of<function>(typed, places)};
    else
        return {.many = Many::of<function>(typed, places)};
}

/// Calls the function of a command with `count` arguments.
void call(Context& context, const Run& run, std::size_t count, const Arg (&args)[most_args]);

#if SPANGLE_MESSAGES
/// Sends the message of an error that the command has just raised, if there is one.
inline void explain_error(Context& context, const CommandText* text, const Arg* args, unsigned count) {
    if (context.pending_error.code != GL_NO_ERROR) [[unlikely]]
        explain(context, *text, args, count);
}
#else
inline void explain_error(Context&, const CommandText*, const Arg*, unsigned) {}
#endif

/// Sends the message of an error of a command whose arguments are not words yet.
template <class F, class R, class... A>
[[gnu::always_inline]] inline void explain_run([[maybe_unused]] Context& context, R (*)(Context&, A...),
                                               [[maybe_unused]] const std::type_identity_t<A>&... args) {
#if SPANGLE_MESSAGES
    if (context.pending_error.code == GL_NO_ERROR) [[likely]]
        return;
    const Arg given[] = {Passed<A>::arg(args)..., 0};
    explain(context, *F::text, given, sizeof...(A));
#endif
}

/// Reports a command to the context's watcher, which exists on hosts only.
inline void tell_watcher([[maybe_unused]] Context& context, [[maybe_unused]] const CommandText* text,
                         [[maybe_unused]] const Arg* args, [[maybe_unused]] unsigned count) {
#if SPANGLE_WATCHED
    if ((context.gate & gate_watched) != 0 && text != nullptr) [[unlikely]]
        context.watcher->command(context, *text, args, count);
#endif
}

/// Reports a command that runs at once to the watcher. The arguments of the command are not words yet.
template <class F, class R, class... A>
[[gnu::always_inline]] inline void tell_run([[maybe_unused]] R (*)(Context&, A...),
                                            [[maybe_unused]] const std::type_identity_t<A>&... args) {
#if SPANGLE_WATCHED
    Context* const context = current_context();
    if (context == nullptr || (context->gate & gate_watched) == 0 || F::text == nullptr) [[likely]]
        return;
    const Arg given[] = {Passed<A>::arg(args)..., 0};
    context->watcher->command(*context, *F::text, given, sizeof...(A));
#endif
}

struct Command : list::Player {
    Run run;

    /// Runs the command with arguments whose number is known.
    template <class... A> void operator()(Context& context, A... args) const {
        const Arg given[most_args] = {args...};
        if constexpr (sizeof...(A) <= few_args)
            Few::call(run.few, context, given);
        else if constexpr (sizeof...(A) <= some_args)
            Some::call(run.some, context, given);
        else
            Many::call(run.many, context, given);
        explain_error(context, text, given, sizeof...(A));
    }
};

/// A command that display lists record by its own encoder, not word by word.
struct EncodedCommand : Command {
#if SPANGLE_FEATURE_LISTS
    Run encode;
#endif
};

template <class F>
constexpr std::uint8_t stops = static_cast<std::uint8_t>(
    (F::inside ? 0 : gate_inside) | gate_watched |
    (SPANGLE_FEATURE_BANDS && std::is_same_v<F, family::Vertex> ? gate_left_out : 0) |
    (SPANGLE_FEATURE_LISTS && F::listing != Listing::never ? gate_compiling : 0));

/// Whether a command may run. A command that is not allowed between Begin and End raises INVALID_OPERATION
/// there (GL 1.3, 2.6.3).
bool may_run_here(Context& context, const list::Player& command);

template <class... A> constexpr list::Form form_of(void (*)(Context&, A...)) {
    return (std::is_same_v<A, const Params&> || ...)     ? list::Form::params
           : (std::is_same_v<A, const Matrix16&> || ...) ? list::Form::matrix
                                                         : list::Form::words;
}
template <class... A> constexpr std::uint8_t count_args(void (*)(Context&, A...)) {
    static_assert(sizeof...(A) <= most_args);
    return sizeof...(A);
}

template <class F> constexpr auto command_of() {
    constexpr bool encoded = !std::is_null_pointer_v<decltype(F::encode)>;
    std::conditional_t<encoded, EncodedCommand, Command> command;
    command.stops = stops<F>;
    command.args = count_args(F::run);
    command.form = encoded ? list::Form::encoded : form_of(F::run);
#if SPANGLE_MESSAGES
    command.text = F::text;
#endif
    command.run = run_of<F::run>(F::run);
#if SPANGLE_FEATURE_LISTS
    if constexpr (encoded)
        command.encode = run_of<F::encode>(F::encode);
#endif
    return command;
}

template <class F> inline constexpr auto command = command_of<F>();

namespace list {

/// The number of a command's arguments that are single words.
constexpr unsigned words_of(const Command& command) {
    return command.args - (command.form > Form::encoded ? 1u : 0u);
}

/// Records a command with its arguments, word by word.
void write(Context& context, const Command& command, const Arg* args);

/// Plays a record of a command; returns the next record.
const Word* play_command(Context& context, const Command& command, const Word* words);

template <class F, class... A> void record_words(Context& context, const A&... args) {
    const Arg given[] = {Passed<A>::arg(args)...};
    write(context, command<F>, given);
}

} // namespace list

} // namespace spangle::gl
