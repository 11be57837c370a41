// A frame that a callback draws once for each band of the picture: a band leaves out the batches of
// primitives that do not reach its rows, before their vertices are loaded.
#pragma once

#include <cstdint>

#include "raster/primitive/keep.hpp"

namespace spangle::raster {

/// While the first band of a frame is drawn, the rows that each batch reaches are noted. The callback draws
/// the same batches in the same order for every band, so that later bands know a batch by its number. A long
/// batch has pieces, which are numbered behind it, and left out by themselves.
///
/// The table has a fixed size, two bytes for each of its entries. Where a frame has more batches than the
/// table has entries, neighbours share one: twice as many whenever the table is full.
class BatchRows : public Recorder {
  public:
    /// The picture has `height` rows.
    explicit BatchRows(std::int32_t height);

    /// The first band of a frame begins: everything is drawn, and noted.
    void begin_frame();
    /// Another band begins: what lies outside of rows [first, end) of the picture, counted from its lowest,
    /// is left out.
    void begin_band(std::int32_t first, std::int32_t end);
    /// What the callback draws may depend on what it has read from a band: this frame is drawn whole in each.
    void distrust() { trusted_ = false; }

    bool notes() const { return noting_; }
    /// Primitives of this state are noted from now on, and drawn.
    void take(DrawState& live);

    /// False: the batch that begins here is left out.
    bool begin_batch();
    /// Since begin_batch() returned false, until end_batch().
    bool leaves_out() const { return left_out_; }
    /// The batch that is left out has so many pieces, whose numbers are passed over.
    void leave_out(std::uint32_t pieces) { number_ += pieces; }
    /// False: the next piece of this batch is left out. Else end_piece() follows.
    bool begin_piece();
    void end_piece();
    /// Ends the batch that has begun, left out or not.
    void end_batch();

  private:
    /// Rows in units of 1 << shift_, lowest and highest; low > high: none.
    struct Entry {
        std::uint8_t low, high;
    };
    static constexpr std::uint32_t entries = 128;
    static constexpr Entry none = {255, 0};

    static void note(Recorder& self, const DrawState& state, const Primitive& primitive);
    static void widen(Entry& entry, Entry by);
    /// The rows of the latest piece are some of its batch.
    void add_piece();
    Entry& at(std::uint32_t number);
    bool meets(std::uint32_t number);

    std::int32_t height_;
    std::uint8_t shift_ = 0;
    bool noting_ = false, trusted_ = false, left_out_ = false;
    std::uint8_t sharing_ = 0; ///< an entry is that of 1 << sharing_ batches
    Entry band_ = none;        ///< the rows of this band
    Entry batch_ = none;       ///< what was noted of this batch,
    Entry piece_ = none;       ///< and of its latest piece
    std::uint32_t number_ = 0; ///< of the next batch or piece
    std::uint32_t batch_number_ = 0;
    std::uint32_t noted_ = 0; ///< how many numbers the first band had
    Entry table_[entries];
};

} // namespace spangle::raster
