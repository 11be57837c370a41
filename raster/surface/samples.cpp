#include "raster/surface/samples.hpp"

#if SPANGLE_FEATURE_MULTISAMPLE

#include <bit>

#include "raster/surface/pixel.hpp"

namespace spangle::raster {

namespace {

/// The means of the fields of four words. `fields` masks the fields, which have two zero bits above each.
/// `halves` holds four times one half in each field.
constexpr std::uint32_t average(const std::uint32_t (&v)[sample_count], std::uint32_t fields,
                                std::uint32_t halves) {
    std::uint32_t sum = halves;
    for (const std::uint32_t word : v)
        sum += word & fields;
    return sum >> 2 & fields;
}

/// The means of R5 G6 B5 fields, which are spread over both halves of a word so that no field touches the
/// next.
constexpr std::uint32_t mean_565(const std::uint32_t (&v)[sample_count]) {
    std::uint32_t apart[sample_count] = {};
    for (unsigned i = 0; i < sample_count; ++i)
        apart[i] = v[i] | v[i] << 16;
    const std::uint32_t sum = average(apart, 0x07E0F81F, 2u << 21 | 2u << 11 | 2u);
    return (sum | sum >> 16) & 0xFFFF;
}
constexpr std::uint32_t mean_bytes(const std::uint32_t (&v)[sample_count]) {
    std::uint32_t high[sample_count] = {};
    for (unsigned i = 0; i < sample_count; ++i)
        high[i] = v[i] >> 8;
    return average(v, 0x00FF00FF, 0x00020002) | average(high, 0x00FF00FF, 0x00020002) << 8;
}

class Resolve {
  public:
    explicit Resolve(const Surface& s) : resolved_(s) {
        for (unsigned i = 0; i < sample_count; ++i)
            samples_[i] = sample_of(s, i);
    }

    void row(std::int32_t y, RowSpan span) const {
        mark_damage(resolved_, y, span.begin, span.end);
        switch (resolved_.format) {
        case PixelFormat::rgb565_be:
        case PixelFormat::rgb565_le:
            return words<std::uint16_t>(y, span);
        case PixelFormat::rgba8888:
            return words<std::uint32_t>(y, span);
        default:
            for (std::int32_t x = span.begin; x < span.end; ++x)
                pixel(x, y);
        }
    }

  private:
    template <class Word> void words(std::int32_t y, RowSpan span) const {
        constexpr std::intptr_t bytes = sizeof(Word);
        const bool swaps = bytes == 2 && (resolved_.format == PixelFormat::rgb565_be) ==
                                             (std::endian::native == std::endian::little);
        for (std::int32_t x = span.begin; x < span.end; ++x) {
            std::uint32_t v[sample_count];
            for (unsigned i = 0; i < sample_count; ++i) {
                Word word;
                __builtin_memcpy(&word, samples_[i].color_row(y) + x * bytes, sizeof word);
                v[i] = swaps ? swap_bytes_16(word) : word;
            }
            const std::uint32_t found = bytes == 2 ? mean_565(v) : mean_bytes(v);
            const auto word = static_cast<Word>(swaps ? swap_bytes_16(found) : found);
            __builtin_memcpy(resolved_.color_row(y) + x * bytes, &word, sizeof word);
        }
    }

    void pixel(std::int32_t x, std::int32_t y) const {
        std::uint32_t k[4] = {};
        for (const Surface& sample : samples_) {
            const StoredColor color = read_color(sample, x, y);
            for (int c = 0; c < 4; ++c)
                k[c] += color.c[c].k;
        }
        for (std::uint32_t& sum : k)
            sum = (sum + sample_count / 2) / sample_count;
        write_color(resolved_, x, y, k);
    }

    const Surface& resolved_;
    Surface samples_[sample_count];
};

} // namespace

Surface sample_of(const Surface& s, unsigned sample) {
    const Samples& samples = *s.samples;
    const auto i = static_cast<std::ptrdiff_t>(sample);
    Surface out = s;
    out.color = samples.color + i * samples.next_color;
    out.color_stride = samples.color_stride;
    if (s.depth != nullptr)
        out.depth = s.depth + i * samples.next_depth;
#if SPANGLE_EXTENTS
    out.extents = nullptr;
    out.touched = samples.unresolved;
    out.touched_step = 1;
#endif
    out.samples = nullptr;
    return out;
}

void clear_samples(const Surface& s, const ClearRequest& request) {
    if (s.samples == nullptr)
        return clear(s, request);
    each_sample(s, [&](const Surface& sample, unsigned) { clear(sample, request); });
    if (!clears_all(s, request))
        return;
    ClearRequest shown = request;
    shown.depth = false;
    shown.stencil_mask = 0;
    clear(s, shown);
    const Rect all = s.area();
    for (std::int32_t y = all.y; y < all.y + all.h; ++y)
        s.samples->unresolved[y] = RowSpan{};
}

void resolve(const Surface& s) {
    if (s.samples == nullptr)
        return;
    const Resolve resolved(s);
    const Rect all = s.area();
    for (std::int32_t y = all.y; y < all.y + all.h; ++y) {
        RowSpan& row = s.samples->unresolved[y];
        if (row.begin < row.end)
            resolved.row(y, row);
        row = RowSpan{};
    }
}

} // namespace spangle::raster

#endif
