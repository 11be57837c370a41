// Prints, as JSON, what the page compares itself with: digests of the pictures and the bus traffic of the
// checked choices, drawn natively.
#include <cstdio>

#include "host_sim/page/view.hpp"

int main() {
    using namespace spangle;
    const char* comma = "";
    std::printf("[");
    for (const page::Choice& choice : page::checked_choices()) {
        const std::string digest = page::digest_of(choice);
        std::printf("%s\n[%d, %d, %d, %d, \"%s\"]", comma, choice.board, choice.scene, choice.tier,
                    choice.format, digest.c_str());
        comma = ",";
        if (digest.starts_with("error")) {
            std::fprintf(stderr, "%s, scene %s, tier %s, format %d: %s\n", page::board_of(choice.board).name,
                         scenes::all().first[choice.scene].id, page::tiers[choice.tier], choice.format,
                         digest.c_str());
            return 1;
        }
    }
    std::printf("\n]\n");
    return 0;
}
