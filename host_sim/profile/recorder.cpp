#include "host_sim/profile/recorder.hpp"

#if SPANGLE_WATCHED

#include <algorithm>
#include <cstring>

#include <spangle/GL/gl.h>
#include <spangle/native.hpp>

#include "gl/api/explain.hpp"
#include "gl/context/context.hpp"
#include "host_sim/profile/needs.hpp"
#include "raster/fused/table.hpp"
#include "raster/span/rows.hpp"

namespace spangle::profile {

using raster::Kind;

namespace {

Recorder* listening = nullptr;

bool is(const char* name, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const char* one) { return std::strcmp(name, one) == 0; });
}

/// The bit of SPANGLE_PRIMITIVES for what a mode of Begin draws.
unsigned primitives_of(GLenum mode) {
    constexpr unsigned points = 1, lines = 2, polygons = 4;
    return mode == GL_POINTS                        ? points
           : mode <= GL_LINE_STRIP                  ? lines
           : mode >= GL_QUADS && mode <= GL_POLYGON ? polygons
                                                    : 0;
}

} // namespace

/// Counts pixels, and passes them on to the span that draws them.
struct Spans {
    template <int K>
    static void run(raster::Span<raster::Fixed>& span, const raster::Row* row, const raster::Row* end) {
        std::uint64_t pixels = 0;
        for (const raster::Row* at = row; at != end; ++at)
            pixels += static_cast<std::uint64_t>(at->last - at->first);
        reinterpret_cast<raster::RowsFunction<raster::Fixed>>(listening->count({span.state, K}, pixels))(
            span, row, end);
    }
    static constexpr raster::RowsFunction<raster::Fixed> of[raster::kind_count] = {&run<0>, &run<1>, &run<2>,
                                                                                   &run<3>};
};

Recorder::Recorder() {
    listening = this;
}

Recorder::Recorder(PixelFormat colors) : color_format_(colors) {
    listening = this;
}

Recorder::Recorder(gl::Context& context) : context_(&context) {
    listening = this;
    add(context);
    note_state(context);
}

Recorder::~Recorder() {
    if (context_ != nullptr)
        gl::watch(*context_, nullptr);
    listening = nullptr;
}

void Recorder::add(gl::Context& context) {
    gl::watch(context, this);
}

/// The surface that keys are made for: the program's own, or one of the formats asked for.
raster::Surface Recorder::target(const gl::Context& context) const {
    raster::Surface surface = context.drawable.surface;
    if (!color_format_)
        return surface;
    surface.format = *color_format_;
    if (surface.depth_format != DepthFormat::none)
        surface.depth_format = has_stencil_ ? DepthFormat::z24s8 : DepthFormat::z16;
    return surface;
}

raster::AnyFunction Recorder::count(const std::pair<const raster::DrawState*, int>& variant,
                                    std::uint64_t pixels) {
    const std::lock_guard lock(mutex_);
    const CountedFunction& counted = counted_states_.at(variant);
    record_.keys[counted.key].pixels += pixels;
    return counted.run;
}

std::size_t Recorder::place_of(const raster::Key& key) {
    const auto at = std::find_if(record_.keys.begin(), record_.keys.end(),
                                 [&](const KeyUse& use) { return use.key == key; });
    if (at != record_.keys.end())
        return static_cast<std::size_t>(at - record_.keys.begin());
    record_.keys.push_back({key, 0, raster::find_fused(key) != nullptr, false});
    return record_.keys.size() - 1;
}

/// Notes the key of a draw in one flat colour. The recorder may note keys for other formats than the one that
/// the program draws in. Then the surface that draws may lack a span for one colour, and the recorded format
/// may have one. How many pixels that span would draw is unknown, so its key counts as needed: with
/// dithering, a smooth span may draw other bytes.
void Recorder::keep_one_color(const raster::FragmentState& fragment, const raster::Surface& surface,
                              const raster::DrawState& state) {
    const raster::Key key = raster::make_key(fragment, surface, Kind::flat);
    if (state.variant[0].run == nullptr && !state.textured_or_fogged && key.number == raster::Number::raw565)
        record_.keys[place_of(key)].needed = true;
}

/// Notes the keys of a state, and makes its spans count. Shapes, tiles and paths are turned off: rows draw
/// the same bytes, and are counted. A kind is needed unless another kind draws the same. The affine kind
/// draws one colour, too; FLAT shading without textures or fog needs the flat kind only. In the fast tier
/// divided colours are drawn as affine ones, so that the full kind is listed only with its pixels.
void Recorder::compiled(gl::Context& context, const raster::FragmentState& fragment,
                        raster::DrawState& state) {
    const std::lock_guard lock(mutex_);
    has_stencil_ = has_stencil_ || fragment.stencil_test;
    const raster::Surface surface = target(context);
    record_.tiers |= 1u << static_cast<unsigned>(fragment.tier);
    const bool one_color =
        fragment.flat && !state.textured_or_fogged && !state.pixels && state.variant[0].run != nullptr;
    if (color_format_ && !state.nothing)
        keep_one_color(fragment, surface, state);
    for (int i = 0; i < raster::kind_count; ++i) {
        raster::Variant& variant = state.variant[i];
        if (variant.run == nullptr || state.nothing)
            continue;
        const auto kind = static_cast<Kind>(i);
        const std::size_t place = place_of(raster::make_key(fragment, surface, kind));
        const bool optional = kind == Kind::flat ? !fragment.flat : one_color;
        const bool never = kind == Kind::full && fragment.tier == raster::Tier::fast;
        record_.keys[place].needed = record_.keys[place].needed || !(optional || never);
        counted_states_[{&state, i}] = {variant.run, place};
        variant.run = reinterpret_cast<raster::AnyFunction>(Spans::of[i]);
        variant.walk = nullptr;
        variant.shapes = nullptr;
    }
    state.shapes = state.tiles = false;
    state.paths = {};
}

void Recorder::reached(gl::Range range, std::uint32_t value) {
    const std::lock_guard lock(mutex_);
    std::uint32_t& most = record_.reached[static_cast<unsigned>(range)];
    most = std::max(most, value);
}

/// Notes the optional system that a token asks for, wherever the token occurs.
void Recorder::value(std::uint32_t word) {
    if (const char* const feature = feature_of(word); feature != nullptr)
        record_.features.insert(feature);
}

/// Notes switches of lighting that are limits, not optional systems. A program that only turns them off names
/// them, too.
void Recorder::note_switch(std::uint32_t word) {
    if (word == GL_COLOR_MATERIAL)
        record_.light_kinds |= light_follows_colors;
    record_.full_lighting = record_.full_lighting || word == GL_COLOR_MATERIAL || word == GL_NORMALIZE ||
                            word == GL_RESCALE_NORMAL;
}

void Recorder::note_arguments(gl::Context& context, const gl::CommandText& text, const gl::Arg* args,
                              unsigned count) {
    gl::Arg given[gl::most_explained] = {};
    const unsigned n = gl::unpack(text, args, count, given);
    for (unsigned i = 0; i < n && i < text.count; ++i) {
        const gl::ArgText& arg = text.args[i];
        const auto word = static_cast<std::uint32_t>(given[i]);
        const bool texture = word >= GL_TEXTURE0 && word < GL_TEXTURE0 + 32;
        if (arg.rule == gl::ArgRule::token || arg.rule == gl::ArgRule::pname ||
            std::strcmp(arg.name, "internalformat") == 0)
            value(word);
        if (arg.rule == gl::ArgRule::token)
            note_switch(word);
        if (arg.rule == gl::ArgRule::token && texture)
            record_.texture_units = std::max(record_.texture_units, static_cast<int>(word - GL_TEXTURE0) + 1);
        if (word >= GL_LIGHT0 && word < GL_LIGHT0 + 8 && arg.rule == gl::ArgRule::token)
            record_.lights = std::max(record_.lights, static_cast<int>(word - GL_LIGHT0) + 1);
        if (std::strcmp(arg.name, "internalformat") == 0 && word == GL_DEPTH_COMPONENT)
            record_.features.insert("DEPTH_TEXTURES");
        if (std::strcmp(arg.name, "mode") == 0 &&
            is(text.name, {"glBegin", "glDrawArrays", "glDrawElements", "glDrawRangeElements",
                           "glMultiDrawArrays", "glMultiDrawElements"}))
            record_.primitives |= primitives_of(word);
        if (std::strcmp(arg.name, "type") == 0 && std::strstr(text.name, "Pointer") != nullptr &&
            word - GL_BYTE < 13)
            record_.array_types |= 1u << (word - GL_BYTE);
        if (arg.rule == gl::ArgRule::pname && i + 1 == count - 1 &&
            std::strncmp(text.name, "glGet", 5) != 0) {
            const auto& params = *reinterpret_cast<const gl::Params*>(args[count - 1]);
            for (unsigned v = 0; v < params.count && v < 4; ++v)
                value(params.v[v].word);
        }
    }
    if (is(text.name, {"glClear"}) && (args[0] & GL_ACCUM_BUFFER_BIT) != 0)
        record_.features.insert("ACCUM");
    if (is(text.name, {"glRect"}))
        record_.primitives |= primitives_of(GL_QUADS);
    if (is(text.name, {"glEvalMesh1", "glEvalMesh2"}))
        record_.primitives |= 7;
    if (is(text.name, {"glInterleavedArrays"}))
        record_.array_types |= 1u << (GL_FLOAT - GL_BYTE) | 1u << (GL_UNSIGNED_BYTE - GL_BYTE);
    if (std::strstr(text.name, "Tex") != nullptr)
        record_.texture_units = std::max(record_.texture_units, 1);
    static_cast<void>(context);
}

void Recorder::command(gl::Context& context, const gl::CommandText& text, const gl::Arg* args,
                       unsigned count) {
    const std::lock_guard lock(mutex_);
    ++record_.commands[text.name];
    for (const char* const feature : features_of(text.name))
        record_.features.insert(feature);
    note_state(context);
    if (args != nullptr && count != 0)
        note_arguments(context, text, args, count);
}

const Record& Recorder::finish() {
    const std::lock_guard lock(mutex_);
    if (context_ != nullptr)
        note_state(*context_);
    // A surface with a stencil buffer has depths of 24 bits for every draw.
    if (color_format_ && has_stencil_) {
        for (KeyUse& use : record_.keys)
            if (use.key.depth_format != DepthFormat::none)
                use.key.depth_format = DepthFormat::z24s8;
        record_.depth_formats &= ~(1u << static_cast<unsigned>(DepthFormat::z16));
    }
    record_.arena_peak = memory_use().peak;
    return record_;
}

} // namespace spangle::profile

#endif
