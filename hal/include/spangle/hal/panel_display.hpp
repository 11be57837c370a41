// A panel behind an op-list bus as a Display: frames are drawn in bus-owned memory in the wire format, and a
// present sends what differs from the panel's memory.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus.hpp>
#include <spangle/hal/display.hpp>
#include <spangle/hal/op_list.hpp>
#include <spangle/hal/orientation.hpp>
#include <spangle/hal/readback.hpp>
#include <spangle/hal/row_hash.hpp>
#include <spangle/hal/window.hpp>

namespace spangle::hal {

struct PanelConfig {
    const PanelDesc* panel = nullptr;
    Orientation orientation = {};
    PixelFormat format = PixelFormat::rgb565_be;
    /// Another format on the wire: a present turns what it sends into it, in memory of its own, and returns
    /// while that is on the wire. Null: the surface's pixels travel as they are.
    const Wire* wire = nullptr;
    std::uint8_t buffers =
        1; ///< 1: present() returns when the frame is on the panel; 2: while it is on the wire
    bool reset_line = true; ///< false: SWRESET instead
    bool read_back = false; ///< the panel's data line is wired back: init() checks what answers
    bool wait_te = false;   ///< present starts at the tearing-effect edge, or follows the beam
    bool row_hash = false;  ///< cells of 16x1 pixels that were drawn again as they were are not sent
};

constexpr WireFormat wire_format(const PanelConfig& config) {
    return config.wire != nullptr ? config.wire->format : same_bytes(config.format);
}

/// What is in one frame buffer: outside these rows, the clear value.
struct PanelContent {
    RowSpan* rows = nullptr;
    std::uint32_t clear_value = 0;
};

/// The memory of a PanelDisplay's bookkeeping, handed over by its owner. All rows have `height` elements.
struct PanelMemory {
    RowSpan* touched = nullptr;
    RowSpan* damage = nullptr;
    RowSpan* content[2] = {};
    std::uint16_t* plan = nullptr;
    std::int32_t height = 0;
    std::uint8_t buffers = 0;
    Op* ops = nullptr;
    OpParams* params = nullptr;
    std::size_t op_count = 0;
    RowHashMemory hash = {};
};

/// That memory for pictures up to `Height` rows, and `HashedWidth` columns if they are to be hashed. A list
/// longer than `Ops` goes out in several transfers.
template <std::int32_t Height, std::uint8_t Buffers = 1, std::size_t Ops = 64, std::int32_t HashedWidth = 0>
struct PanelStorage {
    static_assert(Height > 0 && Height <= 4096 && (Buffers == 1 || Buffers == 2) && Ops >= 8);

    RowSpan touched[Height], damage[Height], content[Buffers][Height];
    std::uint16_t plan[Height];
    Op ops[Ops];
    OpParams params[Ops];
    RowHashStorage<Height, HashedWidth> hash;

    PanelMemory memory() {
        return {touched, damage,       {content[0], content[Buffers - 1]}, plan, Height, Buffers, ops, params,
                Ops,     hash.memory()};
    }
};

class PanelDisplay : public Display {
  public:
    PanelDisplay(Bus& bus, const PanelConfig& config, const PanelMemory& memory);

    DisplayInfo info() const override;
    /// Reset, identity, setup, a black glass, display on. May be called again, to recover a panel that lost
    /// its power.
    Result<void> init() override;
    Result<Frame> acquire() override;
    /// With two buffers, or another format on the wire, the error of a transfer is reported by the next
    /// present(), which then sends nothing.
    Result<void> present() override;

    /// Waits until everything presented is on the panel.
    Result<void> finish() override;
    Result<PanelStatus> status();
    Result<std::uint16_t> scanline();
    /// Pixels of the panel's memory, see read_pixels().
    Result<void> read_back(const Rect& area, std::uint8_t* rgb);

    const Placement& placement() const { return placement_; }

  private:
    Result<void> check_config() const;
    Result<void> take_buffers();
    Result<void> reset_panel();
    Result<void> append_setup();
    Result<void> append_registers();
    Result<void> append_program(Program program);
    Result<void> append_black();
    Result<void> append_black_window(const Rect& window);

    void collect_damage();
    Result<void> send();
    Result<void> append_windows(const Rect& area);
    Result<void> append_window(const Rect& window);
    std::size_t convert(const Rect& window);
    void widen_damage();
    Result<void> append_pixels(const std::uint8_t* data, std::uint32_t row_bytes, std::uint32_t rows);
    void append_sync(std::uint32_t bytes);
    void accept();

    Result<void> make_room(std::size_t ops);
    Result<void> start();
    Result<void> complete();

    std::uint32_t stride() const { return static_cast<std::uint32_t>(placement_.size.width) * pixel_bytes_; }
    std::uint32_t wire_bits() const { return wire_info(wire_format(config_)).bits; }
    std::size_t wire_bytes(const Extent& size) const;
    std::uint32_t op_limit() const;

    Bus& bus_;
    PanelConfig config_;
    PanelMemory memory_;
    BusCaps caps_;
    Placement placement_;
    std::uint32_t pixel_bytes_ = 0;
    Windows windows_;
    RowHash hash_;
    OpList ops_;
    ReadScratch scratch_{};

    Buffer buffers_[2];
    Buffer wire_;              ///< where pixels are turned into another format
    std::size_t wire_end_ = 0; ///< of what the list under way takes from it
    PanelContent content_[2];
    RowExtents extents_;
    std::uint8_t presented_ = 0; ///< frames accepted, no further than 2
    std::uint8_t front_ = 0;     ///< the buffer the panel shows
    std::uint8_t back_ = 0;      ///< the buffer being drawn

    Token token_;
    std::uint32_t token_time_ = 0; ///< microseconds the running transfer should take
    bool opened_ = false;          ///< the books hold what was drawn
    bool ready_ = false;           ///< the last init() succeeded
    bool in_flight_ = false;
    bool late_ = false;    ///< the running transfer missed its deadline; its buffer may have changed since
    bool suspect_ = false; ///< what the panel holds inside `damage` is unknown
};

} // namespace spangle::hal
