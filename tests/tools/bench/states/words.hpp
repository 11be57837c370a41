// The grammar of states: a word is one thing that a program sets and that reaches fragments, and a choice is
// one of its values. words.cpp is the only list of them. States are chosen, applied, compared and named by
// this list.
#pragma once

#include <cstdint>

#include "boards/scenes/gl.hpp"

namespace spangle::bench::states {

/// Words in the order in which they are chosen: whether a word applies depends on the words before it.
enum class Word : std::uint8_t {
    surface,
    tier,
    samples,
    shape,
    view,
    shade,
    alpha,
    texture,
    format,
    filter,
    scale,
    wrap,
    env,
    texture2,
    filter2,
    env2,
    alpha_test,
    stencil,
    depth,
    depth_write,
    offset,
    logic,
    blend,
    mask,
    fog,
    dither,
    scissor,
    stipple,
    smooth,
    count
};
inline constexpr int word_count = static_cast<int>(Word::count);

enum Surface : std::uint8_t { surface_565_z16, surface_8888_z24s8 };
enum Shape : std::uint8_t { triangles, small_triangles, lines, wide_lines, points, large_points, sprites };
enum View : std::uint8_t { parallel, mild, harsh };
enum Shade : std::uint8_t { one_color, flat, smooth_color, lit, lit_specular };

/// `work` has a bit for each kind of work that a choice asks for. A choice with some of another's bits, and
/// not all, asks for less.
/// The work of a choice that is neither more nor less than another's, such as a test that some fragments
/// fail.
inline constexpr std::int16_t unordered = -1;
struct Choice {
    const char* name;
    std::uint8_t weight; ///< how often the choice is made, relative to the others
    std::int16_t work;
    GLenum value[3]; ///< values that GL is given
};

struct WordInfo {
    const char* name;
    bool pass; ///< whether it adds a texture, a filter or another pass, and so may cost any amount
    const Choice* choices;
    std::uint8_t count;
};
const WordInfo& info(Word word);

struct State {
    std::uint8_t choice[word_count] = {};
    std::uint8_t& operator[](Word word) { return choice[static_cast<int>(word)]; }
    std::uint8_t operator[](Word word) const { return choice[static_cast<int>(word)]; }
    bool has(Word word) const { return (*this)[word] != 0; } ///< whether the word is not its first choice
    const GLenum* value(Word word) const { return info(word).choices[(*this)[word]].value; }
};

} // namespace spangle::bench::states
