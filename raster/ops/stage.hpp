// What a stage is, and the two ways to run a list of stages: fused into one loop, or as a chain over packets.
//
// A stage is a struct with these members:
// - Stage(const Span<P>& span, std::int32_t x) makes the state at pixel x of the span. It multiplies, so any
//   x can be first. A stage of depth and colours alone also takes a PlaneRow.
// - bool operator()(Px<N>& p) draws one group of lanes. It returns false where no fragment of the group is
//   left alive.
// - void step() goes on to the next group of N::lanes pixels.
// - std::int32_t begin(std::int32_t x) begins the run that holds x and returns the end of the run. Only a
//   stage of one lane with `runs` has it. It is called at the constructor's x before the first fragment. It
//   is called again whenever x reaches a value that some stage has returned.
// - void start(span, x) has the effect of construction in another row of the primitive (fused lists).
// - void next_row() goes to the same column of the next row (tiles).
// - static in, out are the fields of Px that the stage reads and writes (Field). `out` counts only where the
//   stage writes every lane that is alive.
// - static kill: the stage can drop fragments. static effect: it writes memory or counts. static runs: it
//   works in runs.
// - bool row(std::int32_t n) says whether the next n fragments lie in one row of the texture. Only a stage of
//   a fused list with `rows` has it.
// - void step_row() takes the place of step() where p.row is set. Only a stage with `rows` has it.
// - void jump(std::int32_t pixels) moves forward or back within the run. Only a stage of eight lanes with
//   `runs` has it.
// A stage with several lanes drops a fragment by clearing its lane of p.live. Where it has an effect, it
// honours p.live. A stage with one lane need not read or write p.live: the result of operator() says the
// same. The order of the list is GL's order of operations. A stage never writes outside pixels [begin, end).
#pragma once

#include <cstdint>
#include <type_traits>

#include "raster/ops/inverse.hpp"
#include "raster/ops/number_wide.hpp"
#include "raster/span/fill.hpp"
#include "raster/span/instructions.hpp"
#include "raster/span/span.hpp"

namespace spangle::raster {
inline namespace SPANGLE_INSTRUCTIONS {

enum Field : unsigned {
    field_color = 1,
    field_coord = 2, ///< coordinates of unit 0; those of unit 1 are field_coord << 1
    field_lod = 8,   ///< level of detail of unit 0; that of unit 1 is field_lod << 1
    field_fog = 32,
};

/// The fragments that a list works on, one per lane. A Px is only ever a local variable: a fused span keeps
/// its fields in registers. A chain loads and stores only the fields that a stage uses.
template <class N> struct Px {
    typename N::L::Place color_plane, depth_plane; ///< addresses of the pixel from which `i` counts
    std::int32_t i;                                ///< first pixel of the group
    std::int32_t twice; ///< 2 i, for machines whose addressing does not scale an index
    typename N::L::Mask live;
    typename N::L::Mask open; ///< lanes that the guess leaves to a division (stage_guess.hpp)
    bool row = false;         ///< the result of Seq::row(), which is constant in the loop
    /// True where dead fragments are stored, too, as the value that is there already. Then no branch is
    /// needed. The value is a constant of the loop, and all stages of the loop must be able to do this.
    bool selects = false;
    std::uint32_t place;      ///< the pixel of a fragment of a path (PathPixels)
    const inner::Half* cells; ///< the dithered words of the path's colour (DitherCells)
    typename N::Color color;
    typename N::Coord coord[max_texture_units];
    std::int32_t lod[max_texture_units][N::lanes]; ///< level of detail, lambda, in s23.8
    typename N::Fog fog;                           ///< fog coordinate c (FogConstants, draw_state.hpp)
    Inverse inverse; ///< 1/w, which the stage Divide leaves to later stages of a fused list
    /// The fog factor that FogLightLanes found, for later stages of the same fused list.
    typename N::L::U16 fog_factor;

    Px() = default;
    SPANGLE_INLINE void go_to(std::int32_t first) {
        i = first;
        if constexpr (!numeric::scales_indices)
            twice = 2 * first;
    }
    /// The offset in bytes from pixel 0 to pixel i in a plane of `Bytes` bytes per pixel.
    template <int Bytes = 2> SPANGLE_INLINE std::int32_t bytes() const {
        return numeric::scales_indices || Bytes % 2 != 0 ? Bytes * i : Bytes / 2 * twice;
    }
    /// Begins at the planes of a span, or of an object that stands for one row of it. The strides are bytes
    /// from row to row.
    template <class S>
    SPANGLE_INLINE explicit Px(const S& span) : color_plane(span.color), depth_plane(span.depth) {}
    template <class S>
    SPANGLE_INLINE Px(const S& span, std::ptrdiff_t color_stride, std::ptrdiff_t depth_stride)
        : color_plane(N::L::place(span.color, color_stride)),
          depth_plane(N::L::place(span.depth, depth_stride)) {}
};

/// Defaults for the members of a stage.
struct StageBase {
    static constexpr unsigned in = 0, out = 0;
    static constexpr bool kill = false, effect = false, runs = false, rows = false;
    static constexpr bool anywhere = false; ///< the stage draws every fragment alike, wherever it lies
    SPANGLE_INLINE void step() {}
    template <class S> SPANGLE_INLINE void start(const S&, std::int32_t) {}
    SPANGLE_INLINE void next_row() {}
};

/// An affine plane that is stepped along a row. It holds one value per lane.
template <class L> class Ramp {
  public:
    typename L::U32 at;
    template <class S>
    SPANGLE_INLINE Ramp(const S& span, std::int32_t x, const Span<Fixed>::Affine& plane,
                        std::uint32_t more = 0)
        : lane_offsets_(L::offsets(plane.dx, plane.dy)),
          step_(L::splat32(plane.dx * static_cast<std::uint32_t>(L::count))),
          row_step_(L::splat32(plane.dy * static_cast<std::uint32_t>(L::rows))) {
        start(span, x, plane, more);
    }
    /// Starts at pixel x with the value of the plane plus `more`.
    template <class S>
    SPANGLE_INLINE void start(const S& span, std::int32_t x, const Span<Fixed>::Affine& plane,
                              std::uint32_t more = 0) {
        if constexpr (requires { span.lanes; })
            at = span.at(x, plane) + L::splat32(more); // span.at() has a value for each lane
        else
            start(L::splat32(span.at(x, plane) + more));
    }
    /// Starts with `first`, which holds the value of the first lane in all lanes.
    SPANGLE_INLINE void start(const typename L::U32& first) { at = first + lane_offsets_; }
    SPANGLE_INLINE void step() { at += step_; }
    /// Does what step() does, for lists whose planes need more words than Thumb's eight low registers. Both
    /// operands may lie in the other registers (numeric::sum_aside()).
    SPANGLE_INLINE void step_aside() {
        if constexpr (L::count == 1)
            at = numeric::sum_aside(at, step_);
        else
            step();
    }
    SPANGLE_INLINE void next_row() { at += row_step_; }

  private:
    typename L::U32 lane_offsets_, step_,
        row_step_; ///< differences between the lanes of a group, from group to group, and from row to row
};

/// Joins several stages to one stage that runs each in turn. All types `S` are distinct: stages of texture
/// units differ in their template argument Unit.
template <class N, class... S> struct Seq : S... {
    static constexpr unsigned out = (S::out | ... | 0u);
    static constexpr unsigned in = [] {
        unsigned have = 0, need = 0;
        ((need |= S::in & ~have, have |= S::out), ...);
        return need;
    }();
    static constexpr bool kill = (S::kill || ... || false);
    static constexpr bool effect = (S::effect || ... || false);
    static constexpr bool runs = (S::runs || ... || false);
    static constexpr bool rows = (S::rows || ... || false);
    using Policy = typename N::Policy;

    template <class At> SPANGLE_INLINE Seq(const At& span, std::int32_t x) : S(span, x)... {}
    SPANGLE_INLINE bool operator()(Px<N>& p) { return (static_cast<S&>(*this)(p) && ...); }
    /// Runs every stage even where no fragment is left alive. This is faster where the branch would be hard
    /// to predict.
    SPANGLE_INLINE void all(Px<N>& p) { (static_cast<void>(static_cast<S&>(*this)(p)), ...); }
    SPANGLE_INLINE void step() { (S::step(), ...); }
    SPANGLE_INLINE bool row(std::int32_t n) {
        const auto one = [&]<class T>(T& stage) {
            if constexpr (T::rows)
                return stage.row(n);
            else
                return true;
        };
        return rows && (one(static_cast<S&>(*this)) && ...);
    }
    SPANGLE_INLINE void step_row() {
        const auto one = []<class T>(T& stage) {
            if constexpr (T::rows)
                stage.step_row();
            else
                stage.step();
        };
        (one(static_cast<S&>(*this)), ...);
    }
    template <class At> SPANGLE_INLINE void start(const At& span, std::int32_t x) {
        (S::start(span, x), ...);
    }
    SPANGLE_INLINE void next_row() { (S::next_row(), ...); }
    /// Moves forward or back by `pixels`, to pixel x of the span. The new pixel must lie in the same run.
    SPANGLE_INLINE void jump(const Span<Policy>& span, std::int32_t x, std::int32_t pixels) {
        const auto one = [&]<class T>(T& stage) {
            if constexpr (T::runs)
                stage.jump(pixels);
            else
                stage.start(span, x);
        };
        (one(static_cast<S&>(*this)), ...);
    }
    /// Begins the runs that hold x and returns the nearest end of a run.
    SPANGLE_INLINE std::int32_t begin(std::int32_t x) {
        std::int32_t next = INT32_MAX;
        const auto one = [&]<class T>(T& stage) {
            if constexpr (T::runs) {
                const std::int32_t end = stage.begin(x);
                next = end < next ? end : next;
            }
        };
        (one(static_cast<S&>(*this)), ...);
        return next;
    }
};

} // namespace SPANGLE_INSTRUCTIONS
} // namespace spangle::raster
