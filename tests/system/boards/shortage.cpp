// Firmware that runs out of memory, and firmware whose panel does not answer. Both must report it and go on.
#include <cstdint>

#include <spangle/EGL/egl.h>
#include <spangle/GL/gl.h>
#include <spangle/hal/polled_bus.hpp>
#include <spangle/mcu/semihosting.hpp>
#include <spangle/native.hpp>

#include <spangle/boards/boards.hpp>

#include "boards/board.hpp"
#include "boards/demo/demo.hpp"

namespace {

using namespace spangle;
namespace semihosting = mcu::semihosting;

/// A port on which no device acknowledges.
struct DeadPort final : hal::PolledPort {
    hal::Fault begin(bool) override { return hal::Fault::no_answer; }
    hal::Fault write(const std::uint8_t*, std::uint32_t) override { return hal::Fault::no_answer; }
    hal::Fault read(std::uint8_t, std::uint8_t*, std::uint32_t) override { return hal::Fault::no_answer; }
    void end() override {}
    void reset(bool) override {}
    void pause(std::uint32_t) override {}
};

/// A small display, for which every board has memory beside its own.
constexpr hal::Board wiring = [] {
    hal::Board board = boards::ssd1306_128x32;
    board.display.format = PixelFormat::mono;
    board.display.wire = {};
    return board;
}();
DeadPort dead_port;
hal::BusMemoryOf<wiring> dead_frames;
hal::PolledBus dead_bus{dead_port, hal::bus_caps(wiring), dead_frames.buffer()};
hal::BoardDisplay<wiring, 8> dead_display{dead_bus};

struct Hash final : demo::Watcher {
    void begin_frame() override { picture = {}; }
    void drawn(const demo::Rows& rows) override { picture.add(rows); }
    demo::PictureHash picture;
};

void say(const char* what, const char* how) {
    semihosting::print(what);
    semihosting::print(": ");
    semihosting::print(how != nullptr ? how : "shown");
    semihosting::print("\n");
}

/// A scene that makes textures until there is no memory for one more, and then draws with those it has.
void setup(int width, int height) {
    static const GLubyte texels[16 * 16 * 3] = {};
    int count = 0;
    for (; count < 1000 && glGetError() == GL_NO_ERROR; ++count) {
        GLuint name = 0;
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D, name);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
        if (glGetError() == GL_OUT_OF_MEMORY)
            break;
    }
    semihosting::print(count > 2 && count < 1000 ? "GL_OUT_OF_MEMORY after some textures\n"
                                                 : "no shortage was met\n");
    glBindTexture(GL_TEXTURE_2D, 1);
    scenes::two_triangles.setup(width, height);
}
const scenes::Scene shortage{"shortage", "textures without end", setup, scenes::two_triangles.draw};

} // namespace

int main() {
    hal::Display& display = board::start();
    Hash none, wanted, got;
    say("a panel that does not answer", demo::play(dead_display, scenes::two_triangles, 1, none));
    say("the board's own", demo::play(display, scenes::two_triangles, 1, wanted));
    say("without memory", demo::play(display, shortage, 1, got));
    say("the same picture", wanted.picture.value() == got.picture.value() ? "yes" : "no");
    return 0;
}
