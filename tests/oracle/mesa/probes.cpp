#include "tests/oracle/mesa/probes.hpp"

#include <cstring>

#include "tests/oracle/mesa/eval_probes.hpp"
#include "tests/oracle/mesa/vertex_probes.hpp"

namespace spangle::oracle {

scenes::SceneList probes() {
    static const scenes::Scene all[] = {outlines,      divided_quads, two_units, cut_torus,
                                        sphere_mapped, planes_mapped, patches};
    return {all, sizeof all / sizeof all[0]};
}

const scenes::Scene* find_picture(const char* id) {
    for (const scenes::Scene& probe : probes())
        if (std::strcmp(probe.id, id) == 0)
            return &probe;
    return scenes::find(id);
}

} // namespace spangle::oracle
