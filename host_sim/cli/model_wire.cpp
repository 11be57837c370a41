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

constexpr std::size_t most_listed = std::size_t{1} << 20; // notes, parts, pictures

class Packer {
  public:
    std::string bytes;

    template <class T> void number(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <class T> void list(const T& values) {
        static_assert(std::is_trivially_copyable_v<typename T::value_type>);
        number(std::uint64_t{values.size()});
        if (!values.empty())
            bytes.append(reinterpret_cast<const char*>(values.data()),
                         values.size() * sizeof(typename T::value_type));
    }
};

/// Nothing is allocated before the bytes that fill it are seen to be there.
class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : left_(bytes) {}

    bool good() const { return good_; }
    bool finished() const { return good_ && left_.empty(); }

    template <class T> void number(T& value) {
        if (take(sizeof value))
            std::memcpy(&value, taken_, sizeof value);
    }
    template <class T> void list(T& values, std::size_t most) {
        using Value = typename T::value_type;
        std::uint64_t count = 0;
        number(count);
        good_ = good_ && count <= most;
        if (!good_ || !take(static_cast<std::size_t>(count) * sizeof(Value)))
            return;
        values.resize(static_cast<std::size_t>(count));
        if (count != 0)
            std::memcpy(values.data(), taken_, values.size() * sizeof(Value));
    }
    /// How many of something follow.
    std::size_t count(std::size_t most) {
        std::uint64_t n = 0;
        number(n);
        good_ = good_ && n <= most;
        return good_ ? static_cast<std::size_t>(n) : 0;
    }
    /// A bool of any other value than 0 and 1 would be undefined.
    void flag(bool& value) {
        std::uint8_t byte = 0;
        number(byte);
        good_ = good_ && byte <= 1;
        value = byte == 1;
    }

  private:
    std::string_view left_;
    const char* taken_ = nullptr;
    bool good_ = true;

    bool take(std::size_t size) {
        good_ = good_ && size <= left_.size();
        if (!good_)
            return false;
        taken_ = left_.data();
        left_.remove_prefix(size);
        return true;
    }
};

template <std::size_t N> bool finite(const float (&values)[N]) {
    return std::all_of(values, values + N, [](float v) { return std::isfinite(v); });
}
bool finite(const std::array<float, 4>& values) {
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

bool drawable(const ModelPart& part, std::size_t images) {
    const auto corners = static_cast<std::size_t>(part.kind) + 1;
    return !part.indices.empty() && part.indices.size() % corners == 0 &&
           std::all_of(part.indices.begin(), part.indices.end(),
                       [&part](std::uint32_t i) { return i < part.vertices.size(); }) &&
           std::all_of(part.vertices.begin(), part.vertices.end(),
                       [](const ModelVertex& v) {
                           return finite(v.position) && finite(v.normal) && finite(v.texcoord) &&
                                  finite(v.color);
                       }) &&
           finite(part.diffuse) && finite(part.specular) && finite(part.emission) && part.shininess >= 0.0f &&
           part.shininess <= 128.0f && part.image >= -1 && part.image < static_cast<int>(images);
}

bool drawable(const ModelImage& image) {
    const auto side = [](int n) {
        return n > 0 && n <= sim::longest_side && std::has_single_bit(static_cast<unsigned>(n));
    };
    return side(image.width) && side(image.height) &&
           image.rgba.size() ==
               std::size_t{4} * static_cast<unsigned>(image.width) * static_cast<unsigned>(image.height);
}

void unpack_part(Unpacker& from, ModelPart& part) {
    std::uint8_t kind = 0;
    from.number(kind);
    part.kind = static_cast<ModelPart::Kind>(std::min<std::uint8_t>(kind, 2));
    from.list(part.vertices, most_vertices);
    from.list(part.indices, most_indices);
    from.number(part.diffuse);
    from.number(part.specular);
    from.number(part.emission);
    from.number(part.shininess);
    from.number(part.image);
    from.flag(part.colored);
}

void unpack_image(Unpacker& from, ModelImage& image) {
    from.number(image.width);
    from.number(image.height);
    from.list(image.rgba, 4 * most_texels);
    from.flag(image.translucent);
}

} // namespace

std::string pack(const ModelResult& result) {
    Packer to;
    const Model& model = result.model;
    to.list(result.error);
    to.list(model.name);
    to.number(std::uint64_t{model.triangles});
    to.number(std::uint64_t{model.notes.size()});
    for (const std::string& note : model.notes)
        to.list(note);
    to.number(std::uint64_t{model.images.size()});
    for (const ModelImage& image : model.images) {
        to.number(image.width);
        to.number(image.height);
        to.list(image.rgba);
        to.number(static_cast<std::uint8_t>(image.translucent ? 1 : 0));
    }
    to.number(std::uint64_t{model.parts.size()});
    for (const ModelPart& part : model.parts) {
        to.number(static_cast<std::uint8_t>(part.kind));
        to.list(part.vertices);
        to.list(part.indices);
        to.number(part.diffuse);
        to.number(part.specular);
        to.number(part.emission);
        to.number(part.shininess);
        to.number(part.image);
        to.number(static_cast<std::uint8_t>(part.colored ? 1 : 0));
    }
    return std::move(to.bytes);
}

std::string unpack(std::string_view bytes, ModelResult& result) {
    constexpr std::size_t longest_text = 1 << 20;
    Unpacker from(bytes);
    Model& model = result.model;
    from.list(result.error, longest_text);
    from.list(model.name, longest_text);
    std::uint64_t triangles = 0;
    from.number(triangles);
    model.triangles = static_cast<std::size_t>(triangles);
    for (std::size_t left = from.count(most_listed); left > 0 && from.good(); --left)
        from.list(model.notes.emplace_back(), longest_text);
    for (std::size_t left = from.count(most_listed); left > 0 && from.good(); --left)
        unpack_image(from, model.images.emplace_back());
    for (std::size_t left = from.count(most_listed); left > 0 && from.good(); --left)
        unpack_part(from, model.parts.emplace_back());
    const bool sound = from.finished() && model.triangles <= most_triangles &&
                       std::all_of(model.images.begin(), model.images.end(),
                                   [](const ModelImage& i) { return drawable(i); }) &&
                       std::all_of(model.parts.begin(), model.parts.end(), [&model](const ModelPart& part) {
                           return drawable(part, model.images.size());
                       });
    result.error = one_line(result.error);
    for (std::string& note : model.notes)
        note = one_line(note);
    if (sound)
        return "";
    result.model = {};
    return "leaves nonsense behind in its reader";
}

} // namespace spangle::cli
