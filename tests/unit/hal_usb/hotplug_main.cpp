#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

/// Starts the program again under umockdev's wrapper, which must be loaded before the program.
int main(int argc, char** argv) {
    const char* const preloaded = std::getenv("LD_PRELOAD");
    if (preloaded == nullptr || std::strstr(preloaded, "umockdev") == nullptr) {
        std::vector<char*> words = {const_cast<char*>("umockdev-wrapper")};
        words.insert(words.end(), argv, argv + argc + 1);
        execvp(words[0], words.data());
        std::perror("umockdev-wrapper");
        return 1;
    }
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
