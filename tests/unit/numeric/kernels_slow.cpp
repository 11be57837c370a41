// Sweeps the reciprocal and the root over every mantissa.
#include "tests/unit/numeric/kernels.hpp"

TEST(KernelsSlow, ReciprocalOfEveryMantissa) {
    check_reciprocal(1);
}
TEST(KernelsSlow, RsqrtOfEveryMantissa) {
    check_rsqrt(1);
}
