// How a command becomes words of a display list and how they are played. A record is the address of its
// player and the command's canonical arguments: what a program never calls is never referenced, so the linker
// drops it.
#pragma once

#include <type_traits>

#include "gl/api/family.hpp"
#include "gl/context/context.hpp"
#include "gl/context/error.hpp"

namespace spangle::gl::list {

/// What the record of a command is made of.
enum class Form : std::uint8_t {
    words,   ///< one for each argument
    encoded, ///< a function of its own makes the record of a command; what it does not make is as with words
    params,  ///< the last one is Params: their number and so many words
    matrix,  ///< the last one is a Matrix16
    own,     ///< the record has a player of its own
};

/// A constant that says how records of one kind are played.
struct Player {
    std::uint8_t stops = 0; ///< the bits of the gate that keep a command from simply running
    std::uint8_t args = 0;  ///< how many it has
    Form form = Form::words;
#if SPANGLE_MESSAGES
    const CommandText* text = nullptr;
#else
    static constexpr const CommandText* text = nullptr;
#endif
};

/// Executes the record whose arguments start at `words`; returns the next record.
using Play = const Word*(Context& context, const Word* words);

struct OwnPlayer : Player {
    Play* play = nullptr;
};
/// `F` is the family whose command the record is, if its errors are to be explained after it was played.
template <class F> constexpr OwnPlayer own_player(Play* play) {
    OwnPlayer player;
    player.form = Form::own;
    player.play = play;
#if SPANGLE_MESSAGES
    if constexpr (!std::is_void_v<F>)
        player.text = F::text;
#endif
    return player;
}
template <auto play, class F = void> inline constexpr OwnPlayer player = own_player<F>(play);

inline constexpr std::uint32_t player_words = sizeof(Player*) / sizeof(Word);
inline constexpr std::uint32_t address_words = sizeof(void*) / sizeof(Word); ///< of a position in a list

/// Room for the arguments of a new record, or null without memory (EndList reports that). Closes an open run.
Word* record(Context& context, const Player* player, std::uint32_t words);

/// Stores a command that is already known to fail: it raises `code` when executed, or INVALID_OPERATION
/// between Begin and End unless it is allowed there. `rule` is as that of error().
#if SPANGLE_MESSAGES
void record_error(Context& context, GLenum code, bool inside, const char* rule = nullptr);
#else
void record_error(Context& context, GLenum code, bool inside);
inline void record_error(Context& context, GLenum code, bool inside, const char*) {
    record_error(context, code, inside);
}
#endif

} // namespace spangle::gl::list
