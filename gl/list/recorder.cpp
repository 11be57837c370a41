// Writes display lists: records into chunks, and vertices into runs.
//
// A run is one record for any number of vertices with the same attributes. It has a header and, for each
// vertex, its given attributes and its position. Attributes are colour (4 words), normal (3), and texture
// coordinates (2 or 4); a position has 2, 3 or 4 words. Attributes are held back until a vertex takes them,
// or until another command must follow them in the list.
#include "gl/context/features.hpp"

#if SPANGLE_FEATURE_LISTS

#include <cstring>

#include "gl/api/command.hpp"
#include "gl/api/explain.hpp"
#include "gl/api/generated/commands.hpp"
#include "gl/context/arena.hpp"
#include "gl/context/reach.hpp"
#include "gl/context/share_group.hpp"
#include "gl/list/chunk.hpp"
#include "gl/list/play.hpp"
#include "gl/vertex/engine.hpp"

namespace spangle::gl::list {

namespace {

enum Field : std::uint32_t {
    field_color = 1,
    field_normal = 2,
    field_tex2 = 4,
    field_tex4 = 8,
    field_position_shift = 4, ///< the bits from here on count the components of the position, 2 to 4
};

constexpr std::uint32_t count_bits = 24;
constexpr Word count_mask = (Word{1} << count_bits) - 1;

constexpr std::uint32_t words_per_vertex(std::uint32_t fields) {
    return (fields & field_color ? 4 : 0) + (fields & field_normal ? 3 : 0) + (fields & field_tex2 ? 2 : 0) +
           (fields & field_tex4 ? 4 : 0) + (fields >> field_position_shift);
}

/// Plays the link at the end of a chunk, which leads to the next chunk.
const Word* play_link(Context&, const Word* words) {
    const Word* next;
    std::memcpy(&next, words, sizeof next);
    return next;
}

/// Sets the attributes of a vertex. Returns where its position begins.
const Word* play_attributes(Context& context, std::uint32_t fields, const Word* words) {
    if (fields & field_color) {
        cmd::Color(context, {words[0]}, {words[1]}, {words[2]}, {words[3]});
        words += 4;
    }
    if (fields & field_normal) {
        cmd::Normal(context, {words[0]}, {words[1]}, {words[2]});
        words += 3;
    }
    if (fields & field_tex2) {
        cmd::TexCoord(context, {words[0]}, {words[1]}, numeric::zero, numeric::one);
        words += 2;
    } else if (fields & field_tex4) {
        cmd::TexCoord(context, {words[0]}, {words[1]}, {words[2]}, {words[3]});
        words += 4;
    }
    return words;
}

} // namespace

const Word* play_run(Context& context, const Word* words) {
    const Word header = *words++;
    const std::uint32_t fields = header >> count_bits, components = fields >> field_position_shift;
    const bool attributes = (fields & ((1u << field_position_shift) - 1)) != 0;
    // Outside of Begin/End, vertices have no effect, as in cmd::Vertex().
    const auto vertex = context.inside_begin_end() ? context.engine->vertex : nullptr;
    for (Word left = header & count_mask; left != 0; --left) {
        if (attributes)
            words = play_attributes(context, fields, words);
        if (vertex != nullptr)
            vertex(context, {words[0]}, {words[1]}, components > 2 ? Real{words[2]} : numeric::zero,
                   components > 3 ? Real{words[3]} : numeric::one);
        words += components;
    }
    return words;
}

namespace {

void store_player(Word* to, const Player* player) {
    std::memcpy(to, &player, sizeof player);
}

/// Appends a chunk with room for a record of `words` words. False: the arena has no room.
bool grow_chunk(Context& context, std::uint32_t words) {
    ListRecorder& r = context.list.recorder;
    constexpr std::uint32_t first_words = 64, most_words = 4096;
    std::uint32_t size = r.last == nullptr ? first_words : r.last->words * 2;
    size = size > most_words ? most_words : size;
    size = size < words + link_words ? words + link_words : size;
    auto* chunk =
        static_cast<Chunk*>(context.arena->allocate(sizeof(Chunk) + std::size_t{size} * sizeof(Word)));
    if (chunk == nullptr) {
        r.out_of_memory = true;
        return false;
    }
    chunk->next = nullptr;
    chunk->words = size;
    if (r.last != nullptr) {
        const Word* next = chunk->data();
        store_player(r.write, &player<&play_link>);
        std::memcpy(r.write + player_words, &next, sizeof next);
        r.last->next = chunk;
    } else {
        r.first = chunk;
    }
    r.last = chunk;
    r.write = chunk->data();
    r.end = r.write + (size - link_words);
    return true;
}

/// Appends a record and returns where its arguments go. Null: there is no memory.
Word* append(Context& context, const Player* player, std::uint32_t words) {
    ListRecorder& r = context.list.recorder;
    r.run = nullptr;
    const std::uint32_t needed = player_words + words;
    if (r.out_of_memory ||
        (static_cast<std::size_t>(r.end - r.write) < needed && !grow_chunk(context, needed)))
        return nullptr;
    store_player(r.write, player);
    Word* const arguments = r.write + player_words;
    r.write += needed;
    return arguments;
}

void store_reals(Word*& to, const Real* from, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i)
        *to++ = from[i].bits;
}

bool are_equal_bits(Real a, Real b) {
    return a.bits == b.bits;
}

/// Records pending attributes that no vertex has taken.
void flush_attributes(Context& context) {
    ListRecorder& r = context.list.recorder;
    const std::uint32_t pending = r.pending;
    r.pending = 0;
    if (pending & field_color)
        record_words<family::Color>(context, r.color[0], r.color[1], r.color[2], r.color[3]);
    if (pending & field_normal)
        record_words<family::Normal>(context, r.normal[0], r.normal[1], r.normal[2]);
    if (pending & (field_tex2 | field_tex4))
        record_words<family::TexCoord>(context, r.tex_coord[0], r.tex_coord[1], r.tex_coord[2],
                                       r.tex_coord[3]);
}

} // namespace

Word* record(Context& context, const Player* player, std::uint32_t words) {
    if (context.list.recorder.pending != 0)
        flush_attributes(context);
    return append(context, player, words);
}

void write(Context& context, const Command& command, const Arg* args) {
    const unsigned words = words_of(command);
    const std::uint32_t* tail = nullptr;
    std::uint32_t count = words, tail_words = 0;
    if (command.form == Form::params) {
        const Params& params = Passed<const Params&>::value(args[words]);
        tail_words = params.count;
        tail = &params.v[0].word;
        ++count;
    } else if (command.form == Form::matrix) {
        const Matrix16& matrix = Passed<const Matrix16&>::value(args[words]);
        tail_words = sizeof matrix.m / sizeof(Word);
        tail = &matrix.m[0].bits;
    }
    Word* to = record(context, &command, count + tail_words);
    if (to == nullptr)
        return;
    for (unsigned i = 0; i < words; ++i)
        *to++ = static_cast<Word>(args[i]); // NOLINT(clang-analyzer-*): as many as the command takes
    if (command.form == Form::params)
        *to++ = tail_words;
    if (tail_words != 0)
        std::memcpy(to, tail, tail_words * sizeof(Word));
}

namespace {

#if SPANGLE_MESSAGES
/// The parts of a recorded error's message.
struct RecordedError {
    const CommandText* text;
    const char* rule;
    Arg args[most_explained];
};
constexpr std::uint32_t sentence_words = sizeof(RecordedError) / sizeof(Word);
#else
constexpr std::uint32_t sentence_words = 0;
#endif

const Word* play_error(Context& context, const Word* words) {
    const bool inside = words[1] != 0;
#if SPANGLE_MESSAGES
    RecordedError recorded;
    std::memcpy(&recorded, words + 2, sizeof recorded);
    if (inside || allowed_outside(context, recorded.text)) {
        error(context, words[0], recorded.rule);
        explain_unpacked(context, *recorded.text, recorded.args, recorded.text->count);
    }
#else
    if (inside || allowed_outside(context, nullptr))
        error(context, words[0]);
#endif
    return words + 2 + sentence_words;
}

} // namespace

#if SPANGLE_MESSAGES
void record_error(Context& context, GLenum code, bool inside, const char* rule) {
    RecordedError recorded{context.compiled.text, rule, {}};
    unpack(*recorded.text, context.compiled.args, recorded.text->count, recorded.args);
#else
void record_error(Context& context, GLenum code, bool inside) {
#endif
    if (Word* to = record(context, &player<&play_error>, 2 + sentence_words); to != nullptr) {
        to[0] = code;
        to[1] = inside;
#if SPANGLE_MESSAGES
        std::memcpy(to + 2, &recorded, sizeof recorded);
#endif
    }
}

void begin_recording(Context& context) {
    context.list.recorder = ListRecorder{};
}

Chunk* end_recording(Context& context) {
    ListRecorder& r = context.list.recorder;
    if (Word* end = record(context, nullptr, 0); end == nullptr) {
        free_chain(*context.arena, r.first);
        begin_recording(context);
        return nullptr;
    }
    r.last->words = static_cast<std::uint32_t>(r.write - r.last->data());
    context.arena->shrink(r.last, sizeof(Chunk) + r.last->words * sizeof(Word));
    Chunk* const first = r.first;
    begin_recording(context);
    return first;
}

void free_chain(Arena& arena, Chunk* first) {
    while (first != nullptr) {
        Chunk* const next = first->next;
        arena.free(first);
        first = next;
    }
}

} // namespace spangle::gl::list

namespace spangle::gl::encode {

using namespace list;

void Color(Context& context, Real red, Real green, Real blue, Real alpha) {
    ListRecorder& r = context.list.recorder;
    r.color[0] = red, r.color[1] = green, r.color[2] = blue, r.color[3] = alpha;
    r.pending |= field_color;
}

void Normal(Context& context, Real x, Real y, Real z) {
    ListRecorder& r = context.list.recorder;
    r.normal[0] = x, r.normal[1] = y, r.normal[2] = z;
    r.pending |= field_normal;
}

void TexCoord(Context& context, Real s, Real t, Real r, Real q) {
    ListRecorder& recorder = context.list.recorder;
    recorder.tex_coord[0] = s, recorder.tex_coord[1] = t, recorder.tex_coord[2] = r,
    recorder.tex_coord[3] = q;
    recorder.pending &= ~(field_tex2 | field_tex4);
    recorder.pending |=
        are_equal_bits(r, numeric::zero) && are_equal_bits(q, numeric::one) ? field_tex2 : field_tex4;
}

void Vertex(Context& context, Real x, Real y, Real z, Real w) {
    ListRecorder& r = context.list.recorder;
    const Real position[4] = {x, y, z, w};
    const std::uint32_t components = !are_equal_bits(w, numeric::one)    ? 4
                                     : !are_equal_bits(z, numeric::zero) ? 3
                                                                         : 2;
    const std::uint32_t fields = r.pending | components << field_position_shift;
    const std::uint32_t words = words_per_vertex(fields);
    Word* to = r.write;
    if (r.run == nullptr || *r.run >> count_bits != fields || (*r.run & count_mask) == count_mask ||
        static_cast<std::size_t>(r.end - r.write) < words) {
        Word* const header = append(context, &player<&play_run>, 1 + words);
        if (header == nullptr)
            return;
        *header = fields << count_bits;
        r.run = header;
        to = header + 1;
    }
    ++*r.run;
#if SPANGLE_TELLS_REACH
    reach(context, Range::LIST_VERTICES, ++r.vertices);
#endif
    if (fields & field_color)
        store_reals(to, r.color, 4);
    if (fields & field_normal)
        store_reals(to, r.normal, 3);
    if (fields & (field_tex2 | field_tex4))
        store_reals(to, r.tex_coord, fields & field_tex2 ? 2 : 4);
    store_reals(to, position, components);
    r.write = to;
    r.pending = 0;
}

} // namespace spangle::gl::encode

#endif
