#include "tests/gl/vertex/invariance.hpp"

namespace {

using spangle::test::Invariance;

TEST_F(Invariance, EveryWayToGiveAVertex) {
    run(50000, 1);
}

} // namespace
