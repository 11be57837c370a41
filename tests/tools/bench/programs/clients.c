/* Two small programs that draw what user interfaces and effects draw, through EGL and GL alone: clients particles|rectangles FRAMES. Their
   surface is a pbuffer of 320x240 pixels, so that neither needs a window system.

   particles   500 textured squares of 4 to 20 pixels on a dark ground, blended additively, in one array that changes each frame
   rectangles  60 rounded rectangles with a line of text each, triangle fans and glyphs in immediate mode, blended by alpha */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <EGL/egl.h>
#include <GL/gl.h>

enum { WIDTH = 320, HEIGHT = 240 };
enum { PARTICLES = 500, SPARK = 32 };
enum { RECTANGLES = 60, CORNER = 6, GLYPHS = 16, GLYPH = 8, LETTERS = 12 };

static unsigned state = 1;

/* A number of 0 to 1, the same ones in each run. */
static float chance(void) {
    state = state * 1664525u + 1013904223u;
    return (float)(state >> 8) / 16777216.0f;
}

static int open_surface(EGLDisplay* display, EGLSurface* surface) {
    const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8,
                           EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_STENCIL_SIZE, 8, EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, WIDTH, EGL_HEIGHT, HEIGHT, EGL_NONE};
    EGLConfig config;
    EGLContext context;
    EGLint count = 0;
    *display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (!eglInitialize(*display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(*display, wish, &config, 1, &count) ||
        count == 0)
        return 0;
    *surface = eglCreatePbufferSurface(*display, config, size);
    context = eglCreateContext(*display, config, EGL_NO_CONTEXT, NULL);
    return eglMakeCurrent(*display, *surface, *surface, context);
}

/* A texture of alpha values, one byte each. */
static void give_texture(int width, int height, const unsigned char* alphas) {
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA8, width, height, 0, GL_ALPHA, GL_UNSIGNED_BYTE, alphas);
}

static void start(void) {
    glViewport(0, 0, WIDTH, HEIGHT);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, WIDTH, HEIGHT, 0, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(GL_BLEND);
}

static struct Particle {
    float x, y, across, down, size;
    unsigned char color[4];
} particles[PARTICLES];

static struct Corner {
    float x, y, s, t;
    unsigned char color[4];
} corners[4 * PARTICLES];

static void start_particles(void) {
    static unsigned char spark[SPARK * SPARK];
    int i, x, y;
    for (y = 0; y < SPARK; ++y)
        for (x = 0; x < SPARK; ++x) {
            const float dx = ((float)x + 0.5f) / (SPARK / 2) - 1, dy = ((float)y + 0.5f) / (SPARK / 2) - 1;
            const float light = 1 - sqrtf(dx * dx + dy * dy);
            spark[y * SPARK + x] = (unsigned char)(light > 0 ? 255 * light * light : 0);
        }
    give_texture(SPARK, SPARK, spark);
    glEnable(GL_TEXTURE_2D);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    glVertexPointer(2, GL_FLOAT, sizeof *corners, &corners->x);
    glTexCoordPointer(2, GL_FLOAT, sizeof *corners, &corners->s);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof *corners, corners->color);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    for (i = 0; i < PARTICLES; ++i) {
        struct Particle* const p = particles + i;
        p->x = WIDTH * chance();
        p->y = HEIGHT * chance();
        p->across = 4 * chance() - 2;
        p->down = 4 * chance() - 2;
        p->size = 4 + 16 * chance();
        for (x = 0; x < 4; ++x)
            p->color[x] = (unsigned char)(255 * chance());
    }
}

static void draw_particles(void) {
    static const float ends[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    int i, k;
    for (i = 0; i < PARTICLES; ++i) {
        struct Particle* const p = particles + i;
        p->x = fmodf(p->x + p->across + WIDTH, WIDTH);
        p->y = fmodf(p->y + p->down + HEIGHT, HEIGHT);
        for (k = 0; k < 4; ++k) {
            struct Corner* const c = corners + 4 * i + k;
            c->x = p->x + p->size * (ends[k][0] - 0.5f);
            c->y = p->y + p->size * (ends[k][1] - 0.5f);
            c->s = ends[k][0];
            c->t = ends[k][1];
            memcpy(c->color, p->color, sizeof c->color);
        }
    }
    glClearColor(0.02f, 0.02f, 0.08f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(GL_QUADS, 0, 4 * PARTICLES);
}

/* Glyphs of random dots: how they look changes nothing of what they cost. */
static void start_rectangles(void) {
    static unsigned char font[GLYPH * GLYPH * GLYPHS];
    size_t i;
    for (i = 0; i < sizeof font; ++i)
        font[i] = chance() < 0.4f ? 255 : 0;
    give_texture(GLYPH * GLYPHS, GLYPH, font);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

/* A fan around the middle with a quarter of a circle in each corner. */
static void round_rectangle(float x, float y, float width, float height) {
    static const float middles[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    int corner, step;
    glBegin(GL_TRIANGLE_FAN);
    glVertex2f(x + width / 2, y + height / 2);
    for (corner = 0; corner < 4; ++corner)
        for (step = 0; step <= 4; ++step) {
            const float angle = ((float)corner + (float)step / 4) * 1.5707963f;
            glVertex2f(x + CORNER + middles[corner][0] * (width - 2 * CORNER) + CORNER * cosf(angle),
                       y + CORNER + middles[corner][1] * (height - 2 * CORNER) + CORNER * sinf(angle));
        }
    glVertex2f(x + width, y + height - CORNER);
    glEnd();
}

static void write_line(float x, float y, int first) {
    int i;
    glBegin(GL_QUADS);
    for (i = 0; i < LETTERS; ++i, x += GLYPH) {
        const float s = (float)((first + 5 * i) % GLYPHS) / GLYPHS;
        glTexCoord2f(s, 0);
        glVertex2f(x, y);
        glTexCoord2f(s + 1.0f / GLYPHS, 0);
        glVertex2f(x + GLYPH, y);
        glTexCoord2f(s + 1.0f / GLYPHS, 1);
        glVertex2f(x + GLYPH, y + GLYPH);
        glTexCoord2f(s, 1);
        glVertex2f(x, y + GLYPH);
    }
    glEnd();
}

/* Three columns of twenty lines, which overlap and drift a little. */
static void draw_rectangles(int frame) {
    int i;
    glClearColor(0.9f, 0.9f, 0.92f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    for (i = 0; i < RECTANGLES; ++i) {
        const float x = (float)(4 + i % 3 * 105 + (frame + i) % 4), y = (float)(1 + i / 3 * 11);
        glColor4f(0.2f + (float)(i % 5) * 0.1f, 0.4f, 0.8f, 0.85f);
        round_rectangle(x, y, 102, 20);
        glEnable(GL_TEXTURE_2D);
        glColor4f(1, 1, 1, 1);
        write_line(x + 3, y + 4, i);
        glDisable(GL_TEXTURE_2D);
    }
}

int main(int count, char** words) {
    const int particles_wanted = count == 3 && strcmp(words[1], "particles") == 0;
    const int frames = count == 3 ? atoi(words[2]) : 0;
    EGLDisplay display;
    EGLSurface surface;
    int frame;
    if (frames <= 0 || (!particles_wanted && strcmp(words[1], "rectangles") != 0)) {
        fputs("usage: clients particles|rectangles FRAMES\n", stderr);
        return 2;
    }
    if (!open_surface(&display, &surface)) {
        fputs("clients: there is no pbuffer with eight bits a component\n", stderr);
        return 1;
    }
    start();
    if (particles_wanted)
        start_particles();
    else
        start_rectangles();
    for (frame = 0; frame < frames; ++frame) {
        if (particles_wanted)
            draw_particles();
        else
            draw_rectangles(frame);
        eglSwapBuffers(display, surface);
    }
    return glGetError() == GL_NO_ERROR ? 0 : 1;
}
