// What a stage is, and the two ways to run a list of stages: fused into one loop, or as a chain over packets.
//
// A stage is a struct with these members:
//   Stage(const Span<P>& span, std::int32_t x): its state at pixel x of the span, by multiplication, so that
//   any x can be first. Stages of depth and colours only take a PlaneRow as well.
//   bool operator()(Px<N>& p): draws one group of lanes; false: no fragment of the group is left alive.
//   void step(): goes on to the next group of N::lanes pixels.
//   std::int32_t begin(std::int32_t x): only if `runs` (one lane only). It is called at the constructor's x
//   before the first fragment, then whenever x reaches a value that some stage returned. It returns the end
//   of the run that holds x.
//   void start(span, x): the same as construction in another row of the primitive (fused lists).
//   void next_row(): goes to the same column of the next row (tiles).
//   static in, out: the fields of Px that it reads and writes (Field). `out` counts only where the stage
//   writes every lane that is alive.
//   static kill, effect, runs: it can drop fragments; it writes memory (or counts); it works in runs.
//   bool row(std::int32_t n), void step_row(): only if `rows` (fused lists). row() says whether the next n
//   fragments lie in one row of the texture; where p.row is set, step_row() steps.
//   void jump(std::int32_t pixels): only if `runs` (eight lanes). It goes forward or back within the run.
// With more than one lane a stage drops fragments by clearing lanes of p.live, and a stage with an effect
// honours p.live. With one lane p.live need not be read or written: the result of operator() says it. The
// order of the list is the order of operations of GL. A stage never writes outside pixels [begin, end).
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
    field_coord = 2, ///< coordinates of unit 0; unit 1: field_coord << 1
    field_lod = 8,   ///< level of detail of unit 0; unit 1: field_lod << 1
    field_fog = 32,
};

/// The fragments that a list works on, one per lane. A Px is only ever a local: a fused span keeps its fields
/// in registers, and a chain loads and stores those that a stage uses.
template <class N> struct Px {
    typename N::L::Place color_plane, depth_plane; ///< addresses of the pixel from which `i` counts
    std::int32_t i;                                ///< first pixel of the group
    std::int32_t twice;                            ///< 2 i, where addressing does not scale an index
    typename N::L::Mask live;
    typename N::L::Mask open; ///< lanes, possibly dead, whose colour a guess did not decide (stage_guess.hpp)
    bool row = false;         ///< what Seq::row() said; a constant of the loop
    /// Stages of one lane, too, write back what was stored where a fragment is not alive. A constant of the
    /// loop, all of whose stages can do so.
    bool selects = false;
    std::uint32_t place;      ///< the pixel of a fragment of a path (PathPixels)
    const inner::Half* cells; ///< the dithered words of the path's colour (DitherCells)
    typename N::Color color;
    typename N::Coord coord[max_texture_units];
    std::int32_t lod[max_texture_units][N::lanes]; ///< lambda, s23.8
    typename N::Fog fog;                           ///< fog coordinate (draw_state.hpp)
    Inverse inverse;                               ///< 1/w that Divide found, for the stages fused behind it
    /// The fog factor that FogLightLanes found, for the stages fused behind it.
    typename N::L::U16 fog_factor;

    Px() = default;
    SPANGLE_INLINE void go_to(std::int32_t first) {
        i = first;
        if constexpr (!numeric::scales_indices)
            twice = 2 * first;
    }
    /// The offset in bytes from pixel 0 to pixel i, in a plane of `Bytes` bytes per pixel.
    template <int Bytes = 2> SPANGLE_INLINE std::int32_t bytes() const {
        return numeric::scales_indices || Bytes % 2 != 0 ? Bytes * i : Bytes / 2 * twice;
    }
    /// Begins at the planes of a span, or of what stands for one row of it. The strides lead from row to row.
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
    static constexpr bool anywhere = false; ///< the place of a fragment makes no difference to the stage
    SPANGLE_INLINE void step() {}
    template <class S> SPANGLE_INLINE void start(const S&, std::int32_t) {}
    SPANGLE_INLINE void next_row() {}
};

/// An affine plane along rows, one value per lane.
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
    /// `first` holds the value of the first lane, in all lanes.
    SPANGLE_INLINE void start(const typename L::U32& first) { at = first + lane_offsets_; }
    SPANGLE_INLINE void step() { at += step_; }
    /// Steps as step() does, in lists whose planes alone are more words than Thumb's first eight registers.
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

/// Several stages one after the other are a stage again. The types `S` are distinct (a second texture unit
/// has another template argument).
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
    /// Runs every stage, alive or not: worth it where a branch would be taken at random.
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
    /// Moves forward or back by some pixels, to pixel x of the span; the run stays the same.
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
