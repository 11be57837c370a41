#include "host_sim/cli/model_wire.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

#include <spangle/sim/image.hpp>

#include "host_sim/cli/confined.hpp"

namespace spangle::cli {

namespace {

constexpr std::size_t most_listed = std::size_t{1} << 20; // entries of notes, parts, pictures
constexpr std::size_t longest_text = std::size_t{1} << 20;

class Packer {
  public:
    std::string bytes;

    template <class T> void number(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <class T> void list(const T& values, std::size_t) {
        static_assert(std::is_trivially_copyable_v<typename T::value_type>);
        size(values.size());
        if (!values.empty())
            bytes.append(reinterpret_cast<const char*>(values.data()),
                         values.size() * sizeof(typename T::value_type));
    }
    template <class T, class Fields> void each_field(const T& values, Fields fields) {
        size(values.size());
        for (const auto& value : values)
            fields(value);
    }
    void size(std::size_t value) { number(std::uint64_t{value}); }
    void flag(bool value) { number(static_cast<std::uint8_t>(value ? 1 : 0)); }
    void kind(ModelPart::Kind value) { number(static_cast<std::uint8_t>(value)); }
};

/// Reads fields from bytes. It allocates nothing before it has seen that the bytes to fill it are there.
class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

    bool is_valid() const { return is_valid_; }
    bool is_at_end() const { return is_valid_ && rest_.empty(); }

    template <class T> void number(T& value) {
        if (take(sizeof value))
            std::memcpy(&value, last_taken_, sizeof value);
    }
    template <class T> void list(T& values, std::size_t most) {
        using Value = typename T::value_type;
        std::uint64_t count = 0;
        number(count);
        is_valid_ = is_valid_ && count <= most;
        if (!is_valid_ || !take(static_cast<std::size_t>(count) * sizeof(Value)))
            return;
        values.resize(static_cast<std::size_t>(count));
        if (count != 0)
            std::memcpy(values.data(), last_taken_, values.size() * sizeof(Value));
    }
    template <class T, class Fields> void each_field(T& values, Fields fields) {
        std::uint64_t left = 0;
        number(left);
        is_valid_ = is_valid_ && left <= most_listed;
        for (; left > 0 && is_valid_; --left)
            fields(values.emplace_back());
    }
    void size(std::size_t& value) {
        std::uint64_t n = 0;
        number(n);
        value = static_cast<std::size_t>(n);
    }
    void kind(ModelPart::Kind& value) {
        std::uint8_t n = 0;
        number(n);
        value = static_cast<ModelPart::Kind>(std::min<std::uint8_t>(n, 2));
    }
    /// Reads a bool. A byte other than 0 and 1 is refused, because such a bool would be undefined.
    void flag(bool& value) {
        std::uint8_t byte = 0;
        number(byte);
        is_valid_ = is_valid_ && byte <= 1;
        value = byte == 1;
    }

  private:
    std::string_view rest_;
    const char* last_taken_ = nullptr;
    bool is_valid_ = true;

    bool take(std::size_t size) {
        is_valid_ = is_valid_ && size <= rest_.size();
        if (!is_valid_)
            return false;
        last_taken_ = rest_.data();
        rest_.remove_prefix(size);
        return true;
    }
};

template <std::size_t N> bool is_finite(const float (&values)[N]) {
    return std::all_of(values, values + N, [](float v) { return std::isfinite(v); });
}
bool is_finite(const std::array<float, 4>& values) {
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

bool is_drawable(const ModelPart& part, std::size_t images) {
    const auto corners = static_cast<std::size_t>(part.kind) + 1;
    return !part.indices.empty() && part.indices.size() % corners == 0 &&
           std::all_of(part.indices.begin(), part.indices.end(),
                       [&part](std::uint32_t i) { return i < part.vertices.size(); }) &&
           std::all_of(part.vertices.begin(), part.vertices.end(),
                       [](const ModelVertex& v) {
                           return is_finite(v.position) && is_finite(v.normal) && is_finite(v.texcoord) &&
                                  is_finite(v.color);
                       }) &&
           is_finite(part.diffuse) && is_finite(part.specular) && is_finite(part.emission) &&
           part.shininess >= 0.0f && part.shininess <= 128.0f && part.image >= -1 &&
           part.image < static_cast<int>(images);
}

bool is_drawable(const ModelImage& image) {
    const auto side = [](int n) {
        return n > 0 && n <= sim::longest_side && std::has_single_bit(static_cast<unsigned>(n));
    };
    return side(image.width) && side(image.height) &&
           image.rgba.size() ==
               std::size_t{4} * static_cast<unsigned>(image.width) * static_cast<unsigned>(image.height);
}

/// Visits the fields of an image in their order, for packing and unpacking alike.
template <class Wire, class Image> void image_fields(Wire& wire, Image& image) {
    wire.number(image.width);
    wire.number(image.height);
    wire.list(image.rgba, 4 * most_texels);
    wire.flag(image.translucent);
}

template <class Wire, class Part> void part_fields(Wire& wire, Part& part) {
    wire.kind(part.kind);
    wire.list(part.vertices, most_vertices);
    wire.list(part.indices, most_indices);
    wire.number(part.diffuse);
    wire.number(part.specular);
    wire.number(part.emission);
    wire.number(part.shininess);
    wire.number(part.image);
    wire.flag(part.colored);
}

template <class Wire, class Result> void result_fields(Wire& wire, Result& result) {
    auto& model = result.model;
    wire.list(result.error, longest_text);
    wire.list(model.name, longest_text);
    wire.size(model.triangles);
    wire.each_field(model.notes, [&wire](auto& note) { wire.list(note, longest_text); });
    wire.each_field(model.images, [&wire](auto& image) { image_fields(wire, image); });
    wire.each_field(model.parts, [&wire](auto& part) { part_fields(wire, part); });
}

} // namespace

std::string pack(const ModelResult& result) {
    Packer to;
    result_fields(to, result);
    return std::move(to.bytes);
}

std::string unpack(std::string_view bytes, ModelResult& result) {
    Unpacker from(bytes);
    result_fields(from, result);
    const Model& model = result.model;
    const bool sound = from.is_at_end() && model.triangles <= most_triangles &&
                       std::all_of(model.images.begin(), model.images.end(),
                                   [](const ModelImage& i) { return is_drawable(i); }) &&
                       std::all_of(model.parts.begin(), model.parts.end(), [&model](const ModelPart& part) {
                           return is_drawable(part, model.images.size());
                       });
    result.error = one_line(result.error);
    for (std::string& note : result.model.notes)
        note = one_line(note);
    if (sound)
        return "";
    result.model = {};
    return "leaves nonsense behind in its reader";
}

} // namespace spangle::cli
