// The simulated twin of a board. It plays the board's scenes on the model of its display, and compares the
// result with what an emulator did.
//
// usage: spangle_twin play BOARD FRAMES SCENE...
//        spangle_twin replay BOARD FRAMES TRACE PICTURES WIRE... -- SCENE...
//        spangle_twin screens BOARD FRAMES FOLDER PICTURES SCALE SCENE...
//
// play prints "scene ID" and for each frame "frame HASH FRAGMENTS".
// replay sends to a model of the display's controller what a program sent. TRACE is QEMU's trace of register
// writes; WIRE says where the lines are (wires.hpp). Standard input has, a number a line, how many bytes had
// been sent at the end of each frame. screens looks at QEMU's own display: FOLDER/1.ppm, 2.ppm, ... Both
// print what differs from the twin's glass, and write the last frame of each scene to PICTURES-SCENE.png ("":
// nowhere).
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>

#include "board_table.hpp"
#include "host_sim/boards/player.hpp"
#include "host_sim/boards/screen.hpp"
#include "host_sim/boards/wires.hpp"
#include "host_sim/output/output.hpp"

namespace {

using namespace spangle;
using Words = std::vector<std::string>;

/// A board as its display.hpp describes it. `panel` is null for a board that scans memory.
struct Twin {
    const char* name;
    std::unique_ptr<sim::Desk> (*make)();
    const hal::Board* panel;
};

constexpr const hal::Board* panel_of(const hal::Board& board) {
    return &board;
}
constexpr const hal::Board* panel_of(const hal::MappedConfig&) {
    return nullptr;
}

#define SPANGLE_TWIN(name) {#name, [] { return sim::make_desk(boards::name); }, panel_of(boards::name)},
constexpr Twin twins[] = {SPANGLE_BOARDS(SPANGLE_TWIN)};
#undef SPANGLE_TWIN

const Twin* find(const std::string& name) {
    for (const Twin& twin : twins)
        if (twin.name == name)
            return &twin;
    return nullptr;
}

void print(const std::string& line) {
    sim::standard_output().write(line + "\n");
}

int fail(const std::string& text) {
    std::fprintf(stderr, "spangle_twin: %s\n", text.c_str());
    return 1;
}

int play(const Twin& twin, int frames, const Words& scenes) {
    const std::unique_ptr<sim::Desk> desk = twin.make();
    const std::string problem = sim::play(*desk, scenes, frames, [](const sim::PlayedFrame& frame) {
        if (frame.index == 0)
            print(std::string("scene ") + frame.scene.id);
        char line[64];
        std::snprintf(line, sizeof line, "frame %08" PRIx32 " %" PRIu32, frame.hash, frame.fragments);
        print(line);
    });
    return problem.empty() ? 0 : fail(problem);
}

/// Compares frames that an emulator showed with the glass of the twin.
class Comparison {
  public:
    Comparison(const Twin& twin, int frames, std::string pictures)
        : desk_(twin.make()), frames_(frames), pictures_(std::move(pictures)) {}

    /// `look` gives the n-th frame, counted from 1, or returns false if it was not seen. `same` compares two
    /// pictures.
    template <class Look, class Same> int run(const Words& scenes, Look look, Same same) {
        int seen = 0, wrong = 0;
        const std::string problem = sim::play(*desk_, scenes, frames_, [&](const sim::PlayedFrame& frame) {
            sim::Image shown;
            const bool there = look(++seen, shown);
            if (!there || !same(shown, desk_->glass())) {
                ++wrong;
                print(std::string(frame.scene.id) + ": frame " + std::to_string(frame.index) + " " +
                      (there ? "looks different" : "was not seen"));
            }
            if (!pictures_.empty() && frame.index + 1 == frames_ && missing_pictures_.empty())
                missing_pictures_ = sim::write_png(shown, pictures_ + "-" + frame.scene.id + ".png");
        });
        if (!problem.empty())
            return fail(problem);
        if (!missing_pictures_.empty())
            return fail(missing_pictures_);
        return wrong == 0 ? 0 : 1;
    }
    PixelFormat format() { return desk_->display().info().format; }

  private:
    std::unique_ptr<sim::Desk> desk_;
    int frames_;
    std::string pictures_, missing_pictures_;
};

int replay(const Twin& twin, int frames, const Words& words) {
    sim::Wiring wiring;
    std::size_t at = 2;
    for (; at < words.size() && words[at] != "--"; ++at)
        if (!sim::parse_wiring(words[at], wiring))
            return fail("no wire: " + words[at]);
    if (twin.panel == nullptr || at >= words.size())
        return fail("replay: a board with a panel, and scenes behind --");
    std::ifstream trace(words[0]);
    sim::WiredPanel panel(*twin.panel, wiring, sim::read_trace(trace, wiring));
    std::vector<std::uint64_t> sent;
    for (std::uint64_t n; std::cin >> n;)
        sent.push_back(n);

    Comparison comparison(twin, frames, words[1]);
    const int status = comparison.run(
        Words(words.begin() + static_cast<std::ptrdiff_t>(at) + 1, words.end()),
        [&](int n, sim::Image& shown) {
            const auto frame = static_cast<std::size_t>(n - 1);
            const bool there = frame < sent.size() && panel.advance(sent[frame]);
            shown = panel.glass();
            return there;
        },
        [](const sim::Image& shown, const sim::Image& glass) { return shown == glass; });
    if (!panel.at_end())
        print("the program sent more than its frames");
    const std::string violations = panel.violations();
    sim::standard_output().write(violations);
    return status != 0 || !panel.at_end() || !violations.empty() ? 1 : 0;
}

int screens(const Twin& twin, int frames, const Words& words) {
    const int scale = std::atoi(words[2].c_str());
    if (scale < 1)
        return fail("screens: no scale");
    Comparison comparison(twin, frames, words[1]);
    const PixelFormat format = comparison.format();
    return comparison.run(
        Words(words.begin() + 3, words.end()),
        [&](int n, sim::Image& shown) {
            sim::Image screen;
            if (!sim::read_ppm(words[0] + "/" + std::to_string(n) + ".ppm", screen).empty())
                return false;
            shown = sim::shrink_picture(screen, scale);
            return true;
        },
        [&](const sim::Image& shown, const sim::Image& glass) { return sim::shows(shown, glass, format); });
}

int run(const Words& words) {
    const Twin* const twin = words.size() < 4 ? nullptr : find(words[1]);
    if (twin == nullptr)
        return fail(words.size() < 4 ? "usage: spangle_twin play|replay|screens BOARD FRAMES ..."
                                     : "no board '" + words[1] + "'");
    const int frames = std::atoi(words[2].c_str());
    const Words rest(words.begin() + 3, words.end());
    if (words[0] == "play")
        return play(*twin, frames, rest);
    if (words[0] == "replay" && rest.size() > 3)
        return replay(*twin, frames, rest);
    if (words[0] == "screens" && rest.size() > 3)
        return screens(*twin, frames, rest);
    return fail("no command '" + words[0] + "', or too few words");
}

} // namespace

int main(int argc, char** argv) {
    const int status = run(Words(argv + 1, argv + argc));
    const std::string lost = sim::standard_output().commit();
    return lost.empty() ? status : fail(lost);
}
