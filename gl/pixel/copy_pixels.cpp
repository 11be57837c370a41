// CopyPixels (GL 1.3, 4.3.3). The result is as if the whole source were read before the first fragment is
// drawn.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_DRAW_PIXELS

#include <cstring>

#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/context.hpp"
#include "gl/pixel/fetch.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/pixel/rectangle.hpp"
#include "gl/pixel/targets.hpp"

namespace spangle::gl {

namespace {

/// A rectangle of the framebuffer: group (n, m) is pixel (x + n, y + m). GL leaves pixels outside of the
/// framebuffer undefined; here they yield no groups.
struct BufferGroups : GroupSource {
    /// `columns` and `rows` are the part of the rectangle that lies in the framebuffer.
    BufferGroups(const Context& context, Content of, GLint left, GLint bottom, const Interval& columns,
                 const Interval& rows)
        : GroupSource(group_of, of, {columns.begin - left, columns.end - left},
                      {rows.begin - bottom, rows.end - bottom}),
          surface(read_surface(context)), x(left), y(bottom), transfer(context.pixel_mode) {
#if SPANGLE_ROW_CODES
        form = GroupForm(surface.format);
        if (keeps_colors(surface, transfer, of))
            groups = groups_of;
#endif
    }

    std::int32_t column(std::int32_t of) const {
        return x + of;
    }
    std::int32_t row(std::int32_t of) const {
        return y + of;
    }

    static PixelGroup group_of(const GroupSource& source, std::int32_t n, std::int32_t m) {
        const auto& s = static_cast<const BufferGroups&>(source);
        return fetch(s.surface, s.transfer, s.content, s.column(n), s.row(m));
    }

    raster::Surface surface;
    GLint x, y;
    Transfer transfer;

#if SPANGLE_ROW_CODES
    static const std::uint8_t* groups_of(const GroupSource& source, std::int32_t n, std::int32_t m,
                                         std::int32_t count) {
        const auto& s = static_cast<const BufferGroups&>(source);
        return s.surface_row.at(s.surface, s.column(n), s.row(m), count);
    }

    mutable SurfaceRow surface_row;
#endif
};

/// Row y of the plane that `content` is read from.
std::uint8_t* row_of(const raster::Surface& surface, Content content, std::int32_t y) {
    return content <= Content::index ? surface.color_row(y) : surface.depth_row(y);
}

/// Copies whole rows of bytes to the arena, because in narrow formats a byte holds pixels of several columns
/// or rows.
void* set_aside_narrow(Context& context, BufferGroups& source) {
    raster::Surface& surface = source.surface;
    const std::int32_t rows = raster::drawn_info(surface.format).rows,
                       bytes = row_bytes(surface.format, surface.width),
                       first = source.row(source.m.begin) / rows, last = source.row(source.m.end - 1) / rows;
    auto* const memory = static_cast<std::uint8_t*>(context.arena->allocate(
        static_cast<std::size_t>(bytes) * static_cast<std::size_t>(last - first + 1)));
    if (memory == nullptr)
        return nullptr;
    ReadRows from(context);
    for (std::int32_t row = first; row <= last; ++row)
        if (const raster::Surface* const there = from.with_row(row * rows); there != nullptr)
            std::memcpy(memory + std::ptrdiff_t{row - first} * bytes, there->color_row(row * rows),
                        static_cast<std::size_t>(bytes));
    surface.color = memory - std::ptrdiff_t{first} * bytes;
    surface.color_stride = bytes;
    return memory;
}

/// Copies the source to the arena, so that drawing cannot change it. Returns the copy, which the caller
/// frees, or null if the arena is full.
void* set_aside(Context& context, BufferGroups& source) {
    const Content content = source.content;
    if (content == Content::color && is_narrow(source.surface.format))
        return set_aside_narrow(context, source);
    const std::int32_t pixel = content <= Content::index
                                   ? raster::drawn_info(source.surface.format).bytes_per_pixel
                               : source.surface.depth_format == DepthFormat::z16 ? 2
                                                                                 : 4;
    const std::int32_t bytes = (source.n.end - source.n.begin) * pixel,
                       height = source.m.end - source.m.begin;
    auto* const memory =
        static_cast<std::uint8_t*>(context.arena->allocate(static_cast<std::size_t>(bytes * height)));
    if (memory == nullptr)
        return nullptr;
    ReadRows from(context);
    for (std::int32_t i = 0; i < height; ++i) {
        const std::int32_t row = source.row(source.m.begin + i);
        if (const raster::Surface* const there = from.with_row(row); there != nullptr)
            std::memcpy(memory + i * bytes,
                        row_of(*there, content, row) + std::ptrdiff_t{source.column(source.n.begin)} * pixel,
                        static_cast<std::size_t>(bytes));
    }
    (content <= Content::index ? source.surface.color : source.surface.depth) = memory;
    (content <= Content::index ? source.surface.color_stride : source.surface.depth_stride) = bytes;
    source.x = -source.n.begin;
    source.y = -source.m.begin;
    return memory;
}

bool intervals_overlap(std::int32_t a, std::int32_t a_end, std::int32_t b, std::int32_t b_end) {
    return a < b_end && b < a_end;
}

/// Whether the copy may draw a pixel of the source before it reads that pixel.
bool source_overlaps_target(const Context& context, const BufferGroups& source) {
    const Content content = source.content;
    if (content == Content::color && has_sample_buffer(context))
        return false; // CopyPixels reads resolved colours, and draws to samples
    if (row_of(context.drawable.surface, content, 0) != row_of(source.surface, content, 0))
        return false;
    const Real* const at = context.current.raster.position;
    const Real* const zoom = context.pixel_mode.zoom;
    const Rect area = drawing_rect(context);
    const ZoomAxis::Range columns =
        ZoomAxis(at[0], zoom[0]).covered_fragments(source.n.begin, source.n.end, area.x, area.x + area.w);
    const ZoomAxis::Range rows =
        ZoomAxis(at[1], zoom[1]).covered_fragments(source.m.begin, source.m.end, area.y, area.y + area.h);
    return intervals_overlap(columns.begin, columns.end, source.column(source.n.begin),
                             source.column(source.n.end)) &&
           intervals_overlap(rows.begin, rows.end, source.row(source.m.begin), source.row(source.m.end));
}

/// Returns the order in which an unzoomed copy reads each pixel before it overwrites that pixel. memmove uses
/// the same rule.
RectangleOrder order_of(const Context& context, const BufferGroups& source) {
    const Real* const at = context.current.raster.position;
    return {numeric::from_i32(source.x) < at[0], numeric::from_i32(source.y) < at[1]};
}

bool is_color_565(const Context& context, const BufferGroups& source) {
    return raster::drawn_info(context.drawable.read.format).bytes_per_pixel == 2 &&
           !source.transfer.changes_colors();
}

void copy(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, Content content) {
    const Rect all = context.drawable.read.area();
    const Interval columns = clip_interval(x, width, 0, all.w),
                   rows = clip_interval(y, height, all.y, all.y + all.h);
    if (columns.begin == columns.end || rows.begin == rows.end)
        return;
    BufferGroups source(context, content, x, y, columns, rows);
    const Real* const zoom = context.pixel_mode.zoom;
    // No order is safe in a multisample buffer, because depth and stencil are read from one sample and drawn
    // to all samples.
    const bool moves = zoom[0] == numeric::one && zoom[1] == numeric::one && !has_sample_buffer(context);
    const RectangleOrder order = moves ? order_of(context, source) : RectangleOrder{};
    const bool exact = is_color_565(context, source);
    void* aside = nullptr;
    // A recorded draw needs a copy of the source, because it is replayed later, when the source may have
    // changed.
    if (context.drawable.recording != nullptr || (!moves && source_overlaps_target(context, source))) {
        aside = set_aside(context, source);
        if (aside == nullptr)
            return error(context, GL_OUT_OF_MEMORY,
                         SPANGLE_TEXT("no room in the arena to zoom what overlaps its copy"));
    }
    draw_rectangle(context, source, exact ? raster::Colors::of_pixels_565 : raster::Colors::of_pixels, order);
    context.arena->free(aside);
}

} // namespace

void cmd::CopyPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type) {
    if (type != GL_COLOR && type != GL_DEPTH && type != GL_STENCIL)
        return error(context, GL_INVALID_ENUM);
    if (width < 0 || height < 0)
        return error(context, GL_INVALID_VALUE);
    const DepthFormat from = context.drawable.read.depth_format, to = context.drawable.surface.depth_format;
    if ((type == GL_DEPTH && from == DepthFormat::none) ||
        (type == GL_STENCIL && (from != DepthFormat::z24s8 || to != DepthFormat::z24s8)))
        return error(context, GL_INVALID_OPERATION, SPANGLE_TEXT("the surface has no such buffer"));
    if (!raster_position_draws(context, GL_COPY_PIXEL_TOKEN))
        return;
    static_assert(GL_STENCIL - GL_DEPTH ==
                  static_cast<int>(Content::stencil) - static_cast<int>(Content::depth));
    copy(context, x, y, width, height,
         type != GL_COLOR ? static_cast<Content>(type - GL_DEPTH + static_cast<GLenum>(Content::depth))
         : is_indexed(context.drawable) ? Content::index
                                        : Content::color);
}

} // namespace spangle::gl

#endif
