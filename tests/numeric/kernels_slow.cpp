// Every mantissa.
#include "tests/numeric/kernels.hpp"

TEST(KernelsSlow, ReciprocalOfEveryMantissa) {
    check_reciprocal(1);
}
TEST(KernelsSlow, RsqrtOfEveryMantissa) {
    check_rsqrt(1);
}
