// A board: a panel, how it is turned, and the bus it hangs on. Plain data, checked when it is compiled.
#pragma once

#include <cstdint>

#include <spangle/hal/bus_memory.hpp>
#include <spangle/hal/panel_display.hpp>
#include <spangle/hal/panel_rules.hpp>

namespace spangle::hal {

/// A panel, how it is turned, and the bus on which it hangs. board() checks a description while it is
/// compiled.
struct Board {
    /// The name by which tools know the board: lower case, with hyphens. Static.
    const char* name = "";
    /// One line for people to read, in static memory.
    const char* summary = "";
    /// The panel, its orientation, the formats and how frames are presented.
    PanelConfig display;
    /// The wires between the processor and the panel.
    BusKind bus = BusKind::spi4;
    std::uint32_t write_hz = 0; ///< frequency of the serial clock, or of write cycles
    std::uint32_t read_hz = 0;  ///< frequency of reads; 0: the panel cannot be read
    bool has_te = false;        ///< the panel's TE output reaches the bus
    /// Nanoseconds that a command costs beyond its bytes: toggling D/C, a system call.
    std::uint32_t command_cost_ns = 0;
};

/// The capabilities of the bus that a board describes.
constexpr BusCaps bus_caps(const Board& board) {
    BusCaps caps = board.bus == BusKind::i2c ? i2c_caps(board.write_hz) : BusCaps{};
    caps.has_te = board.has_te;
    if (board.bus == BusKind::i2c)
        return caps;
    caps.kind = board.bus;
    caps.write_hz = board.write_hz;
    caps.read_hz = board.read_hz;
    caps.bits_per_cycle = board.bus == BusKind::i8080 ? 8 : 1;
    caps.command_cost_ns = board.command_cost_ns;
    return caps;
}

/// The rule this board breaks, or null. It must name a panel. The rules are those of a PanelDisplay on the
/// bus that the board describes.
constexpr const char* flaw(const Board& board, OnFlaw on = OnFlaw::tell) {
    if (const auto r = check_config(board.display, on); !r)
        return r.error().rule;
    if (const auto r = check_bus(board.display, bus_caps(board), on); !r)
        return r.error().rule;
    return nullptr;
}

/// Describes a board, or does not compile.
consteval Board board(Board description) {
    flaw(description, OnFlaw::stop);
    return description;
}

/// Bytes of frame buffers the board's display asks its bus for, each rounded up to BusMemory::alignment.
constexpr std::size_t bus_memory(const Board& board) {
    const PanelConfig& c = board.display;
    const auto rounded = [](std::size_t n) {
        return (n + BusMemory::alignment - 1) / BusMemory::alignment * BusMemory::alignment;
    };
    const Extent picture = held(c, picture_size(c)), sent = held(c, sent_size(c));
    const auto frame = static_cast<std::size_t>(row_bytes(c.format, picture.width)) *
                       static_cast<std::size_t>(stored_rows(c.format, picture.height));
    if (!c.wire.converts())
        return c.buffers * rounded(frame);
    const auto pixels = static_cast<std::size_t>(sent.width) * static_cast<std::size_t>(sent.height);
    // A window that ends inside a byte takes the whole byte. There is at most one window per row.
    return rounded(frame) +
           rounded((pixels * wire_info(c.wire.format).bits + 7) / 8 + static_cast<std::size_t>(sent.height));
}

/// The memory of bus_memory() for the bus of one board: `static BusMemoryOf<my_board> frames;`
template <const Board& board> class BusMemoryOf {
  public:
    /// The memory, as the constructor of a bus takes it.
    Buffer buffer() { return {bytes_, sizeof bytes_}; }

  private:
    alignas(BusMemory::alignment) std::uint8_t bytes_[bus_memory(board)];
};

/// The memory that a display of this description needs. `ops`: operations of a list. `remembers`:
/// [bands](docs/glossary.md#band) record what the panel shows.
constexpr PanelSizes sizes_of(const PanelConfig& c, std::size_t ops, bool remembers) {
    return {.height = book_height(c),
            .buffers = c.buffers,
            .ops = ops,
            .hashed_width = c.row_hash ? sent_size(c).width : 0,
            .turned = turns(c),
            .held = c.pacing == Pacing::coalesce,
            .content = !remembers    ? 0
                       : c.band != 0 ? picture_size(c).height
                                     : book_height(c),
            .indexed = is_indexed(c.format)};
}

/// The display of a board with exactly the memory it needs: `static BoardDisplay<my_board> display(bus);`
/// `Ops` and `Remembers` are those of sizes_of(). Boards with little memory ask for less.
template <const Board& board, std::size_t Ops = 64, bool Remembers = true>
class BoardDisplay final : private PanelStorage<sizes_of(board.display, Ops, Remembers)>,
                           public PanelDisplay {
  public:
    /// A display on this bus, which must outlive it. Nothing is sent before init().
    explicit BoardDisplay(Bus& bus) : PanelDisplay(bus, board.display, this->memory(), parts) {}

  private:
    static constexpr PanelDisplay::Parts parts = PanelDisplay::parts_of(board.display, Remembers);
};

} // namespace spangle::hal
