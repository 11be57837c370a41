// What travels to a panel: lists of commands, windows and pixels, one list after another.
#pragma once

#include <cstddef>
#include <cstdint>

#include <spangle/hal/bus.hpp>
#include <spangle/hal/op_list.hpp>
#include <spangle/hal/panel_config.hpp>
#include <spangle/hal/window.hpp>

namespace spangle::hal {

/// Fills a list of operations and puts it on the [wire](docs/glossary.md#wire). A list that is full goes out,
/// and is waited for, before more is appended; so a Transfer takes any length in memory of any size.
///
/// Contract:
/// - open() comes first, and nothing is on the wire then.
/// - At most one list is on the wire. Who fills the next one waits for it: complete() or run().
/// - After a list that did not end well, nothing is known of the panel's window: the next one is sent whole.
/// - A list whose deadline passes may still be on the wire: in_flight() stays true, and late() says so.
/// - Errors are those of the bus, and Fault::unsupported for a command longer than one operation.
class Transfer {
  public:
    /// Transfers to a panel that `layout` describes. Both must outlive them.
    Transfer(Bus& bus, const PanelLayout& layout) : bus_(bus), layout_(layout) {}
    /// Opens the transfer with the memory of a list. The window that the panel holds is unknown then.
    void open(const BusCaps& caps, const OpList& list);

    /// The bus.
    Bus& bus() const { return bus_; }
    /// The layout of the panel's display.
    const PanelLayout& layout() const { return layout_; }
    /// The capabilities of the bus.
    const BusCaps& caps() const { return caps_; }
    /// Says which window the panel holds, and how another one is set.
    const Windows& windows() const { return windows_; }
    /// Makes the next window go out whole, after something else has moved it.
    void forget_window() { windows_.forget(); }
    /// The list that is filled. Whoever appends to it must call make_room() before.
    OpList& list() { return ops_; }
    /// The list that is filled, which cannot be changed by this reference.
    const OpList& list() const { return ops_; }

    /// Sends what the list holds when fewer than `ops` more fit.
    Result<void> make_room(std::size_t ops);
    /// Appends the commands and delays of a program.
    Result<void> append(Program program);
    /// Opens a window that the panel can name; its pixels follow, and one more operation fits.
    Result<void> open_window(const Rect& window);
    /// Appends rows of pixels, `stride` bytes apart: whole rows while they fit one operation of the bus, else
    /// pieces of rows.
    Result<void> append_pixels(const std::uint8_t* data, std::uint32_t row_bytes, std::uint32_t rows,
                               std::uint32_t stride);
    /// The number of operations that append_pixels() makes of such rows.
    std::size_t pixel_ops(std::uint32_t row_bytes, std::uint32_t rows) const;
    /// Appends a window of black pixels, `bytes` on the wire.
    Result<void> append_black(const Rect& window, std::size_t bytes);

    /// Starts what the list holds, if anything, and empties it.
    Result<void> start();
    /// Waits for the list that was started last.
    Result<void> complete();
    /// Starts what the list holds and waits for it.
    Result<void> run();
    /// Whether a list was started and is not known to have ended.
    bool in_flight() const { return in_flight_; }
    /// Whether the list that was started last has missed its deadline. What it reads may have changed since.
    bool late() const { return late_; }
    /// Whether the wire is busy at this moment.
    bool busy() const { return in_flight_ && !bus_.done(token_); }
    /// The list that was started last.
    Token token() const { return token_; }

  private:
    std::uint32_t op_limit() const;

    Bus& bus_;
    const PanelLayout& layout_;
    BusCaps caps_;
    Windows windows_;
    OpList ops_;
    Token token_;
    std::uint32_t token_time_ = 0; ///< time in microseconds that the running transfer should take
    bool in_flight_ = false;
    bool late_ = false;
};

} // namespace spangle::hal
