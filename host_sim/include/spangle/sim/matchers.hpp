// GoogleTest matchers for what a board shows: EXPECT_THAT(board, EqualsPicture("hud.png")).
//
// The matchers take an Image, or a SimBoard, whose [glass](docs/glossary.md#glass) they look at. Comparison
// is exact unless a tolerance is given. A failure says where the first difference is, how many pixels differ
// and by how much, and names the pictures that show it. SPANGLE_UPDATE_GOLDEN=1 in the environment writes
// golden pictures instead of comparing with them. Spangle::sim itself does not know GoogleTest: link
// GTest::gmock to the test that includes this.
#pragma once

#include <ostream>
#include <string>

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <spangle/sim/board.hpp>
#include <spangle/sim/verdict.hpp>

namespace spangle::sim {

/// Prints a picture in GoogleTest's messages.
inline void PrintTo(const Image& image, std::ostream* out) {
    *out << image.width << "x" << image.height << " picture with hash " << hash(image);
}
/// Prints a board in GoogleTest's messages.
inline void PrintTo(const SimBoard& board, std::ostream* out) {
    *out << "board with the glass of a ";
    PrintTo(board.glass(), out);
}

namespace detail {

inline Image picture_of(const Image& image) {
    return image;
}
inline Image picture_of(const SimBoard& board) {
    return board.glass();
}

/// The stem of files for the evidence of checks without a file of their own: "TEMP/Suite.Test".
inline std::string evidence_stem() {
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name =
        test == nullptr ? "picture" : std::string(test->test_suite_name()) + "." + test->name();
    for (char& c : name)
        c = c == '/' ? '-' : c; // names of parameterised tests have slashes
    return testing::TempDir() + name;
}

/// A check as a matcher of everything that has a picture. GoogleTest asks a second time when the first answer
/// is no. Only then it listens, and only then the check leaves evidence.
template <class Check> class PictureMatcher {
  public:
    PictureMatcher(std::string what, Check check) : what_(std::move(what)), check_(std::move(check)) {}

    template <class Shown>
    bool MatchAndExplain(const Shown& shown, testing::MatchResultListener* listener) const {
        const Verdict verdict = check_(picture_of(shown), listener->IsInterested());
        *listener << verdict.text;
        return verdict.passed;
    }
    void DescribeTo(std::ostream* out) const { *out << what_; }
    void DescribeNegationTo(std::ostream* out) const { *out << "not: " << what_; }

  private:
    std::string what_;
    Check check_;
};

template <class Check>
testing::PolymorphicMatcher<PictureMatcher<Check>> matcher(std::string what, Check check) {
    return testing::MakePolymorphicMatcher(PictureMatcher<Check>(std::move(what), std::move(check)));
}

} // namespace detail

/// Matches a picture that equals the PNG file, every channel within `tolerance` 255ths. A relative path
/// starts at the test's working directory.
inline auto EqualsPicture(const std::string& golden, int tolerance = 0) {
    return detail::matcher(
        "equals the picture " + golden, [golden, tolerance](const Image& actual, bool explain) {
            return check_golden(actual, golden, tolerance, explain ? Evidence::pictures : Evidence::none);
        });
}

/// Matches a picture with this hash(), sixteen hexadecimal digits.
inline auto HasPictureHash(const std::string& expected) {
    return detail::matcher("has the picture hash " + expected, [expected](const Image& actual, bool explain) {
        return check_hash(actual, expected, explain ? detail::evidence_stem() : "");
    });
}

/// Matches a picture that looks like the art, a character a pixel ('?': any colour). Of a large picture a
/// part can be compared: crop(board.glass(), ...).
inline auto LooksLike(const std::string& art, const Legend& legend = pure_colors()) {
    return detail::matcher("looks like\n" + art, [art, legend](const Image& actual, bool explain) {
        return check_ascii(actual, art, legend, explain ? detail::evidence_stem() : "");
    });
}

} // namespace spangle::sim
