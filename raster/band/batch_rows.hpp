// Bands of a frame that a callback draws once for each band. A band leaves out the batches of primitives that
// do not reach its rows, before their vertices are loaded.
#pragma once

#include <cstdint>

#include "raster/primitive/keep.hpp"

namespace spangle::raster {

/// Notes the rows that each batch reaches while the first band of a frame is drawn. The callback draws the
/// same batches in the same order for every band, so later bands know a batch by its number. A long batch
/// consists of pieces. They are numbered after the batch, and each is left out or drawn separately.
///
/// The table has a fixed size, with two bytes per entry. Where a frame has more batches and pieces than the
/// table has entries, neighbours share an entry. Each time the table is full, twice as many neighbours share
/// one.
class BatchRows : public Recorder {
  public:
    /// `height` is the number of rows of the picture.
    explicit BatchRows(std::int32_t height);

    /// Begins the first band of a frame, in which everything is drawn and noted.
    void begin_frame();
    /// Begins another band. Batches outside of rows [first, end) of the picture are left out. Rows count from
    /// the lowest row.
    void begin_band(std::int32_t first, std::int32_t end);
    /// Says that the callback has read from a band, so that its drawing may differ from band to band. Every
    /// band of this frame is then drawn whole.
    void invalidate() { is_valid_ = false; }

    bool is_recording() const { return is_recording_; }
    /// Notes primitives of this state from now on, besides drawing them.
    void take(DrawState& live);

    /// Returns false where the batch that begins here is left out.
    bool begin_batch();
    /// True from a begin_batch() that returned false until end_batch().
    bool is_skipped() const { return is_skipped_; }
    /// Skips the numbers of all pieces of a batch that is left out.
    void skip_pieces(std::uint32_t pieces) { next_number_ += pieces; }
    /// Returns false where the next piece of this batch is left out. After true, end_piece() must follow.
    bool begin_piece();
    void end_piece();
    /// Ends the current batch, whether it was left out or not.
    void end_batch();

  private:
    /// A range of rows in units of 1 << shift_, including the lowest and the highest. low > high is an empty
    /// range.
    struct RowRange {
        std::uint8_t low, high;
    };
    static constexpr std::uint32_t entries = 128;
    static constexpr RowRange none = {255, 0};

    static void note(Recorder& self, const DrawState& state, const Primitive& primitive);
    static void widen(RowRange& entry, RowRange by);
    /// Adds the rows of the latest piece to those of its batch.
    void merge_piece();
    RowRange& at(std::uint32_t number);
    bool reaches_band(std::uint32_t number);

    std::int32_t height_;
    std::uint8_t shift_ = 0;
    bool is_recording_ = false, is_valid_ = false, is_skipped_ = false;
    std::uint8_t log2_sharing_ = 0; ///< each entry holds the rows of 1 << log2_sharing_ batches or pieces
    RowRange band_ = none;          ///< rows of the current band
    RowRange batch_ = none;         ///< rows noted so far for the current batch
    RowRange piece_ = none;         ///< rows noted so far for the current piece
    std::uint32_t next_number_ = 0; ///< number of the next batch or piece
    std::uint32_t batch_number_ = 0;
    std::uint32_t recorded_count_ = 0; ///< how many batches and pieces the first band had
    RowRange table_[entries];
};

} // namespace spangle::raster
