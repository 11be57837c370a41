#include "host_sim/capture/frame_watch.hpp"

#include "gl/context/context.hpp"
#include "raster/surface/pixel.hpp"

namespace spangle::trade {

namespace {

DrawnPicture picture_of(const raster::Surface& s) {
    DrawnPicture out;
    out.width = s.width;
    out.height = s.height;
    out.depth_bits = s.depth_format == DepthFormat::none ? 0 : s.depth_format == DepthFormat::z16 ? 16 : 24;
    const auto pixels = static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height);
    out.rgba.reserve(4 * pixels);
    std::vector<raster::StoredColor> row(static_cast<std::size_t>(s.width));
    for (std::int32_t y = 0; y < s.height; ++y) {
        raster::read_color_row(s, 0, y, s.width, row.data());
        for (const raster::StoredColor& color : row)
            for (const raster::Component& component : color.c)
                out.rgba.push_back(component.to_8());
    }
    for (std::int32_t y = 0; out.depth_bits != 0 && y < s.height; ++y)
        for (std::int32_t x = 0; x < s.width; ++x)
            out.depth.push_back(raster::read_depth(s, x, y).k);
    coarsen(out);
    return out;
}

} // namespace

FrameWatch::FrameWatch() {
    triangle = [](Observer& self, const std::int32_t x[3], const std::int32_t y[3], const double* ex,
                  const double* ey, Rect scissor) {
        Coverage& coverage = static_cast<FrameWatch&>(self).current();
        coverage.triangle(coverage, x, y, ex, ey, scissor);
    };
    other = [](Observer& self) {
        Coverage& coverage = static_cast<FrameWatch&>(self).current();
        coverage.other(coverage);
    };
    span = [](Observer& self, std::int32_t y, std::int32_t from, std::int32_t to) {
        Coverage& coverage = static_cast<FrameWatch&>(self).current();
        coverage.span(coverage, y, from, to);
    };
}

Coverage& FrameWatch::of(const raster::Surface& surface) {
    WatchedSurface& found = surfaces_[surface.color];
    if (found.coverage == nullptr || found.width != surface.width || found.height != surface.height) {
        if (found.coverage != nullptr)
            earlier_mismatches_ += found.coverage->mismatches();
        found = {std::make_unique<Coverage>(surface.width, surface.height), surface.width, surface.height};
    }
    return *found.coverage;
}

Coverage& FrameWatch::current() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return of(gl::current_context()->drawable.surface);
}

DrawnFrame FrameWatch::take(const raster::Surface& surface) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Coverage& coverage = of(surface);
    DrawnFrame out;
    out.picture = picture_of(surface);
    out.coverage = coverage.end_frame();
    out.mask = upside_down(coverage.take_mask(), surface.width);
    return out;
}

std::uint64_t FrameWatch::mismatches() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::uint64_t out = earlier_mismatches_;
    for (const auto& [pixels, watched] : surfaces_)
        out += watched.coverage->mismatches();
    return out;
}

} // namespace spangle::trade
