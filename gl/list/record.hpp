// How commands become words of a display list, and how these are played. A record is the address of its
// player, then the command's canonical arguments. Players of commands that a program never calls are never
// referenced, so the linker drops them.
#pragma once

#include <type_traits>

#include "gl/api/family.hpp"
#include "gl/context/context.hpp"
#include "gl/context/error.hpp"

namespace spangle::gl::list {

/// The form of a command's record.
enum class Form : std::uint8_t {
    words,   ///< one word for each argument
    encoded, ///< the command's encoder writes most records; others are as with `words`
    params,  ///< the last argument is Params: a count, then that many words
    matrix,  ///< the last argument is a Matrix16: 16 words
    own,     ///< the record has a player of its own
};

/// A constant that describes how records of one kind are played.
struct Player {
    std::uint8_t stops = 0; ///< bits of the gate that keep the command from simply running
    std::uint8_t args = 0;  ///< number of the command's arguments
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
/// `F` is the command's family if errors of playing a record shall name the command; else void.
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
inline constexpr std::uint32_t address_words = sizeof(void*) / sizeof(Word); ///< words of a list position

/// Appends a record and returns where its `words` words of arguments go; closes an open run. Returns null
/// without memory, which EndList reports.
Word* record(Context& context, const Player* player, std::uint32_t words);

/// Records a command that is already known to fail. When played it raises `code`, or INVALID_OPERATION
/// between Begin and End unless `inside` allows it there. `rule` is as for error().
#if SPANGLE_MESSAGES
void record_error(Context& context, GLenum code, bool inside, const char* rule = nullptr);
#else
void record_error(Context& context, GLenum code, bool inside);
inline void record_error(Context& context, GLenum code, bool inside, const char*) {
    record_error(context, code, inside);
}
#endif

} // namespace spangle::gl::list
