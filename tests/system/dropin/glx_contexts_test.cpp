// Tests contexts of GLX: which lists of attributes are refused, and what is destroyed with a window of X.
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <semaphore>
#include <string>
#include <thread>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <spangle/EGL/egl.h>

#include "host_sim/dropin/glx.hpp"

extern char** environ;

namespace {

using namespace spangle::dropin::glx;

/// An Xvfb for this test alone, which tells its number through a pipe.
class Server {
  public:
    Server() {
        int ends[2];
        if (pipe(ends) != 0)
            return;
        std::string number = std::to_string(ends[1]);
        std::vector<std::string> words = {"Xvfb",       "-displayfd", number, "-screen", "0",
                                          "320x240x24", "-nolisten",  "tcp",  "-noreset"};
        std::vector<char*> arguments;
        for (std::string& word : words)
            arguments.push_back(word.data());
        arguments.push_back(nullptr);
        posix_spawn_file_actions_t quiet;
        posix_spawn_file_actions_init(&quiet);
        posix_spawn_file_actions_addopen(&quiet, 2, "/dev/null", 1, 0);
        if (posix_spawnp(&process_, "Xvfb", &quiet, nullptr, arguments.data(), environ) != 0)
            process_ = 0;
        posix_spawn_file_actions_destroy(&quiet);
        close(ends[1]);
        FILE* const said = fdopen(ends[0], "r");
        int screen = -1;
        if (process_ != 0 && std::fscanf(said, "%d", &screen) == 1)
            name_ = ":" + std::to_string(screen);
        std::fclose(said);
    }
    ~Server() {
        if (process_ != 0) {
            kill(process_, SIGTERM);
            waitpid(process_, nullptr, 0);
        }
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    const std::string& name() const { return name_; }

  private:
    pid_t process_ = 0;
    std::string name_;
};

int last_error = Success;

int note_error(Display*, XErrorEvent* error) {
    last_error = error->error_code;
    return 0;
}

class GlxContexts : public testing::Test {
  protected:
    static void SetUpTestSuite() { server = new Server; }
    static void TearDownTestSuite() {
        delete server;
        server = nullptr;
    }
    void SetUp() override {
        if (server->name().empty())
            GTEST_SKIP() << "there is no Xvfb; ./dev setup --programs installs it";
        display = XOpenDisplay(server->name().c_str());
        ASSERT_NE(display, nullptr);
        XSetErrorHandler(note_error);
        ASSERT_EQ(glXQueryExtension(display, &error_base, nullptr), True);
        int count = 0;
        GLXFBConfig* const all = glXGetFBConfigs(display, DefaultScreen(display), &count);
        ASSERT_GT(count, 0);
        config = all[0];
        XFree(all);
        last_error = Success;
    }
    void TearDown() override {
        if (display != nullptr)
            XCloseDisplay(display);
    }

    /// Returns the X error that refuses a list of attributes, or Success if a context is made.
    int made_with(std::vector<int> list) {
        list.push_back(0);
        last_error = Success;
        const GLXContext context = glXCreateContextAttribsARB(display, config, nullptr, True, list.data());
        XSync(display, False);
        EXPECT_EQ(context != nullptr, last_error == Success);
        glXDestroyContext(display, context);
        return last_error;
    }
    int of_glx(Problem problem) const { return error_base + static_cast<int>(problem); }

    static Server* server;
    Display* display = nullptr;
    GLXFBConfig config = nullptr;
    int error_base = 0;
};

Server* GlxContexts::server = nullptr;

TEST_F(GlxContexts, EveryVersionUpToItsOwnIsMade) {
    EXPECT_EQ(made_with({}), Success);
    for (int minor = 0; minor <= 5; ++minor)
        EXPECT_EQ(made_with({CONTEXT_MAJOR_VERSION, 1, CONTEXT_MINOR_VERSION, minor}), Success) << minor;
    EXPECT_EQ(made_with({RENDER_TYPE, RGBA_TYPE, CONTEXT_FLAGS, CONTEXT_DEBUG_BIT}), Success);
}

TEST_F(GlxContexts, HigherVersionsAreRefusedByTheConfiguration) {
    for (const auto& [major, minor] : {std::pair(2, 0), {2, 1}, {3, 3}, {4, 6}})
        EXPECT_EQ(made_with({CONTEXT_MAJOR_VERSION, major, CONTEXT_MINOR_VERSION, minor}),
                  of_glx(Problem::fb_config))
            << major << '.' << minor;
}

TEST_F(GlxContexts, VersionsThatDoNotExistAreABadMatch) {
    for (const auto& [major, minor] :
         {std::pair(-1, 0), {0, 0}, {1, -1}, {1, 6}, {2, -1}, {2, 2}, {3, 4}, {4, 7}, {5, 0}})
        EXPECT_EQ(made_with({CONTEXT_MAJOR_VERSION, major, CONTEXT_MINOR_VERSION, minor}), BadMatch)
            << major << '.' << minor;
}

TEST_F(GlxContexts, ForwardCompatibleContextsBeginWithVersionThree) {
    EXPECT_EQ(made_with({CONTEXT_FLAGS, CONTEXT_FORWARD_COMPATIBLE_BIT}), BadMatch);
    EXPECT_EQ(made_with({CONTEXT_FLAGS, CONTEXT_FORWARD_COMPATIBLE_BIT, CONTEXT_MAJOR_VERSION, 3}),
              of_glx(Problem::fb_config));
}

TEST_F(GlxContexts, UnknownValuesAreBadValues) {
    for (int bit = 2; bit < 32; ++bit)
        EXPECT_EQ(made_with({CONTEXT_FLAGS, static_cast<int>(1u << bit)}), BadValue) << bit;
    for (const int type : {0, -1, RGBA_BIT, 0x20B9, 0x20B1})
        EXPECT_EQ(made_with({RENDER_TYPE, type}), BadValue) << type;
    EXPECT_EQ(made_with({DEPTH_SIZE, 24}), BadValue);
}

TEST_F(GlxContexts, NoConfigurationHasColourIndices) {
    EXPECT_EQ(made_with({RENDER_TYPE, COLOR_INDEX_TYPE}), BadMatch);
}

TEST_F(GlxContexts, MasksOfNoneOrSeveralProfilesAreBadProfiles) {
    for (const int mask : {0, 3, 4, 8, -1})
        EXPECT_EQ(made_with({CONTEXT_PROFILE_MASK, mask}), of_glx(Problem::profile)) << mask;
    // GLX ignores the profile of a version before 3.2.
    EXPECT_EQ(made_with({CONTEXT_PROFILE_MASK, CONTEXT_CORE_PROFILE_BIT}), Success);
    EXPECT_EQ(made_with({CONTEXT_PROFILE_MASK, CONTEXT_COMPATIBILITY_PROFILE_BIT}), Success);
}

TEST_F(GlxContexts, AWindowOfGlxGoesWithItsWindowOfX) {
    const auto window_of_glx = [this](Window& window) {
        window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 16, 16, 0, 0, 0);
        return glXCreateWindow(display, config, window, nullptr);
    };
    Window window = 0;
    GLXWindow drawable = window_of_glx(window);
    glXDestroyWindow(display, drawable);
    XDestroyWindow(display, window);
    XSync(display, False);
    EXPECT_EQ(last_error, Success);
    drawable = window_of_glx(window);
    XDestroyWindow(display, window);
    glXDestroyWindow(display, drawable);
    XSync(display, False);
    EXPECT_EQ(last_error, of_glx(Problem::window));
}

/// Returns whether GL works on this connection.
bool draws(Display* connection) {
    int wish[] = {RGBA, DOUBLEBUFFER, 0};
    XVisualInfo* const visual = glXChooseVisual(connection, DefaultScreen(connection), wish);
    if (visual == nullptr)
        return false;
    const GLXContext context = glXCreateContext(connection, visual, nullptr, True);
    const Window window = XCreateSimpleWindow(connection, DefaultRootWindow(connection), 0, 0, 8, 8, 0, 0, 0);
    const bool made = glXMakeCurrent(connection, window, context) == True;
    if (made)
        glClear(GL_COLOR_BUFFER_BIT);
    XFree(visual);
    return made && glGetError() == GL_NO_ERROR;
}

/// Returns the colour that the server shows in a corner of a window, as 0xRRGGBB.
unsigned long seen(Display* connection, Window window) {
    XSync(connection, False);
    XImage* const image = XGetImage(connection, window, 0, 0, 1, 1, AllPlanes, ZPixmap);
    if (image == nullptr)
        return ~0ul;
    const unsigned long pixel = XGetPixel(image, 0, 0) & 0xFFFFFF;
    XDestroyImage(image);
    return pixel;
}

void clear_to(float red, float green) {
    glClearColor(red, green, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

TEST_F(GlxContexts, TheFrontOfAWindowWithTwoBuffersIsSeenWhenItIsFlushed) {
    constexpr unsigned long red = 0xFF0000, green = 0x00FF00;
    ASSERT_TRUE(draws(display));
    const Window window = glXGetCurrentDrawable();
    XMapWindow(display, window);
    glDrawBuffer(GL_FRONT);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    clear_to(1, 0);
    glFlush();
    EXPECT_EQ(seen(display, window), red);
    clear_to(0, 1);
    glFinish();
    EXPECT_EQ(seen(display, window), green);
    clear_to(1, 0);
    glDrawBuffer(GL_BACK); // the colour is read before anything else is drawn there
    EXPECT_EQ(seen(display, window), red);
    clear_to(0, 1);
    glFlush();
    EXPECT_EQ(seen(display, window), red) << "the back is not seen before a swap";
    glXSwapBuffers(display, window);
    EXPECT_EQ(seen(display, window), green);
    glReadBuffer(GL_FRONT);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    std::uint8_t pixel[4] = {};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    EXPECT_EQ(pixel[0], 0);
    EXPECT_EQ(pixel[1], 255);
}

TEST_F(GlxContexts, AWindowThatIsGoneIsNeitherCurrentNorShown) {
    const EGLDisplay egl = eglGetDisplay(display);
    EGLConfig egl_config = nullptr;
    EGLint count = 0;
    const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    ASSERT_TRUE(eglInitialize(egl, nullptr, nullptr));
    ASSERT_TRUE(eglChooseConfig(egl, wish, &egl_config, 1, &count));
    const Window window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 16, 16, 0, 0, 0);
    const EGLSurface surface = eglCreateWindowSurface(egl, egl_config, window, nullptr);
    const EGLContext context = eglCreateContext(egl, egl_config, nullptr, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, surface, surface, context));
    XDestroyWindow(display, window);
    XSync(display, False);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_FALSE(eglSwapBuffers(egl, surface));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_FALSE(eglMakeCurrent(egl, surface, surface, context));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    EXPECT_TRUE(eglMakeCurrent(egl, nullptr, nullptr, nullptr));
    EXPECT_FALSE(eglMakeCurrent(egl, surface, surface, context));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    eglDestroySurface(egl, surface);
    // Nothing uses this window between its end and the next eglMakeCurrent().
    const Window idle = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 16, 16, 0, 0, 0);
    const EGLSurface on_idle = eglCreateWindowSurface(egl, egl_config, idle, nullptr);
    ASSERT_TRUE(eglMakeCurrent(egl, on_idle, on_idle, context));
    EXPECT_TRUE(eglMakeCurrent(egl, nullptr, nullptr, nullptr));
    XDestroyWindow(display, idle);
    XSync(display, False);
    EXPECT_FALSE(eglMakeCurrent(egl, on_idle, on_idle, context));
    EXPECT_EQ(eglGetError(), EGL_BAD_NATIVE_WINDOW);
    eglDestroySurface(egl, on_idle);
    eglDestroyContext(egl, context);
}

TEST_F(GlxContexts, ManyConnectionsAreOpenAtOnce) {
    std::vector<Display*> connections;
    for (int i = 0; i < 20; ++i) {
        connections.push_back(XOpenDisplay(server->name().c_str()));
        EXPECT_TRUE(draws(connections.back())) << i;
    }
    for (Display* connection : connections)
        XCloseDisplay(connection);
}

TEST_F(GlxContexts, AProgramOpensAndClosesMoreConnectionsThanItHasDisplays) {
    std::vector<void*> places; // so that connections lie at different addresses
    for (int i = 0; i < 200; ++i) {
        Display* const connection = XOpenDisplay(server->name().c_str());
        ASSERT_TRUE(draws(connection)) << i;
        if (i % 3 == 0)
            glBegin(GL_TRIANGLES);
        XCloseDisplay(connection); // closes the connection while its context is current
        EXPECT_EQ(glXGetCurrentContext(), nullptr);
        EXPECT_EQ(glXGetCurrentDisplay(), nullptr);
        places.push_back(std::malloc(std::size_t{64} << (i % 12)));
    }
    for (void* const place : places)
        std::free(place);
}

TEST_F(GlxContexts, AConnectionAtTheAddressOfAClosedOneIsANewOne) {
    for (int i = 0; i < 200; ++i) {
        Display* const connection = XOpenDisplay(server->name().c_str());
        ASSERT_TRUE(draws(connection)) << i;
        const GLXContext context = glXGetCurrentContext();
        XCloseDisplay(connection);
        EXPECT_FALSE(glXIsDirect(display, context)); // the context no longer exists
        EXPECT_EQ(last_error, of_glx(Problem::context));
    }
}

TEST_F(GlxContexts, AnotherThreadKeepsWhatIsCurrentWhenTheConnectionIsClosed) {
    Display* const connection = XOpenDisplay(server->name().c_str());
    std::binary_semaphore drawn(0), closed(0);
    std::thread other([&] {
        const bool drew = draws(connection);
        drawn.release();
        closed.acquire();
        EXPECT_TRUE(drew);
        glViewport(0, 0, 4, 4);
        glClear(GL_COLOR_BUFFER_BIT);
        glFinish();
        EXPECT_TRUE(glXMakeCurrent(display, 0, nullptr));
        EXPECT_EQ(glXGetCurrentContext(), nullptr);
    });
    drawn.acquire();
    XCloseDisplay(connection);
    closed.release();
    other.join();
}

} // namespace
