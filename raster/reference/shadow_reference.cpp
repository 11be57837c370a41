#include "raster/reference/shadow.hpp"

#include "raster/reference/stage_index_reference.hpp"
#include "raster/reference/stage_reference.hpp"

#include "raster/chain/assemble.hpp"

namespace spangle::raster {

namespace {

thread_local ShadowReport* current_report = nullptr;

// Units of the fixed policy's words. Raw colours and fog factors have 24 fraction bits. A coordinate that
// repeats is a fraction of the image with 32 bits. A coordinate that is clamped is signed and has 28 fraction
// bits.
constexpr double word_24 = 0x1p-24, word_32 = 0x1p-32, word_28 = 0x1p-28;
/// A clamped coordinate counts as saturated below this distance from 8 repeats.
constexpr double saturation = 0x1p-27;
/// NEAREST adds this to the place of a coordinate, in texels, so that edges of texels fall to one side.
constexpr double nearest_bias = 0x1p-13;

/// One fragment that both policies compute.
template <class N> class Fragment {
  public:
    Fragment(const Span<Fixed>& fixed, const Span<Double>& twin, std::int32_t x, ShadowReport& report)
        : fixed_(fixed), twin_(twin), x_(x), report_(report) {
        fixed_fragment_.go_to(x - fixed.begin);
        double_fragment_.go_to(x - fixed.begin);
        fixed_fragment_.color_plane = double_fragment_.color_plane = fixed.color;
        fixed_fragment_.depth_plane = double_fragment_.depth_plane = fixed.depth;
        fixed_fragment_.live = double_fragment_.live = true;
    }

    void compare_all() {
        const DrawState& state = *fixed_.state;
        if (state.needs.z)
            depth(state);
        if constexpr (!is_raw<N>) {
            primary(state);
            units(state);
            rest(state);
        } else if (state.needs.unit[0]) {
            coord<0>(state, ShadowStage::coord0);
        } else if (fixed_.kind == Kind::affine) { // a flat colour has nothing to compare
            raw_primary();
        }
    }

  private:
    const Span<Fixed>& fixed_;
    const Span<Double>& twin_;
    std::int32_t x_;
    ShadowReport& report_;
    Px<N> fixed_fragment_;
    Px<Reference> double_fragment_;

    /// Runs a stage in both policies. Returns false where one of them has dropped the fragment.
    template <class FixedStage, class DoubleStage> bool run() {
        FixedStage fixed(fixed_, x_);
        if constexpr (FixedStage::runs)
            fixed.begin(x_);
        const bool alive = fixed(fixed_fragment_);
        DoubleStage twin(twin_, x_);
        return twin(double_fragment_) && alive;
    }
    template <template <class> class Stage> bool run() { return run<Stage<N>, Stage<Reference>>(); }

    void colors(ShadowStage stage) {
        const auto one = [&](auto fixed, double exact) {
            report_[stage].add(static_cast<double>(fixed) / static_cast<double>(N::one), exact, 1.0);
        };
        one(fixed_fragment_.color.r, double_fragment_.color.r);
        one(fixed_fragment_.color.g, double_fragment_.color.g);
        one(fixed_fragment_.color.b, double_fragment_.color.b);
        one(fixed_fragment_.color.a, double_fragment_.color.a);
    }

    void depth(const DrawState& state) {
        const int bits = state.depth_format == DepthFormat::z16 ? 16 : 24;
        const std::uint32_t word = bits == 16 ? DepthValue<Exact>(fixed_, x_).word()
                                              : DepthValueOf<Exact, DepthFormat::z24s8>(fixed_, x_).word();
        const double code = word >> (32 - bits);
        report_[ShadowStage::depth].add(code / ((1 << bits) - 1), clamp01(twin_.at(x_, twin_.z)), 1.0);
    }

    void primary(const DrawState& state) {
        if (state.pixels)
            return static_cast<void>(run<PixelColor>());
        if (!state.needs.rgb)
            return static_cast<void>(run<White<N>, White<Reference>>());
        const bool alpha = state.needs.alpha;
        // In builds that divide no colour, spans have no planes of colours over w.
        if constexpr (has_full)
            if (fixed_.kind == Kind::full) {
                alpha ? run<GouraudQ<N, true>, GouraudQ<Reference, true>>()
                      : run<GouraudQ<N, false>, GouraudQ<Reference, false>>();
                return colors(ShadowStage::primary);
            }
        alpha ? run<Gouraud<N, true>, Gouraud<Reference, true>>()
              : run<Gouraud<N, false>, Gouraud<Reference, false>>();
        colors(ShadowStage::primary);
    }

    /// Compares primary colours before they are rounded to what is stored. They are steps of 5 or 6 bits with
    /// a fraction, or 8.24 numbers to which a half was added for rounding.
    void raw_primary() {
        const Gouraud<N, false> fixed(fixed_, x_);
        run<Gouraud<N, false>, Gouraud<Reference, false>>();
        const bool steps = fixed_.state->variant[static_cast<unsigned>(Kind::affine)].steps;
        const auto one = [&](std::uint32_t v, double most, double exact) {
            const double c = steps ? v * word_24 / most : (v * word_24 - 0.5) / 255.0;
            report_[ShadowStage::primary].add(c, exact, 1.0);
        };
        one(fixed.r.at, 31 * 8, double_fragment_.color.r);
        one(fixed.g.at, 63 * 4, double_fragment_.color.g);
        one(fixed.b.at, 31 * 8, double_fragment_.color.b);
    }

    template <int Unit> void coord(const DrawState& state, ShadowStage stage) {
        // The chain chooses runs in the same way.
        const bool cubic = of_tier<has_cubic_runs>(state);
        if (fixed_.kind < Kind::textured)
            run<Coord<N, Unit, false>, Coord<Reference, Unit, false>>();
        else if (!cubic)
            run<CoordAlong<N, Unit, CoordRuns>, Coord<Reference, Unit, true>>();
        else if (std::is_same_v<N, Exact> && divides(fixed_.kind, state.needs.fog))
            run<CoordAlong<N, Unit, DividedCoords>, Coord<Reference, Unit, true>>();
        else
            run<CoordAlong<N, Unit, CubicRuns>, Coord<Reference, Unit, true>>();
        /// Compares one axis. Returns true where both coordinates lie in one texel.
        const auto axis = [&](std::uint32_t fixed, double coordinate, bool wraps, int log2_size,
                              bool halved) {
            const double exact = halved ? coordinate / 2 : coordinate;
            const double size = 1 << log2_size;
            const double repeats = wraps ? fixed * word_32 : static_cast<std::int32_t>(fixed) * word_28;
            double difference = repeats - exact;
            report_[stage].saturated += !wraps && std::fabs(repeats) > 8.0 - saturation ? 1 : 0;
            if (wraps)
                difference -= std::floor(difference + 0.5);
            report_[stage].add_difference(difference * size, exact * size);
            // The bias of NEAREST is the same in every policy.
            const double place = exact * size + nearest_bias;
            return std::floor(place) == std::floor(place + difference * size);
        };
        const bool same_s = axis(fixed_fragment_.coord[Unit].s[0], double_fragment_.coord[Unit].s[0],
                                 state.wraps[Unit].s, state.log2_width[Unit], state.halves[Unit].s != 0);
        const bool same_t = axis(fixed_fragment_.coord[Unit].t[0], double_fragment_.coord[Unit].t[0],
                                 state.wraps[Unit].t, state.log2_height[Unit], state.halves[Unit].t != 0);
        report_[stage].flips += same_s && same_t ? 0 : 1;
    }

    template <int Unit> void place(const DrawState& state, ShadowStage coord_stage, ShadowStage lod) {
        if (!state.needs.unit[Unit] || state.needs.r[Unit])
            return;
        coord<Unit>(state, coord_stage);
        if (!wants_lod(*state.fragment.unit[Unit].texture))
            return;
        run<Lod<N, Unit>, Lod<Reference, Unit>>();
        // A lambda below 0 means magnification, whose amount makes no difference.
        report_[lod].add(std::fmax(fixed_fragment_.lod[Unit][0] / 256.0, 0),
                         std::fmax(double_fragment_.lod[Unit][0] / 256.0, 0));
    }
    template <int Unit>
    void unit(const DrawState& state, ShadowStage coord_stage, ShadowStage lod, ShadowStage texture_stage) {
        place<Unit>(state, coord_stage, lod);
        if (!state.needs.unit[Unit])
            return;
        if (wants_lod(*state.fragment.unit[Unit].texture))
            run<Texture2D<N, Unit, true>, Texture2D<Reference, Unit, true>>();
        else
            run<Texture2D<N, Unit, false>, Texture2D<Reference, Unit, false>>();
        colors(texture_stage);
    }
    void units(const DrawState& state) {
        if (!uses_combiners(state.fragment)) {
            unit<0>(state, ShadowStage::coord0, ShadowStage::lod0, ShadowStage::texture0);
            if constexpr (max_texture_units > 1)
                unit<1>(state, ShadowStage::coord1, ShadowStage::lod1, ShadowStage::texture1);
            return;
        }
        place<0>(state, ShadowStage::coord0, ShadowStage::lod0);
        if constexpr (max_texture_units > 1)
            place<1>(state, ShadowStage::coord1, ShadowStage::lod1);
        run<CombineUnits>();
        colors(state.needs.unit[max_texture_units - 1] ? ShadowStage::texture1 : ShadowStage::texture0);
    }

    void rest(const DrawState& state) {
        if constexpr (has_color_sum) {
            if (state.needs.secondary) {
                if (fixed_.kind == Kind::full)
                    run<ColorSum<N, true>, ColorSum<Reference, true>>();
                else
                    run<ColorSum<N, false>, ColorSum<Reference, false>>();
                colors(ShadowStage::color_sum);
            }
        }
        if (state.needs.fog) {
            if (fixed_.kind >= Kind::textured)
                run<FogCoord<N, true>, FogCoord<Reference, true>>();
            else
                run<FogCoord<N, false>, FogCoord<Reference, false>>();
            report_[ShadowStage::fog_factor].add(fog_factor(state.fragment.fog_mode, fixed_fragment_.fog) *
                                                     word_24,
                                                 reference_fog(state.fragment, double_fragment_.fog));
            fog(state);
            colors(ShadowStage::fog);
        }
        if (!state.fragment.blend || state.fragment.logic || is_indexed(state.format))
            return;
        switch (state.format) {
        case PixelFormat::rgb565_be:
            return blend<PixelFormat::rgb565_be>();
        case PixelFormat::rgb565_le:
            return blend<PixelFormat::rgb565_le>();
        case PixelFormat::rgb888:
            return blend<PixelFormat::rgb888>();
        case PixelFormat::rgba8888:
            return blend<PixelFormat::rgba8888>();
        default:
            if (run<Blend<N, StoredNarrow<N>>, Blend<Reference, StoredNarrow<Reference>>>())
                colors(ShadowStage::blend);
        }
    }
    void fog(const DrawState& state) {
        if constexpr (!is_balanced<N>) // balanced numbers never draw indices (key.cpp)
            if (is_indexed(state.format))
                return static_cast<void>(run<FogIndex>());
        run<Fog>();
    }
    template <PixelFormat Format> void blend() {
        const FragmentState& state = fixed_.state->fragment;
        if constexpr (is_balanced<N> && is_565(Format))
            if (make_key(state, *fixed_.target, fixed_.kind).coarse) {
                if (state.dither ? run<BlendCoarse<N, Format, true>, BlendAlpha<Reference, Format>>()
                                 : run<BlendCoarse<N, Format, false>, BlendAlpha<Reference, Format>>())
                    colors(ShadowStage::blend);
                return;
            }
        const bool over = state.blend_rgb == blend_over && state.blend_alpha == blend_over;
        if (over ? run<BlendAlpha<N, Format>, BlendAlpha<Reference, Format>>()
                 : run<Blend<N, Stored<N, Format>>, Blend<Reference, Stored<Reference, Format>>>())
            colors(ShadowStage::blend);
    }
};

/// Compares a row before it is drawn, while the destination of blending still holds its old colours.
template <class N> void compare_row(const Span<Shadow>& span) {
    ShadowReport* const report = current_report;
    if (report == nullptr)
        return;
    Span<Double> twin = span.twin;
    twin.color = span.color;
    twin.depth = span.depth;
    twin.begin = span.begin;
    twin.end = span.end;
    twin.length = span.length;
    twin.pixels = span.pixels;
    for (std::int32_t x = span.begin; x < span.end; ++x)
        Fragment<N>(span, twin, x, *report).compare_all();
}

/// Compares rows and draws them. Chain is the number system of the chain that draws. The chain runs with the
/// instruction set for which it was assembled.
template <class N, Number Chain> void shadow_rows(Span<Shadow>& span, const Row* row, const Row* end) {
    const bool narrow = is_narrow(span.target->format);
    const auto run = reinterpret_cast<RowsFunction<Fixed>>(chain_runner(Chain, narrow));
    for (; row != end; ++row) {
        span.twin.x = row->left;
        span.twin.y = row->y;
        enter<Fixed>(span, *row);
        if (narrow)
            span.color = span.target->color_row(row->y);
        compare_row<N>(span);
        run(span, row, row + 1);
    }
}

AnyFunction shadow_runner(Number number) {
    switch (number) {
    case Number::raw565:
        return reinterpret_cast<AnyFunction>(&shadow_rows<Raw565<1>, Number::raw565>);
    case Number::balanced:
        return reinterpret_cast<AnyFunction>(&shadow_rows<Balanced<1>, Number::balanced>);
    default:
        return reinterpret_cast<AnyFunction>(&shadow_rows<Exact, Number::exact>);
    }
}

} // namespace

const char* name_of(ShadowStage stage) {
    constexpr const char* names[shadow_stages] = {
        "vertex color", "vertex coord", "vertex fog", "window x",   "window y", "snapping",  "window z",
        "1/w",          "depth",        "primary",    "coord 0",    "lod 0",    "texture 0", "coord 1",
        "lod 1",        "texture 1",    "color sum",  "fog factor", "fog",      "blend"};
    return names[static_cast<unsigned>(stage)];
}

const char* unit_of(ShadowStage stage) {
    switch (stage) {
    case ShadowStage::vertex_coord:
        return "repeats";
    case ShadowStage::vertex_fog:
    case ShadowStage::inverse_w:
        return "relative";
    case ShadowStage::window_x:
    case ShadowStage::window_y:
        return "pixels";
    case ShadowStage::snapping:
        return "1/256 pixel";
    case ShadowStage::coord0:
    case ShadowStage::coord1:
        return "texels";
    case ShadowStage::lod0:
    case ShadowStage::lod1:
        return "levels";
    default:
        return "of 1";
    }
}

void ShadowRecord::add_difference(double difference, double exact) {
    least = count == 0 || exact < least ? exact : least;
    greatest = count == 0 || exact > greatest ? exact : greatest;
    worst = std::fabs(difference) > worst ? std::fabs(difference) : worst;
    squares += difference * difference;
    ++count;
}

void ShadowRecord::add(double fixed, double exact, double limit) {
    saturated += std::fabs(fixed) >= limit ? 1 : 0;
    add(fixed, exact);
}

double ShadowRecord::rms() const {
    return count == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(count));
}

ShadowReport* report_shadow(ShadowReport* report) {
    ShadowReport* const old = current_report;
    current_report = report;
    return old;
}

ShadowReport* shadow_report() {
    return current_report;
}

template <> void compile<ShadowVertex>(const FragmentState& state, const Surface& target, DrawState& draw) {
    compile<FixedVertex>(state, target, draw);
    // The chain divides colours, so set-up must make the planes that a guess would leave out.
    draw.guesses = false;
    for (int i = 0; i < kind_count; ++i)
        if (Variant& variant = draw.variant[i]; variant.run != nullptr) {
            variant.run = shadow_runner(make_key(state, target, static_cast<Kind>(i)).number);
            variant.gray = false;
        }
}

} // namespace spangle::raster
