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

template <class... A> struct Command : Gated { void (*run)(Context&, A...) = nullptr; };

/// One that lists take by a function of its own, not word by word.
template <class... A> struct EncodedCommand : Command<A...> {
#if SPANGLE_FEATURE_LISTS
    void (*encode)(Context&, A...) = nullptr;
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

/// A record of these arguments.
void write(Context& context, const Player& player, const Word* words, std::uint32_t count);

/// The arguments as words of a record, behind room for its player.
template <class... A> struct Words {
    Word record[player_words + (Codec<A>::most + ... + 0u)];
    std::uint32_t count = 0;
    explicit Words(A... args) {
        ((Codec<A>::store(at() + count, args), count += Codec<A>::words(args)), ...);
    }
    Word* at() { return record + player_words; }
};

} // namespace list

template <class F, class... A> constexpr auto command_of(void (*)(Context&, A...)) {
    constexpr bool encoded = F::encode != nullptr;
    std::conditional_t<encoded, EncodedCommand<A...>, Command<A...>> command;
    command.stops = stops<F>;
#if SPANGLE_MESSAGES
    command.refusal = F::refusal;
#endif
    command.run = F::run;
#if SPANGLE_FEATURE_LISTS
    if constexpr (encoded)
        command.encode = F::encode;
    if constexpr (F::listing == Listing::words || F::listing == Listing::attribute)
        command.play = &list::play_words<A...>;
#endif
    return command;
}

template <class F> inline constexpr auto command = command_of<F>(F::run);

namespace list {

template <class... A>
void record_words(Context& context, const Command<A...>& command, std::type_identity_t<A>... args) {
    Words<A...> words(args...);
    write(context, command, words.at(), words.count);
}
template <class F, class... A> inline void record_words(Context& context, const A&... args) {
    record_words(context, command<F>, args...);
}

} // namespace list

} // namespace spangle::gl
