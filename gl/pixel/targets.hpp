// The targets of drawing: the surface, or each sample of its multisample buffer (GL 1.3, 3.2.1).
#pragma once

#include "gl/context/context.hpp"
#include "raster/primitive/sample_shift.hpp"
#include "raster/surface/samples.hpp"

namespace spangle::gl {

inline bool has_sample_buffer(const Context& context) {
    return raster::has_samples && context.drawable.surface.samples != nullptr;
}

/// Whether each sample gets the fragments at its own position. If not, all samples get the fragments at the
/// pixel centre.
inline bool multisampling(const Context& context) {
    return has_sample_buffer(context) && context.fragment_ops.multisample;
}

/// Calls draw(surface, shift) for each target. Geometry must be moved by `shift`, in 1/256 pixel, so that the
/// sample lies at the pixel centre.
template <class Draw> void each_target(Context& context, Draw draw) {
    const bool moves = multisampling(context);
    raster::each_sample(context.drawable.surface, [&](const raster::Surface& target, unsigned sample) {
        context.fragments.primitive.sample = static_cast<std::uint8_t>(sample);
        draw(target, moves ? raster::to_center(sample) : raster::Position{});
    });
}

/// Calls draw() for each target of a primitive. A record stores a primitive once, and moves it to the
/// position of each sample when it is replayed.
template <class Draw> void each_primitive_target(Context& context, Draw draw) {
    if (context.drawable.recording == nullptr)
        return each_target(context, draw);
    raster::PrimitiveState& primitive = context.fragments.primitive;
    primitive.sample = raster::every_sample;
    primitive.moved = multisampling(context);
    draw(context.drawable.surface, raster::Position{});
}

/// A copy of a rasterizer's vertex, moved by `by`.
template <class Window> Window shifted(const Window& window, raster::Position by) {
    Window moved = window;
    raster::shift(moved, by);
    return moved;
}

/// Returns the read surface, after its samples are resolved. If drawing is recorded, no row of the surface is
/// in memory yet.
inline const raster::Surface& read_surface(const Context& context) {
    if (context.drawable.recording == nullptr)
        raster::resolve(context.drawable.read);
    return context.drawable.read;
}

} // namespace spangle::gl
