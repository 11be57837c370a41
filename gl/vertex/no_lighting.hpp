// Replaces lighting in a build without it. LIGHTING cannot be enabled in such a build, so that light() is
// never called.
#pragma once

#include "gl/context/context.hpp"

namespace spangle::gl {

template <class M> class NoLighting {
  public:
    struct Input {};

    void derive(const Context&, unsigned) {}
    void materials_changed() {}
    bool needs_eye() const { return false; }
    bool two_sided() const { return false; }
    bool tracks_color() const { return false; }
    static Input input(const Real (&)[3]) { return {}; }
    template <class Normal>
    void light(const Context&, const Normal&, const typename M::Eye&, int, typename M::Window&) {}
    static void mix(const Input&, const Input&, const typename M::Parameter&, Input&) {}
};

} // namespace spangle::gl
