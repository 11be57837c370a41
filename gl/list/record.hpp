// Converts commands to words of a display list, and describes how these are played. A record is the address
// of its player, followed by the command's canonical arguments. A program that never calls a command has no
// reference to its player, so that the linker drops the player.
#pragma once

#include <type_traits>

#include "gl/api/family.hpp"
#include "gl/context/context.hpp"
#include "gl/context/error.hpp"

namespace spangle::gl::list {

/// The form of a command's record.
enum class Form : std::uint8_t {
    words,   ///< the record has one word for each argument
    encoded, ///< the command's encoder writes most records; the others have the form `words`
    params,  ///< the last argument is Params: a count, followed by that many words
    matrix,  ///< the last argument is a Matrix16: 16 words
    own,     ///< the record has a player of its own
};

/// A constant that describes how records of one kind are played.
struct Player {
    /// Bits of the gate that keep the command from running without further tests.
    std::uint8_t stops = 0;
    std::uint8_t args = 0; ///< number of the command's arguments
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
/// Returns the player of records with a function of their own. `F` is the command's family if errors name the
/// command, and void otherwise.
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
/// Words of an address of a record.
inline constexpr std::uint32_t address_words = sizeof(void*) / sizeof(Word);

/// Appends a record, closes an open run, and returns where the record's `words` words of arguments go. Null:
/// there is no memory, which EndList reports.
Word* record(Context& context, const Player* player, std::uint32_t words);

/// Records a command that is known to fail. When it is played, it raises `code`, or INVALID_OPERATION between
/// Begin and End unless `inside` is true. `rule` is as for error().
#if SPANGLE_MESSAGES
void record_error(Context& context, GLenum code, bool inside, const char* rule = nullptr);
#else
void record_error(Context& context, GLenum code, bool inside);
inline void record_error(Context& context, GLenum code, bool inside, const char*) {
    record_error(context, code, inside);
}
#endif

} // namespace spangle::gl::list
