// A family as a constant. Families with arguments of the same types share the code that checks, records and
// plays them.
#pragma once

#include <type_traits>
#include <utility>

#include "gl/list/record.hpp"

namespace spangle::gl {

/// What there is to know before arguments are looked at.
struct Gated : list::Player {
    std::uint8_t stops = 0; ///< the bits of the gate that keep the command from simply running
#if SPANGLE_MESSAGES
    const char* refusal = nullptr;
#else
    static constexpr const char* refusal = nullptr;
#endif
};

template <class... A> struct Command : Gated {
    void (*run)(Context&, A...) = nullptr;
#if SPANGLE_FEATURE_LISTS
    void (*encode)(Context&, A...) = nullptr; ///< null: word by word
#endif
};

template <class F>
constexpr std::uint8_t stops =
    static_cast<std::uint8_t>((F::inside ? 0 : gate_inside) |
                              (SPANGLE_FEATURE_LISTS && F::listing != Listing::never ? gate_compiling : 0));

/// False, and INVALID_OPERATION, for a command that Begin and End do not allow between them (GL 1.3, 2.6.3).
bool allowed(Context& context, const Gated& command);

namespace list {

template <class... A, std::size_t... I>
void run_words(Context& context, const Command<A...>& command, const Word* words, std::index_sequence<I...>) {
    command.run(context, Codec<A>::load(words + I)...); // all but the last argument take one word
}

template <class... A> const Word* play_words(Context& context, const Word* words) {
    const Player* player;
    __builtin_memcpy(&player, words - player_words, sizeof player);
    const auto& command = static_cast<const Command<A...>&>(*player);
    if (allowed(context, command))
        run_words(context, command, words, std::index_sequence_for<A...>{});
    ((words += Codec<A>::stored(words)), ...);
    return words;
}

/// Client data needs an encoder by hand.
template <class... A>
inline constexpr bool are_words = ((!std::is_pointer_v<A> && !std::is_same_v<A, const Values&>)&&...);

template <class... A>
void write_words(Context& context, const Command<A...>& command, std::type_identity_t<A>... args) {
    Word* to = record(context, &command, (Codec<A>::words(args) + ... + 0u));
    if (to != nullptr)
        ((Codec<A>::store(to, args), to += Codec<A>::words(args)), ...);
}

} // namespace list

template <class F, class... A> constexpr Command<A...> command_of(void (*)(Context&, A...)) {
    Command<A...> command;
    command.stops = stops<F>;
#if SPANGLE_MESSAGES
    command.refusal = F::refusal;
#endif
    command.run = F::run;
#if SPANGLE_FEATURE_LISTS
    command.encode = F::encode;
    if constexpr (F::listing == Listing::words || F::listing == Listing::attribute)
        command.play = &list::play_words<A...>;
#endif
    return command;
}

template <class F> inline constexpr auto command = command_of<F>(F::run);

namespace list {

template <class F, class... A> inline void record_words(Context& context, const A&... args) {
    write_words(context, command<F>, args...);
}

} // namespace list

} // namespace spangle::gl
