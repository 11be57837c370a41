#include "tests/system/sim/controller_stream.hpp"

#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <optional>

#include "host_sim/bus/pins.hpp"
#include "host_sim/controller/dcs_controller.hpp"

namespace sim_test {
namespace {

using namespace spangle::sim;

void require(bool condition, const char* text) {
    if (condition)
        return;
    std::fprintf(stderr, "controller stream: %s\n", text);
    std::abort();
}

/// Reads the bytes of the stream, and zeros after its end.
class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t bytes) : at_(data), end_(data + bytes) {}
    bool more() const { return at_ != end_; }
    std::uint8_t byte() { return at_ != end_ ? *at_++ : std::uint8_t{0}; }

  private:
    const std::uint8_t *at_, *end_;
};

/// The most bytes on the bus in one run, which fill a small memory twice.
constexpr std::uint64_t most_bytes = 2000;

constexpr auto kinds = static_cast<unsigned>(std::size(chips));

/// Returns a chip, or the same chip with a small memory, which finds mistakes as well and far quicker.
Chip chip_of(unsigned choice) {
    Chip chip = chips[choice % kinds];
    if (choice >= kinds) {
        chip.width = 12;
        chip.height = 20;
    }
    return chip;
}

GlassMount mount_of(const Chip& chip, Bytes& in) {
    const unsigned how = in.byte();
    GlassMount m;
    m.x = in.byte() % chip.width;
    m.y = in.byte() % chip.height;
    m.width = 1 + in.byte() % (chip.width - m.x);
    m.height = 1 + in.byte() % (chip.height - m.y);
    m.mirror_columns = (how & 1) != 0;
    m.mirror_rows = (how & 2) != 0;
    m.bgr_filter = (how & 4) != 0;
    m.normally_inverted = (how & 8) != 0;
    return m;
}

/// How a host is wired to the controller: bits 0 to 2 of the stream's second byte.
struct Wiring {
    bool parallel, pins;
    bool odd; ///< for pins: 3-wire SPI with D/C before each byte, or an 8080 bus of 16 lines

    explicit Wiring(unsigned bits) : parallel((bits & 1) != 0), pins((bits & 2) != 0), odd((bits & 6) == 6) {}
    Wiring bytes() const {
        Wiring w = *this;
        w.pins = false;
        return w;
    }
    unsigned cycles() const { return parallel ? 1 : odd ? 9 : 8; } ///< cycles of a byte
    bool wide() const { return parallel && odd; }
};

/// A controller with the front end through which bytes reach it.
class FrontEnd {
  public:
    FrontEnd(const Chip& chip, const GlassMount& glass, const Wiring& wiring)
        : controller(chip, glass, wiring.parallel), wiring_(wiring) {
        if (wiring.pins && wiring.parallel)
            parallel_.emplace(controller, wiring.odd ? 16u : 8u);
        else if (wiring.pins)
            serial_.emplace(controller, wiring.odd);
    }

    DcsController controller;

    void select(bool on, Time now) {
        selected_ = on;
        if (serial_)
            serial_->set(SerialPins::Pin::select, !on, now);
        else if (parallel_)
            parallel_->set(ParallelPins::Pin::select, !on, now);
        else
            controller.select(on, now);
    }
    void reset(bool low, Time now) {
        if (serial_)
            serial_->set(SerialPins::Pin::reset, !low, now);
        else if (parallel_)
            parallel_->set(ParallelPins::Pin::reset, !low, now);
        else
            controller.reset(low, now);
    }
    /// Writes a byte in cycles of `period` from `now` on. A byte counts from its last rising edge on. A byte
    /// of pixels on sixteen lines is sent twice.
    void write(std::uint8_t byte, bool data, Time now, unsigned period) {
        if (serial_) {
            serial_->set(SerialPins::Pin::data, data, now);
            const unsigned word = byte | (data ? 0x100u : 0u);
            for (unsigned i = 0; i < wiring_.cycles(); ++i)
                clock((word >> (wiring_.cycles() - 1 - i) & 1) != 0, now + Time(i) * period, period);
        } else if (parallel_) {
            using Pin = ParallelPins::Pin;
            parallel_->set(Pin::data, data, now);
            parallel_->drive(byte * 0x101u);
            parallel_->set(Pin::write, false, now);
            parallel_->set(Pin::write, true, now + period);
        } else {
            for (int n = data && pairs() ? 2 : 1; n > 0; --n)
                controller.write(byte, data, now + Time(period) * wiring_.cycles(), period);
        }
        if (selected_ && !data)
            command_ = byte;
        dummy_ = dummy_ || selected_;
    }
    unsigned read(Time now, unsigned period) {
        if (serial_)
            return clock(false, now, period);
        if (parallel_) {
            using Pin = ParallelPins::Pin;
            parallel_->set(Pin::read, false, now);
            const unsigned answer = parallel_->answer();
            parallel_->set(Pin::read, true, now + period);
            return answer;
        }
        if (!wiring_.parallel)
            return controller.read_bit(now + period, period);
        if (!selected_)
            return 0;
        unsigned answer = controller.read_byte(now + period, period);
        if (pairs() && !dummy_)
            answer = answer << 8 | controller.read_byte(now + period, period);
        dummy_ = false;
        return answer;
    }
    bool at_pins() const { return wiring_.pins; }
    void edge(unsigned pin, bool high, Time now) {
        if (serial_)
            serial_->set(static_cast<SerialPins::Pin>(pin % 5), high, now);
        else if (parallel_)
            parallel_->set(static_cast<ParallelPins::Pin>(pin % 5), high, now);
    }

  private:
    Wiring wiring_;
    std::optional<SerialPins> serial_;
    std::optional<ParallelPins> parallel_;
    bool selected_ = false, dummy_ = false;
    std::uint8_t command_ = 0;

    /// Whether a cycle of 16 lines carries two bytes of pixels.
    bool pairs() const {
        const bool memory = command_ == 0x2C || command_ == 0x3C || command_ == 0x2E || command_ == 0x3E;
        return wiring_.wide() && memory;
    }
    bool clock(bool out, Time now, unsigned period) {
        using Pin = SerialPins::Pin;
        serial_->set(Pin::clock, false, now);
        serial_->set(Pin::mosi, out, now);
        const bool in = serial_->miso();
        serial_->set(Pin::clock, true, now + period);
        return in;
    }
};

class Run {
  public:
    Run(const std::uint8_t* data, std::size_t bytes)
        : in_(data, bytes), chip_(chip_of(in_.byte())), wiring_(in_.byte()) {
        const GlassMount glass = mount_of(chip_, in_);
        first_ = std::make_unique<FrontEnd>(chip_, glass, wiring_);
        if (wiring_.pins)
            twin_ = std::make_unique<FrontEnd>(chip_, glass, wiring_.bytes());
    }

    void all() {
        while (in_.more() && bytes_ < most_bytes)
            one(static_cast<Step>(in_.byte() % static_cast<unsigned>(Step::count)));
        look();
        if (twin_)
            compare();
    }

  private:
    Bytes in_;
    Chip chip_;
    Wiring wiring_;
    std::unique_ptr<FrontEnd> first_, twin_;
    Time now_ = 0;
    unsigned write_cycle_ = 100, read_cycle_ = 500;
    std::uint64_t bytes_ = 0;

    template <class F> void both(F f) {
        f(*first_);
        if (twin_)
            f(*twin_);
    }

    void one(Step step) {
        switch (step) {
        case Step::command:
            write(in_.byte(), false);
            break;
        case Step::parameter:
            write(in_.byte(), true);
            break;
        case Step::data:
            for (int n = in_.byte(); n > 0; --n)
                write(in_.byte(), true);
            break;
        case Step::repeat: {
            const int n = 4 * in_.byte();
            const std::uint8_t byte = in_.byte();
            for (int i = 0; i < n; ++i)
                write(byte, true);
            break;
        }
        case Step::select: {
            const bool on = in_.byte() % 2 != 0;
            both([&](FrontEnd& f) { f.select(on, now_); });
            break;
        }
        case Step::reset: {
            const bool low = in_.byte() % 2 != 0;
            both([&](FrontEnd& f) { f.reset(low, now_); });
            break;
        }
        case Step::micros: {
            const unsigned high = in_.byte();
            now_ += Time(high << 8 | in_.byte()) * 1000;
            break;
        }
        case Step::millis:
            now_ += Time(in_.byte()) * 1'000'000;
            break;
        case Step::read:
            for (int n = in_.byte(); n > 0; --n)
                read();
            break;
        case Step::write_cycle:
            write_cycle_ = 1u + in_.byte();
            break;
        case Step::read_cycle:
            read_cycle_ = 4u * (1u + in_.byte());
            break;
        case Step::edge:
            if (first_->at_pins()) {
                const unsigned pin = in_.byte();
                twin_.reset();
                first_->edge(pin / 2, pin % 2 != 0, now_ += 10);
            }
            break;
        default:
            look();
            break;
        }
    }

    void write(std::uint8_t byte, bool data) {
        if (answering()) // pins take no bits while the controller answers; whole bytes do
            twin_.reset();
        both([&](FrontEnd& f) { f.write(byte, data, now_, write_cycle_); });
        now_ += Time(write_cycle_) * wiring_.cycles();
        ++bytes_;
    }

    void read() {
        if (!wiring_.parallel && !answering()) // byte ports do not know the clocks of a byte
            twin_.reset();
        const unsigned answer = first_->read(now_, read_cycle_);
        if (twin_)
            require(twin_->read(now_, read_cycle_) == answer, "pins and bytes answer differently");
        now_ += read_cycle_;
    }

    bool answering() const { return !wiring_.parallel && wiring_.pins && first_->controller.answers(); }

    void look() {
        DcsController& c = first_->controller;
        const std::vector<Rgb666> seen = c.glass(now_);
        require(seen.size() == static_cast<std::size_t>(c.mount().width * c.mount().height),
                "the glass has another size");
        for (const Rgb666& p : seen)
            require(p.r < 64 && p.g < 64 && p.b < 64, "the glass shows more than six bits");
        require(c.memory().size() == static_cast<std::size_t>(chip_.width * chip_.height),
                "the memory has another size");
        const int line = c.scan_line(now_);
        require(line >= 0 && line < chip_.height + chip_.porch_lines, "the beam is nowhere");
        if (!c.is_awake())
            require(!c.te(now_), "TE while asleep");
        if (!first_->at_pins()) // pixels of 12 bits are the smallest
            require(c.pixels_written() <= bytes_ * 2 / 3 + 1, "more pixels than bytes");
    }

    void compare() {
        DcsController &a = first_->controller, &b = twin_->controller;
        require(a.memory() == b.memory(), "pins and bytes leave different memories");
        require(a.glass(now_) == b.glass(now_), "pins and bytes show different glasses");
        require(a.madctl() == b.madctl() && a.is_awake() == b.is_awake() && a.display_on() == b.display_on(),
                "pins and bytes leave different registers");
        require(a.pixels_written() == b.pixels_written(), "pins and bytes write different pixels");
    }
};

/// Writes the bytes of a stream.
class Writer {
  public:
    explicit Writer(unsigned chip, unsigned front) : out_{std::uint8_t(chip), std::uint8_t(front)} {
        for (const int byte : {0, 0, 0, 255, 255}) // the glass shows the whole memory
            put(byte);
        step(Step::select, 1);
        step(Step::reset, 1);
        step(Step::micros, 0, 20);
        step(Step::reset, 0);
        step(Step::millis, 130);
    }
    template <class... B> void step(Step s, B... bytes) {
        put(static_cast<int>(s));
        (put(bytes), ...);
    }
    void command(int code, std::initializer_list<int> parameters = {}) {
        step(Step::command, code);
        for (const int p : parameters)
            step(Step::parameter, p);
    }
    void wake(int colmod) {
        command(0x11);
        step(Step::millis, 130);
        command(0x3A, {colmod});
        command(0x29);
    }
    void window(int x0, int x1, int y0, int y1) {
        command(0x2A, {0, x0, 0, x1});
        command(0x2B, {0, y0, 0, y1});
    }
    void pixels(int code, int count, int seed) {
        command(code);
        step(Step::data, count);
        for (int i = 0; i < count; ++i)
            put(seed + i * 53);
    }
    void read(int code, int bits) {
        command(code);
        step(Step::micros, 0, 1);
        step(Step::read, bits);
        step(Step::select, 0);
        step(Step::select, 1);
    }
    std::vector<std::uint8_t> done() {
        step(Step::look);
        return out_;
    }

  private:
    std::vector<std::uint8_t> out_;
    void put(int byte) { out_.push_back(static_cast<std::uint8_t>(byte)); }
};

void draw(Writer& w) {
    for (const int colmod : {0x55, 0x66, 0x53}) {
        w.command(0x3A, {colmod});
        w.window(2, 5, 3, 4);
        w.pixels(0x2C, colmod == 0x66 ? 24 : colmod == 0x55 ? 16 : 12, colmod);
        w.pixels(0x3C, 6, 7);
    }
    for (const int order : {0x20, 0x40, 0x60, 0x88, 0xE8}) {
        w.command(0x36, {order});
        w.window(1, 3, 1, 2);
        w.pixels(0x2C, 12, order);
    }
    w.command(0x00);
}

void modes(Writer& w, int height) {
    w.command(0x33, {0, 4, (height - 6) >> 8, height - 6, 0, 2});
    w.command(0x37, {0, 9});
    w.command(0x30, {0, 3, 0, 8});
    w.command(0x12);
    w.step(Step::look);
    w.command(0x13);
    w.command(0x21);
    w.command(0x39);
    w.step(Step::millis, 40);
    w.step(Step::look);
    w.command(0x35, {1});
    w.command(0x44, {0, 5});
    w.step(Step::look);
    w.command(0x38);
    w.command(0x10);
    w.step(Step::millis, 130);
    w.command(0x01);
}

void answers(Writer& w, bool parallel, int pixel_dummies) {
    for (const int code : {0x04, 0x09, 0x45})
        w.read(code, parallel ? 5 : 33);
    for (int code = 0x0A; code <= 0x0F; ++code)
        w.read(code, parallel ? 2 : 8);
    w.window(2, 3, 2, 3);
    w.read(0x2E, parallel ? 14 : pixel_dummies + 96);
    w.read(0x3E, parallel ? 4 : pixel_dummies + 24);
    w.read(0xDA, parallel ? 2 : 8);
}

/// Writes the mistakes that drivers make.
void mistakes(Writer& w) {
    w.command(0x2A, {0, 9, 0, 8});
    w.command(0x2B, {0, 0, 1, 255});
    w.pixels(0x2C, 5, 1);
    w.command(0x36);
    w.command(0x33, {255, 255, 255, 255, 255, 255});
    w.step(Step::write_cycle, 3);
    w.step(Step::repeat, 80, 0x5A);
    w.step(Step::reset, 1);
    w.step(Step::reset, 0);
    w.command(0x2C);
    w.step(Step::read_cycle, 0);
    w.read(0x04, 24);
}

/// Writes single edges: a byte in which D/C changes, and a byte that CS ends.
void edges(Writer& w) {
    for (const int pin : {3, 2, 0, 1, 2, 3, 8, 9, 6, 7, 4, 5, 6, 7, 6, 7, 6, 7})
        w.step(Step::edge, pin);
    w.command(0x29);
}

} // namespace

void run_controller_stream(const std::uint8_t* data, std::size_t bytes) {
    Run(data, bytes).all();
}

std::vector<std::vector<std::uint8_t>> controller_seeds() {
    std::vector<std::vector<std::uint8_t>> seeds;
    for (unsigned chip = 0; chip < 2 * kinds; ++chip) // each chip with its own memory, and with a small one
        for (const unsigned front : {0u, 1u, 2u, 3u, 6u, 7u}) {
            const Chip facts = chip_of(chip);
            const auto with = [&](auto fill) {
                Writer w(chip, front);
                w.wake(0x55);
                fill(w);
                seeds.push_back(w.done());
            };
            with(draw);
            with([&](Writer& w) { modes(w, facts.height); });
            with([&](Writer& w) { answers(w, (front & 1) != 0, facts.pixel_dummy_bits); });
            with(mistakes);
            if ((front & 2) != 0)
                with(edges);
        }
    return seeds;
}

} // namespace sim_test
