#include "tests/gl/vertex/invariance.hpp"

namespace {

using spangle::test::Invariance;

TEST_F(Invariance, AMillionVertices) {
    run(1000000, 2);
}

} // namespace
