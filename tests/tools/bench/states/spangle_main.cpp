// Random states on Spangle. Standard input names their numbers.
//
// usage: bench_states SEED list     prints each state as a line of JSON
//        bench_states SEED count    prints "NUMBER FRAGMENTS PICTURE"; under callgrind, dumps what each one
//        took bench_states SEED time     prints "NUMBER MICROSECONDS"
#include <cstdio>
#include <cstdlib>
#include <cstring>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else // without callgrind, fragments and pictures are still printed
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_STOP_INSTRUMENTATION
#define CALLGRIND_DUMP_STATS_AT(name)
#endif

#include "tests/tools/bench/states/counted.hpp"
#include "tests/tools/bench/states/timed.hpp"

namespace {

using namespace spangle::bench;
using namespace spangle::bench::states;

void print_words(const State& of) {
    const char* between = "";
    for (int i = 0; i < word_count; ++i) {
        const auto word = static_cast<Word>(i);
        if (!applies(of, word))
            continue;
        const Choice& choice = info(word).choices[of[word]];
        std::printf("%s\"%s\": [\"%s\", %d, %s]", between, info(word).name, choice.name, choice.work,
                    info(word).pass ? "true" : "false");
        between = ", ";
    }
}

/// Prints {"number": n, "key": n, "words": {word: [choice, work, whether it may add a pass]}} for each state.
int list(std::uint32_t seed) {
    for (unsigned number = 0; std::scanf("%u", &number) == 1;) {
        std::printf("{\"number\": %u, \"key\": %u, \"words\": {", number, number / variants);
        print_words(state(seed, number));
        std::printf("}}\n");
    }
    return 0;
}

int count_all(std::uint32_t seed) {
    for (unsigned number = 0; std::scanf("%u", &number) == 1;) {
        const Counted found = count(
            state(seed, number),
            [] {
                CALLGRIND_START_INSTRUMENTATION;
                CALLGRIND_ZERO_STATS;
            },
            [number] {
                CALLGRIND_STOP_INSTRUMENTATION;
                char name[16];
                std::snprintf(name, sizeof name, "state %u", number);
                CALLGRIND_DUMP_STATS_AT(name);
            });
        std::printf("%u %u %08x\n", number, found.good ? found.fragments : 0, found.picture);
        std::fflush(stdout);
    }
    return 0;
}

/// Makes the state's context current. Contexts are kept, because states come again in each round.
bool select(const State& of) {
    static Headless kept[2][3][2];
    Headless& gl = kept[of[Word::surface]][of[Word::tier]][of[Word::samples]];
    return gl.context != EGL_NO_CONTEXT ? gl.make_current() : open_for(gl, of);
}

} // namespace

int main(int argc, char** argv) {
    const char* const what = argc == 3 ? argv[2] : "";
    const auto seed = static_cast<std::uint32_t>(std::strtoul(argc > 1 ? argv[1] : "0", nullptr, 10));
    if (std::strcmp(what, "list") == 0)
        return list(seed);
    if (std::strcmp(what, "count") == 0)
        return count_all(seed);
    if (std::strcmp(what, "time") == 0)
        return time_all(seed, select);
    std::fprintf(stderr, "usage: bench_states SEED list|count|time < NUMBERS\n");
    return 2;
}
