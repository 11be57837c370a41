// Reports to an emulator by semihosting. For each frame the program prints "frame HASH DRAWING PRESENTING
// BYTES": the hash of the picture, instructions for drawing and for presenting, and the bytes sent to the
// display so far. Each scene begins with "scene ID". The last lines are "NAME BYTES", one for each kind of
// memory.
//
// The command line, "NAME FRAMES [wait]", says how many frames of a scene are shown. With "wait" the program
// stops after frame N, counted from 1, until there is a file "next-N". This gives time to look at the
// emulated display.
#include "boards/demo/report.hpp"

#include <initializer_list>

#include <spangle/mcu/instructions.hpp>
#include <spangle/mcu/semihosting.hpp>
#include <spangle/mcu/stack.hpp>
#include <spangle/native.hpp>

#include "boards/board.hpp"

namespace spangle::demo {

namespace {

namespace semihosting = mcu::semihosting;

struct Arguments {
    int frames = 30;
    bool wait = false;

    Arguments() {
        char text[64];
        if (!semihosting::command_line(text, sizeof text))
            return;
        const char* at = text;
        while (*at != '\0' && *at != ' ')
            ++at;
        if (*at == ' ' && at[1] >= '1' && at[1] <= '9')
            for (frames = 0, ++at; *at >= '0' && *at <= '9'; ++at)
                frames = frames * 10 + (*at - '0');
        wait = *at == ' ' && at[1] == 'w';
    }
};

void print_line(const char* name, std::uint32_t value) {
    semihosting::print(name);
    semihosting::print(" ");
    semihosting::print_number(value);
    semihosting::print("\n");
}

class Semihosting final : public Watcher {
  public:
    void begin_frame() override {
        hash_ = {};
        drawing_ = presenting_ = 0;
        count_.begin();
    }
    void draws() override {
        presenting_ += count_.end();
        count_.begin();
    }
    void drawn(const Rows& rows) override {
        drawing_ += count_.end();
        hash_.add(rows);
        count_.begin();
    }
    void presented() override {
        presenting_ += count_.end();
        semihosting::print("frame ");
        semihosting::print_hex(hash_.value());
        for (const std::uint32_t value : {drawing_, presenting_, board::bus_bytes()}) {
            semihosting::print(" ");
            semihosting::print_number(value);
        }
        semihosting::print("\n");
        ++shown_;
        if (arguments.wait)
            wait();
    }

    const Arguments arguments;

  private:
    void wait() const {
        char name[16] = "next-";
        std::uint32_t length = 5;
        for (std::uint32_t unit = 10000; unit != 0; unit /= 10)
            if (shown_ >= unit)
                name[length++] = static_cast<char>('0' + shown_ / unit % 10);
        while (!semihosting::exists(name, length)) {
        }
    }

    mcu::InstructionCount count_{board::clock_hz};
    PictureHash hash_;
    std::uint32_t drawing_ = 0, presenting_ = 0, shown_ = 0;
};

Semihosting* listener;

} // namespace

Watcher& watcher() {
    static Semihosting one;
    listener = &one;
    return one;
}

int frames_to_show() {
    return listener->arguments.frames;
}

void begin(const scenes::Scene& scene) {
    semihosting::print("scene ");
    semihosting::print(scene.id);
    semihosting::print("\n");
}

void end(const char* problem) {
    if (problem == nullptr)
        return;
    semihosting::print("failed ");
    semihosting::print(problem);
    semihosting::print("\n");
}

bool again() {
    const MemoryUse use = memory_use();
    print_line("arena", static_cast<std::uint32_t>(use.capacity));
    print_line("peak", static_cast<std::uint32_t>(use.peak));
    print_line("stack", mcu::deepest_stack());
    return false;
}

} // namespace spangle::demo
