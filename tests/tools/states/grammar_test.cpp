// Tests the grammar of `./dev bench states`: states are the same everywhere, come in pairs of neighbours, and
// have all words.
#include <gtest/gtest.h>

#include <set>

#include "tests/tools/bench/states/counted.hpp"
#include "tests/tools/bench/states/grammar.hpp"

namespace {

using namespace spangle::bench::states;

constexpr std::uint32_t pair = 2 * variants;

TEST(Grammar, StatesOfASeedStayWhatTheyAre) {
    std::uint32_t hash = 2166136261u;
    for (const std::uint32_t seed : {1u, 2u, 1000u})
        for (std::uint32_t number = 0; number < 600; ++number)
            for (const std::uint8_t choice : state(seed, number).choice)
                hash = (hash ^ choice) * 16777619u;
    EXPECT_EQ(hash, 0x73d4807u) << std::hex << hash << ": golden.json is of other states, too";
}

TEST(Grammar, OddKeysDifferInOneWordFromTheirNeighbours) {
    std::set<Word> words;
    for (const std::uint32_t seed : {1u, 2u, 3u})
        for (std::uint32_t number = 0; number < 300 * pair; number += pair) {
            const State a = state(seed, number), b = state(seed, number + variants);
            EXPECT_EQ(distance(a, b), 1) << "seed " << seed << ", state " << number;
            EXPECT_EQ(a[Word::shape], b[Word::shape]) << "seed " << seed << ", state " << number;
            for (int i = 0; i < word_count; ++i)
                if (const auto word = static_cast<Word>(i); a[word] != b[word] && applies(a, word))
                    words.insert(word);
        }
    EXPECT_EQ(words.size(), static_cast<std::size_t>(word_count - 3))
        << "each word but shape, surface and tier";
}

TEST(Grammar, AKeyIsDrawnOnBothSurfacesInEachTier) {
    std::set<int> seen;
    for (std::uint32_t number = 600; number < 600 + variants; ++number) {
        State of = state(5, number);
        seen.insert(of[Word::surface] * 3 + of[Word::tier]);
        of[Word::surface] = of[Word::tier] = 0;
        EXPECT_EQ(distance(of, state(5, 600)), 0);
    }
    EXPECT_EQ(seen, (std::set<int>{0, 1, 2, 3, 4, 5}));
}

TEST(Grammar, EveryChoiceIsDrawnWhereItApplies) {
    std::set<int> seen[word_count];
    for (std::uint32_t number = 0; number < 6000 * variants; number += variants) {
        const State of = state(9, number + number / variants % variants);
        for (int i = 0; i < word_count; ++i)
            if (applies(of, static_cast<Word>(i)))
                seen[i].insert(of.choice[i]);
            else
                EXPECT_EQ(of.choice[i], 0) << info(static_cast<Word>(i)).name;
    }
    for (int i = 0; i < word_count; ++i)
        EXPECT_EQ(seen[i].size(), info(static_cast<Word>(i)).count) << info(static_cast<Word>(i)).name;
}

TEST(Grammar, WordsThatDoNotApplyToBothAreNoDifference) {
    State plain, textured;
    textured[Word::texture] = 1;
    textured[Word::filter] = 1;
    textured[Word::env] = 2;
    EXPECT_EQ(distance(plain, textured), 1);
    State other = textured;
    other[Word::filter] = 0;
    other[Word::fog] = 1;
    EXPECT_EQ(distance(textured, other), 2);
}

/// Counts the fragments of each state of two keys. They are those of the shape, whatever hides them.
TEST(Grammar, StatesAreDrawnAndTheirFragmentsCounted) {
    for (std::uint32_t number = 0; number < 10 * pair; number += pair) {
        const State first = state(3, number);
        const GLuint fragments = fragments_of(first, amount_to_count(first));
        EXPECT_GT(fragments, 20u) << "state " << number;
        for (std::uint32_t i = 0; i < variants; ++i) {
            bool drawn = false;
            const Counted found = count(
                state(3, number + i), [&] { drawn = true; }, [] {});
            EXPECT_TRUE(found.good && drawn) << "state " << number + i;
            EXPECT_EQ(found.fragments, fragments) << "state " << number + i;
        }
    }
}

/// Tests that hide fragments, and samples that repeat them, do not change the count; a scissor rectangle
/// does.
TEST(Grammar, FragmentsAreThoseOfTheShape) {
    State of;
    of[Word::shape] = sprites;
    const GLuint all = fragments_of(of, 3);
    EXPECT_EQ(all, 3u * 32 * 32);
    of[Word::alpha_test] = of[Word::stencil] = of[Word::depth] = of[Word::stipple] = of[Word::samples] = 1;
    EXPECT_EQ(fragments_of(of, 3), all);
    of[Word::scissor] = 1;
    EXPECT_LT(fragments_of(of, 3), all);
}

/// The count and the picture of a state must not depend on earlier states.
TEST(Grammar, APictureIsThatOfItsStateAlone) {
    const auto picture = [](std::uint32_t number) {
        return count(
                   state(3, number), [] {}, [] {})
            .picture;
    };
    const std::uint32_t alone = picture(14);
    EXPECT_NE(picture(50), alone);
    EXPECT_EQ(picture(14), alone);
}

} // namespace
