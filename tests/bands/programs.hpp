// Programs of one system each: what a band's edge could show in.
#pragma once

#include "tests/bands/banded.hpp"

namespace spangle::test {

const std::vector<Program>& programs();

} // namespace spangle::test
