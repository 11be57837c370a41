#include "tests/oracle/mesa/answers.hpp"

#include "tests/oracle/mesa/asker.hpp"

namespace spangle::oracle {

const std::vector<Questions>& all_questions() {
    static const std::vector<Questions> all = {{"initial_state", initial_state},
                                               {"state_that_was_set", state_that_was_set},
                                               {"attribute_groups", attribute_groups},
                                               {"selection", selection},
                                               {"feedback", feedback},
                                               {"evaluators", evaluators},
                                               {"lists", lists},
                                               {"raster_positions", raster_positions},
                                               {"lighting", lighting},
                                               {"generated_coordinates", generated_coordinates},
                                               {"clip_planes", clip_planes},
                                               {"buffers", buffers},
                                               {"multi_draw", multi_draw},
                                               {"fog_coordinates", fog_coordinates},
                                               {"secondary_colors", secondary_colors},
                                               {"primitive_restart", primitive_restart},
                                               {"vertex_array_objects", vertex_array_objects},
                                               {"texture_images", texture_images},
                                               {"texture_parameters", texture_parameters},
                                               {"pixel_paths", pixel_paths},
                                               {"fragment_operations", fragment_operations}};
    return all;
}

} // namespace spangle::oracle
