// These tests run on the tests' own kernel. Started anywhere else, the program boots that kernel and runs
// itself there.
#include <cstdio>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/unit/hal_kernel/files.hpp"

namespace {

bool inside() {
    return kernel_test::read_text("/proc/cpuinfo").find("User Mode Linux") != std::string::npos;
}

int boot(char** arguments) {
    char self[4096] = {};
    if (readlink("/proc/self/exe", self, sizeof self - 1) < 0)
        return 2;
    static char script[] = SPANGLE_SOURCE_DIR "/tests/unit/hal_kernel/boot.sh",
                cache[] = SPANGLE_KERNEL_CACHE;
    std::vector<char*> words = {script, cache, self};
    for (++arguments; *arguments != nullptr; ++arguments)
        words.push_back(*arguments);
    words.push_back(nullptr);
    execv(script, words.data());
    std::perror(script);
    return 2;
}

} // namespace

int main(int count, char** arguments) {
    if (!inside())
        return boot(arguments);
    testing::InitGoogleTest(&count, arguments);
    return RUN_ALL_TESTS();
}
