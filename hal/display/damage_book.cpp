#include <spangle/hal/damage_book.hpp>

#include "hal/display/row_spans.hpp"

namespace spangle::hal {

void DamageBook::open() {
    if (layout_.config.row_hash)
        hash_ = RowHash(memory_.hash, layout_.placement().size.width, layout_.placement().size.height,
                        format_info(layout_.config.format).bits);
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.damage[y] = {0, layout_.picture.width};
    suspect_ = true;
}

void DamageBook::open_buffers(std::int32_t height) {
    extents_ = {memory_.touched, height, false, 0};
    forget_drawn();
}

void DamageBook::open_content(std::uint8_t buffer) {
    for (std::int32_t y = 0; y < layout_.picture.height; ++y)
        memory_.content[buffer][y] = {0, layout_.picture.width};
}

// --- What is drawn ---

void DamageBook::begin_band(std::int32_t rows) {
    extents_ = {memory_.touched, rows, true, 0};
    for (std::int32_t y = 0; y < rows; ++y)
        memory_.touched[y] = RowSpan{};
}

void DamageBook::forget_drawn() {
    extents_.cleared = false;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.touched[y] = RowSpan{};
}

bool DamageBook::drawn_since() const {
    bool drawn = extents_.cleared;
    for (std::int32_t y = 0; y < extents_.height && !drawn; ++y)
        drawn = memory_.touched[y].begin < memory_.touched[y].end;
    return drawn;
}

void DamageBook::hold_back() {
    if (memory_.held == nullptr)
        return;
    restore();
    held_cleared_ = extents_.cleared;
    held_clear_value_ = extents_.clear_value;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.held[y] = memory_.touched[y];
    forget_drawn();
    owed_ = true;
}

void DamageBook::restore() {
    if (!owed_)
        return;
    owed_ = false;
    if (extents_.cleared)
        return; // a full clear has covered the frame that was put off
    extents_.cleared = held_cleared_;
    extents_.clear_value = held_clear_value_;
    for (std::int32_t y = 0; y < extents_.height; ++y)
        memory_.touched[y] = unite(memory_.touched[y], memory_.held[y]);
}

// --- What differs ---

/// The damage of a row is:
///  - what was drawn now;
///  - after a full clear, what the shown frame held outside its clear value, or everything when that value
///  changed;
///  - with two buffers and no full clear, what the last present changed, since this buffer is one frame
///    older;
///  - what a failed transfer leaves unknown;
///  - what was sent in place, which the other buffer does not have.
void DamageBook::collect(std::uint8_t shown, std::uint8_t drawn) {
    restore();
    const RowSpan* const shown_rows = memory_.content[shown];
    RowSpan* const drawn_rows = memory_.content[drawn];
    const bool cleared = extents_.cleared;
    const bool everything = cleared && extents_.clear_value != clear_value_[shown];
    const bool keep = suspect_ || behind_ || (!cleared && layout_.canvases() == 2);
    const std::int16_t width = layout_.picture.width;
    const RowSpan all = {0, width};
    for (std::int32_t y = 0; y < layout_.picture.height; ++y) {
        const RowSpan now = clip(memory_.touched[y], width);
        RowSpan damage = keep ? unite(memory_.damage[y], now) : now;
        if (everything)
            damage = all;
        if (cleared)
            damage = unite(damage, shown_rows[y]);
        memory_.damage[y] = damage;
        drawn_rows[y] = cleared ? now : unite(drawn_rows[y], now);
    }
    if (cleared)
        clear_value_[drawn] = extents_.clear_value;
}

/// Adds to the damage of each row the columns from the first to the last pixel whose colour changed.
bool DamageBook::collect_recolored(const std::uint8_t* pixels) {
    Palette& palette = *memory_.palette;
    if (!palette.any_stale())
        return false;
    const std::uint8_t* row = pixels;
    for (std::int32_t y = 0; y < layout_.picture.height; ++y, row += layout_.stride()) {
        std::int32_t begin = 0, end = layout_.picture.width;
        while (begin < end && !palette.is_stale(row[begin]))
            ++begin;
        while (begin < end && !palette.is_stale(row[end - 1]))
            --end;
        if (begin < end)
            memory_.damage[y] =
                unite(memory_.damage[y], {static_cast<std::int16_t>(begin), static_cast<std::int16_t>(end)});
    }
    palette.all_fresh();
    return true;
}

void DamageBook::turn(const std::uint8_t* from, std::uint8_t* to) {
    memory_.turner(layout_.scan,
                   {from, static_cast<std::int32_t>(layout_.stride()), layout_.picture.height, to,
                    static_cast<std::int32_t>(layout_.sent_stride()),
                    format_info(layout_.config.format).bytes_per_pixel},
                   memory_.damage, memory_.turned);
}

/// Takes unchanged cells out of the damage. A buffer that is two sends behind lacks more than the reduced
/// damage, so all of its cells count as changed.
void DamageBook::reduce(const std::uint8_t* sent, bool all) {
    memory_.hash.code->reduce(hash_, sent_damage(), sent, static_cast<std::int32_t>(layout_.sent_stride()),
                              suspect_ || behind_ || all);
}

void DamageBook::widen(Extent shared, std::int32_t rows) {
    if (shared.width == 1 && shared.height == 1)
        return;
    RowSpan* const damage = sent_damage();
    for (std::int32_t y = 0; y < rows; y += shared.height) {
        RowSpan all;
        for (std::int32_t i = 0; i < shared.height; ++i)
            all = unite(all, damage[y + i]);
        if (all.begin < all.end)
            all = {static_cast<std::int16_t>(all.begin / shared.width * shared.width),
                   static_cast<std::int16_t>((all.end + shared.width - 1) / shared.width * shared.width)};
        for (std::int32_t i = 0; i < shared.height; ++i)
            damage[y + i] = all;
    }
}

void DamageBook::accept(bool in_place) {
    behind_ = in_place && layout_.canvases() == 2;
    forget_drawn();
}

} // namespace spangle::hal
