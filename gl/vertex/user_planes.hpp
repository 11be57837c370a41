// The enabled clip planes of the user (GL 1.3, 2.11).
#pragma once

#include "gl/context/features.hpp"
#include "gl/vertex/transform_state.hpp"

namespace spangle::gl {

#if SPANGLE_FEATURE_CLIP_PLANES

template <class M> class UserPlanes {
  public:
    void derive(const TransformState& state) {
        plane_count_ = 0;
        for (int i = 0; i < max_clip_planes; ++i)
            if (state.clip_plane_on[i])
                plane_[plane_count_++] = M::plane(state.clip_plane[i]);
    }

    bool any() const { return plane_count_ != 0; }
    int count() const { return plane_count_; }
    const typename M::Plane& operator[](int i) const { return plane_[i]; }

    /// Returns the planes that the point is outside of; bit i stands for plane i.
    unsigned outside(const typename M::Eye& eye) const {
        unsigned planes = 0;
        for (int i = 0; i < plane_count_; ++i)
            planes |= M::outside(plane_[i], M::distance(plane_[i], eye)) ? 1u << i : 0u;
        return planes;
    }

  private:
    int plane_count_ = 0;
    typename M::Plane plane_[max_clip_planes];
};

#else

/// Replaces UserPlanes in a build without user clip planes. No point is outside of a plane.
template <class M> class UserPlanes {
  public:
    void derive(const TransformState&) {}
    static constexpr bool any() { return false; }
    static constexpr int count() { return 0; }
    typename M::Plane operator[](int) const { return {}; }
    static constexpr unsigned outside(const typename M::Eye&) { return 0; }
};

#endif

} // namespace spangle::gl
