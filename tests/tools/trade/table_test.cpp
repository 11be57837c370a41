// Tests tables, parts of sweeps, promises, advice, and visible differences.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/trade/advice.hpp"
#include "host_sim/trade/boxes.hpp"
#include "host_sim/trade/perceived.hpp"
#include "host_sim/trade/plot.hpp"
#include "host_sim/trade/table.hpp"

namespace spangle::trade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Table table_of(const std::string& csv) {
    Table out;
    EXPECT_EQ(from_csv(csv, out), "") << csv;
    return out;
}

TEST(Tables, AreReadAsTheyWereWritten) {
    Table table{{"name", "value"}, {{"a, b", "1.5"}, {"say \"no\"", ""}, {"two\nlines", "x"}, {"", "-3e2"}}};
    const Table again = table_of(to_csv(table));
    EXPECT_EQ(again.columns, table.columns);
    EXPECT_EQ(again.rows, table.rows);
    EXPECT_EQ(again.number(again.rows[3], "value"), -300.0);
    EXPECT_FALSE(again.number(again.rows[2], "value"));
    EXPECT_FALSE(again.number(again.rows[1], "value"));
    EXPECT_EQ(again.text(again.rows[0], "elsewhere"), "");
    Table quoted;
    EXPECT_EQ(from_csv("a,b\n1,\"q\"", quoted), ""); // the last line may lack its end
    EXPECT_EQ(quoted.rows, (std::vector<Table::Row>{{"1", "q"}}));
}

TEST(Tables, ThatAreNoneAreRefused) {
    Table out;
    for (const char* wrong : {"", "a,b\n1\n", "a\n\"x", "a\n\"x\"y\n"})
        EXPECT_NE(from_csv(wrong, out), "") << wrong;
}

TEST(Parts, AreOneSweepOrSayWhatIsMissing) {
    const Table first = table_of("job,jobs,tier\n0,3,exact\n0,3,fast\n2,3,exact\n2,3,fast\n"),
                second = table_of("job,jobs,tier\n1,3,exact\n1,3,fast\n");
    Table out;
    EXPECT_EQ(merge({second, first}, out), "");
    EXPECT_EQ(to_csv(out), "job,jobs,tier\n0,3,exact\n0,3,fast\n1,3,exact\n1,3,fast\n2,3,exact\n2,3,fast\n");
    EXPECT_THAT(merge({first}, out), HasSubstr("no part has job 1 of 3"));
    EXPECT_THAT(merge({first, second, second}, out), HasSubstr("job 1 is in two parts"));
    EXPECT_THAT(merge({first, table_of("job,jobs,tier\n1,4,exact\n")}, out), HasSubstr("other sweeps"));
    EXPECT_THAT(merge({first, table_of("job,jobs\n1,3\n")}, out), HasSubstr("other columns"));
    EXPECT_THAT(merge({table_of("job,jobs,tier\n7,3,exact\n")}, out), HasSubstr("job 7 of 3"));
}

constexpr const char* columns =
    "job,scene,tier,format,dither,covered,identical,max_lsb,psnr_565,off_own,off_unsnapped,"
    "off_ideal,texel_worst,wrong_texels,depth_worst\n";

std::vector<std::string> missed(const std::string& row) {
    const Table table = table_of(columns + row);
    return missed_boxes(table, table.rows.front());
}

TEST(Promises, AreThoseOfTheirTier) {
    EXPECT_THAT(missed("0,X,exact,565,off,100000,99.99,1,60,0,5,5,0.0156,0.02,1e-5\n"), IsEmpty());
    EXPECT_THAT(missed("0,X,exact,565,off,100000,99.98,1,60,0,0,0,,,\n"),
                ElementsAre(HasSubstr("identical")));
    EXPECT_THAT(missed("0,X,exact,565,off,100000,100,2,60,0,0,0,,,\n"), ElementsAre(HasSubstr("565 steps")));
    EXPECT_THAT(missed("0,X,exact,565,off,100000,100,40,60,0,0,0,0.01,0.01,\n"), IsEmpty())
        << "another texel";
    EXPECT_THAT(missed("0,X,exact,565,off,100000,100,1,60,0,0,0,0.016,0.03,\n"),
                ElementsAre(HasSubstr("wrong texels"), HasSubstr("texel error")));
    EXPECT_THAT(missed("0,X,balanced,565,off,100000,95,9,33,0,0,0,0.25,9,1e-5\n"), IsEmpty());
    EXPECT_THAT(missed("0,X,balanced,565,off,100000,94,9,32,0,0,0,0.26,9,1e-5\n"),
                ElementsAre(HasSubstr("identical"), HasSubstr("PSNR"), HasSubstr("texel error")));
    EXPECT_THAT(missed("0,X,balanced,565,on,100000,94,9,32,0,0,0,0.26,9,1e-5\n"), IsEmpty()) << "dithered";
    EXPECT_THAT(missed("0,X,fast,565,off,100000,1,60,22,0,5,5,0.5,90,1e-5\n"), IsEmpty());
    EXPECT_THAT(missed("0,X,fast,565,off,100000,1,60,21,0,5,5,0.51,90,1e-5\n"),
                ElementsAre(HasSubstr("PSNR"), HasSubstr("texel error")));
    EXPECT_THAT(missed("0,X,fast,565,on,100000,1,60,21,0,5,5,0.51,90,1e-5\n"), IsEmpty()) << "dithered";
    EXPECT_THAT(missed("0,X,mine,565,off,100000,1,60,5,0,5,5,8,90,1e-5\n"), IsEmpty()) << "an own tier";
    EXPECT_THAT(missed("0,X,mine,565,off,100000,1,60,5,1,6,5,8,90,1e-4\n"),
                ElementsAre(HasSubstr("brute force"), HasSubstr("unsnapped"), HasSubstr("depth")));
}

Advice advice_of(const std::string& balanced, const std::string& fast, const std::string& cost) {
    const std::string tail = ",0,0,0,,,\n";
    const Table accuracy =
        table_of(std::string(columns) + "0,X,exact,565,off,9,100,0,99" + tail + "0,X,balanced,565,off,9," +
                 balanced + tail + "0,X,fast,565,off,9," + fast + tail);
    const std::vector<Advice> all =
        advise(accuracy, table_of("job,tier,microseconds,host_instructions\n" + cost));
    EXPECT_EQ(all.size(), 1u);
    return all.front();
}

TEST(Advices, FollowTheNumbers) {
    const std::string timed = "0,exact,100,\n0,balanced,70,\n0,fast,50,\n";
    EXPECT_EQ(advice_of("99,1,50", "97,2,40", timed).take, "fast");
    const Advice seen = advice_of("99,1,50", "90,30,25", timed);
    EXPECT_EQ(seen.take, "balanced") << "fast shows";
    EXPECT_THAT(seen.why,
                HasSubstr("Balanced pays: 30 % less time; 1 % of the pixels differ, by 1 step of 565"));
    EXPECT_THAT(seen.why,
                HasSubstr("Fast shows: 10 % of the pixels differ, by 30 steps of 565 at most (25.0 dB), "
                          "for 50 % less time"));
    const Advice same = advice_of("100,0,99", "100,0,99", "0,exact,100,\n0,balanced,98,\n0,fast,103,\n");
    EXPECT_EQ(same.take, "exact") << "two percent are noise";
    EXPECT_THAT(same.why, HasSubstr("Balanced hardly pays: 2 % less time; no pixel differs"));
    EXPECT_THAT(same.why, HasSubstr("Fast hardly pays: 3 % more time"));
    const Advice counted =
        advice_of("99,1,50", "97,2,40", "0,exact,100,1000\n0,balanced,90,600\n0,fast,200,500\n");
    EXPECT_EQ(counted.take, "fast") << "instructions are counted, times are measured";
    EXPECT_THAT(counted.why, HasSubstr("50 % fewer instructions on this machine"));
    const Advice untimed = advice_of("99,1,50", "97,2,40", "0,exact,100,\n0,balanced,90,\n");
    EXPECT_EQ(untimed.take, "exact") << "nothing is known of what fast takes";
    EXPECT_THAT(untimed.why, HasSubstr("Fast: 3 % of the pixels differ"));
}

/// Boards decide before this machine does. Other targets, memory and the bus are named if they differ.
TEST(Advices, NameWhatBoardsAndBusesTake) {
    const Table accuracy = table_of("job,scene,tier,format,identical,max_lsb,psnr_565,bus_bytes\n"
                                    "0,X,exact,565,100,0,99,1000\n0,X,fast,565,99,1,50,900\n"
                                    "0,X,mine,565,99,1,50,1020\n");
    const Table cost =
        table_of("job,tier,microseconds,host_instructions,m3_instructions,m4_instructions,m4_flash,m4_ram\n"
                 "0,exact,10,1000,500,400,204800,10240\n0,fast,10,1000,400,360,102400,10240\n"
                 "0,mine,10,1000,500,300,204800,9216\n");
    const Advice advice = advise(accuracy, cost).front();
    EXPECT_EQ(advice.take, "fast");
    EXPECT_THAT(advice.why,
                HasSubstr("Fast pays: 20 % fewer instructions on m3 (m4: -10 %, 100.0 KB less flash "
                          "on m4, 10 % fewer bytes on the bus); 1 %"));
    EXPECT_THAT(advice.why,
                HasSubstr("Mine hardly pays: as many instructions on m3 (m4: -25 %, 1.0 KB less RAM "
                          "on m4); 1 %"));
}

TEST(Axes, AreThoseWithFigures) {
    const auto names = [](const char* row) {
        std::vector<std::string> out;
        for (const Axis& axis :
             axes_of(table_of(std::string("job,microseconds,host_instructions,rv32_instructions\n") + row)))
            out.push_back(axis.name);
        return out;
    };
    EXPECT_THAT(names("0,5.0,7,9\n"),
                ElementsAre("instructions on rv32", "instructions on this machine", "time"));
    EXPECT_THAT(names("0,,7,\n"), ElementsAre("instructions on this machine"));
    EXPECT_THAT(names("0,,,\n"), IsEmpty());
}

sim::Image flat(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    sim::Image image(24, 24);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        image.rgba[i] = r;
        image.rgba[i + 1] = g;
        image.rgba[i + 2] = b;
    }
    return image;
}

TEST(Perceived, IsNothingToAllAndGrowsWithTheDifference) {
    const sim::Image grey = flat(128, 128, 128);
    EXPECT_EQ(perceived_difference(grey, grey), 0);
    EXPECT_NEAR(perceived_difference(flat(0, 255, 0), flat(0, 0, 255)), 1, 1e-9);
    EXPECT_NEAR(perceived_difference(flat(0, 0, 255), flat(0, 255, 0)), 1, 1e-9);
    double last = 0;
    for (const int step : {1, 4, 16, 64}) {
        const auto v = static_cast<std::uint8_t>(128 + step);
        const double seen = perceived_difference(grey, flat(v, v, v));
        EXPECT_GT(seen, last);
        last = seen;
    }
    EXPECT_LT(last, 0.7);
    // The eye averages stripes of one pixel, in rows and in columns. It does not average a large square of
    // the same colour.
    sim::Image rows = grey, columns = grey, coarse = grey;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x)
            for (int c = 0; c < 3; ++c) {
                rows.at(x, y)[c] = static_cast<std::uint8_t>(y % 2 == 0 ? 118 : 138);
                columns.at(x, y)[c] = static_cast<std::uint8_t>(x % 2 == 0 ? 118 : 138);
                coarse.at(x, y)[c] = static_cast<std::uint8_t>(x < 12 ? 118 : 138);
            }
    EXPECT_LT(perceived_difference(grey, rows), perceived_difference(grey, coarse) / 2);
    EXPECT_LT(perceived_difference(grey, columns), perceived_difference(grey, coarse) / 2);
}

} // namespace
} // namespace spangle::trade
