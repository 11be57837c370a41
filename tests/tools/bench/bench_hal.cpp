// Measures a transport: frames of a scene go through Spangle's buses and the real libraries below them, on
// modelled devices. Prints one JSON object a line. The devices' own work is subtracted: `Kernel::device_cpu`.
#include <cstdio>
#include <ctime>
#include <memory>

#include <spangle/EGL/egl.h>
#include <spangle/boards/ili9341_8080.hpp>
#include <spangle/boards/ili9341_spi.hpp>
#include <spangle/linux/gpio_bus.hpp>
#include <spangle/linux/spidev_bus.hpp>
#include <spangle/native.hpp>
#include <spangle/usb/ftdi_bus.hpp>
#include <spangle/usb/gud_display.hpp>

#include "boards/scenes/scene.hpp"
#include "host_sim/linux/gpio_chip.hpp"
#include "host_sim/linux/panel_module.hpp"
#include "host_sim/linux/spi_device.hpp"
#include "host_sim/usb/ftdi_adapter.hpp"
#include "host_sim/usb/gud_device.hpp"
#include "host_sim/usb/usbfs.hpp"

namespace {

using namespace spangle;

constexpr int warm_frames = 3, frames = 20;

/// A bus that counts what goes over it.
class Counted final : public hal::Bus {
  public:
    explicit Counted(hal::Bus& bus) : bus_(bus) {}
    hal::BusCaps caps() const override { return bus_.caps(); }
    hal::Result<hal::Buffer> acquire(std::size_t size) override { return bus_.acquire(size); }
    hal::Result<hal::Token> submit(const hal::Op* ops, std::size_t count) override {
        for (std::size_t i = 0; i < count; ++i) {
            const hal::Op& op = ops[i];
            const bool pixels = op.kind == hal::Op::Kind::pixels || op.kind == hal::Op::Kind::repeat;
            bytes += op.kind == hal::Op::Kind::command ? 1 + op.length : pixels ? op.length * op.rows : 0;
        }
        return bus_.submit(ops, count);
    }
    bool done(hal::Token token) const override { return bus_.done(token); }
    hal::Result<void> wait(hal::Token token, std::uint32_t micros) override {
        return bus_.wait(token, micros);
    }

    std::uint64_t bytes = 0;

  private:
    hal::Bus& bus_;
};

std::uint64_t cpu_ns() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<std::uint64_t>(now.tv_sec) * 1'000'000'000u + static_cast<std::uint64_t>(now.tv_nsec);
}

/// Draws the scene on this display; `bytes` counts what its wire carries.
void measure(const char* name, const char* scene_id, hal::Display& display, const std::uint64_t& bytes) {
    sim::Kernel& kernel = sim::Kernel::instance();
    const scenes::Scene& scene = *scenes::find(scene_id);
    const EGLDisplay egl = eglGetDisplay(native(display));
    EGLint count = 0, wish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 16, EGL_NONE};
    EGLConfig config = nullptr;
    if (!eglInitialize(egl, nullptr, nullptr) || !eglChooseConfig(egl, wish, &config, 1, &count)) {
        std::fprintf(stderr, "bench_hal: %s does not start\n", name);
        return;
    }
    const EGLSurface window = eglCreateWindowSurface(egl, config, 0, nullptr);
    eglMakeCurrent(egl, window, window, eglCreateContext(egl, config, nullptr, nullptr));
    scene.setup(display.info().width, display.info().height);
    std::uint64_t cpu = 0, wire = 0, carried = 0;
    for (int frame = 0; frame < warm_frames + frames; ++frame) {
        scene.draw(frame);
        const std::uint64_t bytes_before = bytes, cpu_before = cpu_ns();
        const sim::Time device_before = kernel.device_cpu(), time_before = kernel.now();
        if (!eglSwapBuffers(egl, window) || !display.finish())
            std::fprintf(stderr, "bench_hal: a frame was lost\n");
        if (frame < warm_frames)
            continue;
        const std::uint64_t devices = kernel.device_cpu() - device_before, all = cpu_ns() - cpu_before;
        cpu += all > devices ? all - devices : 0;
        wire += kernel.now() - time_before;
        carried += bytes - bytes_before;
    }
    std::printf(
        "{\"transport\": \"%s\", \"scene\": \"%s\", \"bytes\": %llu, \"wire_us\": %llu, \"cpu_us\": %.1f}\n",
        name, scene_id, static_cast<unsigned long long>(carried / frames),
        static_cast<unsigned long long>(wire / frames / 1000), static_cast<double>(cpu) / frames / 1000);
    eglTerminate(egl);
}

sim::ModuleWiring wiring(sim::ModuleWiring::Bus bus) {
    sim::ModuleWiring w;
    w.bus = bus;
    w.reset = 25;
    w.data_command = 24;
    return w;
}

struct Machine {
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::GpioChip chip{"pinctrl-bcm2711", 54};
    Machine() { chip.attach(kernel, 0); }
    ~Machine() { kernel.forget_all(); }
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;
};

constexpr char chip_path[] = "/dev/gpiochip0";

void spidev(const char* scene) {
    Machine machine;
    sim::PanelModule module(hal::panels::ili9341_240x320, wiring(sim::ModuleWiring::Bus::spi4), machine.chip,
                            machine.kernel);
    sim::SpiDevice device(module.serial());
    device.attach(machine.kernel, "/dev/spidev0.0");
    hal::SpidevConfig config =
        hal::spidev_config(boards::ili9341_spi, "/dev/spidev0.0", {chip_path, 24}, {{chip_path, 25}, {}, {}});
    config.asynchronous = false;
    hal::SpidevBus bus(config);
    Counted counted(bus);
    const auto display = std::make_unique<hal::BoardDisplay<boards::ili9341_spi>>(counted);
    if (bus.open().ok())
        measure("spidev, 40 MHz", scene, *display, counted.bytes);
}

void parallel(const char* scene) {
    Machine machine;
    sim::ModuleWiring w = wiring(sim::ModuleWiring::Bus::parallel8);
    w.select = 8;
    w.clock = 11;
    w.answer = 9;
    for (unsigned i = 0; i < 8; ++i)
        w.data[i] = 30 + i;
    sim::PanelModule module(hal::panels::ili9341_240x320, w, machine.chip, machine.kernel);
    hal::GpioBusConfig config;
    config.wiring = hal::GpioWiring::parallel8;
    config.select = w.select;
    config.data_command = w.data_command;
    config.clock = w.clock;
    config.answer = w.answer;
    std::copy(w.data.begin(), w.data.end(), config.data);
    config.pins.reset = {chip_path, 25};
    config.asynchronous = false;
    hal::GpioBus bus(config);
    Counted counted(bus);
    const auto display = std::make_unique<hal::BoardDisplay<boards::ili9341_8080>>(counted);
    if (bus.open().ok())
        measure("8080 on GPIO lines", scene, *display, counted.bytes);
}

constexpr char usb_path[] = "/dev/bus/usb/001/002";

void ftdi(const char* scene) {
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::FtdiAdapter adapter(kernel);
    sim::UsbfsDevice usb(adapter);
    sim::ModuleWiring w;
    w.clock = sim::MpsseEngine::clock_pin;
    w.data[0] = sim::MpsseEngine::out_pin;
    w.answer = sim::MpsseEngine::in_pin;
    w.select = 3;
    w.data_command = 4;
    w.reset = 6;
    sim::PanelModule module(hal::panels::ili9341_240x320, w, adapter.engine, kernel);
    usb.attach(kernel, usb_path);
    {
        hal::FtdiConfig config = hal::ftdi_config(boards::ili9341_spi);
        config.device_file = usb_path;
        config.asynchronous = false;
        hal::FtdiBus bus(config);
        Counted counted(bus);
        const auto display = std::make_unique<hal::BoardDisplay<boards::ili9341_spi>>(counted);
        if (bus.open().ok())
            measure("FT232H, 30 MHz", scene, *display, counted.bytes);
    }
    kernel.forget_all();
}

void gud(const char* scene, bool compress) {
    sim::Kernel& kernel = sim::Kernel::instance();
    sim::GudDevice device;
    sim::UsbfsDevice usb(device);
    usb.attach(kernel, usb_path);
    {
        hal::GudConfig config;
        config.device_file = usb_path;
        config.compress = compress;
        hal::GudDisplay display(config);
        measure(compress ? "GUD, LZ4" : "GUD, raw", scene, display, device.counters().bulk_bytes);
    }
    kernel.forget_all();
}

} // namespace

int main() {
    for (const char* const scene : {"S5", "HUD"}) {
        spidev(scene);
        parallel(scene);
        ftdi(scene);
        gud(scene, false);
        gud(scene, true);
    }
    return 0;
}
