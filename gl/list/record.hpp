// How a command becomes words of a display list and how they are played. A record is the address of its
// player and the command's canonical arguments: what a program never calls is never referenced, so the linker
// drops it.
#pragma once

#include "gl/api/family.hpp"
#include "gl/context/context.hpp"
#include "gl/context/error.hpp"

namespace spangle::gl::list {

/// A constant that says how records of one kind are played.
struct Player {
#if SPANGLE_FEATURE_LISTS
    /// Executes the record whose arguments start at `words`; returns the next record, or null after a jump
    /// that ended. The player's own address lies before them.
    const Word* (*play)(Context& context, const Word* words) = nullptr;
#endif
};

template <auto play> inline constexpr Player player{play};

inline constexpr std::uint32_t player_words = sizeof(Player*) / sizeof(Word);
inline constexpr std::uint32_t address_words = sizeof(void*) / sizeof(Word); ///< of a position in a list

/// Room for the arguments of a new record, or null without memory (EndList reports that). Closes an open run.
Word* record(Context& context, const Player* player, std::uint32_t words);

/// One word per argument; a matrix and parameters stand last and take more.
template <class T> struct Codec {
    static constexpr std::uint32_t most = 1;
    static std::uint32_t words(T) { return 1; }
    static void store(Word* to, T value) { *to = static_cast<Word>(value); }
    static T load(const Word* from) { return static_cast<T>(*from); }
    static std::uint32_t stored(const Word*) { return 1; }
};
template <> struct Codec<Real> {
    static constexpr std::uint32_t most = 1;
    static std::uint32_t words(Real) { return 1; }
    static void store(Word* to, Real value) { *to = value.bits; }
    static Real load(const Word* from) { return {*from}; }
    static std::uint32_t stored(const Word*) { return 1; }
};
template <> struct Codec<const Matrix16&> {
    static constexpr std::uint32_t most = 16;
    static std::uint32_t words(const Matrix16&) { return 16; }
    static void store(Word* to, const Matrix16& matrix) {
        for (const Real element : matrix.m)
            *to++ = element.bits;
    }
    static Matrix16 load(const Word* from) {
        Matrix16 matrix;
        for (Real& element : matrix.m)
            element.bits = *from++;
        return matrix;
    }
    static std::uint32_t stored(const Word*) { return 16; }
};
template <> struct Codec<const Params&> {
    static constexpr std::uint32_t most = 1 + sizeof(Params::v) / sizeof(Param);
    static std::uint32_t words(const Params& params) { return 1 + params.count; }
    static void store(Word* to, const Params& params) {
        *to++ = params.count;
        for (std::uint32_t i = 0; i < params.count; ++i)
            *to++ = params.v[i].word;
    }
    static Params load(const Word* from) {
        Params params;
        params.count = *from++;
        for (std::uint32_t i = 0; i < params.count; ++i)
            params.v[i].word = *from++;
        return params;
    }
    static std::uint32_t stored(const Word* from) { return 1 + *from; }
};

/// An argument that takes one.
template <class T> Word word_of(T value) {
    static_assert(Codec<T>::most == 1);
    Word word;
    Codec<T>::store(&word, value);
    return word;
}

/// Stores a command that is already known to fail: it raises `code` when executed, or INVALID_OPERATION
/// between Begin and End unless it is allowed there.
void record_error(Context& context, GLenum code, bool inside);

} // namespace spangle::gl::list
