// What is drawn into: the surface, or each sample of its multisample buffer (GL 1.3, 3.2.1).
#pragma once

#include "gl/context/context.hpp"
#include "raster/primitive/sample_shift.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::gl {

inline bool has_sample_buffer(const Context& context) {
    return raster::has_samples && context.drawable.surface.samples != nullptr;
}

/// Each sample gets what lies where it is; else all of them get what the centre gets.
inline bool multisampling(const Context& context) {
    return has_sample_buffer(context) && context.fragment_ops.multisample;
}

/// Calls draw(surface, shift) for each surface that gets fragments: what is drawn moves by `shift`, in 1/256
/// pixel, so that the sample comes to lie in the centre.
template <class Draw> void each_target(Context& context, Draw draw) {
    const bool moves = multisampling(context);
    raster::each_sample(context.drawable.surface, [&](const raster::Surface& target, unsigned sample) {
        context.fragments.primitive.sample = static_cast<std::uint8_t>(sample);
        draw(target, moves ? raster::to_center(sample) : raster::Position{});
    });
}

/// The same of primitives, which a record keeps once and moves when it draws them.
template <class Draw> void each_primitive_target(Context& context, Draw draw) {
    if (context.drawable.recording == nullptr)
        return each_target(context, draw);
    raster::PrimitiveState& primitive = context.fragments.primitive;
    primitive.sample = raster::every_sample;
    primitive.moved = multisampling(context);
    draw(context.drawable.surface, raster::Position{});
}

/// A vertex of the rasterizer, moved.
template <class Window> Window shifted(const Window& window, raster::Position by) {
    Window moved = window;
    raster::shift(moved, by);
    return moved;
}

/// The surface that is read, with all that was drawn to its samples; of a recorded one nothing is there yet.
inline const raster::Surface& read_surface(const Context& context) {
    if (context.drawable.recording == nullptr)
        raster::resolve(context.drawable.read);
    return context.drawable.read;
}

} // namespace spangle::gl
