// Runs the command line unchanged on a modelled Linux machine: panels behind spidev, i2c-dev and an FTDI
// adapter, a GUD display on USB. (Its main() is called spangle_program here.) Each command runs in a child
// process, as a user's does, and leaves its output and the picture of the glass in files.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host_sim/cli/screen.hpp"
#include "host_sim/output/output.hpp"
#include "tests/tools/cli/machines.hpp"

int spangle_program(int argc, char** argv);

namespace {

using namespace spangle;
using namespace on_machine;
using Words = std::vector<std::string>;

struct Ran {
    int status = -1;
    std::string out, err, wrong;
    sim::Image glass;
};

std::string text_of(const std::string& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

struct OnDevices : testing::Test {
    std::string folder = testing::TempDir() + "devices-" + std::to_string(getpid());

    OnDevices() { std::filesystem::create_directories(folder); }
    ~OnDevices() override { std::filesystem::remove_all(folder); }

    /// Runs a command in the child process, and ends it.
    [[noreturn]] void child(const std::function<std::unique_ptr<Machine>()>& make, Words words,
                            const std::string& input) const {
        sim::write_file(folder + "/in", input);
        for (const auto& [stream, name] : {std::pair{0, "/in"}, {1, "/out"}, {2, "/err"}}) {
            const int file =
                open((folder + name).c_str(), stream == 0 ? O_RDONLY : O_CREAT | O_WRONLY | O_TRUNC, 0600);
            dup2(file, stream);
        }
        const std::unique_ptr<Machine> machine = make();
        words.insert(words.begin(), "spangle");
        std::vector<char*> argv;
        for (std::string& word : words)
            argv.push_back(word.data());
        const int status = spangle_program(static_cast<int>(argv.size()), argv.data());
        if (machine != nullptr) {
            std::string wrong = machine->wrong();
            if (machine->kernel.open_files() != 0)
                wrong += "files were left open\n";
            sim::write_png(machine->glass(), folder + "/glass.png");
            sim::write_file(folder + "/wrong", wrong);
        }
        std::_Exit(status);
    }

    Ran run(const std::function<std::unique_ptr<Machine>()>& make, const Words& words,
            const std::string& input = "") const {
        std::fflush(nullptr);
        for (const char* name : {"/glass.png", "/wrong"})
            std::filesystem::remove(folder + name);
        const pid_t pid = fork();
        if (pid == 0)
            child(make, words, input);
        Ran ran;
        int status = 0;
        EXPECT_EQ(waitpid(pid, &status, 0), pid);
        EXPECT_TRUE(WIFEXITED(status)) << "signal " << (WIFSIGNALED(status) ? WTERMSIG(status) : 0);
        ran.status = WEXITSTATUS(status);
        ran.out = text_of(folder + "/out");
        ran.err = text_of(folder + "/err");
        ran.wrong = text_of(folder + "/wrong");
        sim::read_png(folder + "/glass.png", ran.glass);
        return ran;
    }
    template <class M> Ran run_on(const Words& words, const std::string& input = "") const {
        return run([] { return std::make_unique<M>(); }, words, input);
    }
    /// Returns the glass of the simulated board after the same command.
    sim::Image simulated(Words words, const std::string& input = "") const {
        const std::string shot = folder + "/simulated.png";
        words.insert(words.end(), {"--shot", shot});
        const Ran ran = run([] { return nullptr; }, words, input);
        EXPECT_EQ(ran.status, 0) << ran.err;
        sim::Image glass;
        EXPECT_EQ(sim::read_png(shot, glass), "");
        return glass;
    }
    static Words with(Words words, const Words& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    static void expect_shown(const Ran& ran, const sim::Image& expected) {
        EXPECT_EQ(ran.status, 0) << ran.err;
        EXPECT_EQ(ran.wrong, "");
        EXPECT_EQ(sim::hash(ran.glass), sim::hash(expected));
    }
};

const Words spidev = {"--spidev", "/dev/spidev0.0", "--dc",    "gpiochip0:24",
                      "--reset",  "gpiochip0:25",   "--light", "gpiochip0:18"};
const Words i2c = {"--i2c", "/dev/i2c-1"};
const Words ftdi = {"--ftdi", "--usb", ftdi_test::path};
const Words gud = {"--gud", "--usb", OnUsb::path};

// --- run

TEST_F(OnDevices, RunDrawsBehindASpidev) {
    const Words words = {"run", "S5", "--frames", "3"};
    const Ran ran = run_on<OnSpidev>(with(words, spidev));
    expect_shown(ran, simulated(words));
    EXPECT_NE(ran.out.find("S5 on ili9341-spi at /dev/spidev0.0, exact precision, 3 frames"),
              std::string::npos)
        << ran.out;
    EXPECT_NE(ran.out.find("frames a second, measured"), std::string::npos) << ran.out;
}

TEST_F(OnDevices, RunDrawsOnAnOled) {
    const Words words = {"run", "HUD", "--frames", "2"};
    expect_shown(run_on<OnI2c>(with(words, i2c)), simulated(with(words, {"--board", "ssd1306-i2c"})));
    const Ran other =
        run([] { return std::make_unique<OnI2c>(0x3D); }, with(words, with(i2c, {"--address", "0x3D"})));
    EXPECT_EQ(other.status, 0) << other.err;
    EXPECT_NE(other.out.find("at /dev/i2c-1 address 3Dh"), std::string::npos) << other.out;
}

TEST_F(OnDevices, RunDrawsAtAnFtdiAdapter) {
    const Words words = {"run", "S5", "--frames", "2"};
    expect_shown(run_on<OnFtdi>(with(with(words, ftdi), {"--hz", "30000000"})), simulated(words));
}

/// A GUD display takes the surface's own 565, so it shows what was drawn.
TEST_F(OnDevices, RunDrawsOnAGudDisplay) {
    const Words words = {"run", "S5", "--frames", "2"};
    const Ran ran = run_on<OnUsb>(with(words, gud));
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.wrong, "");
    const sim::Difference d = sim::compare_565(ran.glass, simulated(with(words, {"--size", "320x240"})));
    EXPECT_EQ(d.pixels, 320u * 240u);
    EXPECT_EQ(d.identical, d.pixels);
    EXPECT_NE(ran.out.find("S5 on GUD display 320x240 at /dev/bus/usb/001/002"), std::string::npos)
        << ran.out;
}

/// A real bus reports the figures of the simulated one for the first frame, which is sent whole. In later
/// frames the costs of commands differ, and so do the windows into which a change is cut.
TEST_F(OnDevices, RunCountsWhatARealBusIsGiven) {
    const auto figure = [](const std::string& json, const std::string& key) {
        const std::size_t at = json.find("\"" + key + "\": ");
        return at == std::string::npos ? "none" : json.substr(at, json.find_first_of(",\n", at) - at);
    };
    const Words words = {"run", "HUD", "--json"};
    const Ran real = run_on<OnSpidev>(with(words, spidev)), model = run([] { return nullptr; }, words);
    for (const char* key :
         {"bus_bytes", "bus_commands", "bus_pixel_bytes", "full_frame_bytes", "picture_hash", "triangles"})
        EXPECT_EQ(figure(real.out, key), figure(model.out, key));
    EXPECT_NE(figure(real.out, "measured_fps"), "none") << real.out;
    EXPECT_EQ(figure(model.out, "measured_fps"), "none");
}

TEST_F(OnDevices, AFullFrameIsWhatTheWireSends) {
    const Ran ran = run_on<OnI2c>(with({"run", "S1"}, i2c));
    EXPECT_NE(ran.out.find("  100 % of a full frame"), std::string::npos) << ran.out;
}

/// Sent bytes and a frame's bytes are counted in the same way on every board, whatever its windows and pages
/// take.
TEST_F(OnDevices, AWholeFrameIsAHundredPercentOnEveryBoard) {
    for (const hal::Board* board : boards::all) {
        const Ran ran = run([] { return nullptr; }, {"run", "S1", "--board", board->name});
        EXPECT_NE(ran.out.find("  100 % of a full frame"), std::string::npos)
            << board->name << ran.out << ran.err;
    }
}

TEST_F(OnDevices, BandsCountEachTriangleOnce) {
    const auto drawn = [](const Ran& ran) {
        const std::size_t at = ran.out.find("per frame"), end = ran.out.find('\n', at);
        return at == std::string::npos ? ran.err : ran.out.substr(at, end - at);
    };
    const Words words = {"run", "S5", "--frames", "2"};
    const std::string whole = drawn(run([] { return nullptr; }, words));
    for (const Words& bands : {Words{"--band-height", "16"}, {"--band-height", "16", "--bands", "record"}})
        EXPECT_EQ(drawn(run([] { return nullptr; }, with(words, bands))), whole);
    EXPECT_EQ(drawn(run_on<OnSpidev>(with(with(words, spidev), {"--band-height", "16"}))), whole);
}

/// Boards that are made and destroyed in one process may have the same address.
TEST_F(OnDevices, BoardsInTheSamePlaceAreOpenedAnew) {
    std::optional<cli::Screen> screen;
    cli::RunOptions options;
    options.scene = "S1";
    for (int i = 0; i < 6; ++i) {
        screen.emplace();
        cli::Session session;
        ASSERT_EQ(screen->open(options, session), "") << i;
    }
}

TEST_F(OnDevices, TheDemoDrawsThreePictures) {
    const Ran ran = run([] { return nullptr; }, {"demo", "--out", folder + "/demo"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    for (const char* name : {"gears", "torus", "model"}) {
        sim::Image picture;
        EXPECT_EQ(sim::read_png(folder + "/demo/" + name + ".png", picture), "") << name;
        EXPECT_EQ(picture.width, 320) << name;
        EXPECT_NE(ran.out.find(std::string(name) + ".png"), std::string::npos) << ran.out;
    }
}

TEST_F(OnDevices, RunPresentsOnARealPanelAsItIsTold) {
    const Words words = {"run", "HUD", "--frames", "3"};
    const sim::Image expected = simulated(words);
    for (const Words& how : {Words{"--band-height", "40"},
                             {"--band-height", "40", "--bands", "record"},
                             {"--row-hash"},
                             {"--buffers", "2", "--pacing", "coalesce"}})
        expect_shown(run_on<OnSpidev>(with(with(words, spidev), how)), expected);
    const Ran tearless =
        run_on<OnSpidev>(with(with(words, spidev), {"--te", "gpiochip0:17", "--tear-free", "te"}));
    EXPECT_EQ(tearless.status, 0) << tearless.err;
    EXPECT_EQ(sim::hash(tearless.glass), sim::hash(expected));
    EXPECT_NE(tearless.out.find("led the beam"), std::string::npos) << tearless.out;
}

// --- card, probe, wizard

TEST_F(OnDevices, TheCardIsShownOnEach) {
    expect_shown(run_on<OnSpidev>(with({"card"}, spidev)), simulated({"card"}));
    expect_shown(run_on<OnFtdi>(with({"card"}, ftdi)), simulated({"card"}));
    expect_shown(run_on<OnI2c>(with({"card"}, i2c)), simulated({"card", "--board", "ssd1306-i2c"}));
    const Ran usb = run_on<OnUsb>(with({"card"}, gud));
    EXPECT_EQ(usb.status, 0) << usb.err;
    EXPECT_EQ(usb.wrong, "");
    // A GUD display is upright, and its components are 255ths.
    const sim::Image card = simulated({"card"});
    ASSERT_EQ(usb.glass.rgba.size(), card.rgba.size());
    int worst = 0;
    for (std::size_t i = 0; i < card.rgba.size(); ++i)
        worst = std::max(worst, std::abs(usb.glass.rgba[i] - card.rgba[i]));
    EXPECT_LE(worst, 4);
}

TEST_F(OnDevices, ProbeFindsThem) {
    const Ran spi = run_on<OnSpidev>(with({"probe"}, spidev));
    EXPECT_EQ(spi.status, 0) << spi.err;
    EXPECT_NE(spi.out.find("fits: ILI9341 240x320"), std::string::npos) << spi.out;
    const Ran two = run_on<OnI2c>(with({"probe"}, i2c));
    EXPECT_EQ(two.status, 0) << two.err;
    EXPECT_EQ(two.out.rfind("3Ch: a controller acknowledges\n3Dh: nobody\n", 0), 0u) << two.out;
    EXPECT_NE(two.out.find("could be: SSD1306 128x64  (board ssd1306-i2c)"), std::string::npos) << two.out;
    EXPECT_EQ(two.wrong, "");
    const Ran nobody = run([] { return std::make_unique<OnI2c>(0x50); }, with({"probe"}, i2c));
    EXPECT_EQ(nobody.status, 1);
    EXPECT_EQ(nobody.out.rfind("3Ch: nobody\n3Dh: nobody\n", 0), 0u) << nobody.out;
    const Ran usb = run_on<OnUsb>(with({"probe"}, gud));
    EXPECT_EQ(usb.status, 0) << usb.err;
    EXPECT_EQ(usb.out.rfind("GUD display at /dev/bus/usb/001/002: 320x240\n", 0), 0u) << usb.out;
}

TEST_F(OnDevices, TheWizardAsksAboutEach) {
    const Ran oled = run_on<OnI2c>(with({"wizard"}, i2c), "y\nr\nf\nu\n0 0\n");
    EXPECT_EQ(oled.status, 0) << oled.err;
    EXPECT_NE(oled.out.find(".bus = spangle::hal::BusKind::i2c"), std::string::npos) << oled.out;
    EXPECT_EQ(oled.wrong, "");
    const Ran usb = run_on<OnUsb>(with({"wizard"}, gud));
    EXPECT_EQ(usb.status, 0) << usb.err;
    EXPECT_NE(usb.out.find("spangle::hal::GudDisplay display;"), std::string::npos) << usb.out;
}

// --- What is refused

TEST_F(OnDevices, RefusalsSayWhatToDo) {
    const struct {
        Words words;
        const char* says;
    } refusals[] = {
        {{"run", "S5", "--spidev", "/dev/spidev9.9", "--dc", "gpiochip0:24"},
         "/dev/spidev9.9: open: No such file"},
        {{"run", "S5", "--i2c", "/dev/i2c-9"}, "/dev/i2c-9 address 3Ch: open: No such file"},
        {{"run", "S5", "--gud", "--usb", "/dev/bus/usb/009/009"}, "/dev/bus/usb/009/009: open: No such file"},
        {{"run", "S5", "--i2c", "/dev/i2c-1", "--board", "ili9341"}, "does not hang on I2C; take one"},
        {{"run", "S5", "--spidev", "/dev/spidev0.0", "--board", "ssd1306-i2c"},
         "does not hang on SPI; take one"},
        {{"run", "S5", "--ftdi", "--board", "hx8347-spi"}, "start bytes"},
        {{"run", "S5", "--ftdi", "--gud"}, "name one display"},
        {{"run", "S5", "--gud", "--band-height", "8"}, "whole frames"},
        {{"run", "S5", "--gud", "--row-hash"}, "presents as its display does"},
        {{"run", "S5", "--gud", "--size", "9x9"}, "--gud excludes --size"},
        {{"card", "--gud", "--wrong", "order"}, "a GUD display has none"},
        {{"card", "--i2c", "/dev/i2c-1", "--shot", "x.png"}, "a real one is for your eyes"},
        {{"probe", "--i2c", "/dev/i2c-9"}, "/dev/i2c-9 address 3Ch: open: No such file"},
    };
    for (const auto& refusal : refusals) {
        const Ran ran = run_on<OnSpidev>(refusal.words);
        EXPECT_EQ(ran.status, 2) << ran.out;
        EXPECT_EQ(ran.out, "");
        EXPECT_NE(ran.err.find(refusal.says), std::string::npos) << ran.err;
    }
    const Ran dump = run_on<OnSpidev>(with({"run", "S5", "--vcd", folder + "/x.vcd"}, spidev));
    EXPECT_NE(dump.err.find("leave out the real bus"), std::string::npos) << dump.err;
    EXPECT_FALSE(std::filesystem::exists(folder + "/x.vcd"));
    const Ran silent = run([] { return std::make_unique<OnI2c>(0x50); }, with({"run", "S5"}, i2c));
    EXPECT_EQ(silent.status, 2);
    EXPECT_NE(silent.err.find("/dev/i2c-1 address 3Ch"), std::string::npos) << silent.err;
}

} // namespace
