#include "host_sim/profile/recorder.hpp"

#if SPANGLE_WATCHED

#include <algorithm>
#include <cstring>

#include <spangle/GL/gl.h>
#include <spangle/native.hpp>

#include "gl/api/explain.hpp"
#include "gl/context/context.hpp"
#include "gl/context/share_group.hpp"
#include "host_sim/profile/needs.hpp"
#include "raster/span/fused_table.hpp"
#include "raster/span/rows.hpp"

namespace spangle::profile {

using numeric::Real;
using raster::Kind;

namespace {

Recorder* listening = nullptr;

bool is(const char* name, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(),
                       [&](const char* one) { return std::strcmp(name, one) == 0; });
}

/// What SPANGLE_PRIMITIVES calls what a mode of Begin draws.
unsigned primitives_of(GLenum mode) {
    constexpr unsigned points = 1, lines = 2, polygons = 4;
    return mode == GL_POINTS                        ? points
           : mode <= GL_LINE_STRIP                  ? lines
           : mode >= GL_QUADS && mode <= GL_POLYGON ? polygons
                                                    : 0;
}

bool bright(const Real (&color)[4]) {
    constexpr std::uint32_t sixteen = 0x41800000;
    return std::any_of(color, color + 3, [](Real c) { return (c.bits & 0x7FFFFFFF) >= sixteen; });
}

bool black(const Real (&color)[4]) {
    return std::all_of(color, color + 3, [](Real c) { return numeric::is_zero(c); });
}

} // namespace

/// Counts pixels on their way to the span that draws them.
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

Recorder::Recorder(PixelFormat colors) : colors_(colors) {
    listening = this;
}

Recorder::Recorder(gl::Context& context) : context_(&context) {
    listening = this;
    add(context);
    inspect(context);
}

Recorder::~Recorder() {
    if (context_ != nullptr)
        gl::watch(*context_, nullptr);
    listening = nullptr;
}

void Recorder::add(gl::Context& context) {
    gl::watch(context, this);
}

/// The surface that keys are made for.
raster::Surface Recorder::target(const gl::Context& context) const {
    raster::Surface surface = context.drawable.surface;
    if (!colors_)
        return surface;
    surface.format = *colors_;
    if (surface.depth_format != DepthFormat::none)
        surface.depth_format = stencil_ ? DepthFormat::z24s8 : DepthFormat::z16;
    return surface;
}

raster::AnyFunction Recorder::count(const std::pair<const raster::DrawState*, int>& variant,
                                    std::uint64_t pixels) {
    const std::lock_guard lock(mutex_);
    const Counted& counted = counted_.at(variant);
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

/// The same bytes are drawn by rows alone, which are counted. A kind is needed unless another draws what it
/// would: one colour is drawn by the affine kind, too, and FLAT shading without textures or fog has nothing
/// else. Divided colours of the fast tier are affine where no span divides them; they are listed where some
/// were drawn.
void Recorder::compiled(gl::Context& context, const raster::FragmentState& fragment,
                        raster::DrawState& state) {
    const std::lock_guard lock(mutex_);
    stencil_ = stencil_ || fragment.stencil_test;
    const raster::Surface surface = target(context);
    record_.tiers |= 1u << static_cast<unsigned>(fragment.tier);
    const bool one_color =
        fragment.flat && !state.textured_or_fogged && !state.pixels && state.variant[0].run != nullptr;
    for (int i = 0; i < raster::kind_count; ++i) {
        raster::Variant& variant = state.variant[i];
        if (variant.run == nullptr || state.nothing)
            continue;
        const auto kind = static_cast<Kind>(i);
        const std::size_t place = place_of(raster::make_key(fragment, surface, kind));
        const bool optional = kind == Kind::flat ? !fragment.flat : one_color;
        const bool never = kind == Kind::full && fragment.tier == raster::Tier::fast;
        record_.keys[place].needed = record_.keys[place].needed || !(optional || never);
        counted_[{&state, i}] = {variant.run, place};
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

/// Tokens that ask for a system wherever they come.
void Recorder::value(std::uint32_t word) {
    if (const char* const feature = feature_of(word); feature != nullptr)
        record_.features.insert(feature);
}

void Recorder::arguments(gl::Context& context, const gl::CommandText& text, const gl::Arg* args,
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
    inspect(context);
    if (args != nullptr && count != 0)
        arguments(context, text, args, count);
}

void Recorder::inspect_textures(gl::Context& context) {
    const auto look = [&](const gl::TextureObject* object) {
        for (unsigned face = 0; object != nullptr && face < object->faces(); ++face)
            for (int level = 0; level < gl::texture_levels; ++level) {
                const gl::LevelImage* const image = object->image(face, level);
                if (image == nullptr || image->shape.empty())
                    continue;
                record_.texture_formats |= 1u << static_cast<unsigned>(image->shape.format);
                int levels = level + 1;
                for (unsigned side = 0; side < 3; ++side)
                    for (unsigned texels = image->shape.inner(side); texels > 1u << (levels - 1 - level);)
                        ++levels;
                record_.texture_levels = std::max(record_.texture_levels, levels);
            }
    };
    gl::NameTable& textures = context.share->textures;
    for (std::uint32_t i = 0; i < textures.capacity(); ++i)
        if (textures.slot(i).name != 0)
            look(static_cast<const gl::TextureObject*>(textures.slot(i).object));
    for (const gl::TextureKind kind :
         {gl::TextureKind::one, gl::TextureKind::two, gl::TextureKind::three, gl::TextureKind::cube})
        look(&context.texture.default_texture(kind));
}

/// What the commands before have made of the state.
void Recorder::inspect(gl::Context& context) {
    Record& r = record_;
    if (context.drawable.surface.color != nullptr) {
        const raster::Surface surface = target(context);
        r.color_formats |= 1u << static_cast<unsigned>(surface.format);
        r.depth_formats |= 1u << static_cast<unsigned>(surface.depth_format);
        if (surface.samples != nullptr)
            r.features.insert("MULTISAMPLE");
    }
    r.modelview_stack = std::max(r.modelview_stack, context.transform.modelview.top + 1);
    r.projection_stack = std::max(r.projection_stack, context.transform.projection.top + 1);
    for (const auto& stack : context.transform.texture)
        r.texture_stack = std::max(r.texture_stack, stack.top + 1);
    r.list_nesting = std::max(r.list_nesting, static_cast<int>(context.list.depth) + 1);

    const gl::LightingState& lighting = context.lighting;
    const auto kind = [&](unsigned bit, bool used) { r.light_kinds |= used ? bit : 0u; };
    constexpr unsigned specular = 1, local = 2, sides = 4, colors = 8;
    kind(local, lighting.local_viewer);
    kind(sides, lighting.two_side);
    kind(colors, lighting.color_material);
    r.full_lighting = r.full_lighting || context.transform.normalize || context.transform.rescale_normal ||
                      lighting.color_material;
    for (const gl::Light& light : lighting.light) {
        kind(local, !numeric::is_zero(light.position[3]) || !(light.spot_cutoff == Real{0x43340000}));
        r.full_lighting = r.full_lighting || bright(light.diffuse);
    }
    for (const gl::Material& material : lighting.material) {
        kind(specular, !black(material.specular));
        r.full_lighting = r.full_lighting || bright(material.diffuse);
    }
    gl::each_array(context.arrays, [&](const gl::ClientArray& array) {
        if (array.enabled && array.type - GL_BYTE < 13)
            r.array_types |= 1u << (array.type - GL_BYTE);
    });
    const auto [seen, first] = textures_seen_.try_emplace(context.share, 0);
    if (first || seen->second != context.share->texture_changes) {
        seen->second = context.share->texture_changes;
        inspect_textures(context);
    }
}

const Record& Recorder::finish() {
    const std::lock_guard lock(mutex_);
    if (context_ != nullptr)
        inspect(*context_);
    // A surface with stencils has depths of 24 bits for every draw.
    if (colors_ && stencil_) {
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
