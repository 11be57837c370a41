// Tests the initial state against GL 1.3's tables (6.5 to 6.29), and the conversions of the queries (6.1.2).
#include <cmath>
#include <set>
#include <sstream>
#include <string>

#include <spangle/message.hpp>

#include "gl/context/features.hpp"
#include "gl/context/state_table.hpp"
#include "tests/gl/api/recording_context.hpp"

namespace spangle::test {
namespace {

using State = RecordingContext;

struct Expected {
    GLenum name;
    std::vector<double> values;
};

constexpr double ones = 4294967295.0; // a 32-bit mask of all ones

std::vector<double> identity() {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

std::vector<Expected> initial_state() {
    std::vector<Expected> table = {
        {GL_CURRENT_COLOR, {1, 1, 1, 1}},
        {GL_CURRENT_NORMAL, {0, 0, 1}},
        {GL_CURRENT_TEXTURE_COORDS, {0, 0, 0, 1}},
        {GL_VERTEX_ARRAY, {0}},
        {GL_VERTEX_ARRAY_SIZE, {4}},
        {GL_VERTEX_ARRAY_TYPE, {GL_FLOAT}},
        {GL_VERTEX_ARRAY_STRIDE, {0}},
        {GL_NORMAL_ARRAY, {0}},
        {GL_NORMAL_ARRAY_TYPE, {GL_FLOAT}},
        {GL_NORMAL_ARRAY_STRIDE, {0}},
        {GL_COLOR_ARRAY, {0}},
        {GL_COLOR_ARRAY_SIZE, {4}},
        {GL_COLOR_ARRAY_TYPE, {GL_FLOAT}},
        {GL_COLOR_ARRAY_STRIDE, {0}},
        {GL_TEXTURE_COORD_ARRAY, {0}},
        {GL_TEXTURE_COORD_ARRAY_SIZE, {4}},
        {GL_TEXTURE_COORD_ARRAY_TYPE, {GL_FLOAT}},
        {GL_TEXTURE_COORD_ARRAY_STRIDE, {0}},
        {GL_MODELVIEW_MATRIX, identity()},
        {GL_PROJECTION_MATRIX, identity()},
        {GL_TEXTURE_MATRIX, identity()},
        {GL_TRANSPOSE_MODELVIEW_MATRIX, identity()},
        {GL_TRANSPOSE_PROJECTION_MATRIX, identity()},
        {GL_TRANSPOSE_TEXTURE_MATRIX, identity()},
        {GL_MODELVIEW_STACK_DEPTH, {1}},
        {GL_PROJECTION_STACK_DEPTH, {1}},
        {GL_TEXTURE_STACK_DEPTH, {1}},
        {GL_MATRIX_MODE, {GL_MODELVIEW}},
        {GL_VIEWPORT, {0, 0, 64, 48}},
        {GL_DEPTH_RANGE, {0, 1}},
        {GL_NORMALIZE, {0}},
        {GL_RESCALE_NORMAL, {0}},
        {GL_SHADE_MODEL, {GL_SMOOTH}},
        {GL_POINT_SIZE, {1}},
        {GL_LINE_WIDTH, {1}},
        {GL_CULL_FACE, {0}},
        {GL_CULL_FACE_MODE, {GL_BACK}},
        {GL_FRONT_FACE, {GL_CCW}},
        {GL_TEXTURE_2D, {0}},
        {GL_TEXTURE_BINDING_2D, {0}},
        {GL_ACTIVE_TEXTURE, {GL_TEXTURE0}},
        {GL_CLIENT_ACTIVE_TEXTURE, {GL_TEXTURE0}},
        {GL_MAX_TEXTURE_UNITS, {SPANGLE_TEXTURE_UNITS}},
        {GL_SCISSOR_TEST, {0}},
        {GL_SCISSOR_BOX, {0, 0, 64, 48}},
        {GL_ALPHA_TEST, {0}},
        {GL_ALPHA_TEST_FUNC, {GL_ALWAYS}},
        {GL_ALPHA_TEST_REF, {0}},
        {GL_STENCIL_TEST, {0}},
        {GL_STENCIL_FUNC, {GL_ALWAYS}},
        {GL_STENCIL_VALUE_MASK, {ones}},
        {GL_STENCIL_REF, {0}},
        {GL_STENCIL_FAIL, {GL_KEEP}},
        {GL_STENCIL_PASS_DEPTH_FAIL, {GL_KEEP}},
        {GL_STENCIL_PASS_DEPTH_PASS, {GL_KEEP}},
        {GL_STENCIL_BACK_FUNC, {GL_ALWAYS}},
        {GL_STENCIL_BACK_VALUE_MASK, {ones}},
        {GL_STENCIL_BACK_REF, {0}},
        {GL_STENCIL_BACK_FAIL, {GL_KEEP}},
        {GL_STENCIL_BACK_PASS_DEPTH_FAIL, {GL_KEEP}},
        {GL_STENCIL_BACK_PASS_DEPTH_PASS, {GL_KEEP}},
        {GL_STENCIL_BACK_WRITEMASK, {ones}},
        {GL_DEPTH_TEST, {0}},
        {GL_DEPTH_FUNC, {GL_LESS}},
        {GL_BLEND, {0}},
        {GL_BLEND_SRC, {GL_ONE}},
        {GL_BLEND_DST, {GL_ZERO}},
        {GL_BLEND_SRC_RGB, {GL_ONE}},
        {GL_BLEND_DST_RGB, {GL_ZERO}},
        {GL_BLEND_SRC_ALPHA, {GL_ONE}},
        {GL_BLEND_DST_ALPHA, {GL_ZERO}},
        {GL_BLEND_EQUATION, {GL_FUNC_ADD}},
        {GL_BLEND_EQUATION_ALPHA, {GL_FUNC_ADD}},
        {GL_BLEND_COLOR, {0, 0, 0, 0}},
        {GL_COLOR_LOGIC_OP, {0}},
        {GL_INDEX_LOGIC_OP, {0}},
        {GL_LOGIC_OP_MODE, {GL_COPY}},
        {GL_ACCUM_CLEAR_VALUE, {0, 0, 0, 0}},
        {GL_INDEX_CLEAR_VALUE, {0}},
        {GL_INDEX_WRITEMASK, {ones}},
        {GL_DITHER, {1}},
        {GL_DRAW_BUFFER, {GL_BACK}},
        {GL_READ_BUFFER, {GL_BACK}},
        {GL_COLOR_WRITEMASK, {1, 1, 1, 1}},
        {GL_DEPTH_WRITEMASK, {1}},
        {GL_STENCIL_WRITEMASK, {ones}},
        {GL_COLOR_CLEAR_VALUE, {0, 0, 0, 0}},
        {GL_DEPTH_CLEAR_VALUE, {1}},
        {GL_STENCIL_CLEAR_VALUE, {0}},
        {GL_UNPACK_SWAP_BYTES, {0}},
        {GL_UNPACK_LSB_FIRST, {0}},
        {GL_UNPACK_IMAGE_HEIGHT, {0}},
        {GL_UNPACK_SKIP_IMAGES, {0}},
        {GL_UNPACK_ROW_LENGTH, {0}},
        {GL_UNPACK_SKIP_ROWS, {0}},
        {GL_UNPACK_SKIP_PIXELS, {0}},
        {GL_UNPACK_ALIGNMENT, {4}},
        {GL_PACK_SWAP_BYTES, {0}},
        {GL_PACK_LSB_FIRST, {0}},
        {GL_PACK_IMAGE_HEIGHT, {0}},
        {GL_PACK_SKIP_IMAGES, {0}},
        {GL_PACK_ROW_LENGTH, {0}},
        {GL_PACK_SKIP_ROWS, {0}},
        {GL_PACK_SKIP_PIXELS, {0}},
        {GL_PACK_ALIGNMENT, {4}},
        {GL_PERSPECTIVE_CORRECTION_HINT, {GL_DONT_CARE}},
        {GL_POINT_SMOOTH_HINT, {GL_DONT_CARE}},
        {GL_LINE_SMOOTH_HINT, {GL_DONT_CARE}},
        {GL_POLYGON_SMOOTH_HINT, {GL_DONT_CARE}},
        {GL_FOG_HINT, {GL_DONT_CARE}},
        {GL_TEXTURE_COMPRESSION_HINT, {GL_DONT_CARE}},
#if SPANGLE_FEATURE_MIPMAP_GENERATION
        {GL_GENERATE_MIPMAP_HINT, {GL_DONT_CARE}},
#endif
        {GL_MAX_MODELVIEW_STACK_DEPTH, {32}},
        {GL_MAX_PROJECTION_STACK_DEPTH, {2}},
        {GL_MAX_TEXTURE_STACK_DEPTH, {2}},
        {GL_SUBPIXEL_BITS, {8}},
        {GL_MAX_TEXTURE_SIZE, {2048}},
        {GL_MAX_TEXTURE_LOD_BIAS, {12}},
#if SPANGLE_FEATURE_TEXTURE_1D
        {GL_TEXTURE_1D, {0}},
        {GL_TEXTURE_BINDING_1D, {0}},
#endif
#if SPANGLE_FEATURE_TEXTURE_3D
        {GL_TEXTURE_3D, {0}},
        {GL_TEXTURE_BINDING_3D, {0}},
        {GL_MAX_3D_TEXTURE_SIZE, {256}},
#endif
#if SPANGLE_FEATURE_TEXTURE_CUBE_MAP
        {GL_TEXTURE_CUBE_MAP, {0}},
        {GL_TEXTURE_BINDING_CUBE_MAP, {0}},
        {GL_MAX_CUBE_MAP_TEXTURE_SIZE, {2048}},
#endif
#if SPANGLE_FEATURE_COMPRESSED_TEXTURES
        {GL_NUM_COMPRESSED_TEXTURE_FORMATS, {11}},
        {GL_COMPRESSED_TEXTURE_FORMATS,
         {GL_PALETTE4_RGB8_OES, GL_PALETTE4_RGBA8_OES, GL_PALETTE4_R5_G6_B5_OES, GL_PALETTE4_RGBA4_OES,
          GL_PALETTE4_RGB5_A1_OES, GL_PALETTE8_RGB8_OES, GL_PALETTE8_RGBA8_OES, GL_PALETTE8_R5_G6_B5_OES,
          GL_PALETTE8_RGBA4_OES, GL_PALETTE8_RGB5_A1_OES, GL_ETC1_RGB8_OES}},
#endif
        {GL_MAX_VIEWPORT_DIMS, {2048, 2048}},
        {GL_POINT_SIZE_RANGE, {1, 64}},
        {GL_ALIASED_POINT_SIZE_RANGE, {1, 64}},
        {GL_LINE_WIDTH_RANGE, {1, 64}},
        {GL_ALIASED_LINE_WIDTH_RANGE, {1, 64}},
        {GL_AUX_BUFFERS, {0}},
        {GL_RGBA_MODE, {1}},
        {GL_INDEX_MODE, {0}},
        {GL_DOUBLEBUFFER, {1}},
        {GL_STEREO, {0}},
        {GL_RED_BITS, {8}},
        {GL_GREEN_BITS, {8}},
        {GL_BLUE_BITS, {8}},
        {GL_ALPHA_BITS, {8}},
        {GL_INDEX_BITS, {0}},
        {GL_DEPTH_BITS, {24}},
        {GL_STENCIL_BITS, {8}},
        {GL_ACCUM_RED_BITS, {16}},
        {GL_ACCUM_GREEN_BITS, {16}},
        {GL_ACCUM_BLUE_BITS, {16}},
        {GL_ACCUM_ALPHA_BITS, {16}},
    };
    const std::vector<Expected> fog = {{GL_FOG_COLOR, {0, 0, 0, 0}},
                                       {GL_FOG_DENSITY, {1}},
                                       {GL_FOG_START, {0}},
                                       {GL_FOG_END, {1}},
                                       {GL_FOG_MODE, {GL_EXP}},
                                       {GL_FOG, {0}},
                                       {GL_FOG_INDEX, {0}},
                                       {GL_FOG_COORDINATE_SOURCE, {GL_FRAGMENT_DEPTH}},
                                       {GL_CURRENT_FOG_COORDINATE, {0}},
                                       {GL_FOG_COORDINATE_ARRAY, {0}},
                                       {GL_FOG_COORDINATE_ARRAY_TYPE, {GL_FLOAT}},
                                       {GL_FOG_COORDINATE_ARRAY_STRIDE, {0}}};
    const std::vector<Expected> secondary = {{GL_COLOR_SUM, {0}},
                                             {GL_CURRENT_SECONDARY_COLOR, {0, 0, 0, 1}},
                                             {GL_SECONDARY_COLOR_ARRAY, {0}},
                                             {GL_SECONDARY_COLOR_ARRAY_SIZE, {3}},
                                             {GL_SECONDARY_COLOR_ARRAY_TYPE, {GL_FLOAT}},
                                             {GL_SECONDARY_COLOR_ARRAY_STRIDE, {0}}};
    if (SPANGLE_FEATURE_SECONDARY_COLOR)
        table.insert(table.end(), secondary.begin(), secondary.end());
    if (SPANGLE_FEATURE_SECONDARY_COLOR && SPANGLE_FEATURE_BUFFERS)
        table.push_back({GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING, {0}});
    std::vector<Expected> lighting = {
        {GL_LIGHTING, {0}},
        {GL_COLOR_MATERIAL, {0}},
        {GL_COLOR_MATERIAL_PARAMETER, {GL_AMBIENT_AND_DIFFUSE}},
        {GL_COLOR_MATERIAL_FACE, {GL_FRONT_AND_BACK}},
        {GL_LIGHT_MODEL_AMBIENT, {double(0.2f), double(0.2f), double(0.2f), 1}},
        {GL_LIGHT_MODEL_LOCAL_VIEWER, {0}},
        {GL_LIGHT_MODEL_TWO_SIDE, {0}},
        {GL_LIGHT_MODEL_COLOR_CONTROL, {GL_SINGLE_COLOR}},
        {GL_MAX_LIGHTS, {8}},
    };
    for (GLenum i = 0; i < 8; ++i)
        lighting.push_back({GL_LIGHT0 + i, {0}});
    const std::vector<Expected> lists = {
        {GL_LIST_BASE, {0}}, {GL_LIST_INDEX, {0}}, {GL_LIST_MODE, {0}}, {GL_MAX_LIST_NESTING, {64}}};
    if (SPANGLE_FEATURE_POLYGON_MODE)
        table.insert(table.end(), {{GL_POLYGON_MODE, {GL_FILL, GL_FILL}},
                                   {GL_EDGE_FLAG, {1}},
                                   {GL_EDGE_FLAG_ARRAY, {0}},
                                   {GL_EDGE_FLAG_ARRAY_STRIDE, {0}}});
    table.insert(table.end(), {{GL_MULTISAMPLE, {1}},
                               {GL_SAMPLE_ALPHA_TO_COVERAGE, {0}},
                               {GL_SAMPLE_ALPHA_TO_ONE, {0}},
                               {GL_SAMPLE_COVERAGE, {0}},
                               {GL_SAMPLE_COVERAGE_VALUE, {1}},
                               {GL_SAMPLE_COVERAGE_INVERT, {0}},
                               {GL_SAMPLE_BUFFERS, {0}},
                               {GL_SAMPLES, {0}}});
    if (SPANGLE_FEATURE_ANTIALIASING)
        for (GLenum name : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH})
            table.push_back({name, {0}});
    const double granularity = SPANGLE_FEATURE_ANTIALIASING ? 0.125 : 1;
    for (GLenum name : {GL_SMOOTH_POINT_SIZE_GRANULARITY, GL_SMOOTH_LINE_WIDTH_GRANULARITY})
        table.push_back({name, {granularity}});
    if (SPANGLE_FEATURE_STIPPLE)
        table.insert(table.end(), {{GL_LINE_STIPPLE, {0}},
                                   {GL_LINE_STIPPLE_PATTERN, {0xFFFF}},
                                   {GL_LINE_STIPPLE_REPEAT, {1}},
                                   {GL_POLYGON_STIPPLE, {0}}});
    if (SPANGLE_FEATURE_POINT_PARAMETERS)
        table.insert(table.end(), {{GL_POINT_SIZE_MIN, {0}},
                                   {GL_POINT_SIZE_MAX, {64}},
                                   {GL_POINT_FADE_THRESHOLD_SIZE, {1}},
                                   {GL_POINT_DISTANCE_ATTENUATION, {1, 0, 0}},
                                   {GL_POINT_SPRITE, {0}},
                                   {GL_POINT_SPRITE_COORD_ORIGIN, {GL_UPPER_LEFT}}});
    if (SPANGLE_FEATURE_POLYGON_OFFSET)
        table.insert(table.end(), {{GL_POLYGON_OFFSET_FACTOR, {0}},
                                   {GL_POLYGON_OFFSET_UNITS, {0}},
                                   {GL_POLYGON_OFFSET_POINT, {0}},
                                   {GL_POLYGON_OFFSET_LINE, {0}},
                                   {GL_POLYGON_OFFSET_FILL, {0}}});
    if (SPANGLE_FEATURE_BUFFERS)
        for (GLenum name = GL_ARRAY_BUFFER_BINDING; name <= GL_EDGE_FLAG_ARRAY_BUFFER_BINDING; ++name)
            if ((SPANGLE_FEATURE_COLOR_INDEX || name != GL_INDEX_ARRAY_BUFFER_BINDING) &&
                (SPANGLE_FEATURE_POLYGON_MODE || name != GL_EDGE_FLAG_ARRAY_BUFFER_BINDING))
                table.push_back({name, {0}});
    if (SPANGLE_FEATURE_PRIMITIVE_RESTART)
        table.insert(table.end(), {{GL_PRIMITIVE_RESTART, {0}}, {GL_PRIMITIVE_RESTART_INDEX, {0}}});
    if (SPANGLE_FEATURE_VERTEX_ARRAY_OBJECTS)
        table.push_back({GL_VERTEX_ARRAY_BINDING, {0}});
    if (SPANGLE_FEATURE_BUFFERS && SPANGLE_FEATURE_FOG)
        table.push_back({GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING, {0}});
    if (SPANGLE_FEATURE_RASTER_POS)
        table.insert(table.end(), {{GL_CURRENT_RASTER_POSITION, {0, 0, 0, 1}},
                                   {GL_CURRENT_RASTER_POSITION_VALID, {1}},
                                   {GL_CURRENT_RASTER_DISTANCE, {0}},
                                   {GL_CURRENT_RASTER_COLOR, {1, 1, 1, 1}},
                                   {GL_CURRENT_RASTER_INDEX, {1}},
                                   {GL_CURRENT_RASTER_TEXTURE_COORDS, {0, 0, 0, 1}}});
    if (SPANGLE_FEATURE_TEXGEN)
        for (GLenum cap = GL_TEXTURE_GEN_S; cap <= GL_TEXTURE_GEN_Q; ++cap)
            table.push_back({cap, {0}});
    if (SPANGLE_FEATURE_CLIP_PLANES) {
        table.push_back({GL_MAX_CLIP_PLANES, {6}});
        for (GLenum i = 0; i < 6; ++i)
            table.push_back({GL_CLIP_PLANE0 + i, {0}});
    }
    if (SPANGLE_FEATURE_COLOR_INDEX)
        table.insert(table.end(), {{GL_CURRENT_INDEX, {1}},
                                   {GL_INDEX_ARRAY, {0}},
                                   {GL_INDEX_ARRAY_TYPE, {GL_FLOAT}},
                                   {GL_INDEX_ARRAY_STRIDE, {0}}});
    const std::vector<Expected> stacks = {{GL_ATTRIB_STACK_DEPTH, {0}},
                                          {GL_CLIENT_ATTRIB_STACK_DEPTH, {0}},
                                          {GL_MAX_ATTRIB_STACK_DEPTH, {16}},
                                          {GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, {16}}};
    table.push_back({GL_RENDER_MODE, {GL_RENDER}});
    if (SPANGLE_FEATURE_SELECTION)
        table.insert(
            table.end(),
            {{GL_NAME_STACK_DEPTH, {0}}, {GL_MAX_NAME_STACK_DEPTH, {64}}, {GL_SELECTION_BUFFER_SIZE, {0}}});
    if (SPANGLE_FEATURE_DRAW_PIXELS)
        table.insert(table.end(), {{GL_ZOOM_X, {1}}, {GL_ZOOM_Y, {1}}});
    if (SPANGLE_FEATURE_PIXEL_TRANSFER) {
        for (GLenum name : {GL_MAP_COLOR, GL_MAP_STENCIL, GL_INDEX_SHIFT, GL_INDEX_OFFSET, GL_RED_BIAS,
                            GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS})
            table.push_back({name, {0}});
        for (GLenum name : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE})
            table.push_back({name, {1}});
        for (GLenum name = GL_PIXEL_MAP_I_TO_I_SIZE; name <= GL_PIXEL_MAP_A_TO_A_SIZE; ++name)
            table.push_back({name, {1}});
        table.push_back({GL_MAX_PIXEL_MAP_TABLE, {256}});
    }
    if (SPANGLE_FEATURE_EVALUATORS) {
        for (GLenum cap = GL_MAP1_COLOR_4; cap <= GL_MAP1_VERTEX_4; ++cap) {
            table.push_back({cap, {0}});
            table.push_back({cap - GL_MAP1_COLOR_4 + GL_MAP2_COLOR_4, {0}});
        }
        table.insert(table.end(), {{GL_AUTO_NORMAL, {0}},
                                   {GL_MAP1_GRID_DOMAIN, {0, 1}},
                                   {GL_MAP1_GRID_SEGMENTS, {1}},
                                   {GL_MAP2_GRID_DOMAIN, {0, 1, 0, 1}},
                                   {GL_MAP2_GRID_SEGMENTS, {1, 1}},
                                   {GL_MAX_EVAL_ORDER, {8}}});
    }
    if (SPANGLE_FEATURE_FEEDBACK)
        table.insert(table.end(), {{GL_FEEDBACK_BUFFER_SIZE, {0}}, {GL_FEEDBACK_BUFFER_TYPE, {GL_2D}}});
    if (SPANGLE_FEATURE_ATTRIB_STACKS)
        table.insert(table.end(), stacks.begin(), stacks.end());
    if (SPANGLE_FEATURE_FOG)
        table.insert(table.end(), fog.begin(), fog.end());
    if (SPANGLE_FEATURE_LIGHTING)
        table.insert(table.end(), lighting.begin(), lighting.end());
    if (SPANGLE_FEATURE_LISTS)
        table.insert(table.end(), lists.begin(), lists.end());
    std::erase_if(table, [](const Expected& e) {
        const gl::StateRow* const row = gl::find_state(e.name);
        return row != nullptr && row->left_out();
    });
    return table;
}

/// Converts a mask of ones to -1, because GetDoublev returns integers signed.
double as_signed(double v) {
    return v == ones ? -1 : v;
}

TEST_F(State, InitialValues) {
    for (const Expected& e : initial_state()) {
        GLdouble d[17];
        std::fill(std::begin(d), std::end(d), -77);
        glGetDoublev(e.name, d);
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << std::hex << e.name;
        for (std::size_t i = 0; i < e.values.size(); ++i)
            EXPECT_EQ(d[i], as_signed(e.values[i])) << std::hex << e.name << " [" << i << "]";
        EXPECT_EQ(d[e.values.size()], -77) << std::hex << e.name << " wrote too much";
    }
}

/// The table above leaves out no value that can be queried.
TEST_F(State, InitialValuesAreOfTheWholeTable) {
    std::set<GLenum> known = {GL_MAX_ELEMENTS_INDICES, GL_MAX_ELEMENTS_VERTICES}; // these may have any value
    for (const Expected& e : initial_state())
        known.insert(e.name);
    for (const auto& part : gl::all_state())
        for (const gl::StateRow& row : part.rows)
            if (row.source != gl::Source::pointer && !row.left_out())
                for (GLenum i = 0; i < row.names; ++i) {
                    EXPECT_TRUE(known.contains(row.name + i)) << std::hex << row.name + i;
                }
}

TEST_F(State, EveryQueryAgreesAcrossTypes) {
    const auto linear = [](GLenum name) {
        for (GLenum n : {GL_CURRENT_COLOR, GL_CURRENT_SECONDARY_COLOR, GL_CURRENT_NORMAL, GL_DEPTH_RANGE,
                         GL_COLOR_CLEAR_VALUE, GL_DEPTH_CLEAR_VALUE, GL_FOG_COLOR, GL_LIGHT_MODEL_AMBIENT,
                         GL_ALPHA_TEST_REF, GL_CURRENT_RASTER_COLOR})
            if (n == name)
                return true;
        return false;
    };
    for (const Expected& e : initial_state()) {
        GLfloat f[16] = {};
        GLint n[16] = {};
        GLboolean b[16] = {};
        [[maybe_unused]] GLfixed x[16] = {};
        glGetFloatv(e.name, f);
        glGetIntegerv(e.name, n);
        glGetBooleanv(e.name, b);
#if SPANGLE_FEATURE_FIXED_POINT
        glGetFixedvOES(e.name, x);
#endif
        ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        for (std::size_t i = 0; i < e.values.size(); ++i) {
            const double v = as_signed(e.values[i]);
            EXPECT_EQ(f[i], static_cast<float>(v)) << std::hex << e.name;
            EXPECT_EQ(b[i], v != 0) << std::hex << e.name;
            if (linear(e.name)) {
                const double exact = (4294967295.0 * v - 1) / 2;
                EXPECT_NEAR(n[i], exact, 0.51) << std::hex << e.name;
            } else {
                EXPECT_EQ(n[i], static_cast<GLint>(v)) << std::hex << e.name;
            }
#if SPANGLE_FEATURE_FIXED_POINT
            const bool real = linear(e.name) || e.values.size() == 16 || e.name == GL_POINT_SIZE ||
                              (e.name >= GL_POINT_SIZE_MIN && e.name <= GL_POINT_DISTANCE_ATTENUATION) ||
                              e.name == GL_LINE_WIDTH || e.name == GL_POINT_SIZE_GRANULARITY ||
                              e.name == GL_SAMPLE_COVERAGE_VALUE || e.name == GL_LINE_WIDTH_GRANULARITY ||
                              e.name == GL_FOG_DENSITY || e.name == GL_FOG_START ||
                              e.name == GL_MAP1_GRID_DOMAIN || e.name == GL_MAP2_GRID_DOMAIN ||
                              e.name == GL_FOG_END || e.name == GL_FOG_INDEX ||
                              e.name == GL_CURRENT_FOG_COORDINATE || e.name == GL_CURRENT_TEXTURE_COORDS ||
                              e.name == GL_CURRENT_INDEX || e.name == GL_CURRENT_RASTER_POSITION ||
                              e.name == GL_CURRENT_RASTER_DISTANCE || e.name == GL_CURRENT_RASTER_INDEX ||
                              e.name == GL_CURRENT_RASTER_TEXTURE_COORDS ||
                              (e.name >= GL_RED_SCALE && e.name <= GL_DEPTH_BIAS);
            EXPECT_EQ(x[i], real ? std::lround(v * 65536) : static_cast<long>(v)) << std::hex << e.name;
#endif
        }
    }
}

TEST_F(State, QueriesReturnWhatWasSet) {
    glClearColor(0.25f, 0.5f, 2.0f, -1.0f); // clamped when it is set (GL 1.3, 4.2.3)
    GLfloat f[4];
    glGetFloatv(GL_COLOR_CLEAR_VALUE, f);
    EXPECT_EQ(f[0], 0.25f);
    EXPECT_EQ(f[1], 0.5f);
    EXPECT_EQ(f[2], 1.0f);
    EXPECT_EQ(f[3], 0.0f);
    GLint n[4];
    glGetIntegerv(GL_COLOR_CLEAR_VALUE, n);
    EXPECT_EQ(n[2], 2147483647);
    EXPECT_NEAR(n[1], 1073741823, 1);
    glColor4f(3.5f, -2.25f, 1e-30f, 1.0f); // current colours are not clamped
    glGetFloatv(GL_CURRENT_COLOR, f);
    EXPECT_EQ(f[0], 3.5f);
    EXPECT_EQ(f[1], -2.25f);
    EXPECT_EQ(f[2], 1e-30f);
    for (const auto& [given, kept] :
         {std::pair{0.75f, 0.75f}, {-1.0f, 0.0f}, {2.0f, 1.0f}}) { // clamped when it is set
        glSampleCoverage(given, GL_TRUE);
        glGetFloatv(GL_SAMPLE_COVERAGE_VALUE, f);
        EXPECT_EQ(f[0], kept);
        GLint inverted = 0;
        glGetIntegerv(GL_SAMPLE_COVERAGE_INVERT, &inverted);
        EXPECT_EQ(inverted, 1);
    }
    glPointSize(2.75f);
    glGetFloatv(GL_POINT_SIZE, f);
    EXPECT_EQ(f[0], 2.75f);
    glGetIntegerv(GL_POINT_SIZE, n);
    EXPECT_EQ(n[0], 3);
#if SPANGLE_FEATURE_FIXED_POINT
    GLfixed x;
    glGetFixedvOES(GL_POINT_SIZE, &x);
    EXPECT_EQ(x, 0x2C000);
#endif
    glPixelStoref(GL_UNPACK_SKIP_ROWS, 2.5f);
    glGetIntegerv(GL_UNPACK_SKIP_ROWS, n);
    EXPECT_EQ(n[0], 3);
    glStencilMask(0xF0F0F0F0u);
    glGetIntegerv(GL_STENCIL_WRITEMASK, n);
    EXPECT_EQ(static_cast<GLuint>(n[0]), 0xF0F0F0F0u);
}

TEST_F(State, IntegersKeepAllBitsAsDoubles) {
    for (GLint value : {0, 1, -1, 16777217, -16777217, INT32_MAX, INT32_MIN + 1}) {
        glStencilMask(static_cast<GLuint>(value));
        GLdouble d;
        glGetDoublev(GL_STENCIL_WRITEMASK, &d);
        EXPECT_EQ(d, static_cast<double>(value));
    }
}

TEST_F(State, EveryCapabilityToggles) {
    std::vector<GLenum> caps = {GL_ALPHA_TEST,   GL_BLEND,     GL_CULL_FACE,      GL_DEPTH_TEST,
                                GL_DITHER,       GL_NORMALIZE, GL_RESCALE_NORMAL, GL_SCISSOR_TEST,
                                GL_STENCIL_TEST, GL_TEXTURE_2D};
    if (SPANGLE_FEATURE_LIGHTING)
        for (GLenum cap : {GL_LIGHTING, GL_COLOR_MATERIAL, GL_LIGHT0, GL_LIGHT1, GL_LIGHT2, GL_LIGHT3,
                           GL_LIGHT4, GL_LIGHT5, GL_LIGHT6, GL_LIGHT7})
            caps.push_back(cap);
    if (SPANGLE_FEATURE_FOG)
        caps.push_back(GL_FOG);
    if (SPANGLE_FEATURE_TEXGEN)
        for (GLenum cap = GL_TEXTURE_GEN_S; cap <= GL_TEXTURE_GEN_Q; ++cap)
            caps.push_back(cap);
    if (SPANGLE_FEATURE_CLIP_PLANES)
        for (GLenum i = 0; i < 6; ++i)
            caps.push_back(GL_CLIP_PLANE0 + i);
    for (GLenum cap : caps) {
        std::vector<bool> others;
        for (GLenum other : caps)
            others.push_back(glIsEnabled(other));
        const bool before = glIsEnabled(cap);
        EXPECT_EQ(before, cap == GL_DITHER || cap == GL_MULTISAMPLE);
        (before ? glDisable : glEnable)(cap);
        GLint value = -1;
        glGetIntegerv(cap, &value);
        EXPECT_EQ(value, before ? 0 : 1);
        for (std::size_t i = 0; i < caps.size(); ++i)
            EXPECT_EQ(glIsEnabled(caps[i]), caps[i] == cap ? !others[i] : others[i]);
        (before ? glEnable : glDisable)(cap);
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(State, AbsentSystemsAreNamed) {
    static std::string said;
    on_message([](unsigned, const char* text) { said = text; });
    for (const auto& [array, present] :
         {std::pair{GLenum{GL_INDEX_ARRAY}, SPANGLE_FEATURE_COLOR_INDEX != 0},
          {GLenum{GL_EDGE_FLAG_ARRAY}, SPANGLE_FEATURE_POLYGON_MODE != 0},
          {GLenum{GL_FOG_COORDINATE_ARRAY}, SPANGLE_FEATURE_FOG != 0},
          {GLenum{GL_SECONDARY_COLOR_ARRAY}, SPANGLE_FEATURE_SECONDARY_COLOR != 0}}) {
        glEnableClientState(array);
        EXPECT_EQ(glGetError(), present ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_OPERATION});
        EXPECT_EQ(glIsEnabled(array), present);
        glGetError();
    }
    said.clear();
    const std::pair<GLenum, bool> caps[] = {{GL_FOG, SPANGLE_FEATURE_FOG != 0},
                                            {GL_LIGHTING, SPANGLE_FEATURE_LIGHTING != 0},
                                            {GL_TEXTURE_GEN_R, SPANGLE_FEATURE_TEXGEN != 0},
                                            {GL_CLIP_PLANE5, SPANGLE_FEATURE_CLIP_PLANES != 0},
                                            {GL_LIGHT7, SPANGLE_FEATURE_LIGHTING != 0},
                                            {GL_COLOR_MATERIAL, SPANGLE_FEATURE_LIGHTING != 0}};
    for (const auto& [cap, present] : caps) {
        const GLenum expected = present ? GL_NO_ERROR : GL_INVALID_OPERATION;
        GLint value;
        const auto check = [&, cap = cap, present = present] {
            EXPECT_EQ(glGetError(), expected) << std::hex << cap;
            EXPECT_EQ(said.find("SPANGLE_FEATURE_") != std::string::npos, !present);
            said.clear();
        };
        glEnable(cap);
        check();
        EXPECT_EQ(glIsEnabled(cap), present);
        check();
        glGetIntegerv(cap, &value);
        check();
    }
    on_message(nullptr);
}

/// Programs may enable arrays as client state or as capabilities; a list records capabilities.
TEST_F(State, ClientArraysAreCapabilities) {
    for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY}) {
        glEnable(array);
        EXPECT_TRUE(glIsEnabled(array));
        glDisableClientState(array);
        EXPECT_FALSE(glIsEnabled(array));
        glEnableClientState(array);
        EXPECT_TRUE(glIsEnabled(array));
        glDisable(array);
        EXPECT_FALSE(glIsEnabled(array));
    }
    glClientActiveTexture(GL_TEXTURE1); // chooses the unit of the array, whatever ActiveTexture has chosen
    glEnable(GL_TEXTURE_COORD_ARRAY);
    EXPECT_TRUE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
    glClientActiveTexture(GL_TEXTURE0);
    EXPECT_FALSE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
    glEnable(GL_VERTEX_ARRAY);
#if SPANGLE_FEATURE_ATTRIB_STACKS
    glPushAttrib(GL_ENABLE_BIT); // does not save client state
    glDisable(GL_VERTEX_ARRAY);
    glPopAttrib();
    EXPECT_FALSE(glIsEnabled(GL_VERTEX_ARRAY));
#endif
#if SPANGLE_FEATURE_LISTS
    glNewList(1, GL_COMPILE);
    glEnable(GL_NORMAL_ARRAY);
    glEndList();
    EXPECT_FALSE(glIsEnabled(GL_NORMAL_ARRAY));
    glCallList(1);
    EXPECT_TRUE(glIsEnabled(GL_NORMAL_ARRAY));
#endif
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST_F(State, ArrayPointers) {
    int data[4] = {};
    glVertexPointer(2, GL_INT, 12, data);
    glColorPointer(3, GL_FLOAT, 0, data + 1);
    glNormalPointer(GL_BYTE, 4, data + 2);
    glTexCoordPointer(4, GL_SHORT, 8, data + 3);
    const GLenum names[] = {GL_VERTEX_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER,
                            GL_TEXTURE_COORD_ARRAY_POINTER};
    for (int i = 0; i < 4; ++i) {
        void* pointer = nullptr;
        glGetPointerv(names[i], &pointer);
        EXPECT_EQ(pointer, data + i);
    }
    GLint n = -1;
    glGetIntegerv(GL_VERTEX_ARRAY_POINTER, &n); // a pointer is not a number
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(n, -1);
    void* pointer = nullptr;
    glGetPointerv(GL_VERTEX_ARRAY_STRIDE, &pointer);
    EXPECT_EQ(glGetError(), GLenum{GL_INVALID_ENUM});
    glGetIntegerv(GL_VERTEX_ARRAY_STRIDE, &n);
    EXPECT_EQ(n, 12);
}

/// The version string names a version only if nothing of it was left out, so that a program may rely on it.
TEST_F(State, Strings) {
    const auto text = [](GLenum name) {
        return std::string(reinterpret_cast<const char*>(glGetString(name)));
    };
    EXPECT_EQ(text(GL_VENDOR), "Spangle");
    EXPECT_FALSE(text(GL_RENDERER).empty());
    // A build of a version may leave out systems that the version does not have.
    const std::set<std::string> never = {"MULTISAMPLE",  "STENCIL_SIDES",        "PRIMITIVE_RESTART",
                                         "FIXED_POINT",  "VERTEX_ARRAY_OBJECTS", "BANDS",
                                         "BAND_RECORDS", "NARROW_SURFACES",      "GET_PROC_ADDRESS"},
                                of_1_4 = {"DEPTH_TEXTURES", "MIPMAP_GENERATION", "SECONDARY_COLOR",
                                          "POINT_PARAMETERS"},
                                of_1_5 = {"BUFFERS", "QUERIES"};
    char minor = '5';
    std::istringstream left_out(SPANGLE_LEFT_OUT);
    for (std::string system; left_out >> system;)
        minor = std::min(minor, never.count(system) != 0    ? '5'
                                : of_1_5.count(system) != 0 ? '4'
                                : of_1_4.count(system) != 0 ? '3'
                                                            : '0');
    GLint limit = 0;
    for (const auto& [name, least] : {std::pair<GLenum, GLint>{GL_MAX_LIGHTS, 8},
                                      {GL_MAX_CLIP_PLANES, 6},
                                      {GL_MAX_MODELVIEW_STACK_DEPTH, 32},
                                      {GL_MAX_PROJECTION_STACK_DEPTH, 2},
                                      {GL_MAX_TEXTURE_STACK_DEPTH, 2},
                                      {GL_MAX_NAME_STACK_DEPTH, 64},
                                      {GL_MAX_LIST_NESTING, 64},
                                      {GL_MAX_TEXTURE_UNITS, 2},
                                      {GL_MAX_TEXTURE_LOD_BIAS, 2},
                                      {GL_MAX_TEXTURE_SIZE, 64}}) {
        glGetIntegerv(name, &limit);
        if (glGetError() == GL_NO_ERROR && limit < least) // builds without its system report an error
            minor = '0';
    }
    const std::string version = text(GL_VERSION);
    EXPECT_EQ(version.substr(0, 12), std::string("1.") + minor + " Spangle ");
    EXPECT_EQ(version.find("subset") != std::string::npos, minor == '0') << version;
}

TEST_F(State, Extensions) {
    std::istringstream words(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)));
    std::set<std::string> extensions;
    for (std::string word; words >> word;)
        EXPECT_TRUE(word.starts_with("GL_") && extensions.insert(word).second) << word;
    const std::pair<const char*, bool> known[] = {
        {"GL_SGIS_texture_edge_clamp", true},
        {"GL_ARB_shadow", SPANGLE_FEATURE_DEPTH_TEXTURES},
        {"GL_ARB_texture_cube_map", SPANGLE_FEATURE_TEXTURE_CUBE_MAP},
        {"GL_ARB_texture_env_combine", SPANGLE_FEATURE_TEXTURE_COMBINE},
        // Only eglGetProcAddress finds commands with a suffix.
        {"GL_ARB_multitexture", SPANGLE_FEATURE_GET_PROC_ADDRESS},
        {"GL_ARB_window_pos", SPANGLE_FEATURE_RASTER_POS && SPANGLE_FEATURE_GET_PROC_ADDRESS},
        {"GL_EXT_copy_texture", SPANGLE_FEATURE_COPY_TEXTURE && SPANGLE_FEATURE_TEXTURE_1D &&
                                    SPANGLE_FEATURE_TEXTURE_3D && SPANGLE_FEATURE_GET_PROC_ADDRESS},
        {"GL_ARB_vertex_buffer_object", SPANGLE_FEATURE_BUFFERS && SPANGLE_FEATURE_GET_PROC_ADDRESS},
        {"GL_ARB_multisample", SPANGLE_FEATURE_MULTISAMPLE && SPANGLE_FEATURE_GET_PROC_ADDRESS},
        {"GL_ARB_imaging", false},
        {"GL_EXT_framebuffer_object", false},
    };
    for (const auto& [name, present] : known)
        EXPECT_EQ(extensions.count(name), present ? 1u : 0u) << name;
}

#if SPANGLE_FEATURE_MIPMAP_GENERATION
/// Mipmaps have a hint (GL 1.4, 5.6).
TEST_F(State, MipmapsHaveAHint) {
    GLint hint = 0;
    glGetIntegerv(GL_GENERATE_MIPMAP_HINT, &hint);
    EXPECT_EQ(hint, GL_DONT_CARE);
    glHint(GL_GENERATE_MIPMAP_HINT, GL_NICEST);
    glGetIntegerv(GL_GENERATE_MIPMAP_HINT, &hint);
    EXPECT_EQ(hint, GL_NICEST);
    glGetIntegerv(GL_TEXTURE_COMPRESSION_HINT, &hint);
    EXPECT_EQ(hint, GL_DONT_CARE);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}
#endif

TEST_F(State, LaterDrawablesKeepViewportAndScissor) {
    raster::Surface other = surface();
    other.width = 32;
    other.height = 16;
    gl::make_current(context, other, true);
    gl::make_current(context, other, false);
    GLint box[4];
    glGetIntegerv(GL_VIEWPORT, box);
    EXPECT_EQ(box[2], 64);
    glGetIntegerv(GL_SCISSOR_BOX, box);
    EXPECT_EQ(box[3], 48);
    glGetIntegerv(GL_DRAW_BUFFER, box);
    EXPECT_EQ(box[0], GL_BACK);
}

} // namespace
} // namespace spangle::test
