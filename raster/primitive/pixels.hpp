// Draws fragments whose positions the caller finds, as pixel rectangles and bitmaps do (GL 1.3, 3.6.4, 3.7).
#pragma once

#include "raster/primitive/draw.hpp"
#include "raster/primitive/keep.hpp"
#include "raster/primitive/pen.hpp"

namespace spangle::raster {

template <class P> class PixelPen : public PixelSink {
  public:
    PixelPen(const DrawState& state, const Surface& target, const typename P::Vertex& at)
        : PixelSink{run, depth}, pen_(state, target), fragment_(at) {
        Setup<P>(pen_.span, fragment_);
        pen_.begin();
    }
    ~PixelPen() { pen_.flush(); }
    PixelPen(const PixelPen&) = delete;
    PixelPen& operator=(const PixelPen&) = delete;

  private:
    static PixelPen& self(PixelSink& sink) { return static_cast<PixelPen&>(sink); }

    static void run(PixelSink& sink, std::int32_t y, std::int32_t begin, std::int32_t end,
                    const void* pixels) {
        Pen<P>& pen = self(sink).pen_;
        if (y < pen.row_begin() || y >= pen.row_end() || begin >= end || !pen.reaches_scissor(begin, end))
            return;
        pen.span.pixels = pixels;
        pen.add(y, begin, end);
        if (pixels != nullptr) // draws now, because the next run has other pixels
            pen.flush();
    }
    static void depth(PixelSink& sink, std::uint32_t z) {
        PixelPen& own = self(sink);
        own.pen_.flush();
        set_depth(own.fragment_, z);
        Setup<P>(own.pen_.span, own.fragment_);
    }

    Pen<P> pen_;
    typename P::Vertex fragment_;
};

template <class P>
void draw_pixels_of(const DrawState& state, const Surface& target, const typename P::Vertex& at,
                    PixelSource& source) {
    observe_other(state);
    if (state.nothing && !keep_pixels(state, at, source))
        return;
    PixelPen<P> pen(state, target, at);
    source.emit(source, pen);
}

} // namespace spangle::raster
