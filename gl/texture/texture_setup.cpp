#include "gl/texture/texture_setup.hpp"

#include "gl/context/tokens.hpp"
#include "gl/pixel/fragment_setup.hpp"
#include "gl/texture/complete.hpp"
#include "raster/span/fused_keys.hpp"

namespace spangle::gl {

namespace {

raster::TexEnv env_of(GLenum mode) {
    if (raster::spans_only_modulate) // with spans_only_modulate, other modes are refused
        return mode == GL_MODULATE ? raster::TexEnv::modulate : raster::TexEnv::replace;
    return static_cast<raster::TexEnv>(place_in(env_modes, mode));
}

#if SPANGLE_FEATURE_TEXTURE_COMBINE

raster::CombineSource source_of(GLenum source) {
    const unsigned place = place_in(combine_sources, source);
    constexpr auto texture0 = static_cast<unsigned>(raster::CombineSource::texture0);
    return static_cast<raster::CombineSource>(place < texture0 ? place : place + unit_of(source));
}

unsigned arguments_of(GLenum func) {
    return func == GL_REPLACE ? 1 : func == GL_INTERPOLATE ? 3 : 2;
}

raster::Combiner combiner_of(const TexEnvState& env, unsigned alpha) {
    raster::Combiner out;
    out.func = static_cast<raster::CombineFunc>(place_in(combine_functions, env.func[alpha]));
    // The scale is 1, 2 or 4, so the exponent of its float is its logarithm.
    out.log2_scale = static_cast<std::uint8_t>((env.scale[alpha].bits - numeric::one.bits) >> 23);
    for (unsigned i = 0; i < arguments_of(env.func[alpha]); ++i)
        out.argument[i] = {source_of(env.source[alpha][i]), combine_operand_of(env.operand[alpha][i])};
    return out;
}

/// Whether all texture units that a combiner reads are enabled. If not, the unit of the combiner passes the
/// colour on unchanged (ARB_texture_env_crossbar).
bool sources_are_on(const raster::FragmentState& out, const raster::Combiner& combiner) {
    for (const raster::Combiner::Argument& argument : combiner.argument) {
        const unsigned unit =
            static_cast<unsigned>(argument.source) - static_cast<unsigned>(raster::CombineSource::texture0);
        if (unit < texture_units && out.unit[unit].texture == nullptr)
            return false;
    }
    return true;
}

void fill_combiners(const TexEnvState& env, raster::FragmentState& out, raster::TextureUnit& unit) {
    unit.rgb = combiner_of(env, 0);
    unit.alpha = combiner_of(env, 1);
    if (sources_are_on(out, unit.rgb) && sources_are_on(out, unit.alpha))
        return;
    // The unit passes the colour of the previous unit on.
    unit.rgb = unit.alpha = {raster::CombineFunc::replace, 0, {}};
}

#endif

/// The sum of both LOD biases in s23.8, clamped to +-MAX_TEXTURE_LOD_BIAS (GL 1.4, 3.8.8).
std::int32_t lod_bias(Real texture, Real unit) {
    constexpr std::int32_t most = max_texture_lod_bias << 8;
    return numeric::clamp(numeric::to_fixed(numeric::add(texture, unit), 8), -most, most);
}

} // namespace

void fill_textures(const Context& context, raster::FragmentState& out) {
    if constexpr (!raster::has_textures)
        return;
    const TextureObject* textures[texture_units];
    for (int i = 0; i < texture_units; ++i) {
        textures[i] = sampled_texture(context, i);
        out.unit[i].texture = textures[i] != nullptr ? &textures[i]->view : nullptr;
    }
    for (int i = 0; i < texture_units; ++i) {
        if (textures[i] == nullptr)
            continue;
        raster::TextureUnit& unit = out.unit[i];
        const TexEnvState& env = context.texture.unit[i].env;
        unit.env = env_of(env.mode);
        if (raster::spans_with_env_color)
            for (int c = 0; c < 4; ++c)
                unit.env_color[c] = color_units(env.color[c]);
        if (!raster::spans_sample_any)
            continue;
        unit.lod_bias = lod_bias(textures[i]->parameters.lod_bias, env.lod_bias);
#if SPANGLE_FEATURE_TEXTURE_COMBINE
        if (env.mode == GL_COMBINE)
            fill_combiners(env, out, unit);
#endif
    }
}

} // namespace spangle::gl
