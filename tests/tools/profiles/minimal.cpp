// Runs boards/minimal in an emulator. Prints the hash of each frame before it is presented, as boards/demo
// does, and the memory that was used. A display of its own stands between the program and the panel's.
#include "boards/minimal/rocket.hpp"
#include "boards/minimal/screen.hpp"

#include <spangle/mcu/semihosting.hpp>
#include <spangle/mcu/stack.hpp>
#include <spangle/native.hpp>

namespace {

using namespace spangle;
namespace semihosting = mcu::semihosting;

class Listener final : public hal::Display {
  public:
    explicit Listener(hal::Display& display) : display_(display) {}

    hal::DisplayInfo info() const override { return display_.info(); }
    hal::Result<void> init() override { return display_.init(); }
    hal::Result<hal::Frame> acquire() override {
        const hal::Result<hal::Frame> frame = display_.acquire();
        if (frame.ok())
            frame_ = frame.value();
        return frame;
    }
    hal::Result<void> present() override {
        std::uint32_t hash = 2166136261u;
        const std::int32_t bytes = frame_.stride * display_.info().height;
        for (std::int32_t i = 0; i < bytes; ++i)
            hash = (hash ^ frame_.pixels[i]) * 16777619u;
        semihosting::print("frame ");
        semihosting::print_hex(hash);
        semihosting::print("\n");
        return display_.present();
    }

  private:
    hal::Display& display_;
    hal::Frame frame_;
};

void print_line(const char* name, std::size_t value) {
    semihosting::print(name);
    semihosting::print(" ");
    semihosting::print_number(static_cast<std::uint32_t>(value));
    semihosting::print("\n");
}

} // namespace

int main() {
    Listener display(minimal::start());
    semihosting::print("scene MINIMAL\n");
    if (!minimal::open(display))
        semihosting::print("failed open\n");
    for (unsigned step = 0; step < 3; ++step)
        if (!minimal::show(step * 5))
            semihosting::print("failed show\n");
    const MemoryUse use = memory_use();
    print_line("arena", use.capacity);
    print_line("peak", use.peak);
    print_line("stack", mcu::deepest_stack());
    return 0;
}
