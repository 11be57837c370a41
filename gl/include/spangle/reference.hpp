// How far is a picture from the one that doubles draw, and which stage of the pipeline took it there? For
// host programs; link Spangle::gl_reference. docs/trade.md shows a whole program.
//
// The accuracy of a context is its config's: eglChooseConfig takes EGL_PRECISION_SPANGLE with
//   EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_BALANCED_SPANGLE, EGL_PRECISION_FAST_SPANGLE: the three tiers;
//   EGL_PRECISION_DOUBLE_SPANGLE: the reference picture;
//   EGL_PRECISION_SHADOW_SPANGLE, ..._SHADOW_BALANCED_SPANGLE, ..._SHADOW_FAST_SPANGLE: the bytes of a tier,
//   with a double beside every number.
// Configs of the last two lines exist once use_reference_engines() has been called.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace spangle {

/// Makes the configs of DOUBLE and SHADOW precision exist in this program. Call it before eglChooseConfig
/// asks for them; calling it again changes nothing.
void use_reference_engines();

/// One stage of the pipeline in integers, held against the doubles beside it.
struct StageError {
    const char* stage;       ///< "window x", "coord 0", "fog factor", ...
    const char* unit;        ///< of the figures below: "pixels", "texels", "of 1", ...
    std::uint64_t count;     ///< values that were compared
    double worst, rms;       ///< of |integer - double|
    double least, greatest;  ///< range of the doubles
    std::uint64_t saturated; ///< integers that stood at a limit of their range
    std::uint64_t flips;     ///< coordinates: fragments whose NEAREST texel is another one; else 0
};

/// Collects what SHADOW contexts draw on this thread, from its construction to its end. Reports nest: only
/// the innermost one collects, and reports end in the reverse order of their beginning.
class StageReport {
  public:
    StageReport();
    ~StageReport();
    StageReport(const StageReport&) = delete;
    StageReport& operator=(const StageReport&) = delete;

    /// The stages that anything passed since the beginning or the last clear(), in the order of the pipeline.
    std::vector<StageError> stages() const;
    void clear();

  private:
    struct Records;
    std::unique_ptr<Records> records_;
};

/// What a context drew.
struct DrawnPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;   ///< bottom row first, as glReadPixels gives it
    std::vector<std::uint32_t> depth; ///< codes of the depth buffer; empty where there is none
    int depth_bits = 0;
};

/// Reads the draw surface of the current context whole. The state of GL is as it was before.
DrawnPicture read_picture();

/// What two pictures of one size have in common.
struct PictureError {
    std::uint64_t pixels = 0;           ///< compared
    std::uint64_t identical = 0;        ///< of them equal in RGB565
    int max_lsb = 0;                    ///< largest difference of a channel in steps of RGB565
    int max_255 = 0;                    ///< the same in 255ths
    double squares_565 = 0;             ///< sum of squared differences of the 565 values, scaled to 255ths
    double squares_888 = 0;             ///< the same of the 8-bit values
    std::uint32_t depth_steps = 0;      ///< largest difference of depths of one surface, in codes
    std::uint64_t order_flips = 0;      ///< pixels whose depths lie further apart: another surface is seen
    std::uint64_t compared_depths = 0;  ///< pixels whose depths were compared
    static constexpr double alike = 99; ///< decibels of what is identical

    double identical_percent() const;
    double psnr_565() const; ///< decibels
    double psnr_888() const;
    /// Frames of one run: sums and maxima.
    void add(const PictureError& other);
};

/// Depths further apart than this many codes are those of two surfaces. The depth of one surface is within a
/// code of its plane in every tier, where the vertices are the same.
inline constexpr std::uint32_t one_surface = 8;

/// Counts the pixels that `mask` marks, bottom row first; null: all. Pictures of two sizes have nothing in
/// common: no pixel is compared.
PictureError compare(const DrawnPicture& drawn, const DrawnPicture& reference,
                     const std::vector<bool>* mask = nullptr);

} // namespace spangle
