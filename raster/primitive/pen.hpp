// Where spans leave a primitive: scissor, addresses, touched rows, counters, then the state's span function.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/primitive/setup.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {

template <class P> class Pen {
  public:
    Span<P> span;

    Pen(const DrawState& state, const Surface& target)
        : target_(target), clip_(state.fragment.scissor), bytes_(format_info(target.format).bytes_per_pixel),
          depth_bytes_(target.depth_format == DepthFormat::z16 ? 2 : 4) {
        span.state = &state;
    }

    std::int32_t row_begin() const { return clip_.y; }
    std::int32_t row_end() const { return clip_.y + clip_.h; }
    std::int32_t column_begin() const { return clip_.x; }
    std::int32_t column_end() const { return clip_.x + clip_.w; }
    bool sees(std::int32_t left, std::int32_t right) const {
        return left < clip_.x + clip_.w && right > clip_.x;
    }

    /// Once per primitive that reaches a pixel.
    void primitive() const {
        if (span.state->counters != nullptr)
            ++span.state->counters->triangles;
    }

    /// Columns [left, right) of row y, y inside the scissor rectangle and the columns seen.
    SPANGLE_INLINE void draw(Setup<P>& setup, std::int32_t y, std::int32_t left, std::int32_t right) {
        setup.move_to(left, y);
        const std::int32_t clip_end = clip_.x + clip_.w;
        span.length = right - left;
        span.begin = left < clip_.x ? clip_.x - left : 0;
        span.end = right < clip_end ? span.length : clip_end - left;
        const std::int32_t x = left + span.begin;
        span.color = target_.color_row(y) + static_cast<std::ptrdiff_t>(x) * bytes_;
        span.depth = target_.depth == nullptr
                         ? nullptr
                         : target_.depth_row(y) + static_cast<std::ptrdiff_t>(x) * depth_bytes_;
        touch(target_, y, x, left + span.end);
        if (Counters* const counters = span.state->counters; counters != nullptr) {
            counters->fragments += static_cast<std::uint32_t>(span.end - span.begin);
#ifndef SPANGLE_FIRMWARE
            if (counters->observer != nullptr && counters->observer->span != nullptr)
                counters->observer->span(*counters->observer, y, x, left + span.end);
#endif
        }
        const Variant& variant = span.state->variant[static_cast<unsigned>(span.kind)];
        reinterpret_cast<void (*)(const Span<P>&)>(variant.run)(span);
    }

  private:
    const Surface& target_;
    Rect clip_;
    std::int32_t bytes_, depth_bytes_;
};

} // namespace spangle::raster
