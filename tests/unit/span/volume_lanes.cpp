// Places in volumes, cube maps and compared depths are the same integers for eight fragments at once as for
// one fragment after the other. Packets of one lane have the colours of their fragments.
#include <gtest/gtest.h>

#include "raster/chain/assemble.hpp"
#include "raster/ops/stage_volume_packet.hpp"
#include "tests/unit/span/any_texture.hpp"

namespace spangle::raster::test {
namespace {

std::uint32_t word(Random& random) {
    return random.below(0x10000) << 16 | random.below(0x10000);
}

/// Returns a random plane: of any size, constant, or at the ends of the range of 32 bits.
Span<Fixed>::Projective any_plane(Random& random) {
    const auto guarded = [&](std::uint32_t of) {
        return std::uint64_t{of} << guard_bits | random.below(1 << 16);
    };
    const auto value = [&] {
        const std::uint32_t size = word(random) >> random.below(32);
        return random.below(2) == 0 ? size : 0 - size;
    };
    const auto extreme = [&] { return std::uint32_t{0x80000000u} + random.below(5) - 2; };
    Span<Fixed>::Projective plane{};
    plane.value = guarded(random.below(12) == 0 ? extreme() : value());
    plane.dx = random.below(6) == 0 ? 0 : guarded(value() >> random.below(2));
    plane.dy = random.below(6) == 0 ? 0 : guarded(value());
    return plane;
}

/// The fragments of a packet, in one row or at random places.
struct PacketPlaces {
    std::int32_t x, n;
    const PacketRows* rows;
};

struct Case {
    FragmentState fragment;
    DrawState draw{};
    Span<Fixed> span{};
    PacketRows rows{span};
    PacketPlaces places{};
    bool shared;

    Case(Random& random, const Texture& texture) : shared(random.below(2) == 0) {
        fragment.unit[0].texture = &texture;
        draw.fragment = fragment;
        span.state = &draw;
        auto& unit = span.unit[0];
        unit.s = any_plane(random);
        unit.t = random.below(8) == 0 ? unit.s : any_plane(random); // components as large as each other
        unit.r = random.below(8) == 0 ? unit.t : any_plane(random);
        unit.q = any_plane(random);
        for (auto* dy : {&unit.s_dy, &unit.t_dy, &unit.r_dy, &unit.q_dy})
            *dy = any_plane(random).value;
        unit.exponent = static_cast<int>(random.below(60)) - 30;
        places.n = 1 + static_cast<std::int32_t>(random.below(packet_length));
        places.x = static_cast<std::int32_t>(random.below(64));
        for (std::int32_t i = 0; i < packet_length + host_lanes; ++i) {
            rows.x[i] = random.below(512) - 256;
            rows.y[i] = random.below(512) - 256;
        }
        places.rows = shared ? &rows : nullptr;
    }
    /// Returns the place of fragment i as VolumeCoords finds it.
    VolumePlace expected(std::int32_t i) {
        if (!shared)
            return VolumeCoords(span, 0).at(places.x + i);
        Span<Fixed> there = span; // a span whose anchor is the fragment
        auto& unit = there.unit[0];
        for (auto* plane : {&unit.s, &unit.t, &unit.r, &unit.q})
            plane->value =
                plane->at(static_cast<std::int32_t>(rows.x[i]), static_cast<std::int32_t>(rows.y[i]));
        return VolumeCoords(there, 0).at(0);
    }
};

TEST(VolumeLanes, PlacesAreThoseOfOneFragment) {
    Random random{94};
    int cubes = 0, volumes = 0, levels = 0, shared = 0, faces[6] = {};
    for (int round = 0; round < 20000; ++round) {
        const AnyTexture of(random);
        Case c(random, of.texture);
        VolumePlaces found;
        alignas(32) std::int32_t lod[packet_length];
        VolumeLanes<PacketPlaces>(c.places, c.span, 0).find(c.places.n, found, lod);
        for (std::int32_t i = 0; i < c.places.n; ++i) {
            const VolumePlace expected = c.expected(i);
            ASSERT_EQ(found.face[i], expected.face) << round << ' ' << i;
            ASSERT_EQ(found.s[i], expected.s) << round << ' ' << i;
            ASSERT_EQ(found.t[i], expected.t) << round << ' ' << i;
            if (of.texture.shape != TextureShape::cube) { // other shapes read two coordinates only
                ASSERT_EQ(found.r[i], expected.r) << round << ' ' << i;
            }
            ASSERT_EQ(lod[i], expected.lod) << round << ' ' << i;
            levels += expected.lod != 0 ? 1 : 0;
            if (of.texture.shape == TextureShape::cube)
                ++faces[expected.face];
        }
        cubes += of.texture.shape == TextureShape::cube ? 1 : 0;
        volumes += of.texture.shape == TextureShape::volume ? 1 : 0;
        shared += c.shared ? 1 : 0;
    }
    EXPECT_GT(cubes, 2000);
    EXPECT_GT(volumes, 2000);
    EXPECT_GT(shared, 5000);
    EXPECT_GT(levels, 100000);
    for (const int face : faces)
        EXPECT_GT(face, 5000);
}

/// Draws a packet by REPLACE, and each of its fragments by itself.
template <class N> void expect_packet(Random& random, Case& c) {
    c.draw.fragment.unit[0].env = TexEnv::replace;
    const TextureUnit& unit = c.draw.fragment.unit[0];
    const VolumeFunction<N> function(unit);
    const VolumeCoords coords(c.span, 0);
    Packet<N> packet;
    packet.x = c.places.x;
    packet.n = 1 + static_cast<std::int32_t>(random.below(packet_length));
    const typename N::Color before{1, 2, 3, 4};
    for (auto& color : packet.color)
        color = before;
    PacketTexture<N>::template run<0>(packet, c.span);
    for (std::int32_t i = 0; i < packet.n; ++i) {
        typename N::Color expected = before;
        apply_env<N>(TexEnv::replace, unit.texture->base, expected, function.sample(coords.at(packet.x + i)),
                     before);
        ASSERT_EQ(packet.color[i].r, expected.r) << i;
        ASSERT_EQ(packet.color[i].g, expected.g) << i;
        ASSERT_EQ(packet.color[i].b, expected.b) << i;
        ASSERT_EQ(packet.color[i].a, expected.a) << i;
    }
}

TEST(VolumeLanes, PacketsOfOneLaneAreTheirFragments) {
    Random random{95};
    for (int round = 0; round < 10000; ++round) {
        const AnyTexture of(random);
        if (!wants_r(of.texture))
            continue;
        Case c(random, of.texture);
        if (round % 2 == 0) // neighbours are near each other
            for (auto* plane : {&c.span.unit[0].s, &c.span.unit[0].t, &c.span.unit[0].r, &c.span.unit[0].q})
                plane->dx = static_cast<std::uint64_t>(static_cast<std::int64_t>(plane->value) >> 8);
        expect_packet<Balanced<1>>(random, c);
        expect_packet<Exact>(random, c);
    }
}

} // namespace
} // namespace spangle::raster::test
