#include "gl/list/mesh.hpp"

#if SPANGLE_FEATURE_LISTS

#include <cstring>

#include "gl/api/command.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/vertex/current_element.hpp"
#include "gl/vertex/engine.hpp"

namespace spangle::gl::list {

namespace {

/// Header of a mesh's record. It is followed by an ArrayHeader for each enabled array, the elements of these
/// arrays, and the indices.
struct Header {
    Word words; ///< number of words of the record
    Word mode, count;
    Word arrays;     ///< number of enabled arrays
    Word vertices;   ///< number of elements of each array
    Word index_type; ///< GL_NONE: elements are drawn in order, without indices
};
/// An array of the record. `slot` is its number in the order of each_array().
struct ArrayHeader {
    Word slot, size, type;
};
constexpr std::uint32_t header_words = sizeof(Header) / sizeof(Word),
                        array_words = sizeof(ArrayHeader) / sizeof(Word);

std::uint32_t rounded_words(std::size_t bytes) {
    return static_cast<std::uint32_t>((bytes + sizeof(Word) - 1) / sizeof(Word));
}

std::size_t bytes_of_element(GLint size, GLenum type) {
    return static_cast<std::size_t>(size) * bytes_of(type);
}
/// Returns the words of an element. Each element begins at a word.
std::uint32_t words_of_element(GLint size, GLenum type) {
    return rounded_words(bytes_of_element(size, type));
}

/// Calls f(array, slot) for each enabled array.
template <class Arrays, class F> void each_used(Arrays& arrays, F f) {
    Word slot = 0;
    each_array(arrays, [&](auto& array) {
        if (array.on())
            f(array, slot);
        ++slot;
    });
}

/// Chooses how elements are stored: those from the lowest to the highest index, with indices, or each in
/// drawing order. The second way is taken if it needs no more words.
struct Layout {
    std::uint32_t lowest = 0, vertices = 0;
    GLenum index_type = GL_NONE;
    std::uint64_t words = 0; ///< words of elements and indices together

    Layout(std::uint32_t count, const Indices& indices, std::uint32_t element) : vertices(count) {
        words = std::uint64_t{count} * element;
        if (indices.type == GL_NONE || count == 0) {
            lowest = indices.first;
            return;
        }
        std::uint32_t low = UINT32_MAX, high = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t index = indices.at(i);
            low = index < low ? index : low;
            high = index > high ? index : high;
        }
        const std::uint32_t range = high - low;
        const GLenum type = range <= UINT8_MAX    ? GL_UNSIGNED_BYTE
                            : range <= UINT16_MAX ? GL_UNSIGNED_SHORT
                                                  : GL_UNSIGNED_INT;
        const std::uint64_t indexed =
            (std::uint64_t{range} + 1) * element + rounded_words(std::size_t{count} * bytes_of(type));
        if (indexed >= words)
            return;
        lowest = low;
        vertices = range + 1;
        index_type = type;
        words = indexed;
    }
};

void copy_elements(const ClientArray& array, const Layout& layout, const Indices& indices,
                   unsigned char* to) {
    const std::size_t bytes = bytes_of_element(array.size, array.type),
                      step = words_of_element(array.size, array.type) * sizeof(Word),
                      stride = array.stride != 0 ? static_cast<std::size_t>(array.stride) : bytes;
    const bool in_turn = layout.index_type == GL_NONE && indices.type != GL_NONE;
    const auto* const from = static_cast<const unsigned char*>(array.pointer);
    for (std::uint32_t i = 0; i < layout.vertices; ++i, to += step)
        std::memcpy(to, from + stride * (in_turn ? indices.at(i) : layout.lowest + i), bytes);
}

void copy_indices(const Layout& layout, std::uint32_t count, const Indices& indices, unsigned char* to) {
    const unsigned bytes = bytes_of(layout.index_type);
    for (std::uint32_t i = 0; i < count; ++i, to += bytes) {
        const std::uint32_t index = indices.at(i) - layout.lowest;
        const auto narrow = static_cast<std::uint16_t>(index);
        if (bytes == 1)
            *to = static_cast<unsigned char>(index);
        else
            std::memcpy(to, bytes == 2 ? static_cast<const void*>(&narrow) : &index, bytes);
    }
}

/// Makes the arrays of a record the context's vertex arrays during the lifetime of this object.
class MeshArrays {
  public:
    MeshArrays(Context& context, const Header& header, const Word* at) : context_(context) {
        std::memcpy(static_cast<void*>(&saved_arrays_), &context.arrays, sizeof saved_arrays_);
        each_array(context.arrays, [](ClientArray& array) { array.enabled = false; });
        context.arrays.buffered = false;
        const Word* data = at + std::size_t{header.arrays} * array_words;
        for (Word i = 0; i < header.arrays; ++i, at += array_words) {
            ArrayHeader array;
            std::memcpy(&array, at, sizeof array);
            const std::uint32_t words = words_of_element(static_cast<GLint>(array.size), array.type);
            Word slot = 0;
            each_array(context.arrays, [&](ClientArray& to) {
                if (slot++ != array.slot)
                    return;
                to.enabled = true;
                to.size = static_cast<GLint>(array.size);
                to.type = array.type;
                to.stride = static_cast<GLsizei>(words * sizeof(Word));
                to.pointer = data;
                to.buffer = nullptr;
            });
            data += std::size_t{words} * header.vertices;
        }
        indices_ = {.type = header.index_type, .data = data};
    }
    ~MeshArrays() { std::memcpy(static_cast<void*>(&context_.arrays), &saved_arrays_, sizeof saved_arrays_); }
    MeshArrays(const MeshArrays&) = delete;
    MeshArrays& operator=(const MeshArrays&) = delete;

    const Indices& indices() const { return indices_; }

  private:
    Context& context_;
    ArraysState saved_arrays_;
    Indices indices_;
};

} // namespace

void record_mesh(Context& context, const Player* player, GLenum mode, std::uint32_t count,
                 const Indices& indices) {
    Header header{0, mode, count, 0, 0, GL_NONE};
    std::uint32_t element = 0;
    each_used(context.arrays, [&](const ClientArray& array, Word) {
        element += words_of_element(array.size, array.type);
        ++header.arrays;
    });
    const Layout layout(count, indices, element);
    const std::uint64_t words = header_words + std::uint64_t{header.arrays} * array_words + layout.words;
    if (words > UINT32_MAX / (2 * sizeof(Word))) {
        context.list.recorder.out_of_memory = true;
        return;
    }
    header.words = static_cast<Word>(words);
    header.vertices = layout.vertices;
    header.index_type = layout.index_type;
    Word* to = record(context, player, header.words);
    if (to == nullptr)
        return;
    std::memcpy(to, &header, sizeof header);
    to += header_words;
    each_used(context.arrays, [&](const ClientArray& array, Word slot) {
        const ArrayHeader own = {slot, static_cast<Word>(array.size), array.type};
        std::memcpy(to, &own, sizeof own);
        to += array_words;
    });
    each_used(context.arrays, [&](const ClientArray& array, Word) {
        copy_elements(array, layout, indices, reinterpret_cast<unsigned char*>(to));
        to += std::size_t{words_of_element(array.size, array.type)} * layout.vertices;
    });
    if (layout.index_type != GL_NONE)
        copy_indices(layout, count, indices, reinterpret_cast<unsigned char*>(to));
}

const Word* play_mesh(Context& context, const Word* words, const CommandText* text) {
    Header header;
    std::memcpy(&header, words, sizeof header);
    const Word* const next = words + header.words;
    if (!allowed_outside(context, text))
        return next;
    const CurrentStateGuard kept(context);
    cmd::Begin(context, header.mode);
    if (!context.inside_begin_end())
        return next;
    const MeshArrays arrays(context, header, words + header_words);
    context.engine->elements(context, header.count, arrays.indices());
    cmd::End(context);
    return next;
}

} // namespace spangle::gl::list

#endif
