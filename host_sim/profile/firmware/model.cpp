#include "boards/scenes/baked_model.hpp" // first: it names the GL that the model is drawn with

#include "host_sim/profile/firmware/model.hpp"

namespace spangle::measure {

void Model::setup(int width, int height) {
    scenes::setup_baked(model_mesh, width, height);
}

void Model::draw(int frame) {
    scenes::draw_baked(model_mesh, frame);
}

} // namespace spangle::measure
