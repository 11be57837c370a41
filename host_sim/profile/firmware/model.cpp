#include "boards/scenes/baked_model.hpp" // This header comes first, because it names the GL with which the model is drawn.

#include "host_sim/profile/firmware/model.hpp"

namespace spangle::measure {

void Model::setup(int width, int height) {
    scenes::setup_baked(model_mesh, width, height);
}

void Model::draw(int frame) {
    scenes::draw_baked(model_mesh, frame);
}

} // namespace spangle::measure
