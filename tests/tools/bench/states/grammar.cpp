#include "tests/tools/bench/states/grammar.hpp"

#include <initializer_list>

#include "tests/support/random.hpp"

namespace spangle::bench::states {

namespace {

using test::Random;

/// Mixes a number, so that neighbouring numbers begin different sequences.
std::uint32_t mixed(std::uint32_t v) {
    v = (v ^ v >> 16) * 0x7FEB352Du;
    v = (v ^ v >> 15) * 0x846CA68Bu;
    return v ^ v >> 16;
}

std::uint8_t weighted(Random& random, const WordInfo& word) {
    std::uint32_t sum = 0;
    for (int i = 0; i < word.count; ++i)
        sum += word.choices[i].weight;
    std::uint32_t at = random.below(sum);
    std::uint8_t i = 0;
    while (at >= word.choices[i].weight)
        at -= word.choices[i++].weight;
    return i;
}

/// Completes the words from `first` on: words that do not apply are cleared, and words that now apply are
/// chosen at random.
void complete(Random& random, State& state, int first, const State* before) {
    for (int i = first; i < word_count; ++i) {
        const auto word = static_cast<Word>(i);
        if (!applies(state, word))
            state[word] = 0;
        else if (before == nullptr || !applies(*before, word))
            state[word] = weighted(random, info(word));
    }
}

constexpr int first_of_key = static_cast<int>(Word::samples);

State neighbour(Random& random, const State& of) {
    State next = of;
    do {
        next = of;
        const auto place =
            first_of_key +
            static_cast<int>(random.below(static_cast<std::uint32_t>(word_count - first_of_key)));
        const auto word = static_cast<Word>(place);
        if (word == Word::shape || !applies(of, word)) // other shapes have other fragments
            continue;
        next[word] = static_cast<std::uint8_t>(random.below(info(word).count));
        complete(random, next, place + 1, &of);
    } while (distance(of, next) != 1);
    return next;
}

} // namespace

bool applies(const State& state, Word word) {
    const std::uint8_t shape = state[Word::shape];
    const bool polygons = shape == triangles || shape == small_triangles || shape == sprites;
    const bool thin = shape == lines || shape == wide_lines;
    switch (word) {
    case Word::view:
        return thin || (polygons && shape != sprites);
    case Word::format:
    case Word::filter:
    case Word::wrap:
    case Word::env:
        return state.has(Word::texture);
    case Word::scale:
        return state.has(Word::texture) && (thin || (polygons && shape != sprites));
    case Word::filter2:
    case Word::env2:
        return state.has(Word::texture2);
    case Word::depth_write:
        return state.has(Word::depth);
    case Word::offset:
        return state.has(Word::depth) && polygons && shape != sprites;
    case Word::blend:
        return !state.has(Word::logic);
    case Word::stipple:
        return polygons || thin;
    case Word::smooth:
        return !polygons && !state.has(Word::samples);
    default:
        return true;
    }
}

int distance(const State& a, const State& b) {
    int words = 0;
    for (int i = 0; i < word_count; ++i) {
        const auto word = static_cast<Word>(i);
        words += a[word] != b[word] && applies(a, word) && applies(b, word) ? 1 : 0;
    }
    return words;
}

State state(std::uint32_t seed, std::uint32_t number) {
    const std::uint32_t key = number / variants, variant = number % variants;
    Random random{mixed(mixed(seed) + key / 2)};
    State out;
    complete(random, out, first_of_key, nullptr);
    if (key % 2 == 1)
        out = neighbour(random, out);
    out[Word::surface] = static_cast<std::uint8_t>(variant / 3);
    out[Word::tier] = static_cast<std::uint8_t>(variant % 3);
    return out;
}

State bare(const State& of) {
    State out;
    for (const Word word : {Word::surface, Word::tier, Word::shape, Word::view, Word::scissor})
        out[word] = of[word];
    return out;
}

} // namespace spangle::bench::states
