// Is this picture the expected one, and if not, where not? For any test framework; spangle/sim/matchers.hpp
// speaks GoogleTest.
#pragma once

#include <cstdint>
#include <string>

#include <spangle/sim/image.hpp>

namespace spangle::sim {

/// Where two pictures differ by more than a tolerance, in 255ths of a channel.
struct Mismatch {
    bool same_size = true;
    std::uint64_t pixels = 0, differing = 0;
    int first_x = -1, first_y = -1; ///< topmost, then leftmost
    int max_difference = 0;         ///< of any channel of any pixel
    explicit operator bool() const { return !same_size || differing != 0; }
};
Mismatch mismatch(const Image& actual, const Image& expected, int tolerance = 0);

struct Verdict {
    bool passed = true;
    std::string text; ///< why not, and which files show it
};

/// What a check leaves behind when it fails.
enum class Evidence : std::uint8_t { none, pictures };

/// The picture equals a PNG file. Failing, "NAME.actual.png" and "NAME.difference.png" are written beside
/// NAME.png. With SPANGLE_UPDATE_GOLDEN=1 in the environment the file is (re)written instead, and the check
/// passes.
Verdict check_golden(const Image& actual, const std::string& golden, int tolerance = 0,
                     Evidence evidence = Evidence::pictures);

/// The picture has this hash(). Failing, it is written to `evidence_stem` + ".actual.png"; "": nowhere.
Verdict check_hash(const Image& actual, const std::string& expected, const std::string& evidence_stem);

/// The picture is the drawn one, a character a pixel; '?' matches everything. A line break at the start is
/// not part of the art. Failing, `evidence_stem` + ".actual.png" and ".difference.png" are written; "":
/// nothing.
Verdict check_ascii(const Image& actual, const std::string& art, const Legend& legend,
                    const std::string& evidence_stem);

} // namespace spangle::sim
