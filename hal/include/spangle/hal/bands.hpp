// The [bands](docs/glossary.md#band) of a frame that is drawn in a buffer of some rows: which one is drawn,
// and what the panel shows.
#pragma once

#include <cstdint>

#include <spangle/format.hpp>
#include <spangle/hal/panel_config.hpp>

namespace spangle::hal {

/// What a frame buffer holds, or what a panel shows. Pixels outside of the spans in `rows` have the clear
/// value.
struct PanelContent {
    /// An element for each row of the picture.
    RowSpan* rows = nullptr;
    /// The pixel of the last clear, as RowExtents::clear_value has it.
    std::uint32_t clear_value = 0;
};

/// Follows a frame from band to band, and records what the panel shows of it.
///
/// Contract:
/// - A band is begun, drawn, handed over and sent: begin(), hand_over(), collect() unless bands are sent
///   whole, sent(). The first band of a frame begins with row 0.
/// - collect() writes what differs between the panel and the band to `damage`, one element a row of the band.
///   The caller then sends the band. Where that fails, the caller calls forget().
/// - Everything differs after forget(), where the clear value changed, and where nothing is recorded.
/// - A frame that ended early leaves bands with different clear values, and is forgotten by the next one.
/// - It holds no pixels and sends none.
class Bands {
  public:
    /// `layout` must outlive the Bands.
    explicit Bands(const PanelLayout& layout) : layout_(layout) {}
    /// Begins with a panel of which nothing is known. `shown` has an element for each row of the picture, and
    /// must outlive the Bands. Null: nothing is recorded.
    void open(RowSpan* shown);

    /// Whether these rows can be a band: rows of the picture, no more than a buffer holds, that end where
    /// bytes do. Fault::bad_argument: they cannot.
    Result<void> check(std::int32_t first, std::int32_t rows) const;
    /// Begins a band, of rows for which check() succeeds.
    void begin(std::int32_t first, std::int32_t rows);
    /// Whether a band was begun and not handed over.
    bool acquired() const { return acquired_; }
    /// The first row of the band.
    std::int32_t first() const { return first_; }
    /// The number of rows of the band.
    std::int32_t rows() const { return rows_; }

    /// Says that the band was drawn.
    void hand_over();
    /// Collects what differs between the panel's memory and the band, in which `drawn` was drawn.
    void collect(const RowExtents& drawn, RowSpan* damage);
    /// Says that the band was sent. True: it was the last one of the frame.
    bool sent();
    /// Forgets what the panel shows.
    void forget();

  private:
    const PanelLayout& layout_;
    PanelContent shown_;
    std::int32_t first_ = 0, rows_ = 0; ///< rows of the current band, in the picture
    std::uint32_t clear_value_ = 0;     ///< clear value of this frame's bands
    bool complete_ = true;              ///< the frame's last band was sent
    bool acquired_ = false;             ///< the current band may be drawn to
};

} // namespace spangle::hal
