// Tests the matchers for users' own tests: they pass for what is right, and fail for what is not, and say
// where.
#include <cstdlib>
#include <filesystem>

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spangle/boards/boards.hpp>
#include <spangle/sim/matchers.hpp>

namespace {

using namespace spangle;
using namespace spangle::sim;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// Each test has a folder of its own, also for evidence. Golden pictures are updated only if the test says
/// so.
struct Matchers : testing::Test {
    fs::path folder = fs::path(testing::TempDir()) / ("matchers-" + std::to_string(getpid()));
    std::string golden = (folder / "golden.png").string();

    void SetUp() override {
        unsetenv("SPANGLE_UPDATE_GOLDEN");
        fs::create_directories(folder / "evidence");
        setenv("TEST_TMPDIR", (folder / "evidence").c_str(), 1);
    }
    void TearDown() override {
        unsetenv("SPANGLE_UPDATE_GOLDEN");
        unsetenv("TEST_TMPDIR");
        fs::remove_all(folder);
    }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
};

Image ramp(int width = 8, int height = 4) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            image.at(x, y)[0] = static_cast<std::uint8_t>(16 * x);
            image.at(x, y)[1] = static_cast<std::uint8_t>(16 * y);
        }
    return image;
}

/// Returns the explanation that GoogleTest would print.
template <class Value, class Matcher> std::string explain(const Value& value, const Matcher& matcher) {
    testing::StringMatchResultListener listener;
    EXPECT_FALSE(testing::ExplainMatchResult(matcher, value, &listener));
    return listener.str();
}

TEST_F(Matchers, EqualPicturesPassAndLeaveNothing) {
    ASSERT_EQ(write_png(ramp(), golden), "");
    EXPECT_THAT(ramp(), EqualsPicture(golden));
    EXPECT_EQ(files(), 2u);
}

TEST_F(Matchers, AWrongPixelIsNamedAndShown) {
    ASSERT_EQ(write_png(ramp(), golden), "");
    Image wrong = ramp();
    wrong.at(3, 1)[2] = 250;
    wrong.at(1, 2)[2] = 253;
    EXPECT_THAT(wrong, Not(EqualsPicture(golden)));
    EXPECT_EQ(files(), 2u) << "nobody asked for an explanation";
    const std::string text = explain(wrong, EqualsPicture(golden));
    EXPECT_THAT(text, HasSubstr("first of 2 differing pixels (of 32) is (3, 1), #3010FA instead of #3010FF"));
    EXPECT_THAT(text, HasSubstr("largest difference of a channel is 5/255"));
    EXPECT_THAT(text, HasSubstr((folder / "golden.difference.png").string()));
    Image shown;
    ASSERT_EQ(read_png((folder / "golden.actual.png").string(), shown), "");
    EXPECT_EQ(shown, wrong);
    ASSERT_EQ(read_png((folder / "golden.difference.png").string(), shown), "");
    EXPECT_EQ(shown, difference_picture(wrong, ramp()));
}

TEST_F(Matchers, ToleranceIsPerChannelAndInclusive) {
    ASSERT_EQ(write_png(ramp(), golden), "");
    Image near = ramp();
    for (int y = 0; y < near.height; ++y)
        near.at(0, y)[1] = static_cast<std::uint8_t>(near.at(0, y)[1] + 2);
    EXPECT_THAT(near, EqualsPicture(golden, 2));
    EXPECT_THAT(near, Not(EqualsPicture(golden, 1)));
    EXPECT_THAT(near, Not(EqualsPicture(golden)));
}

TEST_F(Matchers, OtherSizesAndMissingOrBrokenGoldensFail) {
    ASSERT_EQ(write_png(ramp(), golden), "");
    EXPECT_THAT(explain(ramp(8, 5), EqualsPicture(golden)), HasSubstr("it is 8x5, expected is 8x4"));
    const std::string missing = (folder / "missing.png").string();
    EXPECT_THAT(explain(ramp(), EqualsPicture(missing)), HasSubstr("SPANGLE_UPDATE_GOLDEN=1"));
    EXPECT_FALSE(fs::exists(missing));
    EXPECT_TRUE(fs::exists(folder / "missing.actual.png"));
    std::FILE* const file = std::fopen(golden.c_str(), "w");
    std::fputs("no picture", file);
    std::fclose(file);
    EXPECT_THAT(explain(ramp(), EqualsPicture(golden)), HasSubstr("cannot read"));
    EXPECT_THAT(explain(ramp(), EqualsPicture((folder / "no" / "folder.png").string())),
                HasSubstr("cannot write"));
}

TEST_F(Matchers, GoldensAreUpdatedOnRequestOnly) {
    setenv("SPANGLE_UPDATE_GOLDEN", "1", 1);
    EXPECT_THAT(ramp(), EqualsPicture(golden)) << "there was none";
    EXPECT_THAT(ramp(5, 5), EqualsPicture(golden)) << "there was another";
    unsetenv("SPANGLE_UPDATE_GOLDEN");
    EXPECT_THAT(ramp(5, 5), EqualsPicture(golden));
    EXPECT_THAT(ramp(), Not(EqualsPicture(golden)));
    setenv("SPANGLE_UPDATE_GOLDEN", "0", 1);
    EXPECT_THAT(ramp(), Not(EqualsPicture(golden)));
}

TEST_F(Matchers, Hash) {
    EXPECT_THAT(ramp(), HasPictureHash(hash(ramp())));
    Image other = ramp();
    other.at(7, 3)[0] ^= 1;
    const std::string text = explain(other, HasPictureHash(hash(ramp())));
    EXPECT_THAT(text, HasSubstr("its hash is " + hash(other) + " instead of " + hash(ramp())));
    EXPECT_THAT(text, HasSubstr("Matchers.Hash.actual.png"));
    Image shown;
    ASSERT_EQ(read_png((folder / "evidence" / "Matchers.Hash.actual.png").string(), shown), "");
    EXPECT_EQ(shown, other);
}

TEST_F(Matchers, AsciiArt) {
    Image image(4, 2);
    std::fill(image.rgba.begin(), image.rgba.end(), std::uint8_t{255});
    const auto paint = [&image](int x, int y, int r, int g, int b) {
        image.at(x, y)[0] = static_cast<std::uint8_t>(r);
        image.at(x, y)[1] = static_cast<std::uint8_t>(g);
        image.at(x, y)[2] = static_cast<std::uint8_t>(b);
    };
    paint(1, 0, 251, 0, 0); // full red of a panel with six bits, whose lowest is not driven
    paint(2, 1, 80, 40, 160);
    EXPECT_THAT(image, LooksLike(R"(
#r##
##?#
)"));
    const Legend legend = {{'.', 0xFFFFFF}, {'x', 0xFF0000}, {'v', 0x5028A0}};
    EXPECT_THAT(image, LooksLike(".x..\n..v.", legend));
    const std::string text = explain(image, LooksLike("..x.\n..v.", legend));
    EXPECT_THAT(text, HasSubstr("first of 2 differing pixels (of 8) is (1, 0), #FB0000 instead of #FFFFFF"));
    EXPECT_THAT(text, HasSubstr("it looks like\n.x..\n..v.\n"));
    EXPECT_THAT(text, HasSubstr("Matchers.AsciiArt.difference.png"));
    EXPECT_THAT(explain(image, LooksLike("....\n...", legend)),
                HasSubstr("line 2 of the art has 3 characters"));
    EXPECT_THAT(explain(image, LooksLike(".z..\n..v.", legend)),
                HasSubstr("the legend does not say what 'z' is"));
    EXPECT_THAT(explain(image, LooksLike("....", legend)), HasSubstr("it is 4x2, expected is 4x1"));
    for (const int green : {252, 251}) { // green has six bits: 252 is full, 251 is not
        paint(3, 0, 255, green, 255);
        EXPECT_EQ(testing::Value(image, LooksLike(".x..\n..v.", legend)), green == 252);
    }
    EXPECT_THAT(Image(), LooksLike(""));
    EXPECT_THAT(image, Not(LooksLike("")));
}

TEST_F(Matchers, ABoardIsJudgedByItsGlass) {
    SimBoard board(boards::st7735_128x160);
    ASSERT_TRUE(board.display().init().ok());
    const auto frame = board.display().acquire();
    ASSERT_TRUE(frame.ok());
    const hal::DisplayInfo info = board.display().info();
    for (int y = 0; y < info.height; ++y) {
        for (int x = 0; x < info.width; ++x) { // red above green, big-endian RGB565
            std::uint8_t* const at = frame.value().pixels + y * frame.value().stride + 2 * x;
            at[0] = y < 2 ? 0xF8 : 0x07;
            at[1] = y < 2 ? 0x00 : 0xE0;
        }
        frame.value().extents->rows[y] = {0, static_cast<std::int16_t>(info.width)};
    }
    ASSERT_TRUE(board.display().present().ok());
    EXPECT_THAT(crop(board.glass(), 0, 0, 3, 4), LooksLike("rrr\nrrr\nggg\nggg"));
    EXPECT_THAT(board, HasPictureHash(hash(board.glass())));
    EXPECT_THAT(board, Not(HasPictureHash("0")));
    setenv("SPANGLE_UPDATE_GOLDEN", "1", 1);
    EXPECT_THAT(board, EqualsPicture(golden));
    unsetenv("SPANGLE_UPDATE_GOLDEN");
    EXPECT_THAT(board, EqualsPicture(golden));
    EXPECT_THAT(testing::PrintToString(board), HasSubstr("128x160 picture with hash"));
}

TEST(Picture, CropLeavesOutWhatIsOutside) {
    const Image image = ramp();
    const Image part = crop(image, 6, -1, 5, 3);
    ASSERT_EQ(part.width, 2);
    ASSERT_EQ(part.height, 2);
    EXPECT_EQ(part.at(1, 1)[0], 16 * 7);
    EXPECT_EQ(part.at(1, 1)[1], 16);
    EXPECT_EQ(crop(image, 3, 3, 2147483647, 2147483647).width, 5);
    EXPECT_EQ(crop(image, 100, 0, 4, 4).width, 0);
    EXPECT_EQ(crop(image, 0, 0, -5, 4).width, 0);
    EXPECT_NE(write_png(crop(image, 100, 0, 4, 4), testing::TempDir() + "empty.png"), "");
}

} // namespace
