// Tests the report of a profile as text, JSON and page: each must hold everything that was recorded and
// measured.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/cli/profile_page.hpp"
#include "host_sim/cli/profile_report.hpp"

namespace spangle::cli {

namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const char* const loop = "balanced full dither";
const char* const chain = "balanced full fog(exp) dither";

/// Makes two keys, one of which has a loop, and figures that all differ.
class Report : public testing::Test {
  protected:
    std::vector<TierRecord> all;
    profile::Profile made{};
    ProfileReport report;

    Report() {
        TierRecord& exact = all.emplace_back();
        exact.tier = "exact";
        exact.error = 0.25;
        TierRecord& one = all.emplace_back();
        one.tier = "balanced";
        one.frames = 7;
        one.error = 1.5;
        one.max_lsb = 3;
        one.psnr_db = 44.25;
        one.record.commands = {{"glVertex", 31}};
        one.record.reached[0] = 4711;
        raster::Key key;
        key.number = raster::Number::balanced;
        key.kind = raster::Kind::full;
        key.depth = raster::Compare::always;
        key.depth_write = false;
        key.dither = true;
        one.record.keys.push_back({key, 3000, true, true});
        made.fused.push_back(key);
        key.fog = true;
        key.fog_mode = raster::FogMode::exp;
        one.record.keys.push_back({key, 1000, false, true});
        made.chain = true;
        made.features = {"FOG"};
        made.limits = {{"CLIPPING", "0"}};
        report = {"a<b", &all, &all[1], &made, {}};
    }
    void measured() {
        report.firmware = {
            {"same_bytes", true},
            {"lines",
             json::array(
                 {{{"line", "x.cpp:12"}, {"command", "glEnd"}, {"calls", 2.5}, {"instructions", 61234}}})},
            {"whole",
             {{"flash", 400001},
              {"flash_of", {{"gl/list", 5001}, {"raster/compile", 7001}}},
              {"ram", 30001},
              {"instructions", 900001},
              {"ram_of", {{"variables", 101}, {"arena", 102}, {"stack", 103}}},
              {"frames", json::array({"0a"})},
              {"keys", {{loop, {{"pixels", 1}, {"instructions_a_pixel", 81.5}}}}}}},
            {"profiled",
             {{"flash", 200002},
              {"flash_of", {{"raster/compile", 6002}}},
              {"ram", 20002},
              {"instructions", 800002},
              {"ram_of", {{"variables", 201}, {"arena", 202}, {"stack", 203}}},
              {"frames", json::array({"0a"})},
              {"keys",
               {{loop, {{"pixels", 1}, {"instructions_a_pixel", 71.5}}},
                {chain, {{"pixels", 1}, {"instructions_a_pixel", 91.25}}}}}}}};
    }
};

TEST_F(Report, WithoutFirmwareTellsWhatWasRecorded) {
    const std::string text = to_text(report), page = to_page(report);
    for (const std::string& told : {text, page}) {
        EXPECT_THAT(told, AllOf(HasSubstr(loop), HasSubstr(chain), HasSubstr("4711"), HasSubstr("75.0 %"),
                                HasSubstr("25.0 %"), HasSubstr("FOG")));
        EXPECT_THAT(told, Not(HasSubstr("same bytes")));
    }
    EXPECT_THAT(text, HasSubstr("glVertex"));
    EXPECT_THAT(page, AllOf(HasSubstr("What a&lt;b takes"), HasSubstr("7 frames"),
                            HasSubstr("SPANGLE_CLIPPING</td><td>0"), HasSubstr("1.5000 %"),
                            HasSubstr("44.2 dB"), HasSubstr("0.2500 %")));
    const json told = to_json(report);
    EXPECT_EQ(told["tier"], "balanced");
    EXPECT_EQ(told["chain"], true);
    EXPECT_EQ(told["chain_percent"], 25.0);
    EXPECT_EQ(told["keys"].size(), 2u);
    EXPECT_FALSE(told["keys"][0].contains("instructions_a_pixel"));
}

TEST_F(Report, TellsWhatWasMeasured) {
    measured();
    const std::string text = to_text(report), page = to_page(report);
    EXPECT_THAT(text,
                AllOf(HasSubstr("Both draw the same bytes."), HasSubstr("400001           200002"),
                      HasSubstr("30001            20002"), HasSubstr("900001           800002"),
                      HasSubstr("71.5  balanced full dither"), HasSubstr("91.2  balanced full fog(exp)"),
                      HasSubstr("61234  2.5       x.cpp:12 glEnd"), HasSubstr("in 6002 bytes of flash")));
    EXPECT_THAT(page, AllOf(HasSubstr("Both draw the same bytes."),
                            HasSubstr("<td>400,001</td><td>200,002</td><td>-50.0 %"),
                            HasSubstr("<td>30,001</td><td>20,002</td>"),
                            HasSubstr("<td>900,001</td><td>800,002</td>"),
                            HasSubstr("<td>gl/list</td><td>5,001</td><td>0</td><td>-100.0 %"),
                            HasSubstr("<td>of it arena</td><td>102</td><td>202</td>")));
    EXPECT_THAT(page,
                AllOf(HasSubstr("<td>x.cpp:12</td><td class=words>glEnd</td><td>2.5</td><td>61,234</td>"),
                      HasSubstr("a loop of its own</td><td>71.5</td><td>81.5</td>"),
                      HasSubstr("the chain</td><td>91.2</td><td>-</td>")));
    const json told = to_json(report);
    EXPECT_EQ(told["keys"][0]["instructions_a_pixel"], 71.5);
    EXPECT_EQ(told["keys"][0]["instructions_a_pixel_whole"], 81.5);
    EXPECT_EQ(told["keys"][1]["instructions_a_pixel"], 91.25);
    EXPECT_FALSE(told["keys"][1].contains("instructions_a_pixel_whole")) << "it was not drawn";
    EXPECT_EQ(told["firmware"], report.firmware);
}

TEST_F(Report, SaysWhereBytesDiffer) {
    measured();
    report.firmware["same_bytes"] = false;
    EXPECT_THAT(to_text(report), HasSubstr("DIFFERENT BYTES"));
    EXPECT_THAT(to_page(report), HasSubstr("draw different bytes"));
}

TEST_F(Report, SaysWhyNothingWasRun) {
    measured();
    report.firmware = {{"unmeasured", "call 3 <is> odd"},
                       {"lines", json::array()},
                       {"whole", {{"flash", 4001}, {"flash_of", json::object()}}},
                       {"profiled", {{"flash", 2002}, {"flash_of", {{"raster/compile", 6002}}}}}};
    EXPECT_THAT(to_text(report), AllOf(HasSubstr("It was not run: call 3 <is> odd"), HasSubstr("2002"),
                                       Not(HasSubstr("BYTES."))));
    EXPECT_THAT(to_page(report), AllOf(HasSubstr("It was not run: call 3 &lt;is&gt; odd"), HasSubstr("2,002"),
                                       Not(HasSubstr("of a frame</td>"))));
}

} // namespace

} // namespace spangle::cli
