#include <spangle/hal/op_list.hpp>

#include <spangle/hal/dcs.hpp>

namespace spangle::hal {

void OpList::pixels(const std::uint8_t* data, std::uint32_t row_bytes, std::uint32_t rows,
                    std::int32_t stride) {
    Op* op = append(Op::Kind::pixels);
    if (op == nullptr)
        return;
    op->data = data;
    op->length = row_bytes;
    op->rows = rows;
    op->stride = stride;
}

void OpList::repeat_black(std::uint32_t bytes, std::uint32_t count) {
    Op* op = append(Op::Kind::repeat);
    if (op == nullptr)
        return;
    OpParams& pixel = params_[size_ - 1];
    pixel = OpParams{};
    op->data = pixel.bytes;
    op->length = bytes;
    op->rows = count;
}

void OpList::delay(std::uint32_t micros) {
    if (Op* op = append(Op::Kind::delay))
        op->micros = micros;
}

void OpList::wait_te(std::uint32_t at_most_micros, std::uint32_t* moment) {
    Op* op = append(Op::Kind::wait_te);
    if (op == nullptr)
        return;
    op->micros = at_most_micros;
    op->into = reinterpret_cast<std::uint8_t*>(moment);
}

void OpList::wait_line(std::uint8_t dummy_bits, std::int32_t first, std::int32_t count, std::int32_t lines,
                       std::uint32_t at_most_micros, std::uint32_t* moment) {
    Op* op = append(Op::Kind::wait_line);
    if (op == nullptr)
        return;
    op->command = dcs::RDSCANLINE;
    op->dummy_bits = dummy_bits;
    op->length = static_cast<std::uint32_t>(first);
    op->rows = static_cast<std::uint32_t>(count);
    op->stride = lines;
    op->micros = at_most_micros;
    op->into = reinterpret_cast<std::uint8_t*>(moment);
}

void OpList::read(std::uint8_t code, std::uint8_t dummy_bits, std::uint8_t* into, std::uint32_t count) {
    Op* op = append(Op::Kind::read);
    if (op == nullptr)
        return;
    op->command = code;
    op->dummy_bits = dummy_bits;
    op->into = into;
    op->length = count;
}

void OpList::reset(std::uint32_t low_micros) {
    if (Op* op = append(Op::Kind::reset))
        op->micros = low_micros;
}

Result<Token> OpList::submit(Bus& bus) const {
    if (overflow_)
        return Error{Fault::bad_argument, "op list: more ops than its storage holds"};
    return bus.submit(ops_, size_);
}

namespace {

constexpr std::uint32_t forever = 0xFFFFFFFF;

std::uint32_t cycles_time(std::uint64_t cycles, std::uint32_t hz) {
    if (hz == 0)
        return forever;
    const std::uint64_t micros = (cycles * 1000000u + hz - 1) / hz;
    return micros < forever ? static_cast<std::uint32_t>(micros) : forever;
}

/// The cycles that a bus needs for this number of bits.
std::uint64_t bus_cycles(const BusCaps& caps, std::uint64_t bits) {
    const std::uint32_t width = caps.bits_per_cycle != 0 ? caps.bits_per_cycle : 1;
    return (bits + width - 1) / width;
}

/// What a list asks of the bus. It is summed before times are computed, as divisions are dear on small cores.
struct BusWork {
    std::uint64_t bytes = 0, read_bits = 0, micros = 0;
    std::uint32_t commands = 0;

    void add(const Op& op) {
        switch (op.kind) {
        case Op::Kind::command:
            ++commands;
            bytes += std::uint64_t{op.length} + 1;
            break;
        case Op::Kind::pixels:
        case Op::Kind::repeat:
            bytes += std::uint64_t{op.length} * op.rows;
            break;
        case Op::Kind::read:
            ++commands;
            bytes += 1;
            read_bits += std::uint64_t{op.length} * 8 + op.dummy_bits;
            break;
        case Op::Kind::delay:
        case Op::Kind::wait_te:
        case Op::Kind::wait_line:
        case Op::Kind::reset:
            micros += op.micros;
            break;
        }
    }
};

} // namespace

std::uint32_t wire_time(const BusCaps& caps, std::uint64_t bytes) {
    if (bytes >> 40 != 0)
        // cycles_time() multiplies by 10^6, and 2^43 bits times 10^6 would not fit 63 bits.
        return forever;
    return cycles_time(bus_cycles(caps, bytes * 8), caps.write_hz);
}

std::int64_t wire_nanoseconds(const BusCaps& caps, std::uint64_t bytes) {
    const std::uint64_t cycles = bus_cycles(caps, bytes * 8);
    return caps.write_hz == 0 ? 0 : static_cast<std::int64_t>(cycles * 1000000000u / caps.write_hz);
}

std::uint64_t OpList::bytes() const {
    BusWork work;
    for (std::size_t i = 0; i < size_; ++i)
        work.add(ops_[i]);
    return work.bytes;
}

std::uint32_t OpList::duration(const BusCaps& caps) const {
    BusWork work;
    for (std::size_t i = 0; i < size_; ++i)
        work.add(ops_[i]);
    std::uint64_t micros = work.micros + wire_time(caps, work.bytes);
    micros += (std::uint64_t{work.commands} * caps.command_cost_ns + 999) / 1000;
    if (work.read_bits != 0)
        micros += cycles_time(bus_cycles(caps, work.read_bits), caps.read_hz);
    return micros < forever ? static_cast<std::uint32_t>(micros) : forever;
}

} // namespace spangle::hal
