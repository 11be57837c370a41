#include "host_sim/profile/needs.hpp"

#include <map>

#include <spangle/GL/gl.h>

namespace spangle::profile {

namespace {

struct CommandNeed {
    const char *command, *feature;
};
constexpr CommandNeed command_needs[] = {
#define COMMAND(name, feature) {name, #feature},
#define TOKEN(name, feature)
#include "host_sim/profile/needs.inc"
#undef COMMAND
#undef TOKEN
};

/// The optional system that tokens from `first` to `last` need.
struct TokenNeed {
    std::uint32_t first, last;
    const char* feature;
};
constexpr TokenNeed token_needs[] = {
#define COMMAND(name, feature)
#define TOKEN(name, feature) {name, name, #feature},
#include "host_sim/profile/needs.inc"
#undef COMMAND
#undef TOKEN
    // Tokens without a row of their own in the state table, and values of parameters.
    {GL_LIGHTING, GL_LIGHTING, "LIGHTING"},
    {GL_LIGHT0, GL_LIGHT7, "LIGHTING"},
    {GL_COLOR_MATERIAL, GL_COLOR_MATERIAL, "LIGHTING"},
    {GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHT_MODEL_AMBIENT, "LIGHTING"},
    {GL_LINE_STIPPLE, GL_LINE_STIPPLE_REPEAT, "STIPPLE"},
    {GL_POLYGON_STIPPLE, GL_POLYGON_STIPPLE, "STIPPLE"},
    {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_Q, "TEXGEN"},
    {GL_CLIP_PLANE0, GL_CLIP_PLANE5, "CLIP_PLANES"},
    {GL_MAP1_COLOR_4, GL_MAP1_VERTEX_4, "EVALUATORS"},
    {GL_MAP2_COLOR_4, GL_MAP2_VERTEX_4, "EVALUATORS"},
    {GL_AUTO_NORMAL, GL_AUTO_NORMAL, "EVALUATORS"},
    {GL_MULTISAMPLE, GL_SAMPLE_COVERAGE, "MULTISAMPLE"},
    {GL_POINT_SPRITE, GL_COORD_REPLACE, "POINT_PARAMETERS"},
    {GL_POINT_SIZE_MIN, GL_POINT_DISTANCE_ATTENUATION, "POINT_PARAMETERS"},
    {GL_COMBINE, GL_OPERAND2_ALPHA, "TEXTURE_COMBINE"},
    {GL_SUBTRACT, GL_SUBTRACT, "TEXTURE_COMBINE"},
    {GL_DOT3_RGB, GL_DOT3_RGBA, "TEXTURE_COMBINE"},
    {GL_GENERATE_MIPMAP, GL_GENERATE_MIPMAP_HINT, "MIPMAP_GENERATION"},
    {GL_PROXY_TEXTURE_1D, GL_PROXY_TEXTURE_1D, "TEXTURE_1D"},
    {GL_PROXY_TEXTURE_3D, GL_PROXY_TEXTURE_3D, "TEXTURE_3D"},
    {GL_TEXTURE_CUBE_MAP_POSITIVE_X, GL_PROXY_TEXTURE_CUBE_MAP, "TEXTURE_CUBE_MAP"},
    {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT32, "DEPTH_TEXTURES"},
    {GL_DEPTH_TEXTURE_MODE, GL_COMPARE_R_TO_TEXTURE, "DEPTH_TEXTURES"},
    {GL_SELECT, GL_SELECT, "SELECTION"},
    {GL_FEEDBACK, GL_FEEDBACK, "FEEDBACK"},
};

} // namespace

const std::vector<const char*>& features_of(const std::string& command) {
    static const auto table = [] {
        std::map<std::string, std::vector<const char*>> made;
        for (const CommandNeed& need : command_needs)
            made[need.command].push_back(need.feature);
        return made;
    }();
    static const std::vector<const char*> none;
    const auto at = table.find(command);
    return at == table.end() ? none : at->second;
}

const char* feature_of(std::uint32_t token) {
    for (const TokenNeed& need : token_needs)
        if (token >= need.first && token <= need.last)
            return need.feature;
    return nullptr;
}

} // namespace spangle::profile
