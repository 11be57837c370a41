// Tests own tiers as words, images of firmware, and what the rows of cost.csv say about them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include <elf.h>
#include <fmt/format.h>
#include <unistd.h>

#include "boards/scenes/scene.hpp"
#include "host_sim/trade/cost.hpp"
#include "host_sim/trade/knobs.hpp"
#include "host_sim/trade/targets.hpp"

namespace spangle::trade {
namespace {

using testing::HasSubstr;

TEST(KnobNames, AreEveryFieldWithItsRange) {
    EXPECT_EQ(knobs().size(), sizeof(raster::Knobs)) << "a byte each";
    for (const Knob& knob : knobs())
        for (int value = 0; value < 256; ++value) {
            // What the words can say is valid, and what is valid can be said.
            raster::Knobs k = raster::balanced_knobs;
            k.longest_run = 16;
            knob.set(k, static_cast<std::uint8_t>(value));
            const bool by_words = [&] {
                Tier read;
                return read_knobs(fmt::format("balanced,longest_run=16,{}={}", knob.name, knob.text(k)), read)
                           .empty() &&
                       read.knobs == k;
            }();
            const bool flag =
                std::string(knob.range()).starts_with("off") || std::string(knob.name) == "runs";
            if (!flag || value < 2) {
                EXPECT_EQ(by_words, raster::are_valid(k)) << knob.name << ' ' << value;
            }
        }
    const std::string table = knob_table();
    for (const Knob& knob : knobs())
        EXPECT_THAT(table, HasSubstr(knob.name));
    Tier own;
    ASSERT_EQ(read_tier("a-tier-of-mine=fast,texel_bits=12,runs=cubic", {}, own), "");
    std::istringstream lines(knob_table({own}));
    for (std::string line; std::getline(lines, line);) {
        // The format is that which ./dev firmware reads: two spaces between columns.
        const auto begins = [&](const char* knob) { return line.starts_with(knob); };
        if (begins("knob ")) {
            EXPECT_THAT(line, HasSubstr("  fast      a-tier-of-mine  what"));
        }
        if (begins("texel_bits ")) {
            EXPECT_THAT(line, HasSubstr("  1         12              Between"));
        }
        if (begins("runs ")) {
            EXPECT_THAT(line, HasSubstr("  straight  cubic           How"));
        }
    }
}

TEST(OwnTierWords, AreReadOrSayWhatIsWrong) {
    Tier tier;
    EXPECT_EQ(read_tier("fine=balanced,texel_bits=5,runs=cubic,coarse_blend=on", {}, tier), "");
    EXPECT_EQ(tier.name, "fine");
    EXPECT_EQ(tier.precision, EGL_PRECISION_BALANCED_SPANGLE);
    ASSERT_TRUE(tier.knobs);
    raster::Knobs want = raster::balanced_knobs;
    want.texel_bits = 5;
    want.runs = raster::Runs::cubic;
    want.coarse_blend = true;
    EXPECT_EQ(*tier.knobs, want);
    Tier again;
    EXPECT_EQ(read_knobs(tier.words, again), "") << "as `spangle run --knobs` reads them";
    EXPECT_EQ(again.knobs, tier.knobs);
    const auto problem = [&](const char* words) { return read_tier(words, {tier}, again); };
    EXPECT_THAT(problem("balanced"), HasSubstr("takes NAME="));
    EXPECT_THAT(problem("a b=fast"), HasSubstr("letters, digits"));
    EXPECT_THAT(problem("fast=exact"), HasSubstr("already"));
    EXPECT_THAT(problem("fine=exact"), HasSubstr("already"));
    EXPECT_THAT(problem("x=best"), HasSubstr("not with 'best'"));
    EXPECT_THAT(problem("x=fast,speed=9"), HasSubstr("--knobs"));
    EXPECT_THAT(problem("x=fast,runs"), HasSubstr("--knobs"));
    EXPECT_THAT(problem("x=fast,texel_bits=14"), HasSubstr("takes 0 to 13, not '14'"));
    EXPECT_THAT(problem("x=fast,affine_texel_bits=ever"), HasSubstr("2 to 13 or never"));
    EXPECT_THAT(problem("x=fast,longest_run=2"), HasSubstr("below shortest_run"));
}

TEST(FirmwareWords, AreReadOrQuoted) {
    FirmwareReport said;
    EXPECT_EQ(read_firmware_report(
                  "qemu: a warning\nframe 1000 0000abcd\nframe 1002 00c0ffee\nown 100\nsurface 20\npeak "
                  "70\nstack 8\n",
                  said),
              "");
    EXPECT_THAT(said.frames, testing::ElementsAre(1000, 1002));
    EXPECT_EQ(said.hash, 0xC0FFEEu) << "of the last frame";
    EXPECT_EQ(said.own + said.surface + said.peak + said.stack, 198u);
    EXPECT_THAT(read_firmware_report("no context: it does not fit\n", said = {}), HasSubstr("no context"));
    EXPECT_THAT(read_firmware_report("frame 1000 0000abcd\n", said = {}), HasSubstr("does not say"));
}

/// Writes an image with code, initialised variables, other variables, a stack, and a section that is not
/// loaded.
std::string image_in(const std::filesystem::path& folder) {
    const std::string names = std::string("\0.text\0.data\0.bss\0.stack\0.debug\0", 31);
    const auto section = [](std::uint32_t name, std::uint32_t type, std::uint32_t flags,
                            std::uint32_t bytes) {
        Elf32_Shdr s{};
        s.sh_name = name;
        s.sh_type = type;
        s.sh_flags = flags;
        s.sh_size = bytes;
        s.sh_offset = sizeof(Elf32_Ehdr); // where the names are
        return s;
    };
    const Elf32_Shdr sections[] = {
        section(0, SHT_STRTAB, 0, 31),
        section(1, SHT_PROGBITS, SHF_ALLOC | SHF_EXECINSTR, 10000),
        section(7, SHT_PROGBITS, SHF_ALLOC | SHF_WRITE, 300),
        section(13, SHT_NOBITS, SHF_ALLOC | SHF_WRITE, 5000),
        section(18, SHT_NOBITS, SHF_ALLOC | SHF_WRITE, 16384),
        section(25, SHT_PROGBITS, 0, 99999),
    };
    Elf32_Ehdr head{};
    std::memcpy(head.e_ident, ELFMAG, SELFMAG);
    head.e_ident[EI_CLASS] = ELFCLASS32;
    head.e_ident[EI_DATA] = ELFDATA2LSB;
    head.e_shoff = static_cast<std::uint32_t>(sizeof head + names.size());
    head.e_shentsize = sizeof sections[0];
    head.e_shnum = 6;
    const std::string path = folder / "image.elf";
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(&head), sizeof head);
    file << names;
    file.write(reinterpret_cast<const char*>(sections), sizeof sections);
    return path;
}

struct Images : testing::Test {
    std::filesystem::path folder = testing::TempDir() + "spangle_images_" + std::to_string(getpid());
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    /// Returns a machine that prints this, and logs the words with which it was called.
    Target machine(const std::string& says, int status = 0) {
        script_ = folder / "machine";
        std::ofstream(script_) << "#!/bin/sh\necho \"$@\" >'" << (folder / "words").string() << "'\nprintf '"
                               << says << "'\nexit " << status << '\n';
        std::filesystem::permissions(script_, std::filesystem::perms::owner_all);
        return {"m3", "a machine", {script_.c_str(), "-M", "board"}};
    }

  private:
    std::string script_;
};

TEST_F(Images, TakeWhatTheirSectionsSay) {
    ImageSizes sizes;
    ASSERT_EQ(read_sizes(image_in(folder), sizes), "");
    EXPECT_EQ(sizes.flash, 10300u) << "code and first values";
    EXPECT_EQ(sizes.variables, 5300u) << "the stack is measured";
    EXPECT_THAT(read_sizes(folder / "none", sizes), HasSubstr("cannot read"));
    std::ofstream(folder / "text") << "no image";
    EXPECT_THAT(read_sizes(folder / "text", sizes), HasSubstr("no ELF"));
    std::filesystem::resize_file(folder / "image.elf", sizeof(Elf32_Ehdr) + 31 + 3 * sizeof(Elf32_Shdr));
    EXPECT_THAT(read_sizes(folder / "image.elf", sizes), HasSubstr("cut off"));
}

TEST(ImageNames, AreWordsOfLettersAndDigits) {
    Tier own;
    ASSERT_EQ(read_tier("fine=balanced,texel_bits=5", {}, own), "");
    EXPECT_EQ(image_path("out", targets()[0], "S4r", tiers[1]), "out/m0plus/S4r-balanced.elf");
    EXPECT_EQ(image_path("out", targets()[3], "a b/c.obj", own), "out/rv32/a_b_c.obj-fine.elf");
}

TEST_F(Images, AreCountedOnTheirMachine) {
    const std::string image = image_in(folder);
    const Setting setting{.width = 96, .height = 64, .frames = 2, .dither = true};
    BoardCost cost{};
    const std::string says =
        "frame 1000 0\\nframe 2000 beef\\nown 4096\\nsurface 500\\npeak 2500\\nstack 700\\n";
    ASSERT_EQ(count_on(machine(says), image, setting, 0xBEEF, cost), "");
    EXPECT_EQ(cost.instructions, 1500u);
    EXPECT_EQ(cost.flash, 10300u);
    EXPECT_EQ(cost.ram, 5300u - 4096 + 2500 - 500 + 700);
    std::string words;
    std::ifstream file(folder / "words");
    std::getline(file, words);
    EXPECT_THAT(words, HasSubstr("-M board -icount shift=0"));
    EXPECT_THAT(words, HasSubstr("arg=spangle,arg=96,arg=64,arg=1,arg=4,arg=1"));
    EXPECT_THAT(words, testing::EndsWith("-kernel " + image));
    EXPECT_THAT(count_on(machine(says), image, setting, 0xBEE, cost), HasSubstr("another picture"));
    EXPECT_THAT(count_on(machine(says, 1), image, setting, 0xBEEF, cost), HasSubstr("status 1"));
    EXPECT_THAT(count_on(machine("no context\\n", 1), image, setting, 0xBEEF, cost),
                HasSubstr("'no context'"));
    EXPECT_THAT(count_on({"m3", "", {"no-such-emulator"}}, image, setting, 0, cost),
                HasSubstr("not installed"));
}

/// In S5, snapping to 1/256 pixel moves some pixel centres from one triangle to another.
TEST(Measured, CoverageIsHeldAgainstThreeReferences) {
    const scenes::Scene* const gears = scenes::find("S5");
    ASSERT_NE(gears, nullptr);
    const Program program{gears->id, gears->setup, gears->draw};
    const Measured m =
        measure(program, tiers[2], *find(formats, "565"), {.width = 320, .height = 240, .frames = 1});
    EXPECT_EQ(m.problem, "");
    EXPECT_EQ(m.off_own, 0u);
    EXPECT_EQ(m.off_snapped, 0u) << "integer vertices lie where doubles are snapped to";
    EXPECT_GT(m.off_unsnapped, 0u);
    EXPECT_EQ(m.off_unsnapped, m.off_ideal);
    const Work work = work_of_frames(program, tiers[2], *find(formats, "565"), {});
    EXPECT_GT(work.fragments, 28743) << "what is seen of the gears, and what lies behind it";
    EXPECT_LT(work.fragments, 32000);
    EXPECT_LT(work.triangles, 800) << "half of them are culled";
    EXPECT_GT(work.triangles, 300);
}

TEST(CostRows, SayWhatAPixelAndATriangleTake) {
    const Job job{0, 1, "X", *find(formats, "565")};
    Cost cost{50, 100, {20, 400, 0}, 8000, {10, 200, 0}, {{"m4", {10000, 4096, 512}}}};
    Table table{cost_columns(), {cost_row(job, tiers[0], cost)}};
    const Table::Row& row = table.rows.front();
    ASSERT_EQ(row.size(), table.columns.size());
    const auto cell = [&](const char* column) { return table.text(row, column); };
    EXPECT_EQ(cell("relative"), "0.500");
    EXPECT_EQ(cell("triangles"), "20");
    EXPECT_EQ(cell("fragments"), "400");
    EXPECT_EQ(cell("host_instructions"), "8000");
    EXPECT_EQ(cell("host_per_pixel"), "20.0");
    EXPECT_EQ(cell("host_per_triangle"), "400.0");
    EXPECT_EQ(cell("m4_instructions"), "10000");
    EXPECT_EQ(cell("m4_per_pixel"), "50.0") << "of what the image draws, a baked model";
    EXPECT_EQ(cell("m4_per_triangle"), "1000.0");
    EXPECT_EQ(cell("m4_flash"), "4096");
    EXPECT_EQ(cell("m4_ram"), "512");
    EXPECT_EQ(cell("m3_instructions") + cell("rv32_flash"), "");
    cost.board_work = {};
    table.rows = {cost_row(job, tiers[0], cost)};
    EXPECT_EQ(table.text(table.rows[0], "m4_per_pixel"), "") << "nothing was drawn";
}

} // namespace
} // namespace spangle::trade
