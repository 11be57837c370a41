// Measures how far a picture is from the reference picture, which is drawn in double, and how much each stage
// of the pipeline contributes. For host programs; link Spangle::gl_reference. docs/trade.md shows a whole
// program.
//
// A context has the accuracy of its config. eglChooseConfig takes EGL_PRECISION_SPANGLE with one of these:
// - EGL_PRECISION_EXACT_SPANGLE, EGL_PRECISION_BALANCED_SPANGLE, EGL_PRECISION_FAST_SPANGLE: the three
//   [tiers](docs/glossary.md#tier);
// - EGL_PRECISION_DOUBLE_SPANGLE: the reference picture;
// - EGL_PRECISION_SHADOW_SPANGLE, ..._SHADOW_BALANCED_SPANGLE, ..._SHADOW_FAST_SPANGLE: the picture of a
//   tier, computed with a double beside every number.
//
// DOUBLE and SHADOW configs exist once use_reference_engines() has been called.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace spangle {

/// Adds the configs of DOUBLE and SHADOW precision to this program. It must be called before eglChooseConfig
/// asks for them. Further calls change nothing.
void use_reference_engines();

/// The error of one stage of the pipeline, which is the difference between its integers and the doubles that
/// were computed with them.
struct StageError {
    const char* stage;       ///< "window x", "coord 0", "fog factor", ...
    const char* unit;        ///< unit of the figures below: "pixels", "texels", "of 1", ...
    std::uint64_t count;     ///< values that were compared
    double worst, rms;       ///< largest and root mean square |integer - double|
    double least, greatest;  ///< range of the doubles
    std::uint64_t saturated; ///< integers that were at a limit of their range
    std::uint64_t flips;     ///< texture coordinates: fragments with another NEAREST texel; other stages: 0
};

/// Collects the errors of what SHADOW contexts draw on this thread, from construction to destruction. Reports
/// may be nested. Only the innermost report collects, and reports must end in the reverse order of their
/// beginning.
class StageReport {
  public:
    /// Begins to collect errors.
    StageReport();
    /// Stops collecting errors. A report that was collecting before this one goes on.
    ~StageReport();
    /// A report cannot be copied, since only one report collects at a time.
    StageReport(const StageReport&) = delete;
    /// A report cannot be assigned, since only one report collects at a time.
    StageReport& operator=(const StageReport&) = delete;

    /// The stages that compared any value since construction or the last clear(), in the order of the
    /// pipeline.
    std::vector<StageError> stages() const;
    /// Discards the errors that were collected.
    void clear();

  private:
    struct Records;
    std::unique_ptr<Records> records_;
};

/// The picture that a context has drawn.
struct DrawnPicture {
    int width = 0, height = 0;        ///< size in pixels
    std::vector<std::uint8_t> rgba;   ///< four bytes a pixel, bottom row first, as glReadPixels gives them
    std::vector<std::uint32_t> depth; ///< codes of the depth buffer; empty where there is none
    int depth_bits = 0;               ///< bits of a depth code
};

/// Reads the whole draw surface of the current context. The state of GL does not change.
DrawnPicture read_picture();

/// How much two pictures of the same size differ.
struct PictureError {
    std::uint64_t pixels = 0;           ///< pixels compared
    std::uint64_t identical = 0;        ///< pixels that are equal in RGB565
    int max_lsb = 0;                    ///< largest difference of a channel, in steps of RGB565
    int max_255 = 0;                    ///< largest difference of a channel, in 255ths
    double squares_565 = 0;             ///< sum of squared differences of RGB565 values, in 255ths
    double squares_888 = 0;             ///< sum of squared differences of 8-bit values, in 255ths
    std::uint32_t depth_steps = 0;      ///< largest difference of depths up to one_surface, in codes
    std::uint64_t order_flips = 0;      ///< pixels whose depths differ more: another surface is seen
    std::uint64_t compared_depths = 0;  ///< pixels whose depths were compared
    static constexpr double alike = 99; ///< decibels of identical pictures

    /// Pixels that are equal in RGB565, in percent; 100 where nothing was compared.
    double identical_percent() const;
    double psnr_565() const; ///< peak signal-to-noise ratio of RGB565 values, in decibels
    /// Peak signal-to-noise ratio of 8-bit values, in decibels.
    double psnr_888() const;
    /// Adds the error of another frame: counts and sums are added, maxima are taken.
    void add(const PictureError& other);
};

/// Depths that differ by more codes than this belong to two surfaces. Where vertices are the same, the depth
/// of one surface is within one code of its plane in every tier.
inline constexpr std::uint32_t one_surface = 8;

/// Compares the pixels that `mask` marks, bottom row first; null: all pixels. Where the two sizes differ, no
/// pixel is compared.
PictureError compare(const DrawnPicture& drawn, const DrawnPicture& reference,
                     const std::vector<bool>* mask = nullptr);

} // namespace spangle
