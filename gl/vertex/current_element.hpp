// Sets the current attributes from an array element (GL 1.3, 2.8).
#pragma once

#include <cstddef>

#include "gl/context/context.hpp"
#include "gl/vertex/array_element.hpp"
#include "gl/vertex/color_tracking.hpp"

namespace spangle::gl {

inline void set_texture(CurrentState& current, const ElementReader& reader, std::uint32_t index) {
    if (!reader.textured)
        return;
    for (int u = 0; u < texture_units; ++u) {
        if (!reader.tex_coord[u].on())
            continue;
        Real(&v)[4] = current.tex_coord[u].v;
        // Coordinates that the array does not have get their initial values (GL 1.3, 2.7).
        v[1] = v[2] = numeric::zero;
        v[3] = numeric::one;
        reader.tex_coord[u].read(index, v);
    }
}

inline void set_color_and_texture(Context& context, const ElementReader& reader, std::uint32_t index) {
    CurrentState& current = context.current;
    if (reader.color.on()) {
        current.color[3] = numeric::one; // an array of three components gives alpha the value 1
        reader.color.read(index, current.color);
        follow_color(context);
    }
    set_texture(current, reader, index);
}

/// Saves the current attributes and restores them when a draw of arrays ends. GL leaves the attributes of
/// enabled arrays undefined (GL 1.3, 2.8), but drivers keep all of them, and programs rely on that. Materials
/// that track the current colour are restored, too.
class CurrentStateGuard {
  public:
    explicit CurrentStateGuard(Context& context) : context_(context) {
        __builtin_memcpy(kept_, &context.current, sizeof kept_);
    }
    ~CurrentStateGuard() {
        __builtin_memcpy(static_cast<void*>(&context_.current), kept_, sizeof kept_);
        follow_color(context_);
    }
    CurrentStateGuard(const CurrentStateGuard&) = delete;
    CurrentStateGuard& operator=(const CurrentStateGuard&) = delete;

  private:
    Context& context_;
    /// Attributes of vertices, without the raster position.
    alignas(Real) unsigned char kept_[offsetof(CurrentState, raster)];
};

/// Sets the current attributes from element `index` of the arrays in ElementReader::seldom.
void set_seldom(CurrentState& current, const ArraysState& arrays, std::uint32_t index);

inline void set_attributes(Context& context, const ElementReader& reader, std::uint32_t index) {
    if (reader.seldom != nullptr)
        set_seldom(context.current, *reader.seldom, index);
    if (reader.normal.on())
        reader.normal.read(index, context.current.normal);
    set_color_and_texture(context, reader, index);
}

} // namespace spangle::gl
