#include "raster/band/batch_rows.hpp"

#include "raster/band/reach.hpp"

#if SPANGLE_FEATURE_BANDS

namespace spangle::raster {

BatchRows::BatchRows(std::int32_t height)
    : Recorder{note, [](Recorder&, const DrawState&, const FixedVertex&, PixelSource&) {}}, height_(height) {
    while ((height - 1) >> shift_ > UINT8_MAX)
        ++shift_;
}

void BatchRows::begin_frame() {
    is_recording_ = is_valid_ = true;
    log2_sharing_ = 0;
    next_number_ = 0;
    for (RowRange& entry : table_)
        entry = none;
}

void BatchRows::begin_band(std::int32_t first, std::int32_t end) {
    if (is_recording_)
        recorded_count_ = next_number_;
    is_recording_ = false;
    next_number_ = 0; // every band has the same batches
    band_ = {static_cast<std::uint8_t>(first >> shift_), static_cast<std::uint8_t>((end - 1) >> shift_)};
}

void BatchRows::take(DrawState& live) {
    live.draws_too = !live.nothing;
    live.nothing = true;
    live.recorder = this;
    live.paths = {};
}

void BatchRows::note(Recorder& self, const DrawState&, const Primitive& primitive) {
    auto& own = static_cast<BatchRows&>(self);
    const Reach rows = exact_reach(primitive);
    const std::int32_t low = rows.low < 0 ? 0 : rows.low,
                       high = (rows.high < own.height_ ? rows.high : own.height_) - 1;
    if (low <= high)
        widen(own.piece_,
              {static_cast<std::uint8_t>(low >> own.shift_), static_cast<std::uint8_t>(high >> own.shift_)});
}

void BatchRows::widen(RowRange& entry, RowRange by) {
    entry.low = by.low < entry.low ? by.low : entry.low;
    entry.high = by.high > entry.high ? by.high : entry.high;
}

/// The entry of a batch or piece. While rows are noted, the table makes room for every number.
BatchRows::RowRange& BatchRows::at(std::uint32_t number) {
    while (number >> log2_sharing_ >= entries) {
        for (std::uint32_t i = 0; i < entries / 2; ++i) {
            table_[i] = table_[2 * i];
            widen(table_[i], table_[2 * i + 1]);
        }
        for (std::uint32_t i = entries / 2; i < entries; ++i)
            table_[i] = none;
        ++log2_sharing_;
    }
    return table_[number >> log2_sharing_];
}

/// Whether a batch or piece reaches the current band. A number that the first band did not have is drawn,
/// too; the callback has then broken its promise.
bool BatchRows::reaches_band(std::uint32_t number) {
    if (!is_valid_ || number >= recorded_count_)
        return true;
    const RowRange& entry = table_[number >> log2_sharing_];
    return entry.low <= band_.high && entry.high >= band_.low;
}

void BatchRows::merge_piece() {
    widen(batch_, piece_);
    piece_ = none;
}

bool BatchRows::begin_batch() {
    batch_number_ = next_number_++;
    is_skipped_ = !is_recording_ && !reaches_band(batch_number_);
    batch_ = piece_ = none;
    return !is_skipped_;
}

bool BatchRows::begin_piece() {
    return is_recording_ || reaches_band(next_number_++);
}

void BatchRows::end_piece() {
    if (!is_recording_)
        return;
    widen(at(next_number_++), piece_);
    merge_piece();
}

void BatchRows::end_batch() {
    is_skipped_ = false;
    if (!is_recording_)
        return;
    merge_piece(); // merges primitives that were drawn outside of any piece
    widen(at(batch_number_), batch_);
}

} // namespace spangle::raster

#endif
