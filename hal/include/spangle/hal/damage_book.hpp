// What changed: the rows that were drawn, what each buffer holds, and what the panel's memory lacks.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/panel_config.hpp>
#include <spangle/hal/panel_memory.hpp>
#include <spangle/hal/row_hash.hpp>

namespace spangle::hal {

/// Keeps what was drawn, and works out the [damage](docs/glossary.md#damage) that a present must send.
///
/// Contract:
/// - damage() is what the panel's memory may lack, a span of columns a row. It is never too little: pixels
///   outside of it are the same on the panel and in the buffer that is sent.
/// - Nothing is forgotten before it arrived. doubt() says that what is in damage() may not have arrived, and
///   trust() that it did; in between, collect() adds to it.
/// - If a frame is put off, what it drew is held back, and restored by the next collect(), unless a full
///   clear replaced it.
/// - Where cells are hashed, reduce() takes out of the damage what was drawn again unchanged.
/// - It reads pixels where hashes, colours or a turned picture ask for it, and sends none.
class DamageBook {
  public:
    /// `layout` must outlive the book, and so must what `memory` points to.
    DamageBook(const PanelLayout& layout, const PanelMemory& memory) : layout_(layout), memory_(memory) {}

    /// Begins with a panel of which nothing is known. What was drawn stays.
    void open();
    /// Begins with buffers of `height` rows in which nothing was drawn.
    void open_buffers(std::int32_t height);
    /// Records that nothing is known of a buffer.
    void open_content(std::uint8_t buffer);

    /// The memory that the constructor was given.
    const PanelMemory& memory() const { return memory_; }
    /// Where the rasterizer notes what it draws.
    RowExtents& extents() { return extents_; }
    /// Begins a buffer of `rows` rows that is all clear.
    void begin_band(std::int32_t rows);
    /// Says that nothing was drawn yet.
    void forget_drawn();
    /// Whether anything was drawn since forget_drawn() or hold_back().
    bool drawn_since() const;

    /// Sets aside what the frame that is put off has drawn, so that drawn_since() tells whether more is
    /// drawn.
    void hold_back();
    /// Whether a frame was put off and is still to be sent.
    bool owed() const { return owed_; }

    /// Collects what differs between the panel, which shows the buffer `shown`, and the buffer `drawn`.
    void collect(std::uint8_t shown, std::uint8_t drawn);
    /// Adds the pixels of a buffer whose colours changed. False: no colour changed.
    bool collect_recolored(const std::uint8_t* pixels);
    /// Copies what differs into the buffer `to`, in the order of the scan.
    void turn(const std::uint8_t* from, std::uint8_t* to);
    /// Hashes the buffer that is sent, and takes cells out that are the same. `all`: colours changed, so all
    /// cells did.
    void reduce(const std::uint8_t* sent, bool all);
    /// Widens the damage of `rows` rows, so that pixels that share bytes share the damage.
    void widen(Extent shared, std::int32_t rows);

    /// The damage that collect() has found, by rows of the picture.
    RowSpan* damage() const { return memory_.damage; }
    /// The damage of the buffer that is sent, by its rows.
    RowSpan* sent_damage() const { return layout_.turns() ? memory_.turned : memory_.damage; }
    /// The [row hash](docs/glossary.md#row-hash), which is not enabled where it has no memory.
    const RowHash& hash() const { return hash_; }

    /// Says that the panel may lack damage(), because its transfer may have failed.
    void doubt() { suspect_ = true; }
    /// Says that the panel holds damage() now.
    void trust() { suspect_ = false; }
    /// Says that the frame was handed over; `in_place`: the other buffer lacks it.
    void accept(bool in_place);

  private:
    void restore();

    const PanelLayout& layout_;
    const PanelMemory memory_;
    RowHash hash_;
    std::uint32_t clear_value_[2] = {}; ///< value of each buffer's pixels outside of its content
    RowExtents extents_;
    std::uint32_t held_clear_value_ = 0;
    bool held_cleared_ = false;
    bool suspect_ = false; ///< true: what the panel holds inside `damage` is unknown
    bool behind_ = false;  ///< true: the other buffer, or the panel, lacks what `damage` holds
    bool owed_ = false;    ///< true: a frame was put off, and `held` has the columns that it touched
};

} // namespace spangle::hal
