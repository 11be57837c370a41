// A bus with a DCS controller behind it, which can be told to fail. It carries out lists only when they are
// waited for, so a driver that changes memory in flight is caught.
#pragma once

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "tests/unit/hal/dcs_model.hpp"
#include <spangle/hal/bus.hpp>
#include <spangle/hal/panel.hpp>

namespace hal_test {

using namespace spangle;
using namespace spangle::hal;

class FakePanelBus final : public Bus {
  public:
    FakePanelBus(const PanelDesc& panel, BusCaps caps)
        : model(panel.memory.width, panel.memory.height), caps_(caps) {}

    // Faults that a test may ask for.
    int refuse_submits = 0;     ///< the number of next submits that answer busy
    long fail_after_bytes = -1; ///< after so many bytes the transfer ends with short_write; -1: never
    int late_waits = 0;         ///< the number of next waits that time out while the transfer goes on
    bool te_missing = false;    ///< whether wait_te ends the transfer with timeout
    std::uint32_t te_period_us = 0, te_now_us = 0; ///< microseconds; 0: the bus reports no moments of TE
    int allow_acquires = 1000;
    std::uint8_t id_command = 0x04;
    std::uint8_t id[3] = {0x85, 0x85, 0x52}, status[4] = {0x00, 0x61, 0x00, 0x00};

    // What the bus has seen so far.
    DcsModel model;
    int madctl = -1, colmod = -1, submits = 0;
    bool inverted = false, awake = false, on = false, te_on = false;
    long pixel_bytes = 0, command_bytes = 0, repeats = 0, delay_us = 0, te_waits = 0, line_waits = 0;
    long cut_pixels = 0; ///< operations that end inside of a pixel
    std::uint32_t longest_op = 0, last_timeout = 0;
    std::string log;
    std::vector<Op> last_list;

    BusCaps caps() const override { return caps_; }

    Result<Buffer> acquire(std::size_t size) override {
        if (allow_acquires-- <= 0)
            return Error{Fault::unsupported, "fake: out of DMA memory"};
        memory_.push_back(std::make_unique<std::uint8_t[]>(size));
        std::memset(memory_.back().get(), 0xA5, size);
        return Buffer{memory_.back().get(), size};
    }

    Result<Token> submit(const Op* ops, std::size_t count) override {
        if (refuse_submits > 0) {
            --refuse_submits;
            return Error{Fault::busy, "fake: busy"};
        }
        run_pending();
        ++submits;
        last_list.assign(ops, ops + count);
        pending_ = true;
        return Token{++last_token_};
    }

    bool done(Token token) const override { return token.id < last_token_ || !pending_; }

    Result<void> wait(Token, std::uint32_t timeout) override {
        last_timeout = timeout;
        if (late_waits > 0) {
            --late_waits;
            return Error{Fault::timeout, "fake: deadline"};
        }
        run_pending();
        const Error ended = outcome_;
        outcome_ = {};
        if (ended.fault != Fault::none)
            return ended;
        return {};
    }

    /// Ends the transfer by itself, as real hardware does.
    void run_pending() {
        if (!pending_)
            return;
        pending_ = false;
        for (const Op& op : last_list)
            if (!run(op))
                return;
    }

  private:
    bool spend(long bytes) {
        if (fail_after_bytes < 0)
            return true;
        fail_after_bytes -= bytes;
        if (fail_after_bytes >= 0)
            return true;
        fail_after_bytes = -1;
        outcome_ = {Fault::short_write, "fake: short write"};
        return false;
    }

    void note(const char* format, unsigned value) {
        char text[32];
        std::snprintf(text, sizeof text, format, value);
        log += text;
    }

    unsigned pixel_size() const { return (colmod & 7) == 6 ? 3 : 2; }

    bool run(const Op& op) {
        const std::uint32_t bytes = op.length * (op.kind == Op::Kind::command ? 1 : op.rows);
        if (op.kind != Op::Kind::read && bytes > longest_op)
            longest_op = bytes;
        if (op.kind == Op::Kind::pixels && op.length % pixel_size() != 0)
            ++cut_pixels;
        switch (op.kind) {
        case Op::Kind::command:
            return run_command(op);
        case Op::Kind::pixels:
            for (std::uint32_t y = 0; y < op.rows; ++y)
                for (std::uint32_t x = 0; x < op.length; ++x)
                    if (!data(op.data[static_cast<std::ptrdiff_t>(y) * op.stride + x]))
                        return false;
            pixel_bytes += bytes;
            return true;
        case Op::Kind::repeat:
            for (std::uint32_t n = 0; n < op.rows; ++n)
                for (std::uint32_t x = 0; x < op.length; ++x)
                    if (!data(op.data[x]))
                        return false;
            repeats += op.rows;
            note("rep%u ", op.rows);
            return true;
        case Op::Kind::delay:
            delay_us += op.micros;
            note("D%u ", op.micros / 1000);
            return true;
        case Op::Kind::wait_te:
            ++te_waits;
            te_now_us += te_period_us;
            tell_moment(op, te_now_us);
            if (te_missing)
                outcome_ = {Fault::timeout, "fake: no TE edge"};
            return !te_missing;
        case Op::Kind::wait_line:
            ++line_waits;
            if (te_missing)
                outcome_ = {Fault::timeout, "fake: no such line"};
            return !te_missing;
        case Op::Kind::read:
            return run_read(op);
        case Op::Kind::reset:
            note("reset%u ", op.micros);
            model.madctl = 0;
            return true;
        }
        return true;
    }

    bool run_command(const Op& op) {
        if (!spend(1))
            return false;
        command_ = op.command;
        held_bytes_ = 0;
        if (command_ == 0x2C)
            model.ramwr();
        note("%02X ", op.command);
        std::uint8_t p[256] = {};
        for (std::uint32_t i = 0; i < op.length; ++i) {
            if (!spend(1))
                return false; // a cut list of parameters changes nothing
            p[i & 255] = op.data[i];
            note("%02x ", op.data[i]);
        }
        command_bytes += op.length + 1;
        const int first = p[0] << 8 | p[1], last = p[2] << 8 | p[3];
        if (command_ == 0x2A)
            model.xs = first, model.xe = last;
        if (command_ == 0x2B)
            model.ys = first, model.ye = last;
        if (command_ == 0x36)
            madctl = p[0], model.madctl = p[0];
        if (command_ == 0x3A)
            colmod = p[0];
        if (command_ == 0x20 || command_ == 0x21)
            inverted = command_ == 0x21;
        if (command_ == 0x11)
            awake = true;
        if (command_ == 0x29)
            on = true;
        if (command_ == 0x35)
            te_on = true;
        return true;
    }

    bool data(std::uint8_t byte) {
        if (!spend(1))
            return false;
        held_ = held_ << 8 | byte;
        const unsigned size = pixel_size();
        if (++held_bytes_ < size)
            return true;
        model.pixel(held_ & (size == 3 ? 0xFFFFFF : 0xFFFF));
        held_ = held_bytes_ = 0;
        return true;
    }

    bool run_read(const Op& op) {
        note("r%02X", op.command);
        note("/%u ", op.dummy_bits);
        for (std::uint32_t i = 0; i < op.length; ++i) {
            std::uint8_t value = 0x9C;
            if (op.command == id_command)
                value = id[i % 3];
            if (op.command == 0x09)
                value = status[i % 4];
            if (op.command == 0x0B)
                value = static_cast<std::uint8_t>(madctl);
            if (op.command == 0x45)
                value = i == 0 ? 0x01 : 0x23;
            if (op.command == 0x2E)
                value = static_cast<std::uint8_t>(i);
            op.into[i] = value;
        }
        return true;
    }

    BusCaps caps_;
    std::vector<std::unique_ptr<std::uint8_t[]>> memory_;
    bool pending_ = false;
    std::uint32_t last_token_ = 0;
    Error outcome_;
    std::uint8_t command_ = 0;
    std::uint32_t held_ = 0;
    unsigned held_bytes_ = 0;
};

inline BusCaps spi(std::uint32_t hz = 40000000) {
    BusCaps caps;
    caps.write_hz = hz;
    caps.read_hz = 6000000;
    return caps;
}

} // namespace hal_test
