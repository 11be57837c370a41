// Bands drawn by callback leave out batches that do not reach them. The probe is a callback that breaks its
// promise: for the first band a batch lies low in the picture, for later bands it fills the picture. Bands
// that leave the batch out show nothing of it.
#include <array>

#include <spangle/reference.hpp>

#include "raster/band/batch_rows.hpp"
#include "tests/system/bands/banded.hpp"
#include "tests/system/bands/programs.hpp"

namespace spangle::test {
namespace {

constexpr int width = 160, height = 80, rows = 8; ///< size of the picture in pixels, and rows of a band
const hal::Board& board = boards::st7735_80x160;

/// Returns which rows of the picture, from the lowest, were drawn. `draw` is called with the number of the
/// band, from the top.
std::array<bool, height> drawn_rows(const std::function<void(int band)>& draw, int frame_count = 1) {
    Banded window(board, {.display_band = rows});
    window.set_up({"", start_program, {}});
    for (int f = 0; f < frame_count; ++f) {
        int band = 0;
        (void)window.show({"probe",
                           {},
                           [&](int) {
                               glClear(GL_COLOR_BUFFER_BIT);
                               draw(band++);
                           }},
                          f);
    }
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    // The glass shows the picture upright, because the board turns it.
    const sim::Image picture = window.sim.glass();
    EXPECT_EQ(picture.width, width);
    std::array<bool, height> drawn{};
    for (int y = 0; y < height; ++y)
        drawn[static_cast<std::size_t>(y)] = picture.at(3, height - 1 - y)[1] != 0;
    return drawn;
}

/// Returns a character for each band, from the lowest: '#' if all rows were drawn, '-' if none was.
std::string bands_of(const std::array<bool, height>& drawn) {
    std::string text;
    for (int band = 0; band < height / rows; ++band) {
        int count = 0;
        for (int y = 0; y < rows; ++y)
            count += drawn[static_cast<std::size_t>(band * rows + y)] ? 1 : 0;
        text += count == 0 ? '-' : count == rows ? '#' : '?';
    }
    return text;
}

void rectangle(float low, float high) {
    glRectf(0.F, low, width, high);
}

TEST(LeftOut, BatchesThatDoNotReachABand) {
    EXPECT_EQ(
        bands_of(drawn_rows([](int band) { rectangle(band == 0 ? 8.F : 0.F, band == 0 ? 16.F : height); })),
        "-#--------");
}

/// Some batches before it reach the band.
TEST(LeftOut, BatchesAreKnownByTheirNumber) {
    EXPECT_EQ(bands_of(drawn_rows([](int band) {
                  for (int i = 0; i < 5; ++i) {
                      glColor3f(0, 0, 0);
                      rectangle(0.F, height);
                  }
                  glColor3f(1, 1, 1);
                  rectangle(band == 0 ? 34.F : 0.F, band == 0 ? 36.F : height);
              })),
              "----#-----");
}

/// If several batches share an entry, a band draws all of them.
TEST(LeftOut, MoreBatchesThanEntries) {
    EXPECT_EQ(bands_of(drawn_rows([](int band) {
                  glColor3f(0, 0, 0);
                  for (int i = 0; i < 1000; ++i)
                      rectangle(60.F, 62.F);
                  glColor3f(1, 1, 1);
                  for (int i = 0; i < 24; ++i)
                      rectangle(band == 0 ? 34.F : 0.F, band == 0 ? 36.F : height);
              })),
              "----#-----");
}

/// The quads are in one array, of which each piece reaches its own rows.
TEST(LeftOut, PiecesOfLongBatches) {
    constexpr int quads = 48; // a piece of a batch has 12
    std::array<GLfloat, std::size_t{quads} * 8> place;
    std::array<GLubyte, std::size_t{quads} * 4> index;
    for (unsigned i = 0; i < index.size(); ++i)
        index[i] = static_cast<GLubyte>(i);
    EXPECT_EQ(bands_of(drawn_rows([&](int band) {
                  for (int q = 0; q < quads; ++q) {
                      // Draws the quads of the first and third piece, or for later bands all quads in the
                      // whole picture.
                      const float low = q / 12 == 0 ? 10.F : q / 12 == 2 ? 50.F : 200.F;
                      const float from = band == 0 ? low : 0.F, to = band == 0 ? low + 2.F : height;
                      const GLfloat corners[] = {0.F, from, width, from, width, to, 0.F, to};
                      std::copy_n(corners, 8, place.data() + std::size_t{8} * static_cast<std::size_t>(q));
                  }
                  glEnableClientState(GL_VERTEX_ARRAY);
                  glVertexPointer(2, GL_FLOAT, 0, place.data());
                  glDrawElements(GL_QUADS, 4 * quads, GL_UNSIGNED_BYTE, index.data());
                  glDisableClientState(GL_VERTEX_ARRAY);
              })),
              "-#----#---");
}

/// A program that reads pixels or counts may draw by them, so what the first band had is no longer known to
/// hold.
TEST(LeftOut, NothingWhereTheProgramReads) {
    const auto reads = [](const std::function<void()>& read) {
        return bands_of(drawn_rows([&](int band) {
            read();
            rectangle(band == 0 ? 8.F : 0.F, band == 0 ? 16.F : height);
        }));
    };
    EXPECT_EQ(reads([] {
                  std::array<GLubyte, 4> pixel{};
                  glReadPixels(0, 79, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
              }),
              "#########-"); // the first band's own rectangle lies elsewhere
    EXPECT_EQ(reads([] {
                  GLuint query = 0, count = 0;
                  glGenQueries(1, &query);
                  glBeginQuery(GL_SAMPLES_PASSED, query);
                  glEndQuery(GL_SAMPLES_PASSED);
                  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
                  glDeleteQueries(1, &query);
              }),
              "#########-");
    EXPECT_EQ(reads([] {
                  std::array<GLubyte, 4 * 4 * 4> texels{};
                  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 76, 4, 4, 0);
                  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
              }),
              "#########-");
    EXPECT_EQ(reads([] {}), "-#--------");
}

/// Each frame uses only what was noted in itself.
TEST(LeftOut, EachFrameBeginsAnew) {
    int calls = 0;
    EXPECT_EQ(bands_of(drawn_rows(
                  [&](int band) {
                      const bool second = calls++ >= height / rows;
                      std::array<GLubyte, 4> pixel{};
                      if (!second)
                          glReadPixels(0, 79, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
                      const float low = second ? 50.F : 8.F;
                      rectangle(band == 0 ? low : 0.F, band == 0 ? low + 2.F : height);
                  },
                  2)),
              "------#---");
}

/// If another surface becomes current during the first band, later batches get no number and are drawn in
/// every band.
TEST(LeftOut, NothingAfterAnotherSurfaceWasCurrent) {
    EXPECT_EQ(bands_of(drawn_rows([](int band) {
                  const EGLDisplay display = eglGetCurrentDisplay();
                  const EGLSurface window = eglGetCurrentSurface(EGL_DRAW);
                  const EGLContext context = eglGetCurrentContext();
                  if (band == 0) {
                      EXPECT_NE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT),
                                EGLBoolean{EGL_FALSE});
                      EXPECT_NE(eglMakeCurrent(display, window, window, context), EGLBoolean{EGL_FALSE});
                  }
                  rectangle(band == 0 ? 8.F : 0.F, band == 0 ? 16.F : height);
              })),
              "#########-");
}

#if SPANGLE_FEATURE_STENCIL_SIDES
/// If the sides of polygons have different stencil tests, back faces have a state of their own, whose rows
/// are noted, too.
TEST(LeftOut, BackFacesReachTheirRows) {
    EXPECT_EQ(bands_of(drawn_rows([](int) {
                  glEnable(GL_STENCIL_TEST);
                  glStencilFuncSeparate(GL_BACK, GL_ALWAYS, 1, 1);
                  glBegin(GL_QUADS); // a clockwise quad, of which the back is seen
                  for (const auto& [x, y] : {std::pair{0, 8}, {0, 16}, {width, 16}, {width, 8}})
                      glVertex2i(x, y);
                  glEnd();
                  glDisable(GL_STENCIL_TEST);
              })),
              "-#--------");
}
#endif

/// Feedback and selection see every primitive in every band.
TEST(LeftOut, NothingOfFeedback) {
    std::array<GLint, height / rows> values{};
    (void)drawn_rows([&](int band) {
        std::array<GLfloat, 64> buffer{};
        glFeedbackBuffer(64, GL_2D, buffer.data());
        glRenderMode(GL_FEEDBACK);
        rectangle(8.F, 16.F);
        values[static_cast<std::size_t>(band)] = glRenderMode(GL_RENDER);
    });
    for (const GLint count : values)
        EXPECT_EQ(count, values[0]);
    EXPECT_GT(values[0], 0);
}

/// A list that is compiled and executed gets the vertices that its band leaves out.
TEST(LeftOut, ListsGetWhatIsLeftOut) {
    EXPECT_EQ(bands_of(drawn_rows([](int band) {
                  if (band == 1) // the batch does not reach this band
                      glNewList(7, GL_COMPILE_AND_EXECUTE);
                  glBegin(GL_QUADS);
                  for (const auto& [x, y] : {std::pair{0, 8}, {width, 8}, {width, 16}, {0, 16}})
                      glVertex2i(x, y);
                  glEnd();
                  if (band == 1)
                      glEndList();
                  glClear(band > 1 ? GL_COLOR_BUFFER_BIT : 0);
                  if (band > 1)
                      glCallList(7);
              })),
              "-#--------");
}

/// The state is also right behind a batch that was left out. A primitive restart begins another batch.
TEST(LeftOut, WhatComesBehindIsThere) {
    std::array<GLint, height / rows> values{};
    (void)drawn_rows([&](int band) {
        rectangle(8.F, 16.F);
        std::array<GLfloat, 64> buffer{};
        glFeedbackBuffer(64, GL_2D, buffer.data());
        glRenderMode(GL_FEEDBACK);
        glBegin(GL_LINES);
        glVertex2i(3, 5);
        glVertex2i(30, 50);
        glEnd();
        values[static_cast<std::size_t>(band)] = glRenderMode(GL_RENDER);
    });
    for (const GLint count : values)
        EXPECT_EQ(count, 5);
#if SPANGLE_FEATURE_PRIMITIVE_RESTART
    const std::array<GLfloat, 16> place = {0, 8,  width, 8,  width, 16, 0, 16,
                                           0, 40, width, 40, width, 48, 0, 48};
    EXPECT_EQ(bands_of(drawn_rows([&](int) {
                  glEnableClientState(GL_VERTEX_ARRAY);
                  glVertexPointer(2, GL_FLOAT, 0, place.data());
                  glEnable(GL_PRIMITIVE_RESTART);
                  glPrimitiveRestartIndex(99);
                  glBegin(GL_QUADS);
                  for (const GLint i : {0, 1, 2, 3, 99})
                      glArrayElement(i);
                  for (int i = 4; i < 8; ++i)
                      glVertex2fv(place.data() + std::size_t{2} * static_cast<std::size_t>(i));
                  glEnd();
                  glDisable(GL_PRIMITIVE_RESTART);
                  glDisableClientState(GL_VERTEX_ARRAY);
              })),
              "-#---#----");
#endif
}

/// The reference policy of a config draws everything in every band.
TEST(LeftOut, NothingOfTheReference) {
    use_reference_engines();
    const Program& program = programs().front();
    const std::vector<sim::Image> whole =
                                      play(board, {.precision = EGL_PRECISION_DOUBLE_SPANGLE}, program, 2),
                                  banded =
                                      play(board,
                                           {.display_band = rows, .precision = EGL_PRECISION_DOUBLE_SPANGLE},
                                           program, 2);
    ASSERT_EQ(whole.size(), banded.size());
    for (std::size_t f = 0; f < whole.size(); ++f)
        EXPECT_EQ(sim::hash(whole[f]), sim::hash(banded[f]));
}

/// Notes the rows of a triangle in the table.
void note(raster::BatchRows& table, std::int32_t low, std::int32_t high) {
    raster::FixedVertex corner[3]{};
    corner[0].y = low * raster::subpixel_one;
    corner[1].y = corner[2].y = high * raster::subpixel_one;
    const raster::FixedVertex* const corners[] = {&corner[0], &corner[1], &corner[2]};
    const raster::DrawState state;
    table.primitive(table, state, {raster::Primitive::Shape::triangle, 3, 0, corners, &corner[0], nullptr});
}

/// For pictures of more than 256 rows the table has larger units. Rows outside of the picture are not noted.
TEST(BatchTable, RowsOfTallPictures) {
    for (const std::int32_t tall : {256, 257, 4096, 32767}) {
        raster::BatchRows table(tall);
        table.begin_frame();
        const std::int32_t low[] = {-500, 0, tall / 3, tall - 10, tall + 100, INT16_MIN};
        for (const std::int32_t first : low) {
            ASSERT_TRUE(table.begin_batch());
            note(table, first, first == INT16_MIN ? INT16_MAX : first + 5);
            table.end_batch();
        }
        for (std::int32_t row = 0; row < tall; row += tall / 256) {
            table.begin_band(row, row + 1);
            for (const std::int32_t first : low) {
                const std::int32_t last = first == INT16_MIN ? INT16_MAX : first + 5;
                const bool meets = table.begin_batch();
                if (first <= row && row < last) {
                    EXPECT_TRUE(meets) << tall << ": " << first << " at " << row;
                }
                const std::int32_t unit = tall / 128;
                if (row + 1 + 2 * unit + 4 < first || row > last + 2 * unit + 4) {
                    EXPECT_FALSE(meets) << tall << ": " << first << " at " << row;
                }
            }
        }
    }
}

TEST(BatchTable, NumbersOfPieces) {
    raster::BatchRows table(80);
    const auto batch = [&](std::initializer_list<int> pieces, std::string& drawn) {
        if (!table.begin_batch()) {
            EXPECT_TRUE(table.is_skipped());
            table.skip_pieces(static_cast<std::uint32_t>(pieces.size()));
            drawn += '.';
            return;
        }
        drawn += 'B';
        for (const int row : pieces) {
            if (!table.begin_piece()) {
                drawn += '-';
                continue;
            }
            drawn += 'p';
            note(table, row, row + 1);
            table.end_piece();
        }
        table.end_batch();
    };
    const auto frame = [&] {
        std::string drawn;
        batch({10, 30, 50}, drawn);
        batch({30, 30}, drawn);
        batch({}, drawn);
        batch({50, 70}, drawn);
        return drawn;
    };
    table.begin_frame();
    EXPECT_EQ(frame(), "BpppBppBBpp");
    table.begin_band(50, 52);
    EXPECT_EQ(frame(), "B--p..Bp-");
    table.begin_band(70, 72);
    EXPECT_EQ(frame(), "...B-p");
    table.begin_band(20, 40);
    EXPECT_EQ(frame(), "B-p-Bpp..");
    table.invalidate();
    EXPECT_EQ(frame(), "BpppBppBBpp");
}

} // namespace
} // namespace spangle::test
