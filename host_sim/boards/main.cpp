// The simulated twin of a board: plays the board's scenes on the model of its display and says what the board
// should have said.
//
// usage: spangle_twin play BOARD FRAMES SCENE...
//
// Prints "scene ID" and for each frame "frame HASH FRAGMENTS BYTES": the hash of what was drawn, fragments
// drawn, bytes sent to the display so far.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <memory>

#include <spangle/sim/board.hpp>

#include "board_table.hpp"
#include "boards/demo/demo.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "host_sim/boards/desk.hpp"

namespace {

using namespace spangle;

/// A board as its display.hpp describes it.
struct Twin {
    const char* name;
    std::unique_ptr<sim::Desk> (*make)();
};

#define SPANGLE_TWIN(name) {#name, [] { return sim::make_desk(boards::name); }},
constexpr Twin twins[] = {SPANGLE_BOARDS(SPANGLE_TWIN)};
#undef SPANGLE_TWIN

const Twin* find(const char* name) {
    for (const Twin& twin : twins)
        if (std::strcmp(twin.name, name) == 0)
            return &twin;
    return nullptr;
}

class Printer final : public demo::Watcher {
  public:
    explicit Printer(sim::Desk& desk) : desk_(desk) {}

    void begin_frame() override {
        counters_ = {};
        gl::observe(*gl::current_context(), &counters_, false);
    }
    void drawn() override { hash_ = demo::frame_hash(desk_.display()); }
    void presented() override {
        std::printf("frame %08" PRIx32 " %" PRIu64 " %" PRIu64 "\n", hash_,
                    static_cast<std::uint64_t>(counters_.fragments), desk_.bytes());
    }

  private:
    sim::Desk& desk_;
    raster::Counters counters_;
    std::uint32_t hash_ = 0;
};

int play(const Twin& twin, int frames, int count, char** ids) {
    const std::unique_ptr<sim::Desk> desk = twin.make();
    Printer printer(*desk);
    for (int i = 0; i < count; ++i) {
        const scenes::Scene* const scene = scenes::find(ids[i]);
        if (scene == nullptr) {
            std::fprintf(stderr, "spangle_twin: no scene '%s'\n", ids[i]);
            return 2;
        }
        std::printf("scene %s\n", scene->id);
        if (const char* const problem = demo::play(desk->display(), *scene, frames, printer)) {
            std::fprintf(stderr, "spangle_twin: %s on %s: %s failed\n", scene->id, twin.name, problem);
            return 1;
        }
    }
    const std::string wrong = desk->violations();
    std::fputs(wrong.c_str(), stderr);
    return wrong.empty() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 5 || std::strcmp(argv[1], "play") != 0) {
        std::fprintf(stderr, "usage: spangle_twin play BOARD FRAMES SCENE...\n");
        return 2;
    }
    const Twin* const twin = find(argv[2]);
    if (twin == nullptr) {
        std::fprintf(stderr, "spangle_twin: no board '%s'\n", argv[2]);
        return 2;
    }
    return play(*twin, std::atoi(argv[3]), argc - 4, argv + 4);
}
