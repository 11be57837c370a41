// A panel that is sent whole frames through a port that is polled: for programs whose flash or RAM has no
// room for PanelDisplay, which keeps what the panel shows and sends what differs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <spangle/hal/board.hpp>

namespace spangle::hal {

namespace detail {

/// Writes an initialisation program at compile time.
struct ProgramWriter {
    std::array<std::uint8_t, 512> bytes{};
    std::size_t size = 0;

    consteval void add(Program program) {
        for (std::size_t i = 0; i < program.size; ++i)
            bytes[size++] = program.at[i];
    }
    consteval void add(const OpList& commands) {
        for (const Op* op = commands.data(); op != commands.data() + commands.size(); ++op) {
            bytes[size++] = op->command;
            bytes[size++] = static_cast<std::uint8_t>(op->length);
            for (std::uint32_t i = 0; i < op->length; ++i)
                bytes[size++] = op->data[i];
        }
    }
    consteval void add_delay(std::uint32_t micros) {
        if (micros != 0)
            add(delay_ms((micros + 999) / 1000));
    }
};

/// The commands from reset to the first pixel, and those from one frame's last pixel to the next one's first.
struct FramePrograms {
    ProgramWriter opening, next;
};

consteval FramePrograms frame_programs(const Board& board) {
    const PanelConfig& config = board.display;
    const PanelDesc& panel = *config.panel;
    const Placement placement = place(panel, config.orientation);
    const FormatCode format = format_code(panel, board.bus, wire_format(config));
    const Rect all = {0, 0, placement.size.width, placement.size.height};
    Windows windows(panel, placement, wire_format(config));
    if (!(windows.first_of(all) == all))
        return {}; // a frame needs several windows on this panel
    Op ops[16];
    OpParams params[16];
    FramePrograms out;
    if (!config.reset_line)
        out.opening.add(panel.commands->soft_reset);
    out.opening.add_delay(panel.timing.reset_wait_us);
    out.opening.add(panel.setup);
    OpList settings(ops, params, 16);
    append_settings(settings, panel, placement, format);
    out.opening.add(settings);
    out.opening.add(panel.commands->wake);
    out.opening.add_delay(panel.timing.sleep_out_wait_us);
    OpList first(ops, params, 16);
    windows.open(first, all);
    out.opening.add(first);
    OpList second(ops, params, 16);
    windows.open(second, all);
    out.next.add(second);
    return out;
}

/// A program of just the bytes that were written.
template <ProgramWriter written> consteval ProgramBytes<written.size> trimmed() {
    ProgramBytes<written.size> bytes{};
    for (std::size_t i = 0; i < written.size; ++i)
        bytes[i] = written.bytes[i];
    return bytes;
}
template <const Board& board>
inline constexpr auto opening_program = trimmed<frame_programs(board).opening>();
template <const Board& board> inline constexpr auto next_program = trimmed<frame_programs(board).next>();

/// Whether a board asks for no more than whole frames, unconverted, through a port that is polled.
constexpr bool sends_plain_frames(const Board& board) {
    const PanelConfig& c = board.display;
    return !c.wire.converts() && c.buffers == 1 && !c.read_back && !c.wait_te && !c.poll_line &&
           !c.scan_order && !c.row_hash && c.band == 0 && !is_indexed(c.format);
}

} // namespace detail

/// All commands are constants that the compiler makes. The [wire](docs/glossary.md#wire) carries what
/// PanelDisplay sends of frames that changed everywhere. `Wires` has the functions of a PolledPort, which
/// need not be virtual.
template <const Board& board, class Wires> class FrameDisplay final : public Display {
    static_assert(detail::sends_plain_frames(board), "display: this board asks for more than whole frames");
    static_assert(!detail::opening_program<board>.empty(),
                  "display: one window of this panel does not name a frame");

  public:
    static constexpr std::size_t bytes = bus_memory(board); ///< bytes of a frame

    /// `frame` must outlive the display, and must be black: all bytes are zero.
    constexpr FrameDisplay(Wires& wires, std::uint8_t* frame) : wires_(wires), frame_(frame) {}

    DisplayInfo info() const override {
        return {.name = board.display.panel->name,
                .width = size.width,
                .height = size.height,
                .format = board.display.format,
                .keeps_buffer = true};
    }
    /// Sets the panel up, also after it lost its power. It comes on with what was drawn last.
    Result<void> init() override {
        fault_ = Fault::none;
        if constexpr (board.display.reset_line) {
            wires_.reset(true);
            wires_.pause(board.display.panel->timing.reset_low_us);
            wires_.reset(false);
        }
        send(detail::opening_program<board>);
        play(light);
        return ended();
    }
    Result<Frame> acquire() override {
        return Frame{frame_, row_bytes(board.display.format, size.width), age_};
    }
    /// A panel that did not take a frame is set up again by the next present.
    Result<void> present() override {
        if (failed())
            return init();
        age_ = 1;
        send(detail::next_program<board>);
        return ended();
    }

  private:
    static constexpr Extent size = picture_size(board.display);
    // These are constants, so that the panel's tables are not linked.
    static constexpr Program light = board.display.panel->commands->light;
    static constexpr bool parameters_are_data = !board.display.panel->commands->parameters_are_commands;

    /// Wires without any acknowledgement set their own `can_fail` to false.
    static constexpr bool can_fail = !requires { requires !Wires::can_fail; };
    bool failed() const { return can_fail && fault_ != Fault::none; }
    Result<void> ended() {
        wires_.end();
        if (failed())
            return Error{fault_, "FrameDisplay: the port ended the transfer with a fault"};
        return {};
    }
    /// Sends a program, which ends with the command for pixels, and a frame behind it.
    void send(Program program) {
        play(program);
        write(true, frame_,
              row_bytes(board.display.format, size.width) * stored_rows(board.display.format, size.height));
    }
    void play(Program program) {
        while (!program.empty() && !failed()) {
            const Program::Step step = program.next();
            if (step.delay_micros != 0) {
                wires_.end();
                wires_.pause(step.delay_micros);
                continue;
            }
            write(false, step.command, 1);
            if (step.count != 0)
                write(parameters_are_data, step.params, step.count);
        }
    }
    /// Writes bytes, but nothing after a fault.
    void write(bool data, const std::uint8_t* from, std::uint32_t count) {
        if (failed())
            return;
        Fault fault = wires_.begin(data);
        if (fault == Fault::none)
            fault = wires_.write(from, count);
        if constexpr (can_fail)
            fault_ = fault;
    }

    Wires& wires_;
    std::uint8_t* frame_;
    std::int32_t age_ = 0;
    Fault fault_ = Fault::none; ///< what ended the last transfer; the next one sets the panel up anew
};

} // namespace spangle::hal
