// Where spans leave a primitive: scissor, addresses, touched rows, counters, then the state's span function.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/primitive/setup.hpp"
#include "raster/surface/surface.hpp"

namespace spangle::raster {

/// A line or a point begins.
inline void observe_other([[maybe_unused]] const DrawState& state) {
#ifndef SPANGLE_FIRMWARE
    if (state.counters != nullptr && state.counters->observer != nullptr &&
        state.counters->observer->other != nullptr)
        state.counters->observer->other(*state.counters->observer);
#endif
}

template <class P> class Pen {
  public:
    Span<P> span;

    Pen(const DrawState& state, const Surface& target)
        : target_(target), clip_(state.fragment.scissor), bytes_(format_info(target.format).bytes_per_pixel),
          depth_shift_(target.depth_format == DepthFormat::z16 ? 1 : 2) {
        span.state = &state;
        span.depth = nullptr;
    }

    std::int32_t row_begin() const { return clip_.y; }
    std::int32_t row_end() const { return clip_.y + clip_.h; }
    std::int32_t column_begin() const { return clip_.x; }
    std::int32_t column_end() const { return clip_.x + clip_.w; }
    bool sees(std::int32_t left, std::int32_t right) const {
        return left < clip_.x + clip_.w && right > clip_.x;
    }
    /// All columns of a primitive: those drawn later lie among them.
    bool sees_extent(std::int32_t left, std::int32_t right) {
        clips_ = left < clip_.x || right > clip_.x + clip_.w;
        return !clips_ || sees(left, right);
    }

    /// Once per primitive that reaches a pixel, after its set-up.
    void begin() {
        run_ = reinterpret_cast<Run>(span.state->variant[static_cast<unsigned>(span.kind)].run);
        if (span.state->counters != nullptr)
            ++span.state->counters->triangles;
    }

    /// Columns [left, right) of row y, y inside the scissor rectangle.
    SPANGLE_INLINE void draw(Setup<P>& setup, std::int32_t y, std::int32_t left, std::int32_t right) {
        std::int32_t first = left, last = right;
        if (clips_) {
            if (!sees(left, right))
                return;
            first = left < clip_.x ? clip_.x : left;
            last = right < column_end() ? right : column_end();
        }
        setup.move_to(left, y);
        span.length = right - left;
        span.begin = first - left;
        span.end = last - left;
        span.color =
            target_.color + std::ptrdiff_t{y} * target_.color_stride + std::ptrdiff_t{first} * bytes_;
        if (target_.depth != nullptr)
            span.depth = target_.depth + std::ptrdiff_t{y} * target_.depth_stride +
                         (std::ptrdiff_t{first} << depth_shift_);
        touch(target_, y, first, last);
        if (Counters* const counters = span.state->counters; counters != nullptr) {
            counters->fragments += static_cast<std::uint32_t>(last - first);
#ifndef SPANGLE_FIRMWARE
            if (counters->observer != nullptr && counters->observer->span != nullptr)
                counters->observer->span(*counters->observer, y, first, last);
#endif
        }
        run_(span);
    }

  private:
    using Run = void (*)(const Span<P>&);
    const Surface& target_;
    Rect clip_;
    std::int32_t bytes_;
    int depth_shift_;
    bool clips_ = true; ///< some column may lie outside of the scissor rectangle
    Run run_ = nullptr;
};

} // namespace spangle::raster
