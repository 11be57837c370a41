// The program that every board runs: it shows scenes, one after the other. boards/tools/boards.py builds it
// with DEMO_SCENES, the addresses of the board's scenes.
#include "boards/board.hpp"
#include "boards/demo/demo.hpp"
#include "boards/demo/report.hpp"

#ifndef DEMO_SCENES
#error "define DEMO_SCENES: &scenes::torus_textured, &scenes::hud"
#endif

int main() {
    using namespace spangle;
    static constexpr const scenes::Scene* list[] = {DEMO_SCENES};
    hal::Display& display = board::start();
    demo::Watcher& watcher = demo::watcher();
    do
        for (const scenes::Scene* scene : list) {
            demo::begin(*scene);
            demo::end(demo::play(display, *scene, demo::frames_to_show(), watcher));
        }
    while (demo::again());
    return 0;
}
