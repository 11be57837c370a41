#include "gl/pixel/row_converter.hpp"

#if SPANGLE_ROW_CODES

#include "gl/pixel/component.hpp"
#include "gl/pixel/row_elements.hpp"
#include "raster/surface/narrow.hpp"

namespace spangle::gl {

namespace {

bool has_channel(const GroupForm& form, unsigned c) {
    if (form.fields.bytes != 0)
        return form.fields.field[c].bits != 0;
    for (unsigned i = 0; i < form.layout->components; ++i) {
        const Channel channel = form.layout->channel[i];
        if (static_cast<unsigned>(channel) == c || (channel == Channel::luminance && c < 3))
            return true;
    }
    return false;
}

bool is_luminance(const GroupForm& form) {
    return form.layout != nullptr && form.layout->channel[0] == Channel::luminance;
}

/// Whether sums of red, green and blue are exact. They are if each component has eight bits.
bool has_exact_sums(const GroupFields& fields) {
    return fields.bytes != 0 && fields.field[0].bits == 8 && fields.field[1].bits == 8 &&
           fields.field[2].bits == 8;
}

/// Returns the form in which codes are written. Luminance is written from red alone.
GroupForm written(GroupForm to) {
    if (is_luminance(to))
        to.fields.field[1] = to.fields.field[2] = {};
    return to;
}

CodeBits wanted_bits(const GroupForm& from, const GroupForm& to) {
    return to.fields.bytes != 0 ? bits_of(to.fields) : own_bits(from.fields);
}

} // namespace

CodeBits bits_of(const GroupFields& fields) {
    CodeBits bits;
    for (unsigned c = 0; c < 4; ++c)
        bits.of[c] = fields.field[c].bits;
    bits.cut = fields.cut;
    return bits;
}

CodeBits own_bits(const GroupFields& fields) {
    CodeBits bits;
    for (unsigned c = 0; c < 4; ++c)
        bits.of[c] = fields.field[c].bits != 0 ? fields.field[c].bits : std::uint8_t{8};
    return bits;
}

RowReader::RowReader(const GroupForm& from, const CodeBits& to)
    : source_form_(from), bits_(to), fields_(from.fields, to) {
    for (unsigned c = 0; c < 4; ++c)
        if (to.of[c] != 0 && !has_channel(from, c))
            for (std::uint16_t& code : row_.code[c])
                code = static_cast<std::uint16_t>(c == 3 ? all_ones(to.of[c]) : 0);
}

CodeRow& RowReader::read(const std::uint8_t* from, std::int32_t count) {
    if (source_form_.fields.bytes != 0)
        fields_.read(from, count, row_);
    else
        read_elements(from, *source_form_.layout, source_form_.swap, count, bits_, row_);
    return row_;
}

RowConverter::RowConverter(const GroupForm& from, const GroupForm& to)
    : source_form_(from), target_form_(written(to)), adds_luminance_(is_luminance(to)),
      is_supported_(adds_luminance_ ? has_exact_sums(from.fields)
                                    : from.fields.bytes != 0 || to.fields.bytes != 0),
      reader_(from, wanted_bits(from, to)) {}

void RowConverter::convert(const std::uint8_t* from, std::uint8_t* to, std::int32_t count) {
    CodeRow& row = reader_.read(from, count);
    if (adds_luminance_)
        add_luminance(row);
    if (target_form_.fields.bytes != 0)
        write_fields(row, target_form_.fields, count, to);
    else
        write_elements(row, reader_.bits(), *target_form_.layout, target_form_.swap, count, to);
}

void RowConverter::convert_row(const std::uint8_t* from, std::uint8_t* to, std::int32_t count) {
    for (; count > row_chunk; count -= row_chunk) {
        convert(from, to, row_chunk);
        from += std::size_t{row_chunk} * source_form_.bytes();
        to += std::size_t{row_chunk} * target_form_.bytes();
    }
    convert(from, to, count);
}

const std::uint8_t* SurfaceRow::at(const raster::Surface& surface, std::int32_t x, std::int32_t y,
                                   std::int32_t count) {
    const std::uint8_t* const row = surface.color_row(y);
    if (const unsigned bytes = raster::drawn_info(surface.format).bytes_per_pixel; bytes != 0)
        return row + std::ptrdiff_t{x} * static_cast<std::ptrdiff_t>(bytes);
    for (std::int32_t i = 0; i < count; ++i)
        unpacked_pixels_[i] = static_cast<std::uint16_t>(raster::load_narrow(surface.format, row, x + i, y));
    return reinterpret_cast<const std::uint8_t*>(unpacked_pixels_);
}

void SurfaceConverter::convert(const raster::Surface& surface, std::int32_t x, std::int32_t y,
                               std::int32_t count, std::uint8_t* to) {
    for (std::int32_t n; count > 0;
         count -= n, x += n, to += std::size_t{bytes_} * static_cast<std::uint32_t>(n)) {
        n = count < row_chunk ? count : row_chunk;
        converter_.convert(row_.at(surface, x, y, n), to, n);
    }
}

} // namespace spangle::gl

#endif
