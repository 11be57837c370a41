// Checks whether a picture is the expected one, and tells where it is not. The checks suit any test
// framework; spangle/sim/matchers.hpp has matchers for GoogleTest.
#pragma once

#include <cstdint>
#include <string>

#include <spangle/sim/image.hpp>

namespace spangle::sim {

/// Where two pictures differ by more than a tolerance, in 255ths of a channel.
struct Mismatch {
    /// Whether both pictures have the same size; if not, the rest is not filled.
    bool same_size = true;
    /// Pixels of a picture, and how many of these differ.
    std::uint64_t pixels = 0, differing = 0;
    int first_x = -1, first_y = -1; ///< the topmost difference, of these the leftmost; -1: none
    int max_difference = 0;         ///< 255ths; of any channel of any pixel
    /// Whether the pictures differ.
    explicit operator bool() const { return !same_size || differing != 0; }
};
/// Compares two pictures; channels may differ by up to `tolerance` 255ths.
Mismatch mismatch(const Image& actual, const Image& expected, int tolerance = 0);

/// What a check says of a picture.
struct Verdict {
    /// Whether the picture is as it should be.
    bool passed = true;
    std::string text; ///< why the check failed, and which files show it
};

/// The files that a check leaves when it fails.
enum class Evidence : std::uint8_t { none, pictures };

/// Checks that the picture equals a PNG file. On failure, "NAME.actual.png" and "NAME.difference.png" are
/// written beside NAME.png. With SPANGLE_UPDATE_GOLDEN=1 in the environment the file is written instead, and
/// the check passes.
Verdict check_golden(const Image& actual, const std::string& golden, int tolerance = 0,
                     Evidence evidence = Evidence::pictures);

/// Checks that the picture has this hash(). On failure, the picture is written to `evidence_stem` +
/// ".actual.png"; with an empty stem it is not written.
Verdict check_hash(const Image& actual, const std::string& expected, const std::string& evidence_stem);

/// Checks that the picture looks like the art, a character a pixel; '?' matches everything. A line break at
/// the start is not part of the art. On failure, `evidence_stem` + ".actual.png" and ".difference.png" are
/// written; with an empty stem they are not.
Verdict check_ascii(const Image& actual, const std::string& art, const Legend& legend,
                    const std::string& evidence_stem);

} // namespace spangle::sim
