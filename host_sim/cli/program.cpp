#include "host_sim/cli/program.hpp"

#include <memory>

#include <spangle/GL/gl.h>

#include "boards/scenes/baked_model.hpp"
#include "boards/scenes/scene.hpp"
#include "host_sim/cli/model_baked.hpp"

namespace spangle::cli {

std::string make_program(const RunOptions& options, Model& model, Program& out) {
    if (options.model.empty()) {
        const scenes::Scene* const scene = scenes::find(options.scene.c_str());
        if (scene == nullptr)
            return "no scene '" + options.scene + "'; `spangle scenes` lists them";
        out = {scene->id, scene->setup, scene->draw};
        return "";
    }
    ModelResult loaded = load_model(options.model);
    if (!loaded.error.empty())
        return loaded.error;
    model = std::move(loaded.model);
    if (!options.baked) {
        out = {model.name, [&model](int w, int h) { setup_model(model, w, h); },
               [&model](int f) { draw_model(model, f); }};
        return "";
    }
    const auto baked = std::make_shared<BakedModel>(model);
    if (baked->mesh().parts == 0)
        return "nothing of '" + model.name + "' is left once it is baked: every triangle has lost a corner";
    out = {model.name, [baked](int w, int h) { scenes::setup_baked(baked->mesh(), w, h); },
           [baked](int f) { scenes::draw_baked(baked->mesh(), f); }};
    return "";
}

void start(const Program& program, const Session& session, bool dither) {
    program.setup(session.width(), session.height());
    if (dither)
        glEnable(GL_DITHER);
    else
        glDisable(GL_DITHER);
}

} // namespace spangle::cli
