// The obligations that Gappa proves. Each function prints one script, with the numbers of the headers.
#pragma once

#include <vector>

namespace spangle::gappa {

struct Obligation {
    const char* name;
    void (*print)();
};

const std::vector<Obligation>& vertex_obligations();
const std::vector<Obligation>& primitive_obligations();
const std::vector<Obligation>& color_obligations();

} // namespace spangle::gappa
