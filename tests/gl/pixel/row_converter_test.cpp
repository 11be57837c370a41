// Compares the conversion of rows through codes with that of single pixels (Groups, fetch and pack_pixel).
// Tests every pair of layouts, every value of small components, every surface, and whole commands under every
// pixel storage.
#include "gl/pixel/row_converter.hpp"

#if SPANGLE_ROW_CODES

#include <random>

#include "gl/pixel/fetch.hpp"
#include "gl/pixel/row_elements.hpp"
#include "gl/texture/internal_format.hpp"
#include "tests/gl/pixel/client_oracle.hpp"
#include "tests/gl/pixel/pixel_canvas.hpp"

namespace spangle::gl::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr GLenum color_formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA,     GL_RGB,
                                    GL_BGR, GL_RGBA,  GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
constexpr GLint internal_formats[] = {GL_ALPHA8,  GL_LUMINANCE8, GL_INTENSITY8, GL_LUMINANCE8_ALPHA8,
                                      GL_RGB565,  GL_RGB8,       GL_RGBA8,      GL_RGBA4,
                                      GL_RGB5_A1, GL_R3_G3_B2};

struct Client {
    GLenum format, type;
    PixelLayout layout;
};
std::vector<Client> clients() {
    std::vector<Client> all;
    std::vector<GLenum> types(std::begin(plain_types), std::end(plain_types));
    for (const PackedType& p : packed_types)
        types.push_back(p.type);
    for (const GLenum format : color_formats)
        for (const GLenum type : types)
            if (PixelLayout layout; pixel_layout(format, type, layout) == GL_NO_ERROR)
                all.push_back({format, type, layout});
    return all;
}

std::vector<PixelLayout> texel_layouts() {
    std::vector<PixelLayout> all;
    for (unsigned f = 0; f <= static_cast<unsigned>(raster::TexelFormat::rgb332); ++f)
        all.push_back(texel_layout(static_cast<raster::TexelFormat>(f)));
    return all;
}

Bytes random_bytes(std::mt19937& random, std::size_t count) {
    Bytes bytes(count);
    for (std::uint8_t& b : bytes)
        b = static_cast<std::uint8_t>(random());
    return bytes;
}

/// Returns random groups; most floats lie about [0, 1], the others have random bits.
Bytes random_groups(std::mt19937& random, const PixelLayout& layout, bool swap, std::size_t bytes) {
    Bytes groups = random_bytes(random, bytes);
    for (std::size_t i = 0; layout.kind == ElementKind::real && i + 4 <= bytes; i += 4)
        if (random() % 8 != 0)
            store_element(
                &groups[i], 4, swap,
                std::bit_cast<std::uint32_t>(static_cast<float>(random() % 3000) / 2000.0f - 0.25f));
    return groups;
}

/// Converts the pixels one by one.
Bytes converted(const PixelLayout& from, bool from_swap, const std::uint8_t* groups, std::size_t count,
                const PixelLayout& to, bool to_swap, Bytes out) {
    PixelStore store{};
    store.swap_bytes = from_swap;
    const Groups source(from, store);
    for (std::size_t i = 0; i < count; ++i)
        pack_pixel(to, to_swap, source.color(groups, i), &out[i * to.group_bytes()]);
    return out;
}

void expect_same(const PixelLayout& from, bool from_swap, const PixelLayout& to, bool to_swap,
                 std::mt19937& random) {
    RowConverter row(GroupForm(from, from_swap), GroupForm(to, to_swap));
    if (!row.is_supported())
        return;
    const std::size_t count = 1 + random() % 150, offset = random() % 3;
    const Bytes groups = random_groups(random, from, from_swap, count * from.group_bytes());
    const Bytes before = random_bytes(random, count * to.group_bytes() + 40);
    Bytes in(offset);
    in.insert(in.end(), groups.begin(), groups.end());
    in.shrink_to_fit(); // the sanitizer then reports reads behind the last group
    Bytes out(before);
    row.convert_row(in.data() + offset, out.data(), static_cast<std::int32_t>(count));
    ASSERT_EQ(out, converted(from, from_swap, groups.data(), count, to, to_swap, before));
}

TEST(RowScale, IsTheNearestCode) {
    for (unsigned from = 1; from <= 8; ++from)
        for (unsigned to = 1; to <= 8; ++to)
            for (std::uint32_t code = 0; code <= all_ones(from); ++code) {
                const CodeScale s = code_scales[from][to];
                const std::uint32_t product = code * s.factor + s.half;
                ASSERT_LT(product, 1u << 16);
                ASSERT_EQ(product >> s.shift, rescale(code, from, to)) << from << " " << to << " " << code;
            }
}

TEST(RowConverter, ClientImagesBecomeTexels) {
    std::mt19937 random(1);
    for (const Client& from : clients())
        for (const PixelLayout& to : texel_layouts())
            for (int i = 0; i < 4; ++i) {
                EXPECT_TRUE(RowConverter(GroupForm(from.layout, false), GroupForm(to, false)).is_supported());
                SCOPED_TRACE(testing::Message() << std::hex << from.format << " " << from.type);
                expect_same(from.layout, i % 2 != 0, to, false, random);
            }
}

TEST(RowConverter, TexelsAndClientImagesBecomeClientImages) {
    std::mt19937 random(2);
    std::vector<PixelLayout> sources = texel_layouts();
    for (const Client& from : clients())
        sources.push_back(from.layout);
    for (const PixelLayout& from : sources)
        for (const Client& to : clients()) {
            SCOPED_TRACE(testing::Message() << std::hex << to.format << " " << to.type);
            expect_same(from, random() % 2 != 0, to.layout, random() % 2 != 0, random);
        }
}

/// Tests all words of 16 bits; in other groups each component takes all its values.
TEST(RowConverter, EveryValueOfSmallComponents) {
    Bytes words(2u << 16);
    for (unsigned w = 0; w < 1u << 16; ++w) {
        words[2 * w] = static_cast<std::uint8_t>(w);
        words[2 * w + 1] = static_cast<std::uint8_t>(w >> 8);
    }
    Bytes bytes;
    for (unsigned v = 0; v < 256; ++v)
        for (unsigned i = 0; i < 4; ++i)
            bytes.push_back(static_cast<std::uint8_t>(v + 64 * i));
    for (const Client& from : clients()) {
        const std::size_t size = from.layout.group_bytes();
        if (fields_of(from.layout, false).bytes == 0)
            continue;
        const Bytes& groups = size == 2 ? words : bytes;
        const std::size_t count = groups.size() / size;
        for (const PixelLayout& to : texel_layouts()) {
            RowConverter row(GroupForm(from.layout, false), GroupForm(to, false));
            Bytes out(count * to.group_bytes());
            row.convert_row(groups.data(), out.data(), static_cast<std::int32_t>(count));
            ASSERT_EQ(out, converted(from.layout, false, groups.data(), count, to, false, Bytes(out.size())))
                << std::hex << from.format << " " << from.type;
        }
    }
}

/// Readers return units of colours, or words of a 565 surface, which are the upper bits of 255ths.
TEST(RowReader, UnitsAndCutBitsAreThoseOfEachComponent) {
    constexpr GroupFields words{2, false, true, {{11, 5}, {5, 6}, {0, 5}}};
    std::mt19937 random(3);
    for (const Client& from : clients()) {
        const Groups source(from.layout);
        const Bytes groups = random_groups(random, from.layout, false, row_chunk * from.layout.group_bytes());
        const GroupForm form(from.layout, false);
        std::uint8_t out[2 * row_chunk];
        write_fields(RowReader(form, bits_of(words)).read(groups.data(), row_chunk), words, row_chunk, out);
        std::uint32_t units[4 * row_chunk] = {};
        if (form.fields.bytes != 0) {
            RowReader reader(form, own_bits(form.fields));
            write_units(reader.read(groups.data(), row_chunk), reader.bits(), row_chunk, units);
        } else {
            read_units(groups.data(), from.layout, false, row_chunk, units);
        }
        for (unsigned i = 0; i < row_chunk; ++i) {
            const Pixel pixel = source.color(groups.data(), i);
            const Component(&v)[4] = pixel.value;
            ASSERT_EQ(out[2 * i] | out[2 * i + 1] << 8,
                      static_cast<int>(code_of(v[0], 8) >> 3 << 11 | code_of(v[1], 8) >> 2 << 5 |
                                       code_of(v[2], 8) >> 3))
                << std::hex << from.format << " " << from.type;
            for (unsigned c = 0; c < 4; ++c)
                ASSERT_EQ(units[4 * i + c], color_units_of(v[c]));
        }
    }
}

TEST(SurfaceConverter, EverySurfaceIsThatOfItsPixels) {
    std::mt19937 random(4);
    const PixelModeState plain{};
    const Transfer transfer(plain);
    for (unsigned f = 0; f < static_cast<unsigned>(PixelFormat::index8); ++f) {
        raster::Surface s;
        s.format = static_cast<PixelFormat>(f);
        s.width = 151;
        s.height = 9;
        const std::int32_t stride = row_bytes(s.format, s.width);
        Bytes memory =
            random_bytes(random, static_cast<std::size_t>(stride * stored_rows(s.format, s.height)));
        s.color = memory.data();
        s.color_stride = stride;
        for (const Client& to : clients())
            for (int i = 0; i < 4; ++i) {
                const bool swap = random() % 2 != 0;
                SurfaceConverter converter(s.format, GroupForm(to.layout, swap));
                if (!converter.is_supported())
                    continue;
                const auto x = static_cast<std::int32_t>(random() % 40),
                           y = static_cast<std::int32_t>(random() % 9),
                           count = static_cast<std::int32_t>(1 + random() % 110);
                const Bytes before =
                    random_bytes(random, static_cast<std::size_t>(count + 3) * to.layout.group_bytes());
                Bytes out(before), wanted(before);
                converter.convert(s, x, y, count, out.data());
                for (std::int32_t n = 0; n < count; ++n)
                    pack_pixel(to.layout, swap, fetch(s, transfer, Content::color, x + n, y).color,
                               &wanted[static_cast<std::uint32_t>(n) * to.layout.group_bytes()]);
                ASSERT_EQ(out, wanted) << "surface " << f << std::hex << " " << to.format << " " << to.type;
            }
    }
}

/// All commands convert rows through codes: images go in and come back under every pixel storage.
TEST(RowCommands, ImagesGoInAndComeBackUnderEveryStorage) {
    std::mt19937 random(5);
    PixelCanvas canvas;
    for (const Client& from : clients())
        for (const GLint internal : internal_formats) {
            const int width = 3 + static_cast<int>(random() % 13),
                      height = 3 + static_cast<int>(random() % 5);
            const Store in = Store::random(random, width), out = Store::random(random, width);
            in.apply();
            out.apply(true);
            const ClientOracle image(from.format, from.type, width, height, in);
            const Bytes memory = random_groups(random, from.layout, in.swap, image.bytes());
            glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            const int x = static_cast<int>(random() % 3), y = static_cast<int>(random() % 2),
                      w = width - x - 1, h = height - y;
            glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, w, h, from.format, from.type, memory.data());

            const Client to = clients()[random() % clients().size()];
            const ClientOracle back(to.format, to.type, width, height, out);
            Bytes got(back.bytes(), 0xA5), wanted(got);
            glGetTexImage(GL_TEXTURE_2D, 0, to.format, to.type, got.data());

            // Converts by single pixels: the texels first, then what is read from them.
            GLint token = internal;
            raster::TexelFormat format;
            ASSERT_TRUE(texel_format_of(token, PixelFormat::rgba8888, format));
            const PixelLayout kept = texel_layout(format);
            PixelStore unpack{}, pack{};
            unpack.swap_bytes = in.swap;
            const auto set = [](PixelStore& store, const Store& s) {
                store.row_length = s.row_length;
                store.skip_rows = s.skip_rows;
                store.skip_pixels = s.skip_pixels;
                store.alignment = s.alignment;
            };
            set(unpack, in);
            set(pack, out);
            PixelLayout as = to.layout;
            if (as.channel[0] == Channel::luminance)
                as.channel[0] = Channel::red; // texels of luminance return red only (table 6.1)
            const ImageRows from_rows = image_rows(unpack, from.layout, w),
                            to_rows = image_rows(pack, as, width);
            const Groups groups(from.layout, unpack), texels(kept);
            for (int m = 0; m < height; ++m)
                for (int n = 0; n < width; ++n) {
                    std::uint8_t texel[4] = {};
                    if (n >= x && n < x + w && m >= y)
                        pack_pixel(kept, false,
                                   groups.color(memory.data() + from_rows.skip +
                                                    static_cast<std::size_t>(m - y) * from_rows.stride,
                                                static_cast<std::size_t>(n - x)),
                                   texel);
                    pack_pixel(as, out.swap, texels.color(texel, 0),
                               wanted.data() + to_rows.skip + static_cast<std::size_t>(m) * to_rows.stride +
                                   static_cast<std::size_t>(n) * as.group_bytes());
                }
            ASSERT_EQ(got, wanted) << std::hex << from.format << " " << from.type << " " << internal << " "
                                   << to.format << " " << to.type;
        }
}

/// Zoomed by -1, a mirrored image is drawn group by group, and both pictures are the same, also dithered.
TEST(RowCommands, PixelsAreDrawnAsGroupsAre) {
    std::mt19937 random(6);
    for (const PixelFormat format : {PixelFormat::rgb565_be, PixelFormat::rgb565_le, PixelFormat::rgb888,
                                     PixelFormat::rgba8888, PixelFormat::rgb666, PixelFormat::rgb332}) {
        PixelCanvas canvas({.format = format, .width = 150, .height = 6});
        for (const Client& from : clients())
            for (const bool dithers : {false, true}) {
                (dithers ? glEnable : glDisable)(GL_DITHER);
                const int width = 1 + static_cast<int>(random() % 140);
                const std::size_t size = from.layout.group_bytes();
                const bool swap = random() % 2 != 0;
                glPixelStorei(GL_UNPACK_SWAP_BYTES, swap);
                const Bytes image =
                    random_groups(random, from.layout, swap, static_cast<std::size_t>(width) * size);
                Bytes mirrored;
                for (int n = width - 1; n >= 0; --n)
                    mirrored.insert(mirrored.end(), image.begin() + n * static_cast<std::ptrdiff_t>(size),
                                    image.begin() + (n + 1) * static_cast<std::ptrdiff_t>(size));
                const int x = static_cast<int>(random() % 8);
                glClear(GL_COLOR_BUFFER_BIT);
                glRasterPos2i(x, 1);
                glDrawPixels(width, 1, from.format, from.type, image.data());
                const Bytes picture = canvas.color;
                glClear(GL_COLOR_BUFFER_BIT);
                glRasterPos2i(x + width, 1);
                glPixelZoom(-1, 1);
                glDrawPixels(width, 1, from.format, from.type, mirrored.data());
                glPixelZoom(1, 1);
                ASSERT_EQ(canvas.color, picture)
                    << static_cast<int>(format) << std::hex << " " << from.format << " " << from.type;
            }
    }
}

} // namespace
} // namespace spangle::gl::test

#endif
